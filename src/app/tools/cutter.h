/* Before a trim: the rectangles that would cut the first selected patch, and where they meet it. */
#ifndef KG_APP_TOOLS_CUTTER_H
#define KG_APP_TOOLS_CUTTER_H

#include "app/editor.h"
#include "app/overlay.h"

/* So many crossings are kept; of those with more points than these only some are taken. */
enum { KG_CUTTER_MOST = 6, KG_CUTTER_LINES = 16, KG_CUTTER_POINTS = 512 };

typedef struct kg_cutter_crossing {
    int64_t patch;
    size_t line_count;
    size_t starts[KG_CUTTER_LINES + 1]; /* of lines among the points, and one more */
    kg_vec3 points[KG_CUTTER_POINTS];
} kg_cutter_crossing;

/* Crossings of the first selected patch with those that may cut it; found once per solution. */
typedef struct kg_cutter_preview {
    uint64_t solved;
    int64_t red;
    size_t count;
    kg_cutter_crossing items[KG_CUTTER_MOST];
} kg_cutter_preview;

/* The patch under the pointer, when a click would make it a cutter of the first selected one; 0:
 * none. */
int64_t kg_cutter_hovered(const kg_editor *editor);

/* The patches selected after the first, and `hovered` (0: none). */
void kg_cutter_preview_draw(kg_cutter_preview *preview, const kg_editor *editor, int64_t hovered,
                            kg_overlay *overlay);
/* False when a patch drawn before does not meet the first selected one. */
bool kg_cutter_preview_meets(const kg_cutter_preview *preview, int64_t patch);

#endif
