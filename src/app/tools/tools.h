/* How commands start the tools that need more than a click. */
#ifndef KG_APP_TOOLS_TOOLS_H
#define KG_APP_TOOLS_TOOLS_H

#include "app/editor.h"

/* Clicks place the control points of a new patch. */
kg_status kg_tool_start_place(kg_editor *editor, kg_error *error) KG_CHECKED;

typedef enum kg_transform_kind {
    KG_TRANSFORM_MOVE,
    KG_TRANSFORM_ROTATE,
    KG_TRANSFORM_SCALE
} kg_transform_kind;

/* The pointer moves, turns or scales the selection until a click. KG_ERR_INPUT: nothing is
 * selected. */
kg_status kg_tool_start_transform(kg_editor *editor, kg_transform_kind kind,
                                  kg_error *error) KG_CHECKED;

/* The same while the left button is held, along or about an axis (0 … 2, -1: none). */
kg_status kg_tool_hold_transform(kg_editor *editor, kg_transform_kind kind, int axis,
                                 kg_error *error) KG_CHECKED;

/* The middle of what is selected, points at their level, else patches. */
kg_vec3 kg_selection_center(const kg_editor *editor);

/* A click names the patch that trims the selected one, and trims it. */
kg_status kg_tool_start_cutter(kg_editor *editor, kg_error *error) KG_CHECKED;

/* A step that adds a trim to `patch` is open; a click chooses the pieces that stay. Then the `rest`
 * of the cutters, a copy of which is kept, trim it in their turn. */
kg_status kg_tool_start_pieces(kg_editor *editor, int64_t patch, const int64_t *rest, size_t count,
                               kg_error *error) KG_CHECKED;

/* The same where the trim has several faces to choose from and so no piece yet: a click on the
 * patch's rectangle names one. */
kg_status kg_tool_start_face(kg_editor *editor, int64_t patch, kg_error *error) KG_CHECKED;

/* Clicks draw a contour on a patch. */
kg_status kg_tool_start_contour(kg_editor *editor, int64_t patch, kg_error *error) KG_CHECKED;

#endif
