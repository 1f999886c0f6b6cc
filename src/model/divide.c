#include "model/divide.h"

#include "model/clear.h"
#include "model/edit.h"
#include "patch/mend.h"

#include <stdlib.h>
#include <string.h>

enum { PARTS = 3, ROWS = 24, COLUMNS = 12 }; /* places of a part that are looked at */

/* Inside a border by this share of the patch. */
#define HAIR 1e-4

/* Of the places of a half so many may have come to the other side of a cut, because the half was
 * moved; more mean that a wrong piece was kept. So near its joint, as a share of v, none counts. */
#define MOST_CHANGED 0.2
#define JOINT 0.15

/* An interval of v. */
typedef struct span {
    double lo, hi;
} span;

typedef struct task {
    kg_model *model; /* a copy, which is changed */
    const kg_solution *before;
    const kg_model_patch *was;
    const kg_solved_patch *solved;
    kg_patch_parts parts;
    kg_patch patches[PARTS];
    span spans[PARTS][2]; /* of the whole patch what each part replaces, and of the part */
    int64_t ids[KG_DIVIDED];
} task;

static kg_status no_memory(kg_error *error) {
    return kg_fail(error, KG_ERR_MEMORY, "out of memory");
}

/* ---- the parts by themselves ------------------------------------------------------------- */

/* `part` is cut by `cutter`; the piece at `keep` stays. */
static kg_status cut(kg_model *m, int64_t part, int64_t cutter, kg_vec3 keep, kg_error *error) {
    kg_trim_op op = {.kind = KG_TRIM_BY, .by_count = 1, .keep_count = 1};
    op.by = malloc(sizeof *op.by);
    op.keep = malloc(sizeof *op.keep);
    if (!op.by || !op.keep) {
        kg_trim_op_clear(&op);
        return no_memory(error);
    }
    op.by[0] = cutter;
    op.keep[0] = keep;
    return kg_model_add_trim(m, part, &op, error);
}

static kg_status outline(kg_model *m, int64_t part, const kg_vec2 contour[4], kg_error *error) {
    kg_trim_op op = {.kind = KG_TRIM_CONTOUR, .contour_count = 4};
    op.contour = malloc(4 * sizeof *op.contour);
    if (!op.contour)
        return no_memory(error);
    memcpy(op.contour, contour, 4 * sizeof *op.contour);
    return kg_model_add_trim(m, part, &op, error);
}

static kg_status add_wish(kg_model *m, kg_model_join wish, kg_error *error) {
    kg_model_join *more = realloc(m->joins, (m->join_count + 1) * sizeof *more);
    if (!more)
        return no_memory(error);
    m->joins = more;
    more[m->join_count++] = wish;
    return KG_OK;
}

static kg_status add_parts(task *t, const char *const names[KG_DIVIDED], kg_error *error) {
    const kg_patch_parts *parts = &t->parts;
    const kg_patch_input *inputs[KG_DIVIDED] = {&parts->halves[0], &parts->plane, &parts->halves[1],
                                                &parts->cutters[0], &parts->cutters[1]};
    kg_model_patch *first = kg_model_find(t->model, t->was->id);
    for (size_t n = 0; n < first->trim_count; n++)
        kg_trim_op_clear(&first->trims[n]);
    first->trim_count = 0;
    first->input = parts->halves[0];
    t->ids[0] = t->was->id;
    kg_status status = KG_OK;
    for (int i = 1; i < KG_DIVIDED && !status; i++) {
        status = kg_model_add_patch(t->model, inputs[i], names[i], &t->ids[i], error);
        if (!status)
            kg_model_find(t->model, t->ids[i])->construction =
                i >= KG_FIRST_CUT || t->was->construction;
    }
    for (int i = 0; i < PARTS && !status; i++)
        status = kg_patch_init(inputs[i], &t->patches[i], error);
    if (!status)
        status = outline(t->model, t->ids[KG_MIDDLE_PLANE], parts->contour, error);
    for (int i = 0; i < 2 && !status; i++) {
        int64_t half = t->ids[i ? KG_SECOND_HALF : KG_FIRST_HALF];
        int64_t plane = t->ids[KG_MIDDLE_PLANE], cutter = t->ids[KG_FIRST_CUT + i];
        status = cut(t->model, half, cutter, parts->keep[i], error);
        if (!status)
            status = cut(t->model, plane, cutter, parts->keep[2], error);
        if (!status)
            status =
                add_wish(t->model, (kg_model_join){.patches = {half, plane}, .merge = true}, error);
    }
    return status;
}

/* Where a half's geodesic goes through the plane of its cutter. */
static double joint_of(const task *t, int half) {
    const kg_patch_input *cutter = &t->parts.cutters[half];
    const kg_curve *c = &t->patches[half ? KG_SECOND_HALF : KG_FIRST_HALF].geodesic;
    kg_vec3 n = kg_cross(kg_sub(cutter->points[3], cutter->points[0]), cutter->ruling);
    double outer = 1 - half, inner = 0.5;
    bool side = kg_dot(kg_sub(kg_curve_point(c, inner), cutter->points[0]), n) > 0;
    for (int i = 0; i < 50; i++) {
        double v = 0.5 * (inner + outer);
        bool same = (kg_dot(kg_sub(kg_curve_point(c, v), cutter->points[0]), n) > 0) == side;
        *(same ? &inner : &outer) = v;
    }
    return inner;
}

static void find_spans(task *t) {
    double joint[2], was[2], on_plane[2], u;
    for (int i = 0; i < 2; i++) {
        joint[i] = joint_of(t, i);
        kg_vec3 x =
            kg_curve_point(&t->patches[i ? KG_SECOND_HALF : KG_FIRST_HALF].geodesic, joint[i]);
        kg_patch_closest(&t->solved->patch, x, &u, &was[i]);
        kg_patch_closest(&t->patches[KG_MIDDLE_PLANE], x, &u, &on_plane[i]);
    }
    was[1] = fmax(was[1], was[0] + HAIR); /* the halves may have come apart */
    const span spans[PARTS][2] = {{{0, was[0]}, {0, joint[0]}},
                                  {{was[0], was[1]}, {on_plane[0], on_plane[1]}},
                                  {{was[1], 1}, {joint[1], 1}}};
    memcpy(t->spans, spans, sizeof spans);
}

/* ---- what stays of a part ---------------------------------------------------------------- */

/* Places spread over a part, and the region of the whole patch that each was in; -1: none. */
typedef struct sample {
    kg_vec3 x;
    int region;
    double room; /* to the border of the part, mm */
} sample;

static void take_samples(const task *t, int part, sample out[ROWS * COLUMNS]) {
    const kg_patch *p = &t->patches[part], *whole = &t->solved->patch;
    double width = p->extent[1] - p->extent[0], length = p->length_at[KG_PATCH_CELLS];
    double hair = HAIR * (whole->extent[1] - whole->extent[0]);
    for (int i = 0; i < ROWS; i++)
        for (int k = 0; k < COLUMNS; k++) {
            double v = (i + 0.5) / ROWS, f = (k + 0.5) / COLUMNS, at_u, at_v;
            sample *s = &out[i * COLUMNS + k];
            s->x = kg_patch_point(p, p->extent[0] + f * width, v);
            s->room = fmin(fmin(v, 1 - v) * length, fmin(f, 1 - f) * width);
            s->region = -1;
            kg_patch_closest(whole, s->x, &at_u, &at_v);
            /* its extent may have been cut back: what is beyond belongs to its border */
            at_u = fmin(fmax(at_u, whole->extent[0] + hair), whole->extent[1] - hair);
            at_v = fmin(fmax(at_v, HAIR), 1 - HAIR);
            for (size_t r = 0; r < t->solved->regions.count; r++)
                if (kg_region_contains(&t->solved->regions.items[r], at_u, at_v))
                    s->region = (int)r;
        }
}

/* For every region of the whole patch that reaches onto a part the place that is farthest from what
 * was cut away; their number goes to `out_count`. */
static kg_status find_kept(const task *t, int part, kg_vec3 **out, size_t *out_count) {
    sample *s = malloc(ROWS * COLUMNS * sizeof *s);
    kg_vec3 *kept = malloc((t->solved->regions.count + 1) * sizeof *kept);
    if (!s || !kept) {
        free(s);
        free(kept);
        return KG_ERR_MEMORY;
    }
    size_t count = 0;
    take_samples(t, part, s);
    for (int r = 0; r < (int)t->solved->regions.count; r++) {
        double best = 0;
        for (int i = 0; i < ROWS * COLUMNS; i++) {
            double room = s[i].region == r ? s[i].room : 0;
            for (int k = 0; k < ROWS * COLUMNS && room > best; k++)
                if (s[k].region != r)
                    room = fmin(room, kg_dist(s[i].x, s[k].x));
            if (room > best) {
                best = room;
                kept[count] = s[i].x;
            }
        }
        count += best > 0;
    }
    free(s);
    *out = kept;
    *out_count = count;
    return KG_OK;
}

/* ---- trims of the patch ------------------------------------------------------------------ */

static kg_status nothing_left(kg_error *error) {
    return kg_fail(error, KG_ERR_INPUT,
                   "cannot be split: nothing would be left of a part; refit it before");
}

static kg_status meets(const task *t, const kg_patch *a, const kg_patch *b, bool *out,
                       kg_error *error) {
    kg_crossings found;
    kg_status status = kg_crossings_find(a, b, kg_solution_tolerance(t->before), &found, error);
    *out = !status && found.count > 0;
    if (!status)
        kg_crossings_clear(&found);
    return status;
}

/* Leaves those of a trim's cutters that meet the part. */
static kg_status filter_cutters(const task *t, int part, kg_trim_op *op, kg_error *error) {
    kg_status status = KG_OK;
    size_t count = 0;
    for (size_t b = 0; b < op->by_count && !status; b++) {
        const kg_solved_patch *cutter = kg_solution_find(t->before, op->by[b]);
        bool found = op->off;
        if (cutter && cutter->prepared && !op->off)
            status = meets(t, &t->patches[part], &cutter->patch, &found, error);
        if (found)
            op->by[count++] = op->by[b];
    }
    op->by_count = count;
    return status;
}

/* The face of a trim by several is closed by the cuts of the part where it goes on beyond them. */
static kg_status close_face(const task *t, int part, kg_trim_op *op, kg_error *error) {
    int64_t *more = realloc(op->by, (op->by_count + 2) * sizeof *more);
    if (!more)
        return no_memory(error);
    op->by = more;
    for (int i = 0; i < 2; i++)
        if (part == KG_MIDDLE_PLANE || part == (i ? KG_SECOND_HALF : KG_FIRST_HALF))
            more[op->by_count++] = t->ids[KG_FIRST_CUT + i];
    return KG_OK;
}

/* Lays a contour on the part: v runs evenly between its ends, u is as it was. False: it is beside
 * the part. */
static bool lay_contour(const task *t, int part, kg_trim_op *op) {
    const span *from = &t->spans[part][0], *to = &t->spans[part][1];
    double middle = 0.5 * (from->lo + from->hi), lo = HUGE_VAL, hi = -HUGE_VAL;
    double scale = (to->hi - to->lo) / (from->hi - from->lo);
    kg_vec3 d = kg_patch_ruling(&t->solved->patch, middle).d;
    kg_vec3 e = kg_patch_ruling(&t->patches[part], 0.5 * (to->lo + to->hi)).d;
    for (size_t i = 0; i < op->contour_count; i++) {
        kg_vec2 *c = &op->contour[i];
        *c = kg_v2(kg_dot(d, e) < 0 ? -c->x : c->x, to->lo + scale * (c->y - from->lo));
        lo = fmin(lo, c->y);
        hi = fmax(hi, c->y);
    }
    return lo < to->hi && hi > to->lo;
}

static kg_status carry_contour(task *t, int part, kg_trim_op *op, kg_error *error) {
    if (lay_contour(t, part, op))
        return kg_model_add_trim(t->model, t->ids[part], op, error);
    bool gone = !op->outside && !op->off;
    kg_trim_op_clear(op);
    return gone ? nothing_left(error) : KG_OK;
}

static kg_status carry_cut(task *t, int part, kg_trim_op *op, const kg_vec3 *kept, size_t count,
                           kg_error *error) {
    size_t cutters = op->by_count;
    kg_status status = filter_cutters(t, part, op, error);
    if (status || op->by_count == 0) {
        kg_trim_op_clear(op);
        return status;
    }
    if (op->kind == KG_TRIM_INSIDE && op->by_count < cutters)
        status = close_face(t, part, op, error);
    if (!status && !op->off && (op->keep_count > 0 || op->kind == KG_TRIM_INSIDE)) {
        kg_vec3 *keep = malloc(count * sizeof *keep);
        free(op->keep);
        op->keep = keep;
        op->keep_count = keep ? count : 0;
        if (keep)
            memcpy(keep, kept, count * sizeof *keep);
        else
            status = no_memory(error);
    }
    if (status) {
        kg_trim_op_clear(op);
        return status;
    }
    return kg_model_add_trim(t->model, t->ids[part], op, error);
}

static kg_status carry_trims(task *t, int part, kg_error *error) {
    kg_vec3 *kept = NULL;
    size_t count = 0;
    kg_status status = find_kept(t, part, &kept, &count);
    if (!status && count == 0)
        status = nothing_left(error);
    for (size_t n = 0; n < t->was->trim_count && !status; n++) {
        kg_trim_op op;
        if (t->was->trims[n].trim_cutters && !t->was->trims[n].off)
            status = kg_fail(error, KG_ERR_INPUT,
                             "cannot be split while its trims also trim the cutters");
        else if (!kg_trim_op_copy(&t->was->trims[n], &op)) {
            kg_trim_op_clear(&op);
            status = no_memory(error);
        } else if (op.kind == KG_TRIM_CONTOUR)
            status = carry_contour(t, part, &op, error);
        else
            status = carry_cut(t, part, &op, kept, count, error);
    }
    free(kept);
    return status;
}

/* ---- others ------------------------------------------------------------------------------ */

/* Puts the parts that patch `other` meets in the place of the patch in one of its trims. */
static kg_status replace_cutter(task *t, kg_model_patch *other, kg_trim_op *op, size_t at,
                                kg_error *error) {
    const kg_solved_patch *solved = kg_solution_find(t->before, other->id);
    int64_t found[PARTS];
    size_t count = 0;
    kg_status status = KG_OK;
    for (int i = 0; i < PARTS && !status && solved && solved->prepared; i++) {
        bool met;
        status = meets(t, &solved->patch, &t->patches[i], &met, error);
        if (met)
            found[count++] = t->ids[i];
    }
    if (status || count == 0)
        return status;
    if (count > 1 && op->kind == KG_TRIM_BY && !op->off)
        return kg_fail(error, KG_ERR_INPUT,
                       "cannot be split: patch %lld, which it trims, lies across the plane",
                       (long long)other->id);
    int64_t *more = realloc(op->by, (op->by_count + PARTS) * sizeof *more);
    if (!more)
        return no_memory(error);
    op->by = more;
    more[at] = found[0];
    for (size_t i = 1; i < count && op->kind == KG_TRIM_INSIDE; i++)
        more[op->by_count++] = found[i];
    return KG_OK;
}

static kg_status follow_cutters(task *t, kg_error *error) {
    kg_status status = KG_OK;
    for (size_t i = 0; i < t->model->patch_count && !status; i++) {
        kg_model_patch *p = &t->model->patches[i];
        for (size_t n = 0; n < p->trim_count; n++)
            for (size_t b = 0; b < p->trims[n].by_count && !status; b++)
                if (p->trims[n].by[b] == t->was->id) {
                    status = replace_cutter(t, p, &p->trims[n], b, error);
                    break; /* once in each trim */
                }
    }
    return status;
}

/* The part nearest to a point. */
static int part_at(const task *t, kg_vec3 x, kg_vec2 *out_at) {
    double nearest = HUGE_VAL;
    int best = 0;
    for (int i = 0; i < PARTS; i++) {
        kg_vec2 at;
        double d = kg_patch_closest(&t->patches[i], x, &at.x, &at.y);
        if (d < nearest) {
            nearest = d;
            best = i;
            *out_at = at;
        }
    }
    return best;
}

/* A wish for one join goes to the part at its place, one for all of them to every part. */
static kg_status follow_joins(task *t, size_t count, kg_error *error) {
    kg_status status = KG_OK;
    for (size_t i = 0; i < count && !status; i++) {
        kg_model_join *j = &t->model->joins[i];
        int side = j->patches[0] == t->was->id ? 0 : 1;
        if (j->patches[side] != t->was->id || j->patches[1 - side] == t->was->id)
            continue;
        if (j->has_at) {
            const kg_solved_patch *on = kg_solution_find(t->before, j->patches[0]);
            kg_vec2 at = j->at;
            if (!on || !on->prepared)
                continue;
            j->patches[side] = t->ids[part_at(t, kg_patch_point(&on->patch, at.x, at.y), &at)];
            if (side == 0)
                j->at = at;
            continue;
        }
        for (int part = 1; part < PARTS && !status; part++) {
            kg_model_join wish = t->model->joins[i];
            wish.patches[side] = t->ids[part];
            wish.json = NULL;
            status = add_wish(t->model, wish, error);
        }
    }
    return status;
}

/* ---- is it sound? ------------------------------------------------------------------------ */

/* Whether a half kept what was kept there. */
static kg_status compare(const task *t, int part, const kg_solution *s, kg_error *error) {
    const kg_solved_patch *p = kg_solution_find(s, t->ids[part]);
    sample *samples = malloc(ROWS * COLUMNS * sizeof *samples);
    int changed = 0, held = 0;
    if (!samples)
        return no_memory(error);
    take_samples(t, part, samples);
    for (int i = 0; i < ROWS * COLUMNS; i++) {
        double at_u, at_v;
        bool is = false, was = samples[i].region >= 0;
        kg_patch_closest(&p->patch, samples[i].x, &at_u, &at_v);
        for (size_t r = 0; r < p->regions.count; r++)
            is = is || kg_region_contains(&p->regions.items[r], at_u, at_v);
        if (part == KG_FIRST_HALF ? at_v > 1 - JOINT : at_v < JOINT)
            continue;
        changed += is != was;
        held += is || was;
    }
    free(samples);
    if (changed > MOST_CHANGED * held)
        return kg_fail(error, KG_ERR_INPUT,
                       "cannot be split: what its trims keep would not be found again");
    return KG_OK;
}

/* Takes out trims that only met what another cut took away. True: there were such. */
static bool drop_idle(task *t, const kg_solution *s) {
    bool dropped = false;
    for (int i = 0; i < PARTS; i++) {
        kg_model_patch *p = kg_model_find(t->model, t->ids[i]);
        const kg_trim_notes *notes = &kg_solution_find(s, t->ids[i])->notes;
        size_t kept = 0;
        for (size_t n = 0; n < p->trim_count; n++) {
            kg_trim_op *op = &p->trims[n];
            bool idle = false;
            for (size_t k = 0; k < notes->count && op->kind == KG_TRIM_BY; k++)
                idle = idle || (notes->items[k].kind == KG_NOTE_OUTSIDE &&
                                notes->items[k].source == op->by[0]);
            dropped = dropped || idle;
            if (idle)
                kg_trim_op_clear(op);
            else
                p->trims[kept++] = *op;
        }
        p->trim_count = kept;
    }
    return dropped;
}

static kg_status check(task *t, kg_error *error) {
    kg_solution *s;
    double tolerance = kg_solution_tolerance(t->before);
    kg_status status = kg_solution_create(t->model, tolerance, NULL, &s, error);
    if (!status && drop_idle(t, s))
        status = kg_solution_create(t->model, tolerance, s, &s, error);
    if (status)
        return status;
    for (size_t i = 0; i < kg_solution_issue_count(s) && !status; i++) {
        const kg_issue *issue = kg_solution_issue(s, i);
        if (issue->severity == KG_FAULT && kg_solution_find(t->before, issue->patch) &&
            !kg_solution_find(t->before, issue->patch)->valid)
            continue; /* it had one before */
        if (issue->severity == KG_FAULT)
            status = kg_fail(error, KG_ERR_INPUT, "cannot be split: a part %s", issue->message);
    }
    for (int half = KG_FIRST_HALF; half <= KG_SECOND_HALF && !status; half += 2)
        status = compare(t, half, s, error);
    kg_solution_destroy(s);
    return status;
}

/* ---- the edit ---------------------------------------------------------------------------- */

static kg_status divide(task *t, const char *const names[KG_DIVIDED], kg_error *error) {
    size_t wishes = t->model->join_count;
    kg_status status = add_parts(t, names, error);
    if (!status)
        find_spans(t);
    for (int i = 0; i < PARTS && !status; i++)
        status = carry_trims(t, i, error);
    if (!status)
        status = follow_cutters(t, error);
    if (!status)
        status = follow_joins(t, wishes, error);
    return status ? status : check(t, error);
}

kg_status kg_model_divide(kg_model *model, const kg_solution *solution, int64_t id,
                          const char *const names[KG_DIVIDED], int64_t out_ids[KG_DIVIDED],
                          kg_error *error) {
    task t = {.before = solution,
              .was = kg_model_find(model, id),
              .solved = kg_solution_find(solution, id)};
    if (!t.was || !t.solved)
        return kg_fail(error, KG_ERR_INPUT, "does not exist");
    if (!t.solved->valid || t.solved->regions.count == 0)
        return kg_fail(error, KG_ERR_INPUT, "is not valid; mend it first");
    kg_status status = kg_patch_divide(&t.was->input, &t.parts, error);
    if (status)
        return status;
    t.model = kg_model_copy(model);
    status = t.model ? divide(&t, names, error) : no_memory(error);
    if (!status) {
        kg_model_swap(model, t.model);
        memcpy(out_ids, t.ids, sizeof t.ids);
    }
    kg_model_destroy(t.model);
    return status;
}
