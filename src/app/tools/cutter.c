#include "app/tools/cutter.h"

#include "app/commands/commands.h"
#include "app/modes/patch_scene.h"
#include "app/scenery.h"
#include "app/text.h"
#include "app/tools/tool.h"
#include "app/tools/tools.h"

#include <stdlib.h>

/* Crossings are shown to half a pixel; where the trim is made they are found to its tolerance. */
#define PREVIEW_TOLERANCE KG_EDITOR_CHORD

static const kg_solved_patch *prepared(const kg_editor *e, int64_t id) {
    const kg_solved_patch *s = kg_solution_find(kg_editor_solution(e), id);
    return s && s->prepared ? s : NULL;
}

int64_t kg_cutter_hovered(const kg_editor *e) {
    int64_t red = kg_editor_first_selected(e);
    bool other = e->hover_patch && red && !kg_editor_is_selected(e, e->hover_patch);
    return other ? e->hover_patch : 0;
}

static const kg_cutter_crossing *find(const kg_cutter_preview *preview, int64_t patch) {
    for (size_t i = 0; i < preview->count; i++)
        if (preview->items[i].patch == patch)
            return &preview->items[i];
    return NULL;
}

bool kg_cutter_preview_meets(const kg_cutter_preview *preview, int64_t patch) {
    const kg_cutter_crossing *c = find(preview, patch);
    return !c || c->line_count > 0;
}

static void take_lines(const kg_crossings *from, kg_cutter_crossing *to) {
    size_t count = from->count < KG_CUTTER_LINES ? from->count : KG_CUTTER_LINES, total = 0;
    for (size_t i = 0; i < count; i++)
        total += from->branches[i].count + 2;
    size_t step = total / KG_CUTTER_POINTS + 1, n = 0;
    for (size_t i = 0; i < count; i++) {
        const kg_crossing *branch = &from->branches[i];
        size_t last = branch->closed ? branch->count : branch->count - 1;
        if (n + last / step + 2 > KG_CUTTER_POINTS)
            break;
        for (size_t k = 0; k < last; k += step)
            to->points[n++] = branch->points[k].x;
        to->points[n++] = branch->points[last % branch->count].x;
        to->starts[++to->line_count] = n;
    }
}

/* The crossing with a patch, from before or found now; NULL: there is none to be shown. */
static const kg_cutter_crossing *follow(kg_cutter_preview *preview, const kg_editor *e,
                                        int64_t patch) {
    const kg_cutter_crossing *known = find(preview, patch);
    const kg_solved_patch *red = prepared(e, preview->red), *cutter = prepared(e, patch);
    if (known || !red || !cutter)
        return known;
    if (preview->count == KG_CUTTER_MOST)
        preview->count = 0; /* others were hovered before */
    kg_cutter_crossing *c = &preview->items[preview->count++];
    kg_crossings found;
    c->patch = patch;
    c->line_count = 0;
    c->starts[0] = 0;
    if (!kg_crossings_find(&red->patch, &cutter->patch, PREVIEW_TOLERANCE, &found, NULL)) {
        take_lines(&found, c);
        kg_crossings_clear(&found);
    } /* else they coincide, and nothing would be cut */
    return c;
}

static void draw_crossing(const kg_cutter_crossing *c, kg_overlay *overlay) {
    kg_style rim = kg_line_style((kg_color){0.1F, 0.1F, 0.12F, 1}, 6);
    kg_style core = kg_line_style((kg_color){1, 0.85F, 0.2F, 1}, 3);
    rim.hidden = 0.5F;
    core.hidden = 0.8F;
    for (size_t i = 0; i < c->line_count; i++) {
        size_t count = c->starts[i + 1] - c->starts[i];
        kg_overlay_line(overlay, &c->points[c->starts[i]], count, rim);
        kg_overlay_line(overlay, &c->points[c->starts[i]], count, core);
    }
}

void kg_cutter_preview_draw(kg_cutter_preview *preview, const kg_editor *e, int64_t hovered,
                            kg_overlay *overlay) {
    int64_t red = kg_editor_first_selected(e);
    if (preview->solved != e->solved || preview->red != red) {
        preview->solved = e->solved;
        preview->red = red;
        preview->count = 0;
    }
    if (!red)
        return;
    const kg_solved_patch *s = hovered ? prepared(e, hovered) : NULL;
    if (s)
        kg_patch_rectangle_draw(overlay, &s->patch, kg_rank_color(1));
    const kg_cutter_crossing *c = s ? follow(preview, e, hovered) : NULL;
    if (c)
        draw_crossing(c, overlay);
    for (size_t i = 1; i < e->selection.patches.count; i++)
        if ((c = follow(preview, e, e->selection.patches.items[i])))
            draw_crossing(c, overlay);
}

/* ---- the tool: a click names the cutter ---------------------------------------------------- */

static void hover(kg_editor *e, kg_vec2 px) {
    enum { MOST_HITS = 32 };
    kg_hit hits[MOST_HITS];
    size_t count = kg_editor_hits(e, px, hits, MOST_HITS);
    e->hover_patch = 0;
    for (size_t i = 0; i < count && !e->hover_patch; i++)
        if (!kg_editor_is_selected(e, hits[i].patch))
            e->hover_patch = hits[i].patch;
}

static bool on_event(kg_editor *e, const kg_event *event) {
    switch (event->type) {
    case KG_EVENT_MOVE:
        hover(e, event->position);
        return true;
    case KG_EVENT_PRESS: {
        if (event->button != KG_MOUSE_LEFT)
            return false;
        hover(e, event->position);
        int64_t cutter = kg_cutter_hovered(e);
        if (!cutter)
            return true;
        kg_editor_use_default(e);
        kg_editor_select(e, cutter, true);
        kg_command_do(e, "trim.by");
        return true;
    }
    case KG_EVENT_KEY:
        if (event->key != KG_KEY_ESCAPE)
            return false;
        kg_editor_use_default(e);
        return true;
    default:
        return false;
    }
}

static void draw(const kg_editor *e, kg_overlay *overlay) {
    kg_cutter_preview_draw(e->tool_state, e, kg_cutter_hovered(e), overlay);
}

static const char *hint_now(const kg_editor *e) {
    int64_t hovered = kg_cutter_hovered(e);
    return hovered && !kg_cutter_preview_meets(e->tool_state, hovered)
               ? _("This patch does not meet the red one, so it cannot trim it.")
               : NULL;
}

kg_status kg_tool_start_cutter(kg_editor *e, kg_error *error) {
    kg_cutter_preview *preview = calloc(1, sizeof *preview);
    if (!preview)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    kg_editor_use(e, &kg_tool_cutter, preview);
    hover(e, e->pointer);
    return KG_OK;
}

const kg_tool kg_tool_cutter = {
    "cutter",
    N_("Choose the cutter"),
    N_("Click the patch that trims the red one   Esc: no trim"),
    on_event,
    draw,
    hint_now,
    NULL,
};
