/*
 * Fewer parts: seams that are straight on both parts become folds of one part, or vanish.
 *
 * Two parts can be one piece of paper where their seam is a straight line on both: planes that
 * meet, a plane and the end ruling of a curved part, two curved parts along a common ruling.
 */
#ifndef KG_NET_MERGE_H
#define KG_NET_MERGE_H

#include "katagami/net.h"

typedef struct kg_merge_options {
    bool all;           /* every seam that can; else only the wanted ones */
    const bool *wanted; /* per join; may be NULL. A wanted seam that cannot be merged is a remark */
    kg_vec2 room;       /* page without margins, mm at the net's scale; (0,0): no limit */
    double **bends;     /* 2 per join, as kg_tab_options has them: moved along with their joins;
                           those of merged seams are freed. May be NULL */
} kg_merge_options;

typedef enum kg_merge_refusal {
    KG_MERGE_BENT,     /* the seam is no straight line on both parts */
    KG_MERGE_SIDES,    /* one part is seen from its front, the other from its back */
    KG_MERGE_OVERLAPS, /* the two would lie on each other */
    KG_MERGE_TOO_BIG,  /* the whole would not fit the page */
    KG_MERGE_SAME      /* both sides already belong to one part */
} kg_merge_refusal;

typedef struct kg_merge_remark {
    int number; /* printed number of the seam */
    int64_t sources[2];
    kg_merge_refusal refusal;
} kg_merge_remark;

typedef struct kg_merge_report {
    size_t merged;
    size_t remark_count;
    kg_merge_remark *remarks; /* wanted seams that could not be merged; free() it */
} kg_merge_report;

/* Merges in place, the longest seams first; parts are numbered anew, joins keep their numbers.
 * Errors: KG_ERR_MEMORY, with the net still whole. */
kg_status kg_net_merge(kg_net *net, const kg_merge_options *options, kg_merge_report *out_report,
                       kg_error *error) KG_CHECKED;

#endif
