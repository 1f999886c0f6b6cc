/*
 * Widgets, drawn anew every frame: the only door to Dear ImGui, which the C++ files of this folder
 * alone include.
 *
 * Between kg_ui_begin and kg_ui_end each call shows a widget and tells at once what the user did
 * with it. Labels identify widgets: "Name##3" shows "Name". Lengths are layout units (pixels
 * without HiDPI) unless they end in _px; positions on canvases are pixels of the framebuffer.
 */
#ifndef KG_APP_UI_H
#define KG_APP_UI_H

#include "app/event.h"
#include "katagami/render.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct kg_area {
    double x, y, width, height; /* pixels, from the upper left corner */
} kg_area;

static inline bool kg_area_contains(kg_area a, kg_vec2 p) {
    return p.x >= a.x && p.x < a.x + a.width && p.y >= a.y && p.y < a.y + a.height;
}

typedef enum kg_ui_theme { KG_UI_DARK, KG_UI_LIGHT } kg_ui_theme;

/* ---- life ------------------------------------------------------------------------------- */

/* Starts in the current OpenGL context. Fonts: the first Japanese one installed, else a Latin one,
 * else ImGui's own. There is one user interface per process. */
kg_status kg_ui_create(kg_error *error) KG_CHECKED;
void kg_ui_destroy(void);

/* Takes effect at the next frame. */
void kg_ui_set_look(kg_ui_theme theme, double scale);

/* Text to and from other programs; without these it stays inside. */
void kg_ui_set_clipboard(void *user, const char *(*get)(void *user),
                         void (*set)(void *user, const char *text));

/* ---- frames ----------------------------------------------------------------------------- */

/* Starts a frame after `event`, `seconds` after the one before. */
void kg_ui_begin(const kg_event *event, int width_px, int height_px, double seconds);
/* Whether the event just given belongs to the widgets and not to what lies behind them. */
bool kg_ui_has_mouse(void);
bool kg_ui_has_keys(void);
void kg_ui_end(void);
/* Draws the last frame into the bound framebuffer. */
void kg_ui_draw(void);
/* Whether another frame is needed before the picture is right (new glyphs, new windows). */
bool kg_ui_unsettled(void);

typedef enum kg_ui_cursor {
    KG_CURSOR_ARROW,
    KG_CURSOR_TEXT,
    KG_CURSOR_MOVE,
    KG_CURSOR_RESIZE_X,
    KG_CURSOR_RESIZE_Y,
    KG_CURSOR_HAND
} kg_ui_cursor;
kg_ui_cursor kg_ui_get_cursor(void);

/* Where the last frame showed the widget of this label (what is before "##"); for scripts. */
bool kg_ui_find(const char *label, kg_area *out_area);

/* ---- windows ---------------------------------------------------------------------------- */

enum {
    KG_PANEL_PLAIN = 1, /* no padding around the content */
    KG_PANEL_NO_SCROLL = 2,
    KG_PANEL_SEE_THROUGH = 4
};
/* A fixed window; end it always. `title` may be NULL. */
void kg_ui_panel_begin(const char *id, const char *title, kg_area area, unsigned flags);
void kg_ui_panel_end(void);

/* A child that scrolls by itself; height 0: the rest of the window, negative: all but that. */
void kg_ui_child_begin(const char *id, double height);
void kg_ui_child_end(void);

void kg_ui_popup_open(const char *id);
/* Popups close by a click beside them, modal ones by kg_ui_popup_close. End them when true. */
bool kg_ui_popup_begin(const char *id);
bool kg_ui_modal_begin(const char *id, double width);
/* Open a modal at the top of the window, for the palette. */
bool kg_ui_palette_begin(const char *id, double width);
void kg_ui_popup_end(void);
void kg_ui_popup_close(void);
bool kg_ui_any_popup(void);

bool kg_ui_menu_bar_begin(void);
double kg_ui_menu_bar_end(void); /* its height, pixels */
bool kg_ui_menu_begin(const char *label);
void kg_ui_menu_end(void);
bool kg_ui_menu_item(const char *label, const char *shortcut, bool checked, bool enabled);

/* ---- layout ----------------------------------------------------------------------------- */

void kg_ui_same_line(void);
void kg_ui_right(double width); /* continues the line so that `width` is left on its right */
void kg_ui_separator(void);
void kg_ui_space(void);
void kg_ui_indent(void);
void kg_ui_unindent(void);
void kg_ui_width(double width); /* of the next widget; -1: all that is left */
double kg_ui_available(void);   /* width left on this line */
double kg_ui_text_width(const char *text);
double kg_ui_line_height_px(void);
void kg_ui_id_push(int64_t id);
void kg_ui_id_pop(void);
void kg_ui_disabled_begin(bool disabled);
void kg_ui_disabled_end(void);
bool kg_ui_section(const char *label, bool open); /* a heading that folds what follows */

/* Columns; widths 0 share what is left. */
bool kg_ui_table_begin(const char *id, int columns, const double *widths);
void kg_ui_table_row(void);
void kg_ui_table_next(void);
void kg_ui_table_end(void);

/* ---- widgets ---------------------------------------------------------------------------- */

void kg_ui_text(const char *text);
void kg_ui_text_dim(const char *text);
void kg_ui_text_wrapped(const char *text);
void kg_ui_text_color(kg_color color, const char *text);
/* A text that can be clicked. */
bool kg_ui_link(kg_color color, const char *text);

bool kg_ui_button(const char *label);
bool kg_ui_primary_button(const char *label); /* Enter presses it too */
bool kg_ui_small_button(const char *label);
bool kg_ui_check(const char *label, bool *value);
bool kg_ui_radio(const char *label, bool on);
bool kg_ui_choice(const char *label, const char *const *items, int count, int *index);
bool kg_ui_selectable(const char *label, bool selected);
/* The same in as many lines as it takes, and how many these are in a width. */
bool kg_ui_selectable_lines(const char *label, bool selected);
size_t kg_ui_line_count(const char *text, double width);
/* The same as high as wanted, to draw into; buttons may lie on it. */
bool kg_ui_row(const char *label, bool selected, double height, kg_area *out_area);
void kg_ui_progress(double fraction, const char *text);
void kg_ui_tooltip(const char *text); /* for the widget before it */

/* What happened to a field whose change is one step in the history. */
enum {
    KG_FIELD_BEGAN = 1,   /* the user took hold of it */
    KG_FIELD_CHANGED = 2, /* its value is another */
    KG_FIELD_ENDED = 4,   /* the user let go after changing it */
    KG_FIELD_LEFT = 8     /* the user let go without changing it */
};
unsigned kg_ui_number(const char *label, double *value, double speed, double lo, double hi,
                      const char *format);
/* A number and small arrows to step it. */
unsigned kg_ui_slider(const char *label, double *value, double lo, double hi, const char *format);
unsigned kg_ui_color_field(const char *label, kg_color *color);
/* `hint` shows while the field is empty; `focus` takes the keyboard. */
unsigned kg_ui_text_field(const char *label, char *text, size_t size, const char *hint, bool focus);
/* True when Enter was pressed in the text field before. */
bool kg_ui_field_entered(void);

typedef enum kg_icon {
    KG_ICON_EYE,
    KG_ICON_EYE_OFF,
    KG_ICON_FLIP,
    KG_ICON_UP,
    KG_ICON_DOWN,
    KG_ICON_REMOVE,
    KG_ICON_SELECT,
    KG_ICON_PLACE,
    KG_ICON_MOVE,
    KG_ICON_ROTATE,
    KG_ICON_SCALE,
    KG_ICON_TRIM,
    KG_ICON_CONTOUR,
    KG_ICON_MIRROR,
    KG_ICON_GUIDE,
    KG_ICON_WARNING,
    KG_ICON_FOLDER,
    KG_ICON_FILE,
    KG_ICON_FOLD_CORNER,
    KG_ICON_FOLD_AXIS,
    KG_ICON_FOLD_BISECT,
    KG_ICON_FOLD_SQUARE,
    KG_ICON_MOUNTAIN,
    KG_ICON_VALLEY,
    KG_ICON_CHECK,
    KG_ICON_VOXEL_ADD,
    KG_ICON_VOXEL_REMOVE,
    KG_ICON_PULL,
    KG_ICON_WINDOW,
    KG_ICON_TOP,
    KG_ICON_PLANE_UPRIGHT,
    KG_ICON_PLANE_LEVEL,
    KG_ICON_PLAY,
    KG_ICON_STOP,
    KG_ICON_FIRST,
    KG_ICON_PREVIOUS,
    KG_ICON_NEXT,
    KG_ICON_LAST,
    KG_ICON_ADD,
    KG_ICON_COPY
} kg_icon;
/* `size` 0: as high as text. */
bool kg_ui_icon_button(const char *label, kg_icon icon, bool on, double size);
void kg_ui_icon(kg_icon icon, kg_color color);

/* Colours the edge of the table cell that begins here. */
void kg_ui_mark(kg_color color);

bool kg_ui_item_hovered(void);
bool kg_ui_item_double_clicked(void);
void kg_ui_scroll_here(void);
/* What the panel is about: another subject is shown from its top. */
void kg_ui_subject(int64_t subject);
bool kg_ui_mouse_held(void);
bool kg_ui_key_pressed(int key); /* in this frame, whoever has the keyboard */

/* ---- canvas: pictures drawn with lines --------------------------------------------------- */

/* Following drawings go behind all windows, above all windows, or into the current window. */
typedef enum kg_canvas { KG_CANVAS_BEHIND, KG_CANVAS_ABOVE, KG_CANVAS_WINDOW } kg_canvas;
void kg_ui_canvas(kg_canvas canvas);
void kg_ui_canvas_clip(kg_area area);
void kg_ui_canvas_unclip(void);
void kg_ui_canvas_line(kg_vec2 a, kg_vec2 b, kg_color color, double width_px);
void kg_ui_canvas_polyline(const kg_vec2 *points, size_t count, bool closed, kg_color color,
                           double width_px);
void kg_ui_canvas_polygon(const kg_vec2 *points, size_t count, kg_color color); /* convex */
void kg_ui_canvas_circle(kg_vec2 center, double radius_px, kg_color color, double width_px);
void kg_ui_canvas_disc(kg_vec2 center, double radius_px, kg_color color);
void kg_ui_canvas_rect(kg_area area, kg_color color, double rounding_px);
void kg_ui_canvas_frame(kg_area area, kg_color color, double width_px, double rounding_px);
/* Text from its upper left corner on. */
void kg_ui_canvas_label(kg_vec2 at, kg_color color, const char *text);
/* Text with its middle at `at`. */
void kg_ui_canvas_text(kg_vec2 at, kg_color color, const char *text);
/* The same turned by `angle` (x towards y) about `at`, which is at half the height of capitals and
 * has `share` of the text before it. */
void kg_ui_canvas_text_turned(kg_vec2 at, double angle, double share, double capital_px,
                              kg_color color, const char *text);
/* Pictures live on the graphics card until they are destroyed, at the latest with the user
 * interface. */
uint32_t kg_ui_picture_create(const kg_image *image);
void kg_ui_picture_destroy(uint32_t picture); /* 0: none */
void kg_ui_canvas_picture(kg_area area, uint32_t picture, double opacity);
/* The colour of text, fainter where it is disabled. */
kg_color kg_ui_text_ink(void);
/* Lets kg_ui_find find something drawn. */
void kg_ui_name(const char *label, kg_area area);
/* An area of the window that takes the mouse, to draw into and to interact with. */
kg_area kg_ui_canvas_area(const char *label, double width, double height);

#ifdef __cplusplus
}
#endif
#endif
