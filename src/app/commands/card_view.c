/* Commands: the cursor, the brush and the opening of pop-up cards. They change no document. */
#include "app/commands/arguments.h"
#include "app/commands/commands.h"
#include "app/modes/card_state.h"
#include "app/text.h"

#define DEGREE (KG_PI / 180)

/* A step of the keys, degrees. */
#define STEP 5

static kg_status brush(kg_editor *e, kg_brush kind) {
    kg_card_state_of(e)->brush = kind;
    return KG_OK;
}

#define BRUSH(name, kind)                                                                          \
    static kg_status name(kg_editor *e, const json_t *a, kg_error *error) {                        \
        (void)a, (void)error;                                                                      \
        return brush(e, kind);                                                                     \
    }
BRUSH(brush_add, KG_BRUSH_ADD)
BRUSH(brush_remove, KG_BRUSH_REMOVE)
BRUSH(brush_window, KG_BRUSH_WINDOW)
BRUSH(brush_top, KG_BRUSH_TOP)

static kg_status plane(kg_editor *e, const json_t *a, kg_error *error) {
    kg_card_state *s = kg_card_state_of(e);
    bool level = !s->level;
    kg_status status = kg_argument_bool(a, "horizontal", &level, error);
    if (!status)
        s->level = level;
    return status;
}

static kg_status symmetry(kg_editor *e, const json_t *a, kg_error *error) {
    kg_card_state *s = kg_card_state_of(e);
    bool on = !s->symmetric;
    kg_status status = kg_argument_bool(a, "on", &on, error);
    if (!status)
        s->symmetric = on;
    return status;
}

static kg_status cursor(kg_editor *e, const json_t *a, kg_error *error) {
    kg_card_state *s = kg_card_state_of(e);
    kg_vec3 v = {s->cursor.x, s->cursor.y, s->cursor.z};
    kg_status status = kg_argument_number(a, "x", &v.x, error);
    if (!status)
        status = kg_argument_number(a, "y", &v.y, error);
    if (!status)
        status = kg_argument_number(a, "z", &v.z, error);
    if (status)
        return status;
    double limit = KG_OA_MAX_SIZE;
    kg_card_move_cursor(e, (kg_spot){(int)fmin(fmax(v.x, 0), limit), (int)fmin(fmax(v.y, 0), limit),
                                     (int)fmin(fmax(v.z, 0), limit)});
    return KG_OK;
}

static kg_status select_box(kg_editor *e, const json_t *a, kg_error *error) {
    kg_card_state *s = kg_card_state_of(e);
    kg_vec3 from = {0, 0, 0}, to = from;
    kg_status status = kg_argument_vec3(a, "from", &from, error);
    if (!status)
        status = kg_argument_vec3(a, "to", &to, error);
    if (status)
        return status;
    double limit = KG_OA_MAX_SIZE;
    kg_card_move_cursor(e, (kg_spot){(int)fmin(fmax(from.x, 0), limit),
                                     (int)fmin(fmax(from.y, 0), limit),
                                     (int)fmin(fmax(from.z, 0), limit)});
    s->anchor = s->cursor;
    kg_card_move_cursor(e,
                        (kg_spot){(int)fmin(fmax(to.x, 0), limit), (int)fmin(fmax(to.y, 0), limit),
                                  (int)fmin(fmax(to.z, 0), limit)});
    s->box = kg_spots_between(s->anchor, s->cursor);
    s->boxed = true;
    return KG_OK;
}

/* ---- opening ---------------------------------------------------------------------------- */

static kg_status open_to(kg_editor *e, const json_t *a, kg_error *error) {
    double degrees = 90;
    kg_status status = kg_argument_number(a, "degrees", &degrees, error);
    if (!status && !(degrees >= 0 && degrees <= 180))
        status = kg_fail(error, KG_ERR_INPUT, "\"degrees\" has to be 0 to 180");
    if (status)
        return status;
    kg_card_play(e, false);
    kg_card_open(e, degrees * DEGREE);
    return KG_OK;
}

/* To the next whole step, so that a few presses lead from anywhere to 0, 90 and 180. */
static kg_status open_by(kg_editor *e, double steps) {
    double now = kg_card_state_of(e)->open / DEGREE / STEP;
    kg_card_play(e, false);
    kg_card_open(e, STEP * DEGREE *
                        (steps > 0 ? floor(now + 1e-6) + steps : ceil(now - 1e-6) + steps));
    return KG_OK;
}
static kg_status open_more(kg_editor *e, const json_t *a, kg_error *error) {
    (void)a, (void)error;
    return open_by(e, 1);
}
static kg_status open_less(kg_editor *e, const json_t *a, kg_error *error) {
    (void)a, (void)error;
    return open_by(e, -1);
}

static kg_status play(kg_editor *e, const json_t *a, kg_error *error) {
    bool on = !kg_card_state_of(e)->playing;
    kg_status status = kg_argument_bool(a, "on", &on, error);
    if (!status)
        kg_card_play(e, on);
    return status;
}

static const kg_app_command items[] = {
    {"card.brush_add", N_("Brush: add"), N_("A drag fills voxels."), "A", NULL, brush_add, NULL, 0},
    {"card.brush_remove", N_("Brush: remove"), N_("A drag takes voxels away."), "R", NULL,
     brush_remove, NULL, 0},
    {"card.brush_window", N_("Brush: windows"), N_("A drag makes windows, or closes them."),
     "Shift+W", NULL, brush_window, NULL, 0},
    {"card.brush_top", N_("Brush: tops"), N_("A drag leaves tops out, or puts them back."),
     "Shift+T", NULL, brush_top, NULL, 0},
    {"card.plane", N_("Vertical or horizontal plane"),
     N_("Changes the plane in which arrows and drags move."), "Space", NULL, plane, NULL, 0},
    {"card.symmetry", N_("Mirror symmetry"), N_("Edits are also done on the other side."), "M",
     NULL, symmetry, NULL, 0},
    {"card.cursor", N_("Move the cursor"), N_("Puts the cursor at a voxel."), NULL, NULL, cursor,
     NULL, KG_COMMAND_HIDDEN},
    {"card.select", N_("Select a box"), N_("Selects a box of voxels."), NULL, NULL, select_box,
     NULL, KG_COMMAND_HIDDEN},
    {"card.open", N_("Stand at 90°"), N_("Opens the card by a right angle."), "0", NULL, open_to,
     NULL, 0},
    {"card.open_more", N_("Open"), N_("Opens the card by 5°."), "]", NULL, open_more, NULL, 0},
    {"card.open_less", N_("Close"), N_("Closes the card by 5°."), "[", NULL, open_less, NULL, 0},
    {"card.play", N_("Play"), N_("Closes and opens the card once, or stops."), "P", NULL, play,
     NULL, 0},
};
const kg_command_table kg_card_view_commands = {items, sizeof items / sizeof *items,
                                                KG_FOR_KIND(KG_DOCUMENT_OA)};
