/* Cards made at random, and a second, direct way to everything: from the faces of voxels. */
#ifndef KG_TESTS_OA_REFERENCE_H
#define KG_TESTS_OA_REFERENCE_H

#include "katagami/oa.h"

#include "check.h"

/* A card of random size and steps; windows and omitted tops with the given chances. `plain` keeps
 * its border empty. */
kg_oa *random_card(kg_random *r, double windows, double omitted, bool plain);

/* The same of a given size. */
kg_oa *random_card_of(kg_random *r, int width, int depth, int height, double windows,
                      double omitted, bool plain);

/* Chance in [0,1]. */
static inline bool chance(kg_random *r, double p) {
    return kg_random_in(r, 0, 1) < p;
}
/* A whole number in [lo, hi]. */
static inline int whole(kg_random *r, int lo, int hi) {
    return lo + (int)kg_random_in(r, 0, hi - lo + 1);
}

/* All that is derived from a card. */
typedef struct solved {
    kg_oa_sheet *sheet;
    kg_oa_stability *stability;
    kg_oa_remarks *remarks;
} solved;

solved solve(const kg_oa *oa);
void clear(solved *s);

/* A unit face of paper in space: upper and lower edge as (y,z). */
typedef struct face {
    int y0, z0, y1, z1;
    bool front; /* vertical, before the back sheet, not pushed back */
} face;

/* All faces of a card without margins, [row * width + x], gathered voxel by voxel: asserts that
 * every cell of the sheet is exactly one face. free() it. */
face *faces_of(const kg_oa *oa);

/* Lines between neighbours by the edges they share in space (Table 1). */
kg_oa_edge edge_below(const kg_oa *oa, const face *faces, int x, int row);
kg_oa_edge edge_right(const kg_oa *oa, const face *faces, int x, int row);

/* Floods cell by cell with a stack; the number of front cells that one of them misses. */
size_t flood_fill(const kg_oa *oa, const face *faces);

/* Degrees of freedom of the card whose back sheet is held, and of each cell whether it keeps still
 * when the base is held as well: by the speeds of all patches, of which any two that share a fold
 * move alike there. */
int move_freely(const kg_oa *oa, const face *faces, bool *out_still);

/* Windows by trying each candidate with a flood of its own. */
void open_windows_slowly(kg_oa *oa, const unsigned char *candidates);

#endif
