/* Contours with their tabs as one line. */
#ifndef KG_NET_TAB_MERGE_H
#define KG_NET_TAB_MERGE_H

#include "net/tab_place.h"

/* Sorts a part's tabs by contour and place on it, and gives neighbours that share a foot the very
 * same point. Comes before the others. */
void kg_tab_order(const kg_tab_ground *ground, kg_tab_list *tabs);

/* A contour around its tabs. map[i] is the index in it of the old point i, or, where that lies
 * under a tab, of the next old point or tab end. */
typedef struct kg_tab_contour {
    kg_net_line line;
    size_t *map;
} kg_tab_contour;

/* Merges the tabs that stand on loop number `index` (those with a height, in order along it). The
 * caller destroys the contour. */
kg_status kg_tab_merge(const kg_tab_loop *loop, int index, const kg_tab_list *tabs,
                       kg_tab_contour *out) KG_CHECKED;
void kg_tab_contour_destroy(kg_tab_contour *contour);

/* The contour's stretch under a tab as a fold line of that kind and tab number. The caller frees
 * its points and corners. */
kg_status kg_tab_fold(const kg_tab_loop *loop, const kg_tab *tab, kg_net_kind kind, int number,
                      kg_net_line *out) KG_CHECKED;

#endif
