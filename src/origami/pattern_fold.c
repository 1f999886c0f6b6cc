/* Crease patterns folded: every face turned about the creases between it and the first one. */
#include "origami/pattern.h"

#include <stdlib.h>

/* Radians: how far alternate angles around a vertex may be from a half turn; files have few
 * digits. */
#define KAWASAKI 1e-3
/* Relative to the size: how far a vertex may come apart for the same reason. */
#define CLOSES 1e-4

/* Paper (x, y) lies at o + x ex + y ey. */
typedef struct frame {
    kg_vec3 o, ex, ey;
} frame;

static kg_vec3 place(const frame *f, kg_vec2 p) {
    return kg_madd(kg_madd(f->o, p.x, f->ex), p.y, f->ey);
}

static bool is_flat_fold(double angle) {
    return fabs(fabs(angle) - KG_PI) < 1e-9;
}

static kg_vec3 turn(kg_vec3 r, kg_vec3 d, double angle) {
    double c = is_flat_fold(angle) ? -1 : cos(angle), s = is_flat_fold(angle) ? 0 : sin(angle);
    return kg_madd(kg_madd(kg_scale(r, c), s, kg_cross(d, r)), (1 - c) * kg_dot(d, r), d);
}

/* The face across a half-edge. A valley turns it towards the front: from the left of the direction
 * d its normal n becomes n cos + (n × d) sin. */
static frame frame_across(const kg_origami_state *s, const frame *f, int32_t half) {
    kg_vec2 a = s->vertices.items[s->halves.items[half].origin].paper,
            b = s->vertices.items[s->halves.items[kg_twin(half)].origin].paper;
    kg_vec3 p = place(f, a), d = kg_unit(kg_sub(place(f, b), p));
    double angle = -s->edges.items[half >> 1].angle;
    if (angle == 0)
        return *f;
    return (frame){kg_add(p, turn(kg_sub(f->o, p), d, angle)), turn(f->ex, d, angle),
                   turn(f->ey, d, angle)};
}

/* ---- around one vertex ------------------------------------------------------------------ */

/* KG_ERR_INPUT when the creases around an inner vertex, all flat ones, cannot be folded flat. */
static kg_status check_vertex(const kg_pattern *p, const kg_origami_state *s, int32_t start,
                              kg_error *error) {
    int32_t v = s->halves.items[start].origin;
    kg_vec2 o = s->vertices.items[v].paper, told = kg_pattern_in_file(p, o);
    double sums[2] = {0, 0}, last = 0, first = 0, total = 0;
    int folds = 0, mountains = 0, valleys = 0, open = 0;
    for (int32_t h = start;;) { /* clockwise */
        const kg_paper_edge *e = &s->edges.items[h >> 1];
        if (kg_loop_of(s, h) < 0 || kg_loop_of(s, kg_twin(h)) < 0)
            return KG_OK;
        if (e->angle != 0) {
            if (!is_flat_fold(e->angle))
                return KG_OK;
            mountains += e->kind == KG_PAPER_CREASE && e->angle < 0;
            valleys += e->kind == KG_PAPER_CREASE && e->angle > 0;
            open += e->kind == KG_PAPER_OPEN;
            if (folds++ == 0)
                first = total;
            else
                sums[folds & 1] += total - last;
            last = total;
        }
        int32_t next = kg_next(s, kg_twin(h));
        kg_vec2 a = kg_sub2(s->vertices.items[s->halves.items[kg_twin(h)].origin].paper, o),
                b = kg_sub2(s->vertices.items[s->halves.items[kg_twin(next)].origin].paper, o);
        total += fabs(atan2(kg_cross2(a, b), kg_dot2(a, b)));
        h = next;
        if (h == start)
            break;
    }
    if (folds == 0)
        return KG_OK;
    sums[(folds + 1) & 1] += total - last + first;
    if (folds % 2 == 1 || fabs(sums[0] - KG_PI) > KAWASAKI)
        return kg_fail(error, KG_ERR_INPUT,
                       "vertex %d at (%g, %g) does not fold flat: alternate angles are %.4g and "
                       "%.4g degrees, not both 180 (Kawasaki)",
                       v, told.x, told.y, sums[0] * 180 / KG_PI, sums[1] * 180 / KG_PI);
    if (open == 0 && abs(mountains - valleys) != 2)
        return kg_fail(error, KG_ERR_INPUT,
                       "vertex %d at (%g, %g) does not fold flat: %d mountain and %d valley folds, "
                       "not two more of one kind (Maekawa)",
                       v, told.x, told.y, mountains, valleys);
    return KG_OK;
}

static kg_status check_vertices(const kg_pattern *p, const kg_origami_state *s, kg_error *error) {
    int32_t *out = malloc((s->vertices.count + 1) * sizeof *out);
    if (!out)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    kg_status status = KG_OK;
    for (size_t v = 0; v < s->vertices.count; v++)
        out[v] = -1;
    for (size_t h = s->halves.count; h-- > 0;)
        if (kg_loop_of(s, (int32_t)h) >= 0)
            out[s->halves.items[h].origin] = (int32_t)h;
    for (size_t v = 0; v < s->vertices.count && !status; v++)
        if (out[v] >= 0)
            status = check_vertex(p, s, out[v], error);
    free(out);
    return status;
}

/* ---- all faces -------------------------------------------------------------------------- */

static kg_status find_frames(const kg_origami_state *s, frame *frames) {
    int32_t *todo = malloc((s->loops.count + 1) * sizeof *todo);
    bool *done = calloc(s->loops.count + 1, sizeof *done);
    kg_status status = todo && done ? KG_OK : KG_ERR_MEMORY;
    for (size_t i = 0; i < s->loops.count && !status; i++) {
        size_t from = 0, to = 0;
        if (done[i])
            continue;
        done[i] = true;
        frames[i] = (frame){kg_v3(0, 0, 0), kg_v3(1, 0, 0), kg_v3(0, 1, 0)};
        todo[to++] = (int32_t)i;
        while (from < to) { /* in breadth: short chains keep rounding small */
            int32_t loop = todo[from++], first = s->loops.items[loop].first, h = first;
            do {
                int32_t other = kg_loop_of(s, kg_twin(h));
                if (other < 0 || done[other])
                    continue;
                done[other] = true;
                frames[other] = frame_across(s, &frames[loop], h);
                todo[to++] = other;
            } while ((h = kg_next(s, h)) != first);
        }
    }
    free(todo);
    free(done);
    return status;
}

static kg_status place_vertices(kg_origami_state *s, const frame *frames, kg_error *error) {
    bool *placed = calloc(s->vertices.count + 1, sizeof *placed);
    if (!placed)
        return KG_ERR_MEMORY;
    double worst = 0;
    int32_t where = 0;
    for (size_t h = 0; h < s->halves.count; h++) {
        int32_t loop = kg_loop_of(s, (int32_t)h), v = s->halves.items[h].origin;
        if (loop < 0)
            continue;
        kg_vec3 p = place(&frames[loop], s->vertices.items[v].paper);
        if (placed[v] && kg_dist(p, s->vertices.items[v].position) > worst)
            worst = kg_dist(p, s->vertices.items[v].position), where = v;
        if (!placed[v])
            s->vertices.items[v].position = p;
        placed[v] = true;
    }
    free(placed);
    if (worst > CLOSES * s->size)
        return kg_fail(error, KG_ERR_INPUT,
                       "the paper does not close around vertex %d: it comes apart by %.3g mm",
                       where, worst);
    s->touch = fmax(KG_OVERLAP * s->size, 10 * worst);
    return KG_OK;
}

static kg_status find_groups(kg_origami_state *s) {
    s->groups.count = 0;
    for (size_t i = 0; i < s->loops.count; i++) {
        kg_vec3 n = kg_origami_normal(s, (int32_t)i);
        double offset = kg_dot(n, *kg_origin(s, s->loops.items[i].first));
        size_t g = 0;
        for (; g < s->groups.count; g++) {
            const kg_face_group *k = &s->groups.items[g];
            double same = kg_dot(n, k->normal) > 0 ? 1 : -1;
            if (kg_len(kg_cross(n, k->normal)) * s->size < 10 * s->touch &&
                fabs(offset - same * k->offset) < 10 * s->touch)
                break;
        }
        if (g == s->groups.count && !kg_push(&s->groups, ((kg_face_group){n, offset})))
            return KG_ERR_MEMORY;
        s->loops.items[i].group = (int32_t)g;
    }
    return KG_OK;
}

kg_status kg_pattern_take(kg_origami_state *s, kg_error *error) {
    double worst = 0;
    for (size_t i = 0; i < s->loops.count; i++) {
        int32_t first = s->loops.items[i].first;
        for (int32_t h = kg_next(s, first); h != first; h = kg_next(s, h))
            for (int32_t k = first; k != h; k = kg_next(s, k)) {
                const kg_paper_vertex *a = &s->vertices.items[s->halves.items[h].origin],
                                      *b = &s->vertices.items[s->halves.items[k].origin];
                double off = kg_dist(a->position, b->position) - kg_dist2(a->paper, b->paper);
                worst = fmax(worst, fabs(off));
                if (!(fabs(off) <= CLOSES * s->size))
                    return kg_fail(error, KG_ERR_INPUT,
                                   "face %zu of the folded form is not that of the crease pattern: "
                                   "it is stretched by %.3g mm",
                                   i, off);
            }
    }
    s->touch = fmax(KG_OVERLAP * s->size, 10 * worst);
    return find_groups(s);
}

kg_status kg_pattern_fold(const kg_pattern *p, kg_origami_state *s, kg_error *error) {
    kg_status status = check_vertices(p, s, error);
    if (status)
        return status;
    frame *frames = calloc(s->loops.count + 1, sizeof *frames);
    status = frames ? find_frames(s, frames) : KG_ERR_MEMORY;
    if (!status)
        status = place_vertices(s, frames, error);
    if (!status)
        status = find_groups(s);
    free(frames);
    return status == KG_ERR_MEMORY ? kg_fail(error, status, "out of memory") : status;
}
