/* The guide's own pages: text, pictures and drawings in millimetres, y down, as one PDF. */
#ifndef KG_GUIDE_PAPER_H
#define KG_GUIDE_PAPER_H

#include "katagami/net.h"
#include "katagami/render.h"
#include "net/bytes.h"

#include <cairo.h>

/* Sizes of text, mm from line to line being about 1.35 times that. */
#define KG_PAPER_TITLE 9.0
#define KG_PAPER_HEADING 5.5
#define KG_PAPER_TEXT 3.7
#define KG_PAPER_SMALL 3.0

/* Free at every side of a page, mm. */
#define KG_PAPER_MARGIN 14.0

enum { KG_INK = 0x202428, KG_FAINT_INK = 0x69727a };

typedef struct kg_paper {
    kg_vec2 size;
    cairo_t *cr;
    int page;       /* from 1 */
    double y;       /* how far the page is filled */
    void *texts;    /* Pango's */
    kg_bytes bytes; /* the PDF, whole after kg_paper_finish */
    char *footer;
} kg_paper;

/* KG_ERR_SYSTEM: the machine has no font. `footer` stands on each page beside its number. */
kg_status kg_paper_create(kg_vec2 size, const char *title, const char *footer, kg_paper **out_paper,
                          kg_error *error) KG_CHECKED;
void kg_paper_destroy(kg_paper *paper);

/* Ends the page, with its number, and begins the next. */
void kg_paper_turn(kg_paper *paper);

/* Begins a new page when less than `height` is left on this one. */
void kg_paper_need(kg_paper *paper, double height);

/* Ends the last page; paper->bytes holds the file then. */
kg_status kg_paper_finish(kg_paper *paper, kg_error *error) KG_CHECKED;

/* Width between the margins, and the lowest y that may be used. */
double kg_paper_width(const kg_paper *paper);
double kg_paper_bottom(const kg_paper *paper);

typedef enum kg_align { KG_ALIGN_LEFT, KG_ALIGN_CENTRE } kg_align;

typedef struct kg_text {
    double size; /* mm */
    uint32_t colour;
    kg_align align;
    int lines; /* cut off with an ellipsis behind so many; 0: wrapped into any number */
} kg_text;

/* Height of `text` wrapped to `width`, mm. */
double kg_paper_text_height(const kg_paper *paper, const kg_text *style, double width,
                            const char *text);

/* Writes text into the column whose upper left corner is (x, y); returns its height. */
double kg_paper_text(kg_paper *paper, const kg_text *style, double x, double y, double width,
                     const char *text);

/* Puts text under what is on the page, over its whole width, and moves on. */
void kg_paper_write(kg_paper *paper, const kg_text *style, const char *text);

/* A picture with its upper left corner at (x, y). Opaque pixels only. */
kg_status kg_paper_image(kg_paper *paper, const kg_image *image, double x, double y, double width,
                         kg_error *error) KG_CHECKED;

void kg_paper_colour(kg_paper *paper, uint32_t colour);

/* A number in a circle (joins) or a box (parts) around (x, y), and the half size of such a badge.
 */
void kg_paper_join_badge(kg_paper *paper, double x, double y, int number);
void kg_paper_part_badge(kg_paper *paper, double x, double y, int number, uint32_t colour);
kg_vec2 kg_paper_badge_half(int number);

#endif
