/* The courses of joins on their patches, by which single ones are told apart. */
#ifndef KG_UNROLL_COURSE_H
#define KG_UNROLL_COURSE_H

#include "unroll/piece.h"

/* Notes where a stretch's join runs, and its middle as the place that names it. */
void kg_course_of_stretch(const kg_pieces *pieces, const kg_stretch *stretch, kg_net_join *join);

#endif
