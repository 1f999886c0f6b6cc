/* Splitting a patch in two with a plane in between, cut apart by construction patches. */
#include "app/commands/mend.h"
#include "app/scenery.h"
#include "app/text.h"
#include "model/edit.h"
#include "patch/mend.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool kg_mend_is_trimmed(const kg_model *m, const kg_model_patch *p) {
    bool found = p->trim_count > 0;
    for (size_t i = 0; i < m->patch_count; i++)
        for (size_t n = 0; n < m->patches[i].trim_count; n++)
            for (size_t b = 0; b < m->patches[i].trims[n].by_count; b++)
                found = found || m->patches[i].trims[n].by[b] == p->id;
    return found;
}

static kg_status add_part(kg_model *m, const char *name, const char *suffix, const char *color,
                          const kg_patch_input *input, int64_t *out_id, kg_error *error) {
    char text[256];
    snprintf(text, sizeof text, "%s%s%s", name, name[0] ? " " : "", suffix);
    kg_status status = kg_model_add_patch(m, input, text, out_id, error);
    if (!status && color)
        status = kg_model_set_patch_color(kg_model_find(m, *out_id), color, error);
    return status;
}

/* `part` is cut by `cutter`; the piece at `keep` stays. */
static kg_status cut(kg_model *m, int64_t part, int64_t cutter, kg_vec3 keep, kg_error *error) {
    kg_trim_op op = {.kind = KG_TRIM_BY, .by_count = 1, .keep_count = 1};
    op.by = malloc(sizeof *op.by);
    op.keep = malloc(sizeof *op.keep);
    if (!op.by || !op.keep) {
        free(op.by);
        free(op.keep);
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    }
    op.by[0] = cutter;
    op.keep[0] = keep;
    return kg_model_add_trim(m, part, &op, error);
}

static kg_status outline(kg_model *m, int64_t part, const kg_vec2 contour[4], kg_error *error) {
    kg_trim_op op = {.kind = KG_TRIM_CONTOUR, .contour_count = 4};
    op.contour = malloc(4 * sizeof *op.contour);
    if (!op.contour)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    memcpy(op.contour, contour, 4 * sizeof *op.contour);
    return kg_model_add_trim(m, part, &op, error);
}

/* The wish that both are one part of the net. */
static kg_status merge(kg_model *m, int64_t a, int64_t b, kg_error *error) {
    kg_model_join *more = realloc(m->joins, (m->join_count + 1) * sizeof *more);
    if (!more)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    m->joins = more;
    more[m->join_count++] = (kg_model_join){.patches = {a, b}, .merge = true};
    return KG_OK;
}

/* The cuts have to work as they were meant to. */
static kg_status check_sound(kg_editor *e, const int64_t *ids, size_t count, kg_error *error) {
    kg_editor_touch(e);
    kg_editor_update(e);
    const kg_solution *s = kg_editor_solution(e);
    for (size_t i = 0; i < kg_solution_issue_count(s); i++)
        for (size_t k = 0; k < count; k++)
            if (kg_solution_issue(s, i)->patch == ids[k])
                return kg_fail(error, KG_ERR_INPUT, "cannot be split: a part %s",
                               kg_solution_issue(s, i)->message);
    return KG_OK;
}

kg_status kg_mend_split(kg_editor *e, int64_t id, kg_error *error) {
    kg_model *m = kg_editor_model(e);
    kg_model_patch *p = kg_model_find(m, id);
    kg_patch_parts parts;
    if (kg_mend_is_trimmed(m, p))
        return kg_fail(error, KG_ERR_INPUT,
                       "is trimmed or trims others, which the parts would not do; split it before "
                       "it is trimmed");
    kg_status status = kg_patch_divide(&p->input, &parts, error);
    char *name = status ? NULL : strdup(p->name);
    char color[8]; /* as it is shown: the parts stay one thing to the eye */
    kg_color_print(kg_patch_color(p), color);
    if (!status && !name)
        status = kg_fail(error, KG_ERR_MEMORY, "out of memory");
    int64_t half = 0, plane = 0, cutters[2] = {0, 0};
    if (!status) {
        p->input = parts.halves[0];
        status = add_part(m, name, _("plane"), color, &parts.plane, &plane, error);
    }
    if (!status)
        status = add_part(m, name, "2", color, &parts.halves[1], &half, error);
    for (int i = 0; i < 2 && !status; i++) {
        status = add_part(m, name, i ? _("cut 2") : _("cut 1"), NULL, &parts.cutters[i],
                          &cutters[i], error);
        if (!status)
            kg_model_find(m, cutters[i])->construction = true;
    }
    if (!status)
        status = outline(m, plane, parts.contour, error);
    for (int i = 0; i < 2 && !status; i++) {
        int64_t part = i ? half : id;
        status = cut(m, part, cutters[i], parts.keep[i], error);
        if (!status)
            status = cut(m, plane, cutters[i], parts.keep[2], error);
        if (!status)
            status = merge(m, part, plane, error);
    }
    free(name);
    if (!status)
        status = check_sound(e, (const int64_t[]){id, plane, half}, 3, error);
    const int64_t all[] = {plane, half, cutters[0], cutters[1]};
    for (size_t i = 0; i < sizeof all / sizeof *all && !status; i++)
        if (!kg_editor_is_selected(e, all[i]))
            kg_editor_select(e, all[i], true);
    return status;
}
