/* Commands: moving, turning and scaling patches and points. */
#include "app/commands/arguments.h"
#include "app/commands/commands.h"
#include "app/text.h"
#include "app/tools/tools.h"
#include "model/edit.h"

static kg_status map_one(kg_editor *e, int64_t id, const void *map, kg_error *error) {
    kg_editor_touch(e);
    return kg_model_transform_patch(kg_editor_model(e), id, map, error);
}

static kg_status map_all(kg_editor *e, const json_t *a, const char *label, const kg_similarity *map,
                         kg_error *error) {
    return kg_argument_each(e, a, label, map_one, map, error);
}

static kg_status move(kg_editor *e, const json_t *a, kg_error *error) {
    kg_similarity map = {{1, 0, 0, 0, 1, 0, 0, 0, 1}, 1, {0, 0, 0}};
    if (!a)
        return kg_tool_start_transform(e, KG_TRANSFORM_MOVE, error);
    kg_status status = kg_argument_vec3(a, "by", &map.offset, error);
    return status ? status : map_all(e, a, N_("Move"), &map, error);
}

static kg_status rotate(kg_editor *e, const json_t *a, kg_error *error) {
    kg_vec3 center = {0, 0, 0}, axis = {0, 0, 1};
    double angle = 0;
    if (!a)
        return kg_tool_start_transform(e, KG_TRANSFORM_ROTATE, error);
    kg_status status = kg_argument_vec3(a, "center", &center, error);
    if (!status)
        status = kg_argument_vec3(a, "axis", &axis, error);
    if (!status)
        status = kg_argument_number(a, "angle_deg", &angle, error);
    if (!status && !(kg_len(axis) > 0))
        status = kg_fail(error, KG_ERR_INPUT, "\"axis\" has to be a direction");
    if (status)
        return status;
    kg_similarity map = kg_similarity_turn(center, kg_unit(axis), angle * KG_PI / 180);
    return map_all(e, a, N_("Rotate"), &map, error);
}

static kg_status scale(kg_editor *e, const json_t *a, kg_error *error) {
    kg_vec3 center = {0, 0, 0};
    kg_similarity map = {{1, 0, 0, 0, 1, 0, 0, 0, 1}, 1, {0, 0, 0}};
    if (!a)
        return kg_tool_start_transform(e, KG_TRANSFORM_SCALE, error);
    kg_status status = kg_argument_vec3(a, "center", &center, error);
    if (!status)
        status = kg_argument_number(a, "factor", &map.scale, error);
    map.offset = kg_scale(center, 1 - map.scale);
    return status ? status : map_all(e, a, N_("Scale"), &map, error);
}

/* One control point, to a place ("to") or by a way ("by"). */
static kg_status move_point(kg_editor *e, const json_t *a, kg_error *error) {
    kg_model_patch *p;
    size_t index = 0;
    kg_status status = kg_argument_patch(e, a, &p, error);
    if (!status)
        status = kg_argument_index(a, "point", &index, error);
    if (!status && index >= p->input.point_count)
        status = kg_fail(error, KG_ERR_INPUT, "patch %lld has %zu points, counted from 0",
                         (long long)p->id, p->input.point_count);
    if (status)
        return status;
    kg_vec3 to = p->input.points[index], by = {0, 0, 0};
    status = kg_argument_vec3(a, "to", &to, error);
    if (!status)
        status = kg_argument_vec3(a, "by", &by, error);
    if (!status)
        status = kg_editor_begin(e, N_("Move point"), error);
    if (status)
        return status;
    to = kg_add(to, by);
    if (!(fabs(to.x) <= 1e6 && fabs(to.y) <= 1e6 && fabs(to.z) <= 1e6))
        status = kg_fail(error, KG_ERR_INPUT, "coordinates beyond 1000000 mm cannot be stored");
    else
        p->input.points[index] = to;
    kg_editor_touch(e);
    return kg_editor_finish(e, status);
}

static const kg_app_command items[] = {
    {"patch.move", N_("Move"), N_("Moves the selected patches or points."), "G", NULL, move,
     kg_has_selection, KG_COMMAND_EDIT},
    {"patch.rotate", N_("Rotate"), N_("Turns the selected patches or points."), "R", NULL, rotate,
     kg_has_selection, KG_COMMAND_EDIT},
    {"patch.scale", N_("Scale"), N_("Scales the selected patches or points."), "S", NULL, scale,
     kg_has_selection, KG_COMMAND_EDIT},
    {"point.move", N_("Move point"), N_("Moves one control point."), NULL, NULL, move_point, NULL,
     KG_COMMAND_ARGUMENTS},
};
const kg_command_table kg_move_commands = {items, sizeof items / sizeof *items,
                                           KG_FOR_KIND(KG_DOCUMENT_PATCHES)};
