/* The page that options describe, and which of it parts may use. */
#ifndef KG_NET_SHEET_H
#define KG_NET_SHEET_H

#include "katagami/net.h"

/* mm. The scale bar and page number stand in the lower margin when it is as high as they are, else
 * they take room from the parts. */
#define KG_SHEET_BAR_HEIGHT 6.0
#define KG_SHEET_BAR_WIDTH 80.0

/* mm. Silhouette's registration marks of type 1: a square at the upper left, angles at the upper
 * right and lower left, in the corners of the usable area. */
#define KG_REGISTRATION_SQUARE 5.0
#define KG_REGISTRATION_LEG 20.0
#define KG_REGISTRATION_WIDTH 0.5

/* mm. The page frame is drawn so far outside of the usable area, within the page, that what is cut
 * along the area's edge is not taken for it, nor it for a cut. */
#define KG_SHEET_FRAME_OUTSIDE 1.0

/* Distance of the page frame from the page's edges, mm. */
static inline double kg_sheet_frame(double margin) {
    return fmax(margin - KG_SHEET_FRAME_OUTSIDE, margin / 2);
}

enum { KG_SHEET_FORBIDDEN_MAX = 8 };

typedef struct kg_sheet {
    bool endless;   /* no paper: the page becomes as large as the parts */
    kg_vec2 size;   /* mm, of the page */
    kg_vec2 origin; /* upper left corner of the usable area */
    kg_vec2 usable; /* its width and height */
    int forbidden_count;
    kg_box2 forbidden[KG_SHEET_FORBIDDEN_MAX]; /* from the usable area's corner: marks, scale bar */
} kg_sheet;

/* Errors: KG_ERR_INPUT for options out of their range or a page with no room left. */
kg_status kg_sheet_from_options(const kg_net_options *options, kg_sheet *out_sheet,
                                kg_error *error) KG_CHECKED;

#endif
