/* Dragging control points and edges by the mouse. */
#ifndef KG_APP_TOOLS_DRAG_H
#define KG_APP_TOOLS_DRAG_H

#include "app/editor.h"
#include "app/overlay.h"

/* Some selected points, moved together. */
typedef struct kg_point_drag {
    kg_point_ref held; /* the one under the pointer */
    kg_vec3 start;     /* where it was */
    kg_vec2 pressed;
    int axis;        /* it moves along this one only, 0 x, 1 y, 2 z; -1: none */
    bool on_surface; /* it slides on the reference */
    kg_vec3 foot;    /* nearest to it on the reference, at the start */
    double lift;     /* from there along the normal */
    kg_vec2 aim;     /* the pointer, fine movements taken in */
    kg_vec2 last;    /* the pointer */
    unsigned mods;
} kg_point_drag;

/* Opens a step. */
kg_status kg_point_drag_start(kg_point_drag *drag, kg_editor *editor, kg_point_ref held, kg_vec2 px,
                              kg_error *error) KG_CHECKED;
/* On the reference at its distance; Alt: in the screen plane; Ctrl: whole steps; Shift: a tenth of
 * the way. */
void kg_point_drag_move(kg_point_drag *drag, kg_editor *editor, kg_vec2 px, unsigned mods);

/* Along one axis only, 0 x, 1 y, 2 z; the same once more: free again. */
void kg_point_drag_lock(kg_point_drag *drag, kg_editor *editor, int axis);

/* One of the two edges u = extent of a patch, along its ruling. */
typedef struct kg_extent_drag {
    int64_t patch;
    int side;                   /* 0 low, 1 high */
    kg_vec2 pressed, aim, last; /* as above */
    double start;               /* the extent at the press */
    kg_vec2 along;              /* pixels per mm, along the ruling */
} kg_extent_drag;

/* True when a handle lies under `px`; a step is open then. */
bool kg_extent_drag_start(kg_extent_drag *drag, kg_editor *editor, kg_vec2 px);
void kg_extent_drag_move(kg_extent_drag *drag, kg_editor *editor, kg_vec2 px, unsigned mods);
/* Drops the hover of a patch where a handle is nearer. */
void kg_extent_drag_hover(kg_editor *editor, kg_vec2 px);
bool kg_extent_is_hovered(const kg_editor *editor);
void kg_extent_drag_draw(const kg_editor *editor, kg_overlay *overlay);

/* The edges of regression of the selected patches: beyond them the paper would fold back. */
void kg_legal_band_draw(const kg_editor *editor, kg_overlay *overlay);

/* While a box is being drawn: where it began. */
bool kg_select_box_now(const kg_editor *editor, kg_vec2 *out_from);

/* The line through a point along an axis, 0 x, 1 y, 2 z, in the axis' colour. */
void kg_axis_draw(const kg_editor *editor, kg_vec3 through, int axis, kg_overlay *overlay);

/* `x` rounded to whole steps of the settings. */
double kg_round_to_step(const kg_editor *editor, double x);

#endif
