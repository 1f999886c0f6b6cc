/* What is on the pages, in millimetres with y down: the writers only translate it. */
#ifndef KG_NET_DRAWING_H
#define KG_NET_DRAWING_H

#include "katagami/net.h"
#include "net/path.h"

typedef struct kg_stroke {
    kg_net_layer layer;
    int part;       /* number printed on it, 0: of the page */
    int64_t source; /* of the part */
    int64_t contact;
    int tab;
    bool filled; /* an area instead of a line: outlines of text, registration marks */
    bool dashed; /* drawn with its layer's dashes */
    kg_path path;
} kg_stroke;

typedef enum kg_frame { KG_FRAME_NONE, KG_FRAME_BOX, KG_FRAME_RING } kg_frame;

/* Where a text lies in its box, which is on the generous side. */
typedef enum kg_caption_align {
    KG_CAPTION_MIDDLE = 0,
    KG_CAPTION_START,
    KG_CAPTION_END
} kg_caption_align;

typedef struct kg_caption {
    kg_net_layer layer;
    kg_frame frame; /* what is drawn around it: parts stand in boxes, joins in rings */
    int part;
    int64_t source;
    kg_vec2 center; /* of the box from baseline to capital height */
    double angle;   /* turning x towards y */
    double capital; /* height of capitals, mm */
    kg_caption_align align;
    char *text;
} kg_caption;

typedef struct kg_strokes {
    kg_stroke *items;
    size_t count, capacity;
} kg_strokes;

typedef struct kg_captions {
    kg_caption *items;
    size_t count, capacity;
} kg_captions;

typedef struct kg_page {
    kg_strokes strokes;
    kg_captions captions;
} kg_page;

typedef struct kg_drawing {
    kg_vec2 size; /* of every page */
    size_t page_count;
    kg_page *pages;
    char *title;
    double flatten_tolerance; /* mm, what a writer without curves may stray from them */
    kg_net_style styles[KG_LAYER_COUNT];
} kg_drawing;

/* Lengths of dash, gap, … of a layer's look, mm; returns how many, 0 for a whole line. */
int kg_layer_dashes(kg_net_layer layer, const double **out_dashes);

/* "cut" and "Cut", as the SVG's ids and labels are. */
const char *kg_layer_id(kg_net_layer layer);
const char *kg_layer_label(kg_net_layer layer);

/* Adds an empty stroke, or NULL when memory runs out; valid until the next is added. */
kg_stroke *kg_page_stroke(kg_page *page, kg_net_layer layer, const kg_net_part *part);

/* Adds a copy of the caption, its text made fit for one line. False when memory runs out. */
bool kg_page_caption(kg_page *page, const kg_caption *caption) KG_CHECKED;

/* Draws all pages of the net. Without `curves` the writer is
 * going to flatten them, and fitting leaves it two fifths of the tolerance. Errors: KG_ERR_MEMORY,
 * KG_ERR_INPUT (options). */
kg_status kg_drawing_create(const kg_net *net, const kg_net_layout *layout,
                            const kg_net_options *options, bool curves, kg_drawing **out_drawing,
                            kg_error *error) KG_CHECKED;
void kg_drawing_destroy(kg_drawing *drawing);

#endif
