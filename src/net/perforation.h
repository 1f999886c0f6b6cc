/* Folds cut into dashes with real gaps, for machines that know only cut or not. */
#ifndef KG_NET_PERFORATION_H
#define KG_NET_PERFORATION_H

#include "net/drawing.h"

/* Splits every mountain and valley stroke into segments of about `dash` mm with gaps of `gap` mm.
 * Every piece of a path begins and ends with a segment; what does not come out even lengthens the
 * outer ones. Errors: KG_ERR_MEMORY. */
kg_status kg_perforate(kg_drawing *drawing, double dash, double gap, kg_error *error) KG_CHECKED;

/* The same for one path, appended to `out`; false when memory runs out. */
bool kg_path_dashes(const kg_path *path, double dash, double gap, kg_path *out) KG_CHECKED;

#endif
