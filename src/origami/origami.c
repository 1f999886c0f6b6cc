/* Sheets, folds, and the states between them. */
#include "origami/origami.h"

#include "origami/folding.h"
#include "origami/solver.h"

#include <jansson.h>
#include <stdlib.h>
#include <string.h>

kg_fold kg_fold_default(void) {
    return (kg_fold){.angle_deg = 180, .face = -1, .between = {-1, -1}};
}

kg_origami *kg_origami_create(void) {
    kg_origami *o = calloc(1, sizeof *o);
    kg_origami_state *s = NULL;
    if (o)
        o->net = kg_net_settings_default();
    if (o && (o->title = calloc(1, 1)) && kg_state_from_sheets(NULL, 0, &s, NULL) == KG_OK &&
        kg_push(&o->states, s))
        return o;
    kg_state_destroy(s);
    kg_origami_destroy(o);
    return NULL;
}

/* Forgets folds from `count` on, and their states. */
static void cut_folds(kg_origami *o, size_t count) {
    while (o->folds.count > count)
        json_decref(o->folds.items[--o->folds.count].json);
    while (o->states.count > count + 1)
        kg_state_destroy(o->states.items[--o->states.count]);
}

static void clear_sheet(kg_paper_sheet *sheet) {
    free(sheet->polygon);
    json_decref(sheet->json);
}

void kg_origami_destroy(kg_origami *o) {
    if (!o)
        return;
    cut_folds(o, 0);
    for (size_t i = 0; i < o->states.count; i++)
        kg_state_destroy(o->states.items[i]);
    for (size_t i = 0; i < o->sheets.count; i++)
        clear_sheet(&o->sheets.items[i]);
    free(o->sheets.items);
    free(o->folds.items);
    free(o->states.items);
    free(o->title);
    kg_net_settings_clear(&o->net);
    json_decref(o->json);
    free(o);
}

/* ---- sheets ----------------------------------------------------------------------------- */

bool kg_sheet_copy(const kg_paper_sheet *sheet, kg_paper_sheet *out) {
    *out = *sheet;
    out->polygon = malloc(sheet->count * sizeof *out->polygon + 1);
    if (!out->polygon)
        return false;
    memcpy(out->polygon, sheet->polygon, sheet->count * sizeof *out->polygon);
    json_incref(out->json);
    return true;
}

static kg_status check_unfolded(const kg_origami *o, kg_error *error) {
    if (o->pattern)
        return kg_fail(error, KG_ERR_INPUT, "the sheets of a crease pattern stay as they are");
    if (o->step > 0)
        return kg_fail(error, KG_ERR_INPUT, "sheets are placed before the first fold");
    return KG_OK;
}

/* The flat state of the sheets as they are now; folds that could be done again are forgotten. */
static kg_status lay_out(kg_origami *o, kg_error *error) {
    kg_origami_state *s;
    kg_status status = kg_state_from_sheets(o->sheets.items, o->sheets.count, &s, error);
    if (status)
        return status;
    cut_folds(o, 0);
    kg_state_destroy(o->states.items[0]);
    o->states.items[0] = s;
    return KG_OK;
}

kg_status kg_origami_add_sheet(kg_origami *o, const kg_paper_sheet *sheet, kg_error *error) {
    kg_status status = check_unfolded(o, error);
    if (!status)
        status = kg_sheet_check(sheet, error);
    if (status)
        return status;
    kg_paper_sheet copy;
    if (!kg_sheet_copy(sheet, &copy))
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    if (!kg_push(&o->sheets, copy)) {
        clear_sheet(&copy);
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    }
    if ((status = lay_out(o, error)))
        clear_sheet(&o->sheets.items[--o->sheets.count]);
    return status;
}

kg_status kg_origami_remove_sheet(kg_origami *o, size_t index, kg_error *error) {
    kg_status status = check_unfolded(o, error);
    if (!status && index >= o->sheets.count)
        status = kg_fail(error, KG_ERR_INPUT, "there is no sheet %zu", index + 1);
    if (status)
        return status;
    kg_paper_sheet sheet = o->sheets.items[index], *at = &o->sheets.items[index];
    size_t behind = o->sheets.count - index - 1;
    memmove(at, at + 1, behind * sizeof *at);
    o->sheets.count--;
    if ((status = lay_out(o, error))) {
        memmove(at + 1, at, behind * sizeof *at);
        *at = sheet;
        o->sheets.count++;
        return status;
    }
    clear_sheet(&sheet);
    return KG_OK;
}

kg_status kg_origami_place_sheet(kg_origami *o, size_t index, const kg_vec2 *polygon, size_t count,
                                 kg_error *error) {
    kg_status status = check_unfolded(o, error);
    if (!status && index >= o->sheets.count)
        status = kg_fail(error, KG_ERR_INPUT, "there is no sheet %zu", index + 1);
    if (status)
        return status;
    kg_paper_sheet before = o->sheets.items[index], given = before, now;
    given.polygon = (kg_vec2 *)(uintptr_t)polygon; /* read only */
    given.count = count;
    if ((status = kg_sheet_check(&given, error)))
        return status;
    if (!kg_sheet_copy(&given, &now))
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    o->sheets.items[index] = now;
    if ((status = lay_out(o, error))) {
        o->sheets.items[index] = before;
        clear_sheet(&now);
        return status;
    }
    clear_sheet(&before);
    return KG_OK;
}

size_t kg_origami_sheet_count(const kg_origami *o) {
    return o->sheets.count;
}

const kg_paper_sheet *kg_origami_sheet(const kg_origami *o, size_t index) {
    return &o->sheets.items[index];
}

const kg_origami_state *kg_origami_state_at(const kg_origami *o, size_t step) {
    return o->states.items[step];
}

size_t kg_origami_step(const kg_origami *o) {
    return o->step;
}

size_t kg_origami_fold_count(const kg_origami *o) {
    return o->folds.count;
}

const kg_fold *kg_origami_fold_at(const kg_origami *o, size_t index) {
    return &o->folds.items[index];
}

bool kg_origami_is_pattern(const kg_origami *o) {
    return o->pattern;
}

void kg_origami_colors(const kg_origami *o, int32_t sheet, uint32_t *out_front,
                       uint32_t *out_back) {
    bool known = sheet >= 0 && (size_t)sheet < o->sheets.count;
    *out_front = known ? o->sheets.items[sheet].front : KG_SHEET_FRONT;
    *out_back = known ? o->sheets.items[sheet].back : KG_SHEET_BACK;
}

/* The sheets of a pattern, which are known as loops only, as the boxes around them: what bears
 * their colours. */
static kg_status list_sheets(kg_origami *o, size_t count, kg_error *error) {
    const kg_origami_state *s = o->states.items[0];
    while (o->sheets.count < count) {
        kg_box2 box = kg_box2_empty();
        for (size_t i = 0; i < s->vertices.count; i++)
            if (s->vertices.items[i].sheet == (int32_t)o->sheets.count)
                kg_box2_add(&box, s->vertices.items[i].paper);
        kg_paper_sheet sheet = {.count = 4, .front = KG_SHEET_FRONT, .back = KG_SHEET_BACK};
        kg_vec2 corners[4] = {box.lo, kg_v2(box.hi.x, box.lo.y), box.hi, kg_v2(box.lo.x, box.hi.y)};
        sheet.polygon = malloc(sizeof corners);
        if (!sheet.polygon || !kg_push(&o->sheets, sheet)) {
            free(sheet.polygon);
            return kg_fail(error, KG_ERR_MEMORY, "out of memory");
        }
        memcpy(sheet.polygon, corners, sizeof corners);
    }
    return KG_OK;
}

kg_status kg_origami_set_colors(kg_origami *o, size_t sheet, uint32_t front, uint32_t back,
                                kg_error *error) {
    const kg_origami_state *s = o->states.items[0];
    size_t known = o->sheets.count;
    for (size_t i = 0; o->pattern && i < s->loops.count; i++)
        known =
            (size_t)s->loops.items[i].sheet >= known ? (size_t)s->loops.items[i].sheet + 1 : known;
    if (sheet >= known)
        return kg_fail(error, KG_ERR_INPUT, "there is no sheet %zu", sheet + 1);
    kg_status status = list_sheets(o, known, error);
    if (status)
        return status;
    o->sheets.items[sheet].front = front & 0xffffff;
    o->sheets.items[sheet].back = back & 0xffffff;
    return KG_OK;
}

const char *kg_origami_title(const kg_origami *o) {
    return o->title;
}

kg_status kg_origami_set_title(kg_origami *o, const char *title, kg_error *error) {
    char *copy = strdup(title);
    if (!copy)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    free(o->title);
    o->title = copy;
    return KG_OK;
}

kg_net_settings *kg_origami_net_settings(kg_origami *o) {
    return &o->net;
}

/* ---- folding ---------------------------------------------------------------------------- */

kg_status kg_origami_fold(kg_origami *o, const kg_fold *fold, kg_error *error) {
    kg_origami_state *s;
    kg_fold copy = *fold;
    kg_status status = kg_state_fold(o->states.items[o->step], &copy, &s, error);
    if (status)
        return status;
    if (!kg_reserve(&o->folds, o->step + 1) || !kg_reserve(&o->states, o->step + 2)) {
        kg_state_destroy(s);
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    }
    json_incref(copy.json);
    cut_folds(o, o->step);
    o->folds.items[o->folds.count++] = copy;
    o->states.items[o->states.count++] = s;
    o->step++;
    return KG_OK;
}

bool kg_origami_undo(kg_origami *o) {
    if (o->step == 0)
        return false;
    o->step--;
    return true;
}

bool kg_origami_redo(kg_origami *o) {
    if (o->step == o->folds.count)
        return false;
    o->step++;
    return true;
}

kg_status kg_origami_unfold(kg_origami *o, size_t index, kg_error *error) {
    if (index >= o->step)
        return kg_fail(error, KG_ERR_INPUT, "there is no fold %zu to take out", index + 1);
    kg_origami_state **states = calloc(o->step, sizeof *states);
    kg_status status = states ? KG_OK : kg_fail(error, KG_ERR_MEMORY, "out of memory");
    const kg_origami_state *from = o->states.items[index];
    for (size_t i = index + 1; i < o->step && !status; i++) {
        status = kg_state_fold(from, &o->folds.items[i], &states[i], error);
        if (status == KG_ERR_INPUT)
            kg_fail_in(error, status, "fold %zu cannot be done without fold %zu: ", i + 1,
                       index + 1);
        from = states[i];
    }
    if (status) {
        for (size_t i = index + 1; states && i < o->step; i++)
            kg_state_destroy(states[i]);
        free(states);
        return status;
    }
    cut_folds(o, o->step);
    json_decref(o->folds.items[index].json);
    memmove(&o->folds.items[index], &o->folds.items[index + 1],
            (o->folds.count - index - 1) * sizeof *o->folds.items);
    o->folds.count--;
    kg_state_destroy(o->states.items[index + 1]);
    for (size_t i = index + 1; i < o->step; i++) {
        if (i + 1 < o->states.count)
            kg_state_destroy(o->states.items[i + 1]);
        o->states.items[i] = states[i];
    }
    o->states.count--;
    o->step--;
    free(states);
    return KG_OK;
}

void kg_origami_between(const kg_origami *o, size_t step, double fraction, kg_vec3 *out_positions) {
    const kg_origami_state *before = o->states.items[step], *after = o->states.items[step + 1];
    kg_fold_axis axis;
    kg_status status = kg_state_fold_axis(before, &o->folds.items[step], &axis, NULL);
    for (size_t i = 0; i < after->vertices.count; i++) {
        kg_vec3 p = after->vertices.items[i].position;
        /* new vertices lie on the axis; others move when they are not where they were */
        bool moved = i < before->vertices.count && (p.x != before->vertices.items[i].position.x ||
                                                    p.y != before->vertices.items[i].position.y ||
                                                    p.z != before->vertices.items[i].position.z);
        out_positions[i] =
            !status && moved
                ? kg_fold_turn(&axis, before->vertices.items[i].position, fraction * axis.angle)
                : p;
    }
}

kg_status kg_origami_count_orders(const kg_origami *o, const kg_progress *progress,
                                  kg_layer_report *report, kg_error *error) {
    kg_origami_state *s = kg_state_copy(o->states.items[0]);
    kg_status status = s ? kg_state_solve(s, progress, report, error) : KG_ERR_MEMORY;
    kg_state_destroy(s);
    return status == KG_ERR_MEMORY ? kg_fail(error, status, "out of memory") : status;
}
