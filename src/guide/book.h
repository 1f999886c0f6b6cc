/* The guide's own pages: text, pictures and drawings in millimetres, y down, as one PDF. */
#ifndef KG_GUIDE_BOOK_H
#define KG_GUIDE_BOOK_H

#include "katagami/net.h"
#include "katagami/render.h"
#include "net/bytes.h"

#include <cairo.h>

/* Sizes of text, mm from line to line being about 1.35 times that. */
#define KG_BOOK_TITLE 9.0
#define KG_BOOK_HEADING 5.5
#define KG_BOOK_TEXT 3.7
#define KG_BOOK_SMALL 3.0

/* Free at every side of a page, mm. */
#define KG_BOOK_MARGIN 14.0

enum { KG_INK = 0x202428, KG_FAINT_INK = 0x69727a };

typedef struct kg_book {
    kg_vec2 size;
    cairo_t *cr;
    int page;       /* from 1 */
    double y;       /* how far the page is filled */
    void *texts;    /* Pango's */
    kg_bytes bytes; /* the PDF, whole after kg_book_finish */
    char *footer;
} kg_book;

/* KG_ERR_SYSTEM: the machine has no font. `footer` stands on each page beside its number. */
kg_status kg_book_create(kg_vec2 size, const char *title, const char *footer, kg_book **out_paper,
                         kg_error *error) KG_CHECKED;
void kg_book_destroy(kg_book *paper);

/* Ends the page, with its number, and begins the next. */
void kg_book_turn(kg_book *paper);

/* Begins a new page when less than `height` is left on this one. */
void kg_book_need(kg_book *paper, double height);

/* Ends the last page; paper->bytes holds the file then. */
kg_status kg_book_finish(kg_book *paper, kg_error *error) KG_CHECKED;

/* Width between the margins, and the lowest y that may be used. */
double kg_book_width(const kg_book *paper);
double kg_book_bottom(const kg_book *paper);

typedef enum kg_align { KG_ALIGN_LEFT, KG_ALIGN_CENTER } kg_align;

typedef struct kg_text {
    double size; /* mm */
    uint32_t color;
    kg_align align;
    int lines; /* cut off with an ellipsis behind so many; 0: wrapped into any number */
} kg_text;

/* Height of `text` wrapped to `width`, mm. */
double kg_book_text_height(const kg_book *paper, const kg_text *style, double width,
                           const char *text);

/* Writes text into the column whose upper left corner is (x, y); returns its height. */
double kg_book_text(kg_book *paper, const kg_text *style, double x, double y, double width,
                    const char *text);

/* Puts text under what is on the page, over its whole width, and moves on. */
void kg_book_write(kg_book *paper, const kg_text *style, const char *text);

/* A picture with its upper left corner at (x, y). Opaque pixels only. */
kg_status kg_book_image(kg_book *paper, const kg_image *image, double x, double y, double width,
                        kg_error *error) KG_CHECKED;

void kg_book_color(kg_book *paper, uint32_t color);

/* A number in a circle (joins) or a box (parts) around (x, y), and the half size of such a badge.
 */
void kg_book_join_badge(kg_book *paper, double x, double y, int number);
void kg_book_part_badge(kg_book *paper, double x, double y, int number, uint32_t color);
kg_vec2 kg_book_badge_half(int number);

#endif
