/* Parts drawn by hand, and what must hold for every net with tabs. */
#ifndef KG_TESTS_TAB_CHECK_H
#define KG_TESTS_TAB_CHECK_H

#include "tests/check.h"

#include "net/tab.h"

enum { TAB_PEN_MAX = 600 };

/* A contour being drawn. */
typedef struct tab_pen {
    kg_vec2 points[TAB_PEN_MAX];
    unsigned char corners[TAB_PEN_MAX];
    size_t count;
} tab_pen;

void tab_draw(tab_pen *p, double x, double y, bool corner);
void tab_draw_circle(tab_pen *p, double radius, double direction);

/* Adds the contour to a part and starts a new one. */
void tab_add_contour(kg_net *net, size_t part, tab_pen *p);

size_t tab_add_part(kg_net *net);
size_t tab_add_polygon(kg_net *net, const kg_vec2 *points, size_t count);

kg_net_side tab_edge(size_t part, int loop, size_t first, size_t count);
kg_net_side tab_nothing(void);

/* A contact where `b` is nothing, else a seam. */
kg_net_join *tab_add_join(kg_net *net, kg_net_side a, kg_net_side b);

/* kg_net_tabs, with its result checked by GEOS: contours valid, tabs apart from each other and from
 * the paper, areas adding up, no point of the old contours lost, and every join's length covered by
 * folds and remarks. */
kg_net *tab_make(const kg_net *net, const kg_tab_options *options, kg_tab_report *report);

/* The same with default options, for the number of tabs; also checks the sides of the joins, which
 * must not share edges. */
size_t tab_count(kg_net *net, kg_tab_report *report);

const kg_tab_remark *tab_remark_of(const kg_tab_report *report, kg_tab_trouble trouble,
                                   kg_tab_reason reason);

#endif
