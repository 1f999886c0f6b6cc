/*
 * katagami: nets, what is cut out of paper and put together.
 *
 * The net model knows parts, their outlines, folds, marks and the joins between them, and nothing
 * of where they come from: patches, pop-up cards and folded sheets all end here. Data flows one
 * way: a mode builds a kg_net (parts in their own coordinates, joins), kg_net_tabs adds glue tabs,
 * kg_net_layout places parts on pages, the writers draw the pages.
 *
 * Lengths are millimetres on paper at the net's own scale; y points down, as on the page.
 */
#ifndef KATAGAMI_NET_H
#define KATAGAMI_NET_H

#include "katagami/base.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum kg_net_kind {
    KG_NET_CUT = 0,
    KG_NET_MOUNTAIN,
    KG_NET_VALLEY,
    KG_NET_MARK
} kg_net_kind;

/* A curve on paper as a dense polyline (its chords are within a fifth of the writing tolerance,
 * divided by the writing scale, of the true curve). corners[i] is 1 where the direction breaks at
 * points[i]; elsewhere the curve is smooth there. A closed line does not repeat its first point. */
typedef struct kg_net_line {
    kg_net_kind kind;
    bool closed;
    size_t count;
    kg_vec2 *points;
    unsigned char *corners;
    int64_t contact; /* mark lines: id of the source that touches here, else 0 */
    int tab;         /* tab folds: number of the tab in its part, from 1, else 0 */
    int join;        /* index of the join this line belongs to, else -1 */
} kg_net_line;

typedef enum kg_net_join_kind {
    KG_JOIN_SEAM,   /* two edges are glued edge to edge */
    KG_JOIN_CONTACT /* an edge is glued onto the inside of another part, along a mark line */
} kg_net_join_kind;

typedef enum kg_net_tab_side {
    KG_TAB_AUTO = 0,
    KG_TAB_NONE,
    KG_TAB_THIS, /* on side 0 of the join */
    KG_TAB_OTHER /* on side 1 of the join */
} kg_net_tab_side;

typedef enum kg_net_tab_shape {
    KG_TAB_SHAPE_AUTO = 0,
    KG_TAB_TRAPEZOID,
    KG_TAB_TEETH
} kg_net_tab_shape;

/* One side of a join: a stretch of a part's outline (or a mark line inside the part). */
typedef struct kg_net_side {
    int part;      /* index in kg_net.parts, or -1 when that side is in no part */
    int loop;      /* index of the outline loop, or -1 for a mark line */
    size_t first;  /* the stretch runs from points[first], `count` points onward (wrapping) */
    size_t count;  /* at least 2 for an outline stretch */
    int line;      /* index in the part's lines when loop is -1 */
    double length; /* true length on paper, by quadrature, not of the polyline */
    bool reversed; /* side 1: runs against the direction of side 0 */
} kg_net_side;

/* Places by which the course of a join is known. */
enum { KG_JOIN_PLACES = 9 };

/* Where paper is glued to paper. Side 0 of a contact is the edge, side 1 the mark line. */
typedef struct kg_net_join {
    kg_net_join_kind kind;
    int number; /* printed on both sides, from 1 */
    kg_net_side sides[2];
    int64_t sources[2]; /* ids of what the two parts were made from */
    /* Signed angle by which a tab on side 0 / side 1 is folded from the part's plane to lie on the
     * other part, positive: valley as seen from the printed front, negative: mountain; the largest
     * along the stretch in absolute value. */
    double fold[2];
    kg_net_tab_side tab_side; /* wish of the user */
    kg_net_tab_shape tab_shape;
    double tab_width; /* mm; 0: the net's */
    /* Where it runs, evenly along it in the direction of side 0, and the place that names it, in
     * the coordinates of the sources. The net has no use for them. */
    kg_vec2 course[2][KG_JOIN_PLACES];
    kg_vec2 at;  /* of sources[at_side] */
    int at_side; /* 0 or 1 */
} kg_net_join;

typedef struct kg_net_loop {
    kg_net_line line; /* closed; the outer loop runs so that the paper lies on its left in a y-down
                         picture's coordinates taken as they are (positive shoelace area); holes the
                         other way round */
} kg_net_loop;

/* Pages a net can have. */
enum { KG_NET_PAGES_MAX = 1000 };

/* Where a part lies: a point p of it comes to  scale * R(angle) p + offset  on its page, R turning
 * x towards y. Parts are never mirrored. */
typedef struct kg_net_placement {
    int page; /* from 0 */
    double angle;
    kg_vec2 offset;
} kg_net_placement;

typedef struct kg_net_part {
    int number;        /* printed on it, from 1 */
    int64_t source;    /* id of the patch (or card, sheet) it is made from */
    char *name;        /* UTF-8, may be empty */
    size_t loop_count; /* outer contour first, then holes */
    kg_net_loop *loops;
    size_t line_count; /* folds and marks */
    kg_net_line *lines;
    double area;    /* true area on paper, mm² */
    double surface; /* true area in space, mm² */
    double perimeter;
    double isometry_error;
    bool pinned; /* stays where the user put it; the others keep clear of it */
    kg_net_placement pin;
} kg_net_part;

typedef struct kg_net {
    char *title;
    size_t part_count;
    kg_net_part *parts;
    size_t join_count;
    kg_net_join *joins;
} kg_net;

/* ---- building --------------------------------------------------------------------------- */

/* An empty net, or NULL when memory runs out. */
KG_API kg_net *kg_net_create(void);
/* Frees the net and everything it holds; NULL is fine. */
KG_API void kg_net_destroy(kg_net *net);

/* Adds a part numbered one after the last; `name` (UTF-8, NULL: empty) is copied. Its index goes
 * to `out_part`. Errors: KG_ERR_MEMORY. */
KG_API kg_status kg_net_add_part(kg_net *net, int64_t source, const char *name, size_t *out_part,
                                 kg_error *error) KG_CHECKED;

/* Adds a contour (the outer one first, then holes) of `count` points; points and corners
 * (NULL: every point is a corner) are copied. Errors: KG_ERR_MEMORY. */
KG_API kg_status kg_net_add_loop(kg_net *net, size_t part, const kg_vec2 *points,
                                 const unsigned char *corners, size_t count,
                                 kg_error *error) KG_CHECKED;

/* Adds a fold or mark: a copy of `line` with its points and corners (corners NULL: every point is
 * a corner). Its index goes to `out_line` (may be NULL). Errors: KG_ERR_MEMORY. */
KG_API kg_status kg_net_add_line(kg_net *net, size_t part, const kg_net_line *line,
                                 size_t *out_line, kg_error *error) KG_CHECKED;

/* Adds a copy of `join`; a number of 0 becomes one more than the joins so far. Its index goes to
 * `out_join` (may be NULL). Errors: KG_ERR_MEMORY. */
KG_API kg_status kg_net_add_join(kg_net *net, const kg_net_join *join, size_t *out_join,
                                 kg_error *error) KG_CHECKED;

/* How many joins there are between what a join joins, itself included. */
KG_API size_t kg_net_joins_beside(const kg_net *net, const kg_net_join *join);

/* Looks for what no correct builder makes: numbers that are not finite, contours of fewer than
 * three points or the wrong direction, lines of fewer than two, indices out of range, names that
 * are no UTF-8. For tests and for programs that build nets by hand. Errors: KG_ERR_INPUT naming the
 * part. */
KG_API kg_status kg_net_check(const kg_net *net, kg_error *error) KG_CHECKED;

/* ---- options ---------------------------------------------------------------------------- */

typedef enum kg_net_layer {
    KG_LAYER_CUT = 0,
    KG_LAYER_MOUNTAIN,
    KG_LAYER_VALLEY,
    KG_LAYER_MARK,
    KG_LAYER_LABEL,
    KG_LAYER_GUIDE,
    KG_LAYER_COUNT
} kg_net_layer;

typedef enum kg_net_labels {
    KG_LABELS_NONE = 0,
    KG_LABELS_INSIDE,
    KG_LABELS_OUTSIDE
} kg_net_labels;

typedef enum kg_net_preset {
    KG_PRESET_PRINT = 0,
    KG_PRESET_LASER,
    KG_PRESET_SILHOUETTE,
    KG_PRESET_CRICUT
} kg_net_preset;

typedef struct kg_net_style {
    uint32_t color; /* 0xrrggbb */
    double width;   /* of the stroke, mm */
} kg_net_style;

typedef struct kg_net_options {
    kg_vec2 paper;    /* mm; (0,0): one page as large as the parts, without frame or margin */
    bool landscape;   /* turns upright paper on its side */
    double margin;    /* mm kept free at every side of the page, >= 0 */
    double gap;       /* least distance between parts, mm, >= 0 */
    bool nest;        /* by true outlines, which takes longer, instead of in rows; not without
                         paper */
    bool grain;       /* parts keep the direction of the paper's grain */
    double scale;     /* written size over true size, > 0 */
    double tolerance; /* mm a written line may be off the true one, > 0 */
    kg_net_labels labels;
    bool text_outlines;  /* text as filled paths instead of text elements */
    bool registration;   /* Silhouette's marks (type 1), parts kept clear of them */
    bool dashes;         /* mountain and valley folds dash-dotted and dashed in their look */
    double perforate[2]; /* dash and gap, mm: folds as separate segments; 0,0: whole lines */
    bool separate;       /* NAME-print and NAME-cut files instead of one */
    bool mirrored;       /* for printing on the back: pages mirrored, text still readable,
                            mountain and valley exchanged */
    bool frame;          /* page frame, page number and 50 mm scale bar */
    kg_net_style styles[KG_LAYER_COUNT];
} kg_net_options;

/* A4, upright, 8 mm margin, scale 1, 0.01 mm, labels inside, the print preset's look. */
KG_API kg_net_options kg_net_options_default(void);

/* Sets what a preset stands for (colours, widths, outlines, registration marks, frame) and leaves
 * paper, scale and the like alone; Cricut also sets the 6.75 x 9.25 inch print-then-cut page. */
KG_API void kg_net_options_preset(kg_net_options *options, kg_net_preset preset);

/* "print", "laser", "silhouette", "cricut". Errors: KG_ERR_INPUT listing them. */
KG_API kg_status kg_net_preset_parse(const char *text, kg_net_preset *out_preset,
                                     kg_error *error) KG_CHECKED;

/* "A4", "A3", "A2", "letter", "legal" (any case), "none" or "WxH" in mm. Errors: KG_ERR_INPUT. */
KG_API kg_status kg_net_paper_parse(const char *text, kg_vec2 *out_paper,
                                    kg_error *error) KG_CHECKED;
/* The name of the smallest of A4, A3 and A2 that holds `size` within its margins (mm), upright or
 * across; NULL, and nothing is set: none does. */
KG_API const char *kg_net_paper_for(kg_vec2 size, double margin, kg_vec2 *out_paper,
                                    bool *out_across);

/* ---- settings --------------------------------------------------------------------------- */

struct json_t;

/* What a model file of any kind says of its net. */
typedef struct kg_net_settings {
    char *paper;         /* as kg_net_paper_parse takes it; NULL: A4, of sheets what holds them */
    double margin;       /* mm, usually 8 */
    double scale;        /* usually 1 */
    double tab_width;    /* mm, usually 5; 0: without tabs */
    struct json_t *json; /* the object as it was read, with all else that it says; may be NULL */
} kg_net_settings;

/* A4, with the usual values above. */
KG_API kg_net_settings kg_net_settings_default(void);
/* Frees what they hold and makes them the default. */
KG_API void kg_net_settings_clear(kg_net_settings *settings);
/* False when memory runs out; the copy is to be cleared all the same. */
KG_API bool kg_net_settings_copy(const kg_net_settings *from, kg_net_settings *out_copy);
/* Whether files of both would say the same. */
KG_API bool kg_net_settings_equal(const kg_net_settings *a, const kg_net_settings *b);

/* Net options as the settings ask for them. KG_ERR_INPUT: an unknown word or a wrong kind of value.
 */
KG_API kg_status kg_net_settings_options(const kg_net_settings *settings,
                                         kg_net_options *out_options, kg_error *error) KG_CHECKED;
/* The preset that they name, KG_PRESET_PRINT when it is none that is known. */
KG_API kg_net_preset kg_net_settings_preset(const kg_net_settings *settings);

/* ---- pages ------------------------------------------------------------------------------ */

typedef struct kg_net_layout {
    kg_vec2 page_size; /* mm, of every page */
    size_t page_count;
    size_t part_count;
    kg_net_placement *placements; /* one per part */
    double scale;
    double fill; /* area cut out (parts with tabs) over that of the pages within their margins */
} kg_net_layout;

/* Places every part of the net; `progress` (NULL: none) is called while nesting. Pinned parts lie
 * where their pins say, be that off the page; without paper pins mean nothing. Errors: KG_ERR_INPUT
 * (an option out of its range; no parts, or what kg_net_check refuses; a part larger than the page:
 * names it, its size and what would help; a pin that is no place), KG_ERR_CANCELLED, KG_ERR_MEMORY.
 */
KG_API kg_status kg_net_layout_create(const kg_net *net, const kg_net_options *options,
                                      const kg_progress *progress, kg_net_layout **out_layout,
                                      kg_error *error) KG_CHECKED;
KG_API void kg_net_layout_destroy(kg_net_layout *layout);

/* ---- writing ---------------------------------------------------------------------------- */

/* Draws the net as `path` says: .svg and .dxf (one file a page, NAME-1, NAME-2 … when there are
 * several), .pdf (all pages in one). "-" writes one SVG page to standard output. Files are all
 * written or none. On a machine without fonts PDF and outlined text show digits only. Errors:
 * KG_ERR_INPUT (unknown ending, options), KG_ERR_IO, KG_ERR_MEMORY. */
KG_API kg_status kg_net_draw(const kg_net *net, const kg_net_layout *layout,
                             const kg_net_options *options, const char *path,
                             kg_error *error) KG_CHECKED;

/* A remark on the model for the report: `code` is a short fixed word, `message` a sentence. */
typedef struct kg_net_warning {
    int64_t source; /* id of the patch, 0: none */
    const char *code;
    const char *message;
} kg_net_warning;

/* What `katagami net --json` writes: counts, lengths and areas of the net, its parts and joins with
 * their exact measures, warnings. JSON text with a line break at its end; free() it. `tab_overlaps`
 * is how many parts have tabs that lie on paper, their own or others'. `layout` NULL: pages are 0.
 * Errors: KG_ERR_MEMORY. */
KG_API kg_status kg_net_report(const kg_net *net, const kg_net_layout *layout,
                               const kg_net_warning *warnings, size_t warning_count,
                               int tab_overlaps, char **out_json, kg_error *error) KG_CHECKED;

/* kg_net_layout_create and kg_net_draw in one; the layout goes to `out_layout` when that is not
 * NULL (the caller destroys it). */
KG_API kg_status kg_net_write(const kg_net *net, const kg_net_options *options,
                              const kg_progress *progress, const char *path,
                              kg_net_layout **out_layout, kg_error *error) KG_CHECKED;

#ifdef __cplusplus
}
#endif
#endif
