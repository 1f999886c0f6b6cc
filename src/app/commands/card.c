/* Commands: editing pop-up cards. By hand they are about the selected box, else the cursor. */
#include "app/commands/arguments.h"
#include "app/commands/commands.h"
#include "app/modes/card_edit.h"
#include "app/text.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

/* ---- arguments -------------------------------------------------------------------------- */

static kg_status read_int(const json_t *a, const char *name, int *value, kg_error *error) {
    int64_t number = *value;
    kg_status status = kg_argument_id(a, name, &number, error);
    if (!status && (number < INT_MIN / 4 || number > INT_MAX / 4))
        status = kg_fail(error, KG_ERR_INPUT, "\"%s\" is out of range", name);
    if (!status)
        *value = (int)number;
    return status;
}

static kg_status need(const json_t *a, const char *name, int *value, kg_error *error) {
    if (!json_object_get(a, name))
        return kg_fail(error, KG_ERR_INPUT, "\"%s\" is missing", name);
    return read_int(a, name, value, error);
}

static kg_status inside(const kg_editor *e, kg_spot s, kg_error *error) {
    const kg_oa *oa = kg_editor_oa(e);
    if (kg_card_has(oa, s))
        return KG_OK;
    return kg_fail(error, KG_ERR_INPUT, "(%d, %d, %d) is outside the card of %d x %d x %d cells",
                   s.x, s.y, s.z, oa->width, oa->depth_limit, oa->height);
}

/* [x, y, z] */
static kg_status read_spot(const kg_editor *e, const json_t *a, const char *name, kg_spot *out,
                           kg_error *error) {
    const json_t *list = json_object_get(a, name);
    kg_vec3 v;
    kg_status status = list ? kg_argument_vec3(a, name, &v, error)
                            : kg_fail(error, KG_ERR_INPUT, "\"%s\" is missing", name);
    if (status)
        return status;
    if (!(fabs(v.x) < 1e6 && fabs(v.y) < 1e6 && fabs(v.z) < 1e6))
        return kg_fail(error, KG_ERR_INPUT, "\"%s\" is outside the card", name);
    if (v.x != floor(v.x) || v.y != floor(v.y) || v.z != floor(v.z))
        return kg_fail(error, KG_ERR_INPUT, "\"%s\" has to be three whole numbers", name);
    *out = (kg_spot){(int)v.x, (int)v.y, (int)v.z};
    return inside(e, *out, error);
}

/* x, y, z; without arguments what is selected. */
static kg_status read_voxels(const kg_editor *e, const json_t *a, kg_spots *out, kg_error *error) {
    if (!a) {
        *out = kg_card_selected(e);
        return KG_OK;
    }
    kg_status status = need(a, "x", &out->lo.x, error);
    if (!status)
        status = need(a, "y", &out->lo.y, error);
    if (!status)
        status = need(a, "z", &out->lo.z, error);
    out->hi = out->lo;
    return status ? status : inside(e, out->lo, error);
}

/* from, to; without these what is selected, or everything. */
static kg_status read_box(const kg_editor *e, const json_t *a, kg_spots *out, kg_error *error) {
    const kg_oa *oa = kg_editor_oa(e);
    const kg_card_state *s = kg_card_state_of(e);
    kg_spot from, to;
    *out = s->boxed && !a
               ? s->box
               : (kg_spots){{0, 0, 0}, {oa->width - 1, oa->depth_limit - 1, oa->height - 1}};
    if (!json_object_get(a, "from") && !json_object_get(a, "to"))
        return KG_OK;
    kg_status status = read_spot(e, a, "from", &from, error);
    if (!status)
        status = read_spot(e, a, "to", &to, error);
    if (!status)
        *out = kg_spots_between(from, to);
    return status;
}

/* ---- voxels ----------------------------------------------------------------------------- */

static kg_status put(kg_editor *e, const char *label, kg_spots box, bool remove, kg_error *error) {
    kg_status status = kg_editor_begin(e, label, error);
    if (!status)
        kg_card_put(e, box, remove);
    return kg_editor_finish(e, status);
}

static kg_status add(kg_editor *e, const json_t *a, kg_error *error) {
    kg_spots box;
    kg_status status = read_voxels(e, a, &box, error);
    return status ? status : put(e, N_("Add voxels"), box, false, error);
}

/* By hand also where the cursor is before the paper: then what is behind it, and the cursor goes
 * there. */
static kg_status take(kg_editor *e, const json_t *a, kg_error *error) {
    const kg_oa *oa = kg_editor_oa(e);
    kg_spots box;
    kg_status status = read_voxels(e, a, &box, error);
    if (status)
        return status;
    kg_card_state *s = kg_card_state_of(e);
    if (!a && !s->boxed && !kg_card_filled(oa, s->cursor)) {
        kg_spot behind = s->cursor, below = s->cursor;
        behind.y = kg_oa_depth(oa, behind.x, behind.z) - 1;
        while (below.z >= 0 && !kg_card_filled(oa, below))
            below.z--;
        kg_spot found = s->level && below.z >= 0 ? below : behind.y >= 0 ? behind : below;
        if (!kg_card_has(oa, found))
            return kg_fail(error, KG_ERR_INPUT, "There is nothing to remove here.");
        s->cursor = found;
        box = (kg_spots){found, found};
    }
    return put(e, N_("Remove voxels"), box, true, error);
}

static kg_status fill_box(kg_editor *e, const json_t *a, kg_error *error) {
    kg_spots box = {{0, 0, 0}, {0, 0, 0}};
    bool remove = false;
    kg_status status = read_spot(e, a, "from", &box.lo, error);
    if (!status)
        status = read_spot(e, a, "to", &box.hi, error);
    if (!status)
        status = kg_argument_bool(a, "remove", &remove, error);
    if (status)
        return status;
    return put(e, remove ? N_("Remove voxels") : N_("Add voxels"), kg_spots_between(box.lo, box.hi),
               remove, error);
}

static kg_status clear(kg_editor *e, const json_t *a, kg_error *error) {
    const kg_oa *oa = kg_editor_oa(e);
    (void)a;
    return put(e, N_("Empty the card"),
               (kg_spots){{0, 0, 0}, {oa->width - 1, oa->depth_limit - 1, oa->height - 1}}, true,
               error);
}

static kg_status pull(kg_editor *e, const json_t *a, kg_error *error) {
    if (!a) {
        kg_card_state_of(e)->brush = KG_BRUSH_PULL;
        return KG_OK;
    }
    bool top = false;
    int by = 0;
    kg_spot spot = {0};
    kg_status status = kg_argument_bool(a, "top", &top, error);
    if (!status)
        status = need(a, "x", &spot.x, error);
    if (!status)
        status = top ? need(a, "y", &spot.y, error) : need(a, "z", &spot.z, error);
    if (!status)
        status = inside(e, spot, error);
    if (!status)
        status = need(a, "by", &by, error);
    kg_pulled pulled;
    if (!status)
        status = kg_pulled_create(e, spot, top, &pulled, error);
    if (status)
        return status;
    status = kg_editor_begin(e, N_("Pull"), error);
    if (!status)
        kg_card_pull(e, kg_document_oa(e->before), &pulled, pulled.at + by);
    kg_pulled_clear(&pulled);
    return kg_editor_finish(e, status);
}

/* ---- windows and tops ------------------------------------------------------------------- */

static kg_status set_faces(kg_editor *e, const json_t *a, bool top, kg_error *error) {
    const kg_oa *oa = kg_editor_oa(e);
    kg_spots box = kg_card_selected(e);
    kg_status status = KG_OK;
    if (a) {
        status = need(a, "x", &box.lo.x, error);
        if (!status)
            status = need(a, "z", &box.lo.z, error);
        box.lo.z -= top; /* tops are named by their height */
        box.lo.y = 0;
        box.hi = box.lo;
        if (!status)
            status = inside(e, box.lo, error);
    }
    bool on = !status && !kg_card_all_set(e, box, top);
    if (!status)
        status = kg_argument_bool(a, "on", &on, error);
    bool any = false;
    for (int x = box.lo.x; x <= box.hi.x && !status; x++)
        for (int z = box.lo.z; z <= box.hi.z && !any; z++)
            any = top ? kg_oa_top(oa, x, z + 1) > 0 : kg_oa_depth(oa, x, z) > 0;
    if (!status && !any)
        status = kg_fail(error, KG_ERR_INPUT, "%s",
                         top ? _("No top of a block is here.") : _("No front of a block is here."));
    if (!status)
        status = kg_editor_begin(e, top ? N_("Leave out tops") : N_("Windows"), error);
    if (status)
        return status;
    kg_card_set_faces(e, box, top, on);
    kg_editor_commit(e);
    return KG_OK;
}

static kg_status window(kg_editor *e, const json_t *a, kg_error *error) {
    return set_faces(e, a, false, error);
}
static kg_status omit_top(kg_editor *e, const json_t *a, kg_error *error) {
    return set_faces(e, a, true, error);
}

/* ---- automatic -------------------------------------------------------------------------- */

/* All fronts of the box that can be windows become some. */
static kg_status fill_windows(kg_editor *e, const json_t *a, kg_error *error) {
    kg_oa *oa = kg_editor_oa(e);
    kg_spots box;
    kg_status status = read_box(e, a, &box, error);
    if (status)
        return status;
    unsigned char *candidates = calloc((size_t)oa->width * (size_t)oa->height, 1);
    if (!candidates)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    for (int x = box.lo.x; x <= box.hi.x; x++)
        for (int z = box.lo.z; z <= box.hi.z; z++)
            candidates[x * oa->height + z] = kg_oa_depth(oa, x, z) > 0 && !kg_oa_window(oa, x, z);
    status = kg_editor_begin(e, N_("Open windows"), error);
    if (!status) {
        kg_editor_touch(e);
        status = kg_oa_open_windows(oa, candidates, NULL, error);
    }
    free(candidates);
    return kg_editor_finish(e, status);
}

static kg_status omit_thin(kg_editor *e, const json_t *a, kg_error *error) {
    int depth = 1;
    kg_status status = read_int(a, "depth", &depth, error);
    if (!status && depth < 0)
        status = kg_fail(error, KG_ERR_INPUT, "\"depth\" has to be 0 or more");
    if (!status)
        status = kg_editor_begin(e, N_("Leave out thin tops"), error);
    if (status)
        return status;
    kg_editor_touch(e);
    return kg_editor_finish(e, kg_oa_thin_tops(kg_editor_oa(e), depth, error));
}

/* By hand in the background. */
static kg_status stabilize(kg_editor *e, const json_t *a, kg_error *error) {
    kg_oa_mended mended;
    if (!a) {
        e->request = KG_REQUEST_STAND;
        return KG_OK;
    }
    kg_oa *after = kg_oa_copy(kg_editor_oa(e));
    kg_status status = after ? kg_oa_stabilize(after, NULL, &mended, error)
                             : kg_fail(error, KG_ERR_MEMORY, "out of memory");
    if (!status)
        status = kg_card_stand(e, after, &mended, error);
    kg_oa_destroy(after);
    return status;
}

/* Margin enough that nothing sticks out of the closed card. */
static kg_status cover(kg_editor *e, const json_t *a, kg_error *error) {
    const kg_oa_sheet *sheet = kg_document_sheet(e->document);
    int more = sheet ? kg_oa_overhang(sheet) : 0, margin = kg_editor_oa(e)->margin_cells + more;
    (void)a;
    if (margin > KG_OA_MAX_MARGIN)
        return kg_fail(error, KG_ERR_INPUT,
                       "no margin covers the model: it would have to be %d cells wide", margin);
    kg_status status = kg_editor_begin(e, N_("Margin"), error);
    if (status)
        return status;
    kg_editor_oa(e)->margin_cells = margin;
    if (more > 0)
        kg_editor_touch(e);
    kg_editor_commit(e);
    return KG_OK;
}

static kg_status mirror_now(kg_editor *e, const json_t *a, kg_error *error) {
    const char *from = "left";
    kg_status status = kg_argument_text(a, "from", &from, error);
    if (!status && strcmp(from, "left") != 0 && strcmp(from, "right") != 0)
        status = kg_fail(error, KG_ERR_INPUT, "\"from\" has to be \"left\" or \"right\"");
    if (!status)
        status = kg_editor_begin(e, N_("Make symmetric"), error);
    if (status)
        return status;
    if (kg_oa_mirror(kg_editor_oa(e),
                     strcmp(from, "right") == 0 ? KG_OA_RIGHT_HALF : KG_OA_LEFT_HALF))
        kg_editor_touch(e);
    kg_editor_commit(e);
    return KG_OK;
}

/* ---- the card --------------------------------------------------------------------------- */

static kg_status diagonals(kg_editor *e, const json_t *a, kg_error *error) {
    bool on = !kg_editor_oa(e)->diagonals;
    kg_status status = kg_argument_bool(a, "on", &on, error);
    if (!status)
        status = kg_editor_begin(e, N_("45° folds"), error);
    if (status)
        return status;
    kg_editor_oa(e)->diagonals = on;
    kg_editor_touch(e);
    kg_editor_commit(e);
    return KG_OK;
}

static kg_status resize(kg_editor *e, const json_t *a, kg_error *error) {
    int width = kg_editor_oa(e)->width, depth = kg_editor_oa(e)->depth_limit,
        height = kg_editor_oa(e)->height;
    kg_status status = read_int(a, "width", &width, error);
    if (!status)
        status = read_int(a, "depth", &depth, error);
    if (!status)
        status = read_int(a, "height", &height, error);
    if (!status)
        status = kg_editor_begin(e, N_("Size of the card"), error);
    if (status)
        return status;
    kg_editor_touch(e);
    return kg_editor_finish(e, kg_oa_resize(kg_editor_oa(e), width, depth, height, error));
}

/* Title, cell, margin, smallest paper: those that are given. */
static kg_status set(kg_editor *e, const json_t *a, kg_error *error) {
    const kg_oa *oa = kg_editor_oa(e);
    const char *title = oa->title;
    double cell = oa->cell_mm, tiny = oa->tiny_mm;
    int margin = oa->margin_cells;
    kg_status status = kg_argument_text(a, "title", &title, error);
    if (!status)
        status = kg_argument_number(a, "cell_mm", &cell, error);
    if (!status)
        status = kg_argument_number(a, "tiny_mm", &tiny, error);
    if (!status)
        status = read_int(a, "margin_cells", &margin, error);
    if (!status && !(cell > 0 && cell <= KG_OA_MAX_CELL))
        status = kg_fail(error, KG_ERR_INPUT, "\"cell_mm\" has to be above 0 and at most %g",
                         KG_OA_MAX_CELL);
    if (!status && (margin < 0 || margin > KG_OA_MAX_MARGIN))
        status =
            kg_fail(error, KG_ERR_INPUT, "\"margin_cells\" has to be 0 to %d", KG_OA_MAX_MARGIN);
    if (!status && !(tiny >= 0 && tiny <= KG_OA_MAX_CELL))
        status = kg_fail(error, KG_ERR_INPUT, "\"tiny_mm\" has to be 0 to %g", KG_OA_MAX_CELL);
    char *copy = status ? NULL : strdup(title);
    if (!status && !copy)
        status = kg_fail(error, KG_ERR_MEMORY, "out of memory");
    if (!status)
        status = kg_editor_begin(e, N_("Change the card"), error);
    if (status) {
        free(copy);
        return status;
    }
    kg_oa *changed = kg_editor_oa(e);
    free(changed->title);
    changed->title = copy;
    changed->cell_mm = cell;
    changed->tiny_mm = tiny;
    changed->margin_cells = margin;
    kg_editor_touch(e);
    kg_editor_commit(e);
    return KG_OK;
}

static bool is_not_empty(const kg_editor *e) {
    const kg_oa *oa = kg_editor_oa(e);
    for (int x = 0; x < oa->width; x++)
        if (kg_oa_depth(oa, x, 0) > 0)
            return true;
    return false;
}

static const kg_app_command items[] = {
    {"card.add", N_("Add voxel"),
     N_("Fills the voxel at the cursor, or the selected box, and what has to carry it."), "Z", NULL,
     add, NULL, KG_COMMAND_EDIT},
    {"card.remove", N_("Remove voxel"),
     N_("Takes away the voxel at the cursor, or the selected box, and what stands on it."), "X|Del",
     NULL, take, NULL, KG_COMMAND_EDIT},
    {"card.box", N_("Fill a box"), N_("Fills or empties a box of voxels."), NULL, NULL, fill_box,
     NULL, KG_COMMAND_ARGUMENTS},
    {"card.pull", N_("Pull a face"),
     N_("Drag a front out or in, a top up or down; the block follows."), "E", NULL, pull, NULL,
     KG_COMMAND_EDIT},
    {"card.window", N_("Window on or off"),
     N_("Pushes the front at the cursor back, as a window, or brings it to the front again."), "W",
     NULL, window, NULL, KG_COMMAND_EDIT},
    {"card.top", N_("Leave out the top, or not"),
     N_("Without its top a block is a frame; its paper falls down in front."), "T", NULL, omit_top,
     NULL, KG_COMMAND_EDIT},
    {"card.fill_windows", N_("Open windows"),
     N_("Makes windows of all fronts in the selected box, or the card, that it holds without."),
     "Ctrl+Shift+W", NULL, fill_windows, is_not_empty, KG_COMMAND_EDIT},
    {"card.omit_thin", N_("Leave out thin tops"),
     N_("Leaves out tops one cell deep where the card holds without them."), NULL, NULL, omit_thin,
     is_not_empty, KG_COMMAND_EDIT},
    {"card.stabilize", N_("Make it stand"),
     N_("Changes as few cells as it can so that no patch is loose: closes windows, puts tops back, "
        "moves fronts and tops."),
     "Ctrl+Shift+L", NULL, stabilize, is_not_empty, KG_COMMAND_EDIT},
    {"card.cover", N_("Cover it when closed"),
     N_("Makes the margin so wide that nothing sticks out of the closed card."), NULL, NULL, cover,
     is_not_empty, KG_COMMAND_EDIT},
    {"card.mirror_now", N_("Make symmetric"),
     N_("Makes the right half the mirror image of the left half."), "Ctrl+M", NULL, mirror_now,
     NULL, KG_COMMAND_EDIT},
    {"card.diagonals", N_("45° folds"), N_("Folds square pyramids wherever steps allow it."),
     "Shift+D", NULL, diagonals, NULL, KG_COMMAND_EDIT},
    {"card.clear", N_("Empty the card"), N_("Takes away all voxels."), "Shift+Del", NULL, clear,
     is_not_empty, KG_COMMAND_EDIT},
    {"card.resize", N_("Size of the card"), N_("Changes the number of cells."), NULL, NULL, resize,
     NULL, KG_COMMAND_ARGUMENTS},
    {"card.set", N_("Change the card"),
     N_("Sets title, size of a cell, margin or smallest width of paper."), NULL, NULL, set, NULL,
     KG_COMMAND_ARGUMENTS},
};
const kg_command_table kg_card_commands = {items, sizeof items / sizeof *items,
                                           KG_FOR_KIND(KG_DOCUMENT_OA)};
