/* What the stability of a card is worked out from. */
#ifndef KG_OA_STABILITY_H
#define KG_OA_STABILITY_H

#include "oa/sheet.h"

/* Maps patches and hinges; nothing is said of what is stable yet. */
kg_status kg_oa_patches_map(const kg_oa_sheet *sheet, kg_oa_stability *out,
                            kg_error *error) KG_CHECKED;

/* Neighbours of every patch over its hinges: those of patch p are items[starts[p]] …
 * items[starts[p + 1] - 1], in the order of the hinges. */
typedef struct kg_oa_neighbours {
    size_t *starts;
    int *items;
    int *hinges; /* index of the hinge to each */
} kg_oa_neighbours;

/* `extra`: one more neighbourhood, of back and base, that comes first for both (its hinge is -1).
 */
kg_status kg_oa_neighbours_create(const kg_oa_stability *s, bool extra, kg_oa_neighbours *out,
                                  kg_error *error) KG_CHECKED;
void kg_oa_neighbours_clear(kg_oa_neighbours *n);

/* Marks the patches that follow from the opening of the card as stable and counts the others.
 * `held` (per patch; NULL: back and base) are those known to follow. False when memory runs out. */
bool kg_oa_close(kg_oa_stability *s, const kg_oa_neighbours *neighbours,
                 const unsigned char *held) KG_CHECKED;

#endif
