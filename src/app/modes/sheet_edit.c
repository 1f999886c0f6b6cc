#include "app/modes/sheet_edit.h"

#include "app/text.h"

#include <stdlib.h>
#include <string.h>

/* mm, between sheets that are added one after the other. */
#define GAP 10

/* ---- sheets in the plane ----------------------------------------------------------------- */

const char *kg_sheets_why_fixed(const kg_editor *e) {
    const kg_origami *o = kg_editor_origami(e);
    if (kg_origami_is_pattern(o))
        return _("The sheet of a crease pattern stays as it is.");
    if (kg_origami_step(o) > 0)
        return _("Sheets are placed before the first fold.");
    return NULL;
}

size_t kg_sheets_count(const kg_sheets *s) {
    size_t count = kg_origami_sheet_count(s->origami);
    for (size_t i = 0; s->state && i < s->state->loops.count; i++)
        if ((size_t)s->state->loops.items[i].sheet >= count)
            count = (size_t)s->state->loops.items[i].sheet + 1;
    return count;
}

kg_status kg_sheet_corners(const kg_sheet_size *size, kg_vec2 out[KG_SHEET_MOST_SIDES],
                           size_t *out_count, kg_error *error) {
    static const double a4[] = {210, 297};
    double w = size->width, h = size->shape == KG_SHEET_RECTANGLE ? size->height : w;
    size_t sides = size->shape == KG_SHEET_TRIANGLE  ? 3
                   : size->shape == KG_SHEET_POLYGON ? (size_t)size->sides
                                                     : 4;
    if (sides < 3 || sides > KG_SHEET_MOST_SIDES)
        return kg_fail(error, KG_ERR_INPUT, "a polygon has 3 to %d sides", KG_SHEET_MOST_SIDES);
    if (size->shape == KG_SHEET_A4)
        w = a4[0], h = a4[1];
    const kg_vec2 box[] = {{-w / 2, -h / 2}, {w / 2, -h / 2}, {w / 2, h / 2}, {-w / 2, h / 2}};
    double radius = size->shape == KG_SHEET_TRIANGLE ? w / sqrt(3) : w / 2;
    bool is_box = size->shape < KG_SHEET_TRIANGLE;
    /* regular ones stand on a side */
    double first = -KG_PI / 2 - KG_PI / (double)sides;
    for (size_t i = 0; i < sides; i++) {
        double turn = first + 2 * KG_PI * (double)i / (double)sides;
        out[i] = is_box ? box[i] : kg_v2(radius * cos(turn), radius * sin(turn));
    }
    *out_count = sides;
    return KG_OK;
}

/* Right of all sheets, in the middle of their height. */
static kg_vec2 free_place(const kg_origami *o, const kg_vec2 *corners, size_t count) {
    kg_box2 all = kg_box2_empty(), own = kg_box2_empty();
    for (size_t i = 0; i < kg_origami_sheet_count(o); i++)
        for (size_t k = 0; k < kg_origami_sheet(o, i)->count; k++)
            kg_box2_add(&all, kg_origami_sheet(o, i)->polygon[k]);
    for (size_t i = 0; i < count; i++)
        kg_box2_add(&own, corners[i]);
    if (!(all.lo.x <= all.hi.x))
        return kg_v2(0, 0);
    return kg_v2(all.hi.x + GAP - own.lo.x, (all.lo.y + all.hi.y) / 2 - (own.lo.y + own.hi.y) / 2);
}

kg_status kg_sheets_add(kg_editor *e, const kg_vec2 *corners, size_t count, const kg_vec2 *at,
                        uint32_t front, uint32_t back, kg_error *error) {
    kg_origami *o = kg_editor_origami(e);
    kg_vec2 by = at ? *at : free_place(o, corners, count);
    kg_paper_sheet sheet = {.count = count, .front = front, .back = back};
    if (!(sheet.polygon = calloc(count + 1, sizeof *sheet.polygon)))
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    for (size_t i = 0; i < count; i++)
        sheet.polygon[i] = kg_add2(corners[i], by);
    kg_status status = kg_origami_add_sheet(o, &sheet, error);
    free(sheet.polygon);
    kg_editor_touch(e);
    return status;
}

kg_vec2 kg_sheet_span(const kg_origami *o, size_t sheet) {
    const kg_origami_state *s = kg_origami_state_at(o, 0);
    kg_box2 box = kg_box2_empty();
    for (size_t i = 0; i < s->vertices.count; i++)
        if ((size_t)s->vertices.items[i].sheet == sheet)
            kg_box2_add(&box, s->vertices.items[i].paper);
    return box.lo.x <= box.hi.x ? kg_sub2(box.hi, box.lo) : kg_v2(0, 0);
}

kg_vec2 kg_sheet_middle(const kg_paper_sheet *sheet) {
    kg_box2 box = kg_box2_empty();
    for (size_t i = 0; i < sheet->count; i++)
        kg_box2_add(&box, sheet->polygon[i]);
    return kg_lerp2(box.lo, box.hi, 0.5);
}

kg_status kg_sheets_place(kg_editor *e, size_t index, const kg_paper_sheet *from, kg_vec2 center,
                          double angle, kg_vec2 by, kg_error *error) {
    kg_origami *o = kg_editor_origami(e);
    if (index >= kg_origami_sheet_count(o))
        return kg_fail(error, KG_ERR_INPUT, "there is no sheet %zu", index + 1);
    const kg_paper_sheet *sheet = from ? from : kg_origami_sheet(o, index);
    kg_vec2 *corners = calloc(sheet->count + 1, sizeof *corners);
    if (!corners)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    double c = cos(angle), s = sin(angle);
    for (size_t i = 0; i < sheet->count; i++) {
        kg_vec2 d = kg_sub2(sheet->polygon[i], center);
        kg_vec2 turned = angle == 0 ? sheet->polygon[i]
                                    : kg_add2(center, kg_v2(c * d.x - s * d.y, s * d.x + c * d.y));
        corners[i] = kg_add2(turned, by);
    }
    kg_status status = kg_origami_place_sheet(o, index, corners, sheet->count, error);
    free(corners);
    kg_editor_touch(e);
    return status;
}

kg_status kg_sheets_reorder(kg_editor *e, size_t sheet, size_t to, kg_error *error) {
    kg_origami *o = kg_editor_origami(e);
    size_t count = kg_origami_sheet_count(o);
    if (sheet >= count || to >= count)
        return kg_fail(error, KG_ERR_INPUT, "there is no sheet %zu",
                       (sheet >= count ? sheet : to) + 1);
    kg_origami *was = kg_origami_copy(o);
    kg_status status = was ? KG_OK : kg_fail(error, KG_ERR_MEMORY, "out of memory");
    /* all from the first that changes are taken off and put on again */
    size_t first = sheet < to ? sheet : to;
    for (size_t i = count; i-- > first && !status;)
        status = kg_origami_remove_sheet(o, i, error);
    for (size_t i = first; i < count && !status; i++) {
        size_t from = i == to ? sheet : i;
        if (i != to && sheet < to)
            from = i < to ? i + 1 : i;
        else if (i != to && i <= sheet)
            from = i - 1;
        status = kg_origami_add_sheet(o, kg_origami_sheet(was, from), error);
    }
    kg_origami_destroy(was);
    kg_editor_touch(e);
    return status;
}

/* ---- folds done -------------------------------------------------------------------------- */

kg_status kg_sheets_refold(kg_editor *e, size_t index, const kg_fold *fold, kg_error *error) {
    kg_origami *o = kg_editor_origami(e);
    size_t done = kg_origami_step(o);
    if (index >= done)
        return kg_fail(error, KG_ERR_INPUT, "there is no fold %zu that is done", index + 1);
    kg_origami *was = kg_origami_copy(o);
    if (!was)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    while (kg_origami_step(o) > index && kg_origami_undo(o))
        continue;
    kg_status status = kg_origami_fold(o, fold, error);
    for (size_t i = index + 1; i < done && !status; i++) {
        status = kg_origami_fold(o, kg_origami_fold_at(was, i), error);
        if (status == KG_ERR_INPUT)
            kg_fail_in(error, status, "fold %zu cannot be done then: ", i + 1);
    }
    kg_origami_destroy(was);
    kg_editor_touch(e);
    return status;
}
