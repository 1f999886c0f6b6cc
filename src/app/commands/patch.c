/* Commands: adding and removing patches, and what they are. */
#include "app/commands/arguments.h"
#include "app/commands/commands.h"
#include "app/scenery.h"
#include "app/text.h"
#include "app/tools/tools.h"
#include "document/pin.h"
#include "model/edit.h"
#include "model/mirror.h"
#include "model/naming.h"

#include <stdlib.h>
#include <string.h>

/* ---- adding ----------------------------------------------------------------------------- */

static kg_status read_input(const json_t *a, kg_patch_input *input, kg_error *error) {
    double *numbers = NULL;
    size_t count = 0;
    const json_t *extent = json_object_get(a, "extent");
    kg_status status = kg_argument_rows(a, "points", 3, &numbers, &count, error);
    if (!status && count != 4 && count != 6)
        status = kg_fail(error, KG_ERR_INPUT, "\"points\" has to be 4 or 6 points, not %zu", count);
    for (size_t i = 0; i < count && !status; i++)
        input->points[i] = kg_v3(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]);
    input->point_count = count;
    free(numbers);
    if (!status && extent &&
        json_unpack((json_t *)(uintptr_t)extent, "[FF]", &input->extent[0], &input->extent[1]))
        status = kg_fail(error, KG_ERR_INPUT, "\"extent\" has to be [lo, hi]");
    if (!status && json_object_get(a, "ruling")) {
        input->has_ruling = true;
        status = kg_argument_vec3(a, "ruling", &input->ruling, error);
    }
    if (!status)
        status = kg_argument_bool(a, "flip", &input->flip, error);
    return status;
}

static kg_status add(kg_editor *e, const json_t *a, kg_error *error) {
    if (!a)
        return kg_tool_start_place(e, error);
    kg_patch_input input = {.extent = {-20, 20}};
    const char *name = NULL;
    int64_t id;
    kg_status status = read_input(a, &input, error);
    if (!status)
        status = kg_argument_text(a, "name", &name, error);
    if (!status)
        status = kg_editor_begin(e, N_("New patch"), error);
    if (status)
        return status;
    status = kg_editor_finish(e, kg_model_add_patch(kg_editor_model(e), &input, name, &id, error));
    if (!status)
        kg_editor_select(e, id, false);
    return status;
}

static kg_status remove_one(kg_editor *e, int64_t id, const void *a, kg_error *error) {
    (void)a;
    kg_editor_touch(e);
    kg_status status = kg_pin_forget_patch(kg_editor_model(e), id, error);
    return status ? status : kg_model_remove_patch(kg_editor_model(e), id, error);
}
static kg_status remove_patches(kg_editor *e, const json_t *a, kg_error *error) {
    return kg_argument_each(e, a, N_("Delete"), remove_one, a, error);
}

/* Copies replace what they are copies of in the selection. */
static kg_status copy_each(kg_editor *e, const json_t *a, const char *label,
                           const kg_similarity *map, kg_error *error) {
    int64_t *ids, copy;
    size_t count;
    kg_status status = kg_argument_patches(e, a, &ids, &count, error);
    if (status)
        return status;
    status = kg_editor_begin(e, label, error);
    for (size_t i = 0; i < count && !status; i++) {
        status = kg_model_duplicate_patch(kg_editor_model(e), ids[i], &copy, error);
        if (!status && map)
            status = kg_model_transform_patch(kg_editor_model(e), copy, map, error);
        if (!status)
            status = kg_model_name_copy(kg_editor_model(e), copy, map != NULL, error);
        if (!status)
            ids[i] = copy;
    }
    status = kg_editor_finish(e, status);
    if (!status)
        kg_editor_select_none(e);
    for (size_t i = 0; i < count && !status; i++)
        kg_editor_select(e, ids[i], true);
    free(ids);
    return status;
}

static kg_status duplicate(kg_editor *e, const json_t *a, kg_error *error) {
    kg_status status = copy_each(e, a, N_("Duplicate"), NULL, error);
    if (!status && !a)
        status = kg_tool_start_transform(e, KG_TRANSFORM_MOVE, error);
    return status;
}

static kg_status mirror(kg_editor *e, const json_t *a, kg_error *error) {
    /* edits in files say themselves where the plane is */
    kg_mirror_plane plane = a ? (kg_mirror_plane){1, 0} : kg_editor_model(e)->mirror;
    kg_vec3 normal = kg_mirror_plane_normal(plane), point = kg_scale(normal, plane.at);
    kg_status status = kg_argument_vec3(a, "point", &point, error);
    if (!status)
        status = kg_argument_vec3(a, "normal", &normal, error);
    if (status)
        return status;
    if (!(kg_len(normal) > 0) || !isfinite(kg_len(normal)) || !isfinite(kg_len(point)))
        return kg_fail(error, KG_ERR_INPUT, "\"normal\" has to be a direction");
    kg_similarity map = kg_similarity_mirror(point, kg_unit(normal));
    status = copy_each(e, a, N_("Mirror"), &map, error);
    if (!status && !a)
        kg_editor_say(
            e, KG_WARNING,
            _("Mirrored across the plane %s = %.4g mm, which the panel sets under Tools."),
            (const char *[]){"x", "y", "z"}[plane.axis], plane.at);
    return status;
}

/* Where M mirrors across: "across" x, y or z, "at" mm. */
static kg_status set_mirror(kg_editor *e, const json_t *a, kg_error *error) {
    kg_mirror_plane plane = kg_editor_model(e)->mirror;
    const char *across = (const char *[]){"x", "y", "z"}[plane.axis];
    kg_status status = kg_argument_text(a, "across", &across, error);
    if (!status)
        status = kg_argument_number(a, "at", &plane.at, error);
    if (!status && (strlen(across) != 1 || !strchr("xyz", across[0])))
        status = kg_fail(error, KG_ERR_INPUT, "\"across\" has to be \"x\", \"y\" or \"z\"");
    if (!status && !(fabs(plane.at) <= KG_MAX_COORDINATE))
        status = kg_fail(error, KG_ERR_INPUT, "coordinates beyond 1000000 mm cannot be stored");
    if (!status)
        status = kg_editor_begin(e, N_("Mirror plane"), error);
    if (status)
        return status;
    plane.axis = across[0] - 'x';
    kg_editor_model(e)->mirror = plane;
    kg_editor_touch(e);
    kg_editor_commit(e);
    return KG_OK;
}

/* ---- properties ------------------------------------------------------------------------- */

/* Toggles a property by hand, sets it by argument "on". */
static kg_status set_flag(const json_t *a, bool *flag, kg_error *error) {
    bool on = !*flag;
    kg_status status = kg_argument_bool(a, "on", &on, error);
    if (!status)
        *flag = on;
    return status;
}

#define FLAG(verb, label, field)                                                                   \
    static kg_status verb##_one(kg_editor *e, int64_t id, const void *a, kg_error *error) {        \
        kg_editor_touch(e);                                                                        \
        return set_flag(a, &kg_model_find(kg_editor_model(e), id)->field, error);                  \
    }                                                                                              \
    static kg_status verb(kg_editor *e, const json_t *a, kg_error *error) {                        \
        return kg_argument_each(e, a, label, verb##_one, a, error);                                \
    }
FLAG(flip, N_("Flip"), input.flip)
FLAG(hide, N_("Hide"), hidden)
FLAG(construction, N_("Construction"), construction)

static kg_status show_all(kg_editor *e, const json_t *a, kg_error *error) {
    (void)a;
    kg_status status = kg_editor_begin(e, N_("Show all"), error);
    if (status)
        return status;
    kg_model *m = kg_editor_model(e);
    for (size_t i = 0; i < m->patch_count; i++)
        m->patches[i].hidden = false;
    kg_editor_commit(e);
    return KG_OK;
}

/* Hides all others; again: shows them. */
static kg_status isolate(kg_editor *e, const json_t *a, kg_error *error) {
    int64_t *ids;
    size_t count;
    kg_status status = kg_argument_patches(e, a, &ids, &count, error);
    if (!status) {
        status = kg_editor_begin(e, N_("Isolate"), error);
        kg_model *m = kg_editor_model(e);
        bool alone = true;
        for (int pass = 0; pass < 2 && !status; pass++)
            for (size_t i = 0; i < m->patch_count; i++) {
                bool among = false;
                for (size_t k = 0; k < count; k++)
                    among = among || m->patches[i].id == ids[k];
                if (pass == 0)
                    alone = alone && (m->patches[i].hidden || among);
                else
                    m->patches[i].hidden = !alone && !among;
            }
        free(ids);
    }
    return kg_editor_finish(e, status);
}

static kg_status rename_one(kg_editor *e, int64_t id, const void *a, kg_error *error) {
    const char *name = "";
    kg_status status = kg_argument_text(a, "name", &name, error);
    char *copy = status ? NULL : strdup(name);
    if (!status && !copy)
        status = kg_fail(error, KG_ERR_MEMORY, "out of memory");
    if (status)
        return status;
    kg_model_patch *p = kg_model_find(kg_editor_model(e), id);
    free(p->name);
    p->name = copy;
    return KG_OK;
}
static kg_status rename_patch(kg_editor *e, const json_t *a, kg_error *error) {
    if (!a) {
        e->request = KG_REQUEST_RENAME;
        return KG_OK;
    }
    return kg_argument_each(e, a, N_("Rename"), rename_one, a, error);
}

static kg_status color_one(kg_editor *e, int64_t id, const void *a, kg_error *error) {
    const char *text = NULL;
    kg_color color;
    kg_status status = kg_argument_text(a, "color", &text, error);
    if (!status && !kg_color_parse(text, &color))
        status = kg_fail(error, KG_ERR_INPUT, "\"color\" has to be \"#rrggbb\"");
    return status ? status
                  : kg_model_set_patch_color(kg_model_find(kg_editor_model(e), id), text, error);
}
static kg_status set_color(kg_editor *e, const json_t *a, kg_error *error) {
    return kg_argument_each(e, a, N_("Colour"), color_one, a, error);
}

/* Points, extent, ruling and flip, those that are given. */
static kg_status set_one(kg_editor *e, int64_t id, const void *a, kg_error *error) {
    kg_model_patch *p = kg_model_find(kg_editor_model(e), id);
    kg_patch_input input = p->input;
    kg_patch patch;
    json_t *all = json_object();
    json_t *points = json_array();
    for (size_t i = 0; i < input.point_count && points; i++)
        json_array_append_new(
            points, json_pack("[fff]", input.points[i].x, input.points[i].y, input.points[i].z));
    kg_status status = KG_OK;
    if (!all || json_object_set(all, "points", points) != 0 ||
        json_object_update(all, (json_t *)(uintptr_t)a) != 0)
        status = kg_fail(error, KG_ERR_MEMORY, "out of memory");
    if (!status)
        status = read_input(all, &input, error);
    if (!status)
        status = kg_patch_init(&input, &patch, error);
    if (!status)
        p->input = input;
    json_decref(points);
    json_decref(all);
    kg_editor_touch(e);
    return status;
}
static kg_status set_patch(kg_editor *e, const json_t *a, kg_error *error) {
    return kg_argument_each(e, a, N_("Change patch"), set_one, a, error);
}

static bool has_hidden(const kg_editor *e) {
    const kg_model *m = kg_editor_model(e);
    for (size_t i = 0; i < m->patch_count; i++)
        if (m->patches[i].hidden)
            return true;
    return false;
}

static const kg_app_command items[] = {
    {"patch.add", N_("New patch"), N_("Four clicks place the control points of a patch."), "A",
     "Shift+A", add, NULL, KG_COMMAND_EDIT},
    {"patch.delete", N_("Delete"), N_("Deletes the selected patches and the trims they make."),
     "Del", "Del|X", remove_patches, kg_has_selection, KG_COMMAND_EDIT},
    {"patch.duplicate", N_("Duplicate"), N_("Copies the selected patches and moves the copies."),
     "Shift+D", NULL, duplicate, kg_has_selection, KG_COMMAND_EDIT},
    {"patch.mirror", N_("Mirror"), N_("Copies the selected patches to the other side."), "M", NULL,
     mirror, kg_has_selection, KG_COMMAND_EDIT},
    {"mirror.set", N_("Mirror plane"), N_("Says where the plane of the mirror is."), NULL, NULL,
     set_mirror, NULL, KG_COMMAND_ARGUMENTS},
    {"patch.flip", N_("Flip side"), N_("Makes the other side the front."), "N", NULL, flip,
     kg_has_selection, KG_COMMAND_EDIT},
    {"patch.hide", N_("Hide"), N_("Hides the selected patches."), "H", NULL, hide, kg_has_selection,
     KG_COMMAND_EDIT},
    {"patch.show_all", N_("Show all"), N_("Shows all hidden patches."), "Alt+H", NULL, show_all,
     has_hidden, KG_COMMAND_EDIT},
    {"patch.isolate", N_("Isolate"), N_("Hides all other patches, or shows them again."), "/", NULL,
     isolate, kg_has_selection, KG_COMMAND_EDIT},
    {"patch.construction", N_("Construction"),
     N_("A construction patch cuts others but is in no net."), NULL, NULL, construction,
     kg_has_selection, KG_COMMAND_EDIT},
    {"patch.rename", N_("Rename…"), N_("Gives the patch another name."), "F2", NULL, rename_patch,
     kg_has_selection, KG_COMMAND_EDIT},
    {"patch.color", N_("Colour"), N_("Sets the colour of patches."), NULL, NULL, set_color, NULL,
     KG_COMMAND_ARGUMENTS},
    {"patch.set", N_("Change patch"), N_("Sets points, extent, ruling or flip."), NULL, NULL,
     set_patch, NULL, KG_COMMAND_ARGUMENTS},
};
const kg_command_table kg_patch_commands = {items, sizeof items / sizeof *items,
                                            KG_FOR_KIND(KG_DOCUMENT_PATCHES)};
