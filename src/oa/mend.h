/* Small changes of a card that may make a loose patch firm. */
#ifndef KG_OA_MEND_H
#define KG_OA_MEND_H

#include "oa/sheet.h"

typedef enum kg_oa_mend_kind {
    KG_OA_CLOSE_WINDOWS,  /* those on the rows */
    KG_OA_CLOSE_RUNS,     /* whole runs of those */
    KG_OA_PUT_BACK_TOPS,  /* those on the rows */
    KG_OA_MOVE_FRONT,     /* the fronts at depth `at`, by `by` */
    KG_OA_FRONT_TO_LOWER, /* … out to the front below */
    KG_OA_FRONT_TO_UPPER, /* … back to the front above */
    KG_OA_FRONT_AS_LEFT,  /* … to where the column before is, one after another */
    KG_OA_FRONT_AS_RIGHT,
    KG_OA_MOVE_TOP,     /* the tops at height `at`, by `by` */
    KG_OA_TOP_TO_UPPER, /* … up to the top above */
    KG_OA_TOP_TO_LOWER, /* … down to the top below */
    KG_OA_AS_LEFT,      /* whole columns, one after another */
    KG_OA_AS_RIGHT,
    KG_OA_FLATTEN, /* plain columns */
} kg_oa_mend_kind;

/* A change of the columns [x0, x1). */
typedef struct kg_oa_mend {
    kg_oa_mend_kind kind;
    int x0, x1, row0, row1;
    int at, by;
} kg_oa_mend;

/* What may be changed of a card that holds its margins: columns [first, last), levels below
 * `height`, depths up to `depth`. */
typedef struct kg_oa_mend_limits {
    int first, last, height, depth;
} kg_oa_mend_limits;

enum { KG_OA_MENDS = 24 };

/* Makes the change; the staircase rule is kept, and windows and omissions that lose their face go.
 */
void kg_oa_mend_apply(kg_oa *card, const kg_oa_mend_limits *limits, const kg_oa_mend *mend);

/* What may help a loose patch of the sheet, at most KG_OA_MENDS changes, gentle ones first; `wider`
 * columns beside it are changed as well by the last of them. */
size_t kg_oa_mends_of(const kg_oa_sheet *sheet, const kg_oa_patch *patch, int wider,
                      kg_oa_mend out_mends[KG_OA_MENDS]);

/* How much the columns [x0, x1) of two cards differ: voxels, windows and omitted tops. */
size_t kg_oa_mend_cost(const kg_oa *a, const kg_oa *b, int x0, int x1);
/* Makes one column like another one of the card. */
void kg_oa_mend_repeat(kg_oa *card, int to, int from);
/* Copies these columns of a card of the same size. */
void kg_oa_mend_copy(kg_oa *to, const kg_oa *from, int x0, int x1);

#endif
