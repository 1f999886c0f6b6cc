/* Commands: looking at the model. */
#include "app/commands/commands.h"
#include "app/text.h"

static kg_status look(kg_editor *e, kg_view view) {
    kg_camera_look(&e->pane.camera, view);
    e->pane.camera.ortho = true;
    return KG_OK;
}

#define LOOK(name, view)                                                                           \
    static kg_status name(kg_editor *e, const json_t *a, kg_error *error) {                        \
        (void)a, (void)error;                                                                      \
        return look(e, view);                                                                      \
    }
LOOK(look_front, KG_VIEW_FRONT)
LOOK(look_back, KG_VIEW_BACK)
LOOK(look_right, KG_VIEW_RIGHT)
LOOK(look_left, KG_VIEW_LEFT)
LOOK(look_top, KG_VIEW_TOP)
LOOK(look_bottom, KG_VIEW_BOTTOM)

static kg_status look_oblique(kg_editor *e, const json_t *a, kg_error *error) {
    (void)a, (void)error;
    kg_camera_look(&e->pane.camera, KG_VIEW_ISO);
    e->pane.camera.ortho = false;
    return KG_OK;
}

static kg_status toggle_ortho(kg_editor *e, const json_t *a, kg_error *error) {
    (void)a, (void)error;
    e->pane.camera.ortho = !e->pane.camera.ortho;
    return KG_OK;
}

static kg_status frame_selection(kg_editor *e, const json_t *a, kg_error *error) {
    (void)a, (void)error;
    kg_box3 box = kg_editor_box(e, true);
    kg_pane_fit(&e->pane, box.lo.x <= box.hi.x ? box : kg_editor_box(e, false));
    return KG_OK;
}

static kg_status frame_all(kg_editor *e, const json_t *a, kg_error *error) {
    (void)a, (void)error;
    kg_pane_fit(&e->pane, kg_editor_box(e, false));
    return KG_OK;
}

static const kg_app_command items[] = {
    {"view.front", N_("Front view"), N_("Looks along +y."), "Numpad 1|Alt+1", "Numpad 1",
     look_front, NULL, 0},
    {"view.back", N_("Back view"), N_("Looks along -y."), "Ctrl+Numpad 1|Ctrl+Alt+1",
     "Ctrl+Numpad 1", look_back, NULL, 0},
    {"view.right", N_("Right view"), N_("Looks from the right."), "Numpad 3|Alt+3", "Numpad 3",
     look_right, NULL, 0},
    {"view.left", N_("Left view"), N_("Looks from the left."), "Ctrl+Numpad 3|Ctrl+Alt+3",
     "Ctrl+Numpad 3", look_left, NULL, 0},
    {"view.top", N_("Top view"), N_("Looks down."), "Numpad 7|Alt+7", "Numpad 7", look_top, NULL,
     0},
    {"view.bottom", N_("Bottom view"), N_("Looks up."), "Ctrl+Numpad 7|Ctrl+Alt+7", "Ctrl+Numpad 7",
     look_bottom, NULL, 0},
    {"view.oblique", N_("Oblique view"), N_("Looks from above at a corner."), "Numpad 0|Alt+0",
     "Numpad 0", look_oblique, NULL, 0},
    {"view.ortho", N_("Perspective or parallel"), N_("Changes the projection."), "5|Numpad 5",
     "Numpad 5", toggle_ortho, NULL, 0},
    {"view.frame_selection", N_("Frame selection"), N_("Fills the view with what is selected."),
     "F", "Numpad .", frame_selection, NULL, 0},
    {"view.frame_all", N_("Frame all"), N_("Fills the view with everything."), "Home", NULL,
     frame_all, NULL, 0},
};
const kg_command_table kg_view_commands = {items, sizeof items / sizeof *items, 0};
