/* Pop-up cards. */
#include "app/commands/commands.h"
#include "app/modes/card_expect.h"
#include "app/modes/card_net.h"
#include "app/modes/card_scene.h"
#include "app/modes/card_state.h"
#include "app/modes/card_words.h"
#include "app/modes/modes.h"
#include "app/panels/card_panels.h"
#include "app/panels/panels.h"
#include "app/text.h"
#include "app/tools/tool.h"

#include <stdlib.h>

/* Of the height of the side, the part for the card itself. */
#define CARD_SHARE 0.66

static bool tick(kg_editor *e, double seconds) {
    kg_card_state *s = kg_card_state_of(e);
    if (kg_ui_has_mouse() && !s->painting_net) /* the pointer is over a panel */
        s->hovering = false;
    return kg_card_tick(e, seconds);
}

static const char *context_menu(const kg_editor *e) {
    return kg_card_state_of(e)->boxed
               ? "card.add card.remove - card.window card.fill_windows card.top - "
                 "view.frame_selection"
               : "card.add card.remove card.pull - card.window card.top - card.plane "
                 "card.symmetry - view.frame_all";
}

static void toolbar(kg_app *app) {
    kg_editor *e = &app->editor;
    const kg_card_state *s = kg_card_state_of(e);
    kg_panel_tool_button(e, "card.brush_add", KG_ICON_VOXEL_ADD, s->brush == KG_BRUSH_ADD);
    kg_panel_tool_button(e, "card.brush_remove", KG_ICON_VOXEL_REMOVE, s->brush == KG_BRUSH_REMOVE);
    kg_panel_tool_button(e, "card.pull", KG_ICON_PULL, s->brush == KG_BRUSH_PULL);
    kg_panel_tool_button(e, "card.brush_window", KG_ICON_WINDOW, s->brush == KG_BRUSH_WINDOW);
    kg_panel_tool_button(e, "card.brush_top", KG_ICON_TOP, s->brush == KG_BRUSH_TOP);
    kg_ui_separator();
    kg_panel_tool_button(e, "card.symmetry", KG_ICON_MIRROR, s->symmetric);
    kg_panel_tool_button(e, "card.plane", s->level ? KG_ICON_PLANE_LEVEL : KG_ICON_PLANE_UPRIGHT,
                         false);
    kg_ui_separator();
    kg_panel_tool_button(e, "card.play", s->playing ? KG_ICON_STOP : KG_ICON_PLAY, s->playing);
}

static void side(kg_app *app, kg_area area) {
    double card = floor(CARD_SHARE * area.height);
    kg_panel_card(app, (kg_area){area.x, area.y, area.width, card});
    kg_panel_card_remarks(app, (kg_area){area.x, area.y + card, area.width, area.height - card});
    kg_panel_card_opening(app);
}

const kg_mode kg_card_mode = {
    .kind = KG_DOCUMENT_OA,
    .title = N_("pop-up card"),
    .tool = &kg_tool_voxel,
    .create = kg_card_state_create,
    .destroy = free,
    .follow = kg_card_follow,
    .tick = tick,
    .box = kg_card_scene_box,
    .compose = kg_card_scene_compose,
    .drop = kg_card_scene_drop,
    .menu = {N_("Card"),
             "card.add card.remove card.pull card.window card.top - card.brush_add "
             "card.brush_remove card.brush_window card.brush_top - card.symmetry card.mirror_now "
             "card.plane - card.fill_windows card.omit_thin card.diagonals "
             "card.stabilize card.cover - card.open card.open_more card.open_less card.play - "
             "card.clear"},
    .context = context_menu,
    .toolbar = toolbar,
    .side = side,
    .net_event = kg_card_net_event,
    .net_draw = kg_card_net_draw,
    .verdict = kg_card_verdict,
    .expect = kg_card_expect,
};
