/*
 * Tools: what the mouse and the keys do in the 3D view. One file each; the editor uses one at a
 * time. A tool keeps its state in editor->tool_state.
 */
#ifndef KG_APP_TOOLS_TOOL_H
#define KG_APP_TOOLS_TOOL_H

#include "app/editor.h"
#include "app/overlay.h"

struct kg_tool {
    const char *id;
    const char *title; /* marked for translation */
    const char *hint;  /* one line for the status bar, marked for translation */
    /* True: the event is used up. Keys come here before the commands' shortcuts. */
    bool (*event)(kg_editor *editor, const kg_event *event);
    /* Adds what the tool shows; may be NULL. */
    void (*draw)(const kg_editor *editor, kg_overlay *overlay);
    /* The hint of the moment, else NULL; may be NULL. */
    const char *(*hint_now)(const kg_editor *editor);
    /* Before the tool is left, for whatever reason; may be NULL. An open step is cancelled. */
    void (*end)(kg_editor *editor);
};

extern const kg_tool kg_tool_select;
extern const kg_tool kg_tool_place;
extern const kg_tool kg_tool_transform;
extern const kg_tool kg_tool_cutter;
extern const kg_tool kg_tool_pieces;
extern const kg_tool kg_tool_contour;
extern const kg_tool kg_tool_fold;
extern const kg_tool kg_tool_sheets;
extern const kg_tool kg_tool_voxel;

#endif
