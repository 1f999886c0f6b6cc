/* Tabs on the edges of one part: their outlines, and the room they have. */
#ifndef KG_NET_TAB_PLACE_H
#define KG_NET_TAB_PLACE_H

#include "net/tab.h"
#include "net/tab_edge.h"

#include <geos_c.h>

typedef struct kg_tab {
    int join, side, part, loop;
    size_t piece;         /* number of the base along the join, before any split */
    double base[2];       /* the stretch of the edge it is for, positions on the loop */
    double wanted;        /* mm, height it should have */
    double height;        /* mm, height it has; 0: no room */
    double foot[2];       /* where it stands, within the base */
    kg_vec2 path[4];      /* from foot to foot around it */
    kg_tab_reason reason; /* why it is lower than wanted */
} kg_tab;

typedef struct kg_tab_list {
    kg_tab *items;
    size_t count, capacity;
} kg_tab_list;

/* A part to put tabs on. */
typedef struct kg_tab_ground {
    GEOSContextHandle_t geos;
    GEOSGeometry *polygon;
    const GEOSPreparedGeometry *prepared;
    kg_tab_loop *loops;
    size_t loop_count;
} kg_tab_ground;

kg_status kg_tab_ground_create(GEOSContextHandle_t geos, const kg_net_part *part,
                               kg_tab_ground *out) KG_CHECKED;
void kg_tab_ground_destroy(kg_tab_ground *ground);

/* Adds the tabs of one side of a join as if no other join had any. Tabs without room are added with
 * height 0. */
kg_status kg_tab_place(const kg_tab_ground *ground, const kg_net_join *join, int index, int side,
                       const double *bend, const kg_tab_options *options,
                       kg_tab_list *tabs) KG_CHECKED;

/* Whether a contour, with tabs, and the part's other ones make a valid polygon; else out_at is
 * where they do not. */
bool kg_tab_contours_valid(GEOSContextHandle_t geos, const kg_net_line *contours, size_t count,
                           kg_vec2 *out_at);

/* ---- single tabs, for settling ------------------------------------------------------------ */

/* mm kept between a tab and what it must not touch; the factor of one step lower. */
#define KG_TAB_CLEARANCE 0.15
#define KG_TAB_STEP_DOWN 0.85

/* Shapes a tab at most `height` high, lower until it is clear of the part; height 0: nowhere. */
void kg_tab_fit(const kg_tab_ground *ground, const kg_tab_options *options, kg_tab *tab,
                double height);

/* Least height worth cutting on that tab's base. */
double kg_tab_least(const kg_tab *tab, const kg_tab_options *options);

/* The same tab on the first (0) or second (1) half of its base, still to be shaped. */
kg_tab kg_tab_half(const kg_tab *tab, int half, double width);

void kg_tab_drop(kg_tab *tab, kg_tab_reason reason);

/* A tab's path with its feet lifted off the edge and its top pushed out: what must be free. */
void kg_tab_guard(const kg_tab *tab, kg_vec2 out[4]);

#endif
