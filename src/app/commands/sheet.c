/* Commands: sheets in the plane, before they are folded. */
#include "app/commands/arguments.h"
#include "app/commands/commands.h"
#include "app/modes/sheet_edit.h"
#include "app/scenery.h"
#include "app/text.h"
#include "app/tools/tool.h"

#include <stdlib.h>
#include <string.h>

/* Of sheets that are added without other wishes. */
#define DEFAULT_SIZE 150

static const char *const shape_names[KG_SHEET_SHAPE_COUNT] = {"square", "rectangle", "a4",
                                                              "triangle", "polygon"};

/* ---- arguments --------------------------------------------------------------------------- */

/* "sheet": its number from 1; without it the selected one. */
static kg_status read_sheet(const kg_editor *e, const json_t *a, size_t *out, kg_error *error) {
    int64_t number = kg_sheets_of(e)->sheet + 1;
    kg_status status = kg_argument_id(a, "sheet", &number, error);
    if (!status && number == 0 && !json_object_get(a, "sheet"))
        status = kg_fail(error, KG_ERR_INPUT, "select a sheet first");
    if (!status && (number < 1 || (size_t)number > kg_sheets_count(kg_sheets_of(e))))
        status = kg_fail(error, KG_ERR_INPUT, "there is no sheet %lld", (long long)number);
    if (!status)
        *out = (size_t)number - 1;
    return status;
}

/* [x, y] */
static kg_status read_vec2(const json_t *a, const char *name, kg_vec2 *value, kg_error *error) {
    const json_t *x = json_object_get(a, name);
    if (!x)
        return KG_OK;
    if (json_array_size(x) != 2 || !json_is_number(json_array_get(x, 0)) ||
        !json_is_number(json_array_get(x, 1)))
        return kg_fail(error, KG_ERR_INPUT, "\"%s\" has to be [x, y]", name);
    *value =
        kg_v2(json_number_value(json_array_get(x, 0)), json_number_value(json_array_get(x, 1)));
    return KG_OK;
}

static kg_status read_size(const json_t *a, kg_sheet_size *size, kg_error *error) {
    const char *shape = "square";
    int64_t sides = size->sides;
    kg_status status = kg_argument_text(a, "shape", &shape, error);
    if (!status)
        status = kg_argument_number(a, "size", &size->width, error);
    if (!status)
        status = kg_argument_number(a, "width", &size->width, error);
    if (!status)
        status = kg_argument_number(a, "height", &size->height, error);
    if (!status)
        status = kg_argument_id(a, "sides", &sides, error);
    if (status)
        return status;
    size->sides = sides < 0 || sides > KG_SHEET_MOST_SIDES ? 0 : (int)sides;
    for (int i = 0; i < KG_SHEET_SHAPE_COUNT; i++)
        if (strcmp(shape, shape_names[i]) == 0) {
            size->shape = (kg_sheet_shape)i;
            return KG_OK;
        }
    return kg_fail(error, KG_ERR_INPUT,
                   "\"%s\" is none of square, rectangle, a4, triangle and polygon", shape);
}

/* Corners of a sheet as its arguments want it; malloc's. */
static kg_status read_corners(const json_t *a, kg_vec2 **out, size_t *out_count, kg_error *error) {
    kg_sheet_size size = {KG_SHEET_SQUARE, DEFAULT_SIZE, DEFAULT_SIZE, 6};
    double *rows = NULL;
    kg_vec2 *corners = NULL;
    if (json_object_get(a, "polygon")) {
        kg_status status = kg_argument_rows(a, "polygon", 2, &rows, out_count, error);
        corners = status ? NULL : calloc(*out_count + 1, sizeof *corners);
        for (size_t i = 0; corners && i < *out_count; i++)
            corners[i] = kg_v2(rows[2 * i], rows[2 * i + 1]);
        free(rows);
        *out = corners;
        return status || corners ? status : kg_fail(error, KG_ERR_MEMORY, "out of memory");
    }
    kg_status status = read_size(a, &size, error);
    if (!status && !(corners = calloc(KG_SHEET_MOST_SIDES, sizeof *corners)))
        status = kg_fail(error, KG_ERR_MEMORY, "out of memory");
    if (!status)
        status = kg_sheet_corners(&size, corners, out_count, error);
    if (status)
        free(corners);
    else
        *out = corners;
    return status;
}

/* ---- commands ---------------------------------------------------------------------------- */

/* Sheets beside each other are told apart by their fronts. */
static uint32_t next_color(const kg_editor *e) {
    static const uint32_t fronts[] = {KG_SHEET_FRONT, 0x2b7bba, 0xe0a62e, 0x3f9a5a};
    return fronts[kg_origami_sheet_count(kg_editor_origami(e)) % (sizeof fronts / sizeof *fronts)];
}

static void select_sheet(kg_editor *e, size_t sheet) {
    kg_editor_update(e);
    kg_sheets_of(e)->sheet = (int32_t)sheet;
}

/* Selects the sheet that was added last; all are shown when it would not be seen whole. */
static void show_new(kg_editor *e) {
    const kg_origami *o = kg_editor_origami(e);
    size_t index = kg_origami_sheet_count(o) - 1;
    const kg_paper_sheet *sheet = kg_origami_sheet(o, index);
    bool seen = true;
    select_sheet(e, index);
    for (size_t i = 0; i < sheet->count; i++) {
        kg_vec2 px;
        seen = seen &&
               kg_pane_project(&e->pane, kg_v3(sheet->polygon[i].x, sheet->polygon[i].y, 0), &px) &&
               kg_area_contains(e->pane.area, px);
    }
    if (!seen && e->pane.area.width > 1)
        kg_pane_fit(&e->pane, kg_editor_box(e, false));
}

static kg_status add(kg_editor *e, const json_t *a, kg_error *error) {
    kg_vec2 *corners = NULL, at = kg_v2(0, 0);
    size_t count = 0;
    /* a polygon says itself where it lies */
    bool placed = json_object_get(a, "at") || json_object_get(a, "polygon");
    uint32_t front = next_color(e), back = KG_SHEET_BACK;
    kg_status status = read_vec2(a, "at", &at, error);
    if (!status)
        status = kg_argument_color(a, "front", &front, error);
    if (!status)
        status = kg_argument_color(a, "back", &back, error);
    if (!status)
        status = read_corners(a, &corners, &count, error);
    if (!status && !(status = kg_editor_begin(e, N_("Add sheet"), error)))
        status = kg_editor_finish(
            e, kg_sheets_add(e, corners, count, placed ? &at : NULL, front, back, error));
    free(corners);
    if (!status)
        show_new(e);
    return status;
}

static kg_status duplicate(kg_editor *e, const json_t *a, kg_error *error) {
    size_t index;
    kg_origami *o = kg_editor_origami(e);
    kg_status status = read_sheet(e, a, &index, error);
    if (!status && index >= kg_origami_sheet_count(o))
        status = kg_fail(error, KG_ERR_INPUT, "%s", kg_sheets_why_fixed(e));
    if (!status)
        status = kg_editor_begin(e, N_("Duplicate sheet"), error);
    if (status)
        return status;
    const kg_paper_sheet *s = kg_origami_sheet(o, index);
    status =
        kg_editor_finish(e, kg_sheets_add(e, s->polygon, s->count, NULL, s->front, s->back, error));
    if (!status)
        show_new(e);
    return status;
}

static kg_status take_away(kg_editor *e, const json_t *a, kg_error *error) {
    size_t index;
    kg_status status = read_sheet(e, a, &index, error);
    if (!status)
        status = kg_editor_begin(e, N_("Delete sheet"), error);
    if (status)
        return status;
    status = kg_origami_remove_sheet(kg_editor_origami(e), index, error);
    kg_editor_touch(e);
    return kg_editor_finish(e, status);
}

static kg_status place(kg_editor *e, size_t index, double angle, kg_vec2 center, kg_vec2 by,
                       const char *label, kg_error *error) {
    kg_status status = kg_editor_begin(e, label, error);
    return status ? status
                  : kg_editor_finish(e, kg_sheets_place(e, index, NULL, center, angle, by, error));
}

/* Where its middle lies; there is none of a pattern's sheets to be moved. */
static kg_status read_middle(const kg_editor *e, size_t index, kg_vec2 *out, kg_error *error) {
    const kg_origami *o = kg_editor_origami(e);
    if (index >= kg_origami_sheet_count(o))
        return kg_fail(error, KG_ERR_INPUT, "%s", kg_sheets_why_fixed(e));
    *out = kg_sheet_middle(kg_origami_sheet(o, index));
    return KG_OK;
}

static kg_status move(kg_editor *e, const json_t *a, kg_error *error) {
    size_t index;
    kg_vec2 by = kg_v2(0, 0), to, middle = kg_v2(0, 0);
    kg_status status = read_sheet(e, a, &index, error);
    if (!status)
        status = read_middle(e, index, &middle, error);
    to = middle;
    if (!status)
        status = read_vec2(a, "by", &by, error);
    if (!status)
        status = read_vec2(a, "to", &to, error);
    by = kg_add2(by, kg_sub2(to, middle));
    return status ? status : place(e, index, 0, middle, by, N_("Move sheet"), error);
}

static kg_status turn(kg_editor *e, const json_t *a, kg_error *error) {
    size_t index;
    double angle = 0;
    kg_vec2 center = kg_v2(0, 0);
    kg_status status = read_sheet(e, a, &index, error);
    if (!status)
        status = read_middle(e, index, &center, error);
    if (!status)
        status = read_vec2(a, "center", &center, error);
    if (!status)
        status = kg_argument_number(a, "angle_deg", &angle, error);
    return status
               ? status
               : place(e, index, angle * KG_PI / 180, center, kg_v2(0, 0), N_("Turn sheet"), error);
}

static kg_status color(kg_editor *e, const json_t *a, kg_error *error) {
    size_t index;
    uint32_t front, back;
    kg_origami *o = kg_editor_origami(e);
    kg_status status = read_sheet(e, a, &index, error);
    if (status)
        return status;
    kg_origami_colors(o, (int32_t)index, &front, &back);
    status = kg_argument_color(a, "front", &front, error);
    if (!status)
        status = kg_argument_color(a, "back", &back, error);
    if (!status)
        status = kg_editor_begin(e, N_("Colour"), error);
    if (status)
        return status;
    status = kg_origami_set_colors(o, index, front, back, error);
    kg_editor_touch(e);
    return kg_editor_finish(e, status);
}

static kg_status reorder(kg_editor *e, const json_t *a, int by, kg_error *error) {
    size_t index, to;
    kg_status status = read_sheet(e, a, &index, error);
    if (status)
        return status;
    to = index + (size_t)by + 1;
    status = kg_argument_index(a, "to", &to, error);
    if (!status && to == 0)
        status = kg_fail(error, KG_ERR_INPUT, "it is the lowest sheet");
    if (!status && to > kg_sheets_count(kg_sheets_of(e)))
        status = kg_fail(error, KG_ERR_INPUT, "it is the topmost sheet");
    if (!status)
        status = kg_editor_begin(e, N_("Order of sheets"), error);
    if (!status && !(status = kg_editor_finish(e, kg_sheets_reorder(e, index, to - 1, error))))
        select_sheet(e, to - 1);
    return status;
}

static kg_status raise_sheet(kg_editor *e, const json_t *a, kg_error *error) {
    return reorder(e, a, 1, error);
}

static kg_status lower_sheet(kg_editor *e, const json_t *a, kg_error *error) {
    return reorder(e, a, -1, error);
}

static kg_status arrange(kg_editor *e, const json_t *a, kg_error *error) {
    (void)a, (void)error;
    if (e->tool == &kg_tool_sheets)
        kg_editor_use_default(e);
    else
        kg_editor_use(e, &kg_tool_sheets, NULL);
    return KG_OK;
}

static bool can_add(const kg_editor *e) {
    return !kg_sheets_why_fixed(e);
}
static bool can_place(const kg_editor *e) {
    return can_add(e) && kg_sheets_of(e)->sheet >= 0;
}

static const kg_app_command items[] = {
    {"sheet.add", N_("Add sheet"), N_("Adds a square sheet beside the others."), NULL, NULL, add,
     can_add, KG_COMMAND_EDIT},
    {"sheet.arrange", N_("Arrange sheets"),
     N_("Drags sheets to where they lie before the first fold, and turns them by a ring."), "G",
     NULL, arrange, can_add, 0},
    {"sheet.duplicate", N_("Duplicate sheet"), N_("Adds another sheet of the same form."),
     "Shift+D", NULL, duplicate, can_place, KG_COMMAND_EDIT},
    {"sheet.remove", N_("Delete sheet"), N_("Takes the selected sheet away."), NULL, NULL,
     take_away, can_place, KG_COMMAND_EDIT},
    {"sheet.raise", N_("Raise sheet"), N_("Lays the selected sheet over the next one."), NULL, NULL,
     raise_sheet, can_place, KG_COMMAND_EDIT},
    {"sheet.lower", N_("Lower sheet"), N_("Lays the selected sheet under the one before."), NULL,
     NULL, lower_sheet, can_place, KG_COMMAND_EDIT},
    {"sheet.move", N_("Move sheet"), "", NULL, NULL, move, NULL, KG_COMMAND_ARGUMENTS},
    {"sheet.turn", N_("Turn sheet"), "", NULL, NULL, turn, NULL, KG_COMMAND_ARGUMENTS},
    {"sheet.color", N_("Colour"), "", NULL, NULL, color, NULL, KG_COMMAND_ARGUMENTS},
};
const kg_command_table kg_sheet_commands = {items, sizeof items / sizeof *items,
                                            KG_FOR_KIND(KG_DOCUMENT_ORIGAMI)};
