/* Planning the pictures of a folding sequence: from where they are seen, what is folded how. */
#include "guide/diagram.h"

#include "origami/folding.h"

#include <stdlib.h>

/* Costs of a side to look from: a fold that goes behind, paper turned over, and beginning with the
 * back up. */
#define BEHIND_COST 1.0
#define TURN_COST 1.5
#define BACK_COST 0.4

/* Oblique pictures are seen from this far off the upright, from one of these directions around it:
 * y stays up. */
static const double TILT = 0.9;
static const double directions[] = {-0.6, -1.0, -1.35, -1.8, -2.1, -2.5};

typedef struct plan {
    kg_moment moment;
    kg_fold_axis axis; /* of a fold */
    bool folds, flat;
    kg_vec3 normal; /* of a flat state; up */
} plan;

/* ---- states ----------------------------------------------------------------------------- */

static kg_vec3 upwards(kg_vec3 n) {
    bool down = fabs(n.z) > 1e-6 ? n.z < 0 : n.y > 0;
    return down ? kg_neg(n) : n;
}

/* All in one plane? */
static bool is_flat(const kg_origami_state *s, kg_vec3 *out_normal) {
    *out_normal = kg_v3(0, 0, 1);
    if (s->loops.count == 0)
        return true;
    const kg_face_group *g = &s->groups.items[s->loops.items[0].group];
    *out_normal = upwards(g->normal);
    for (size_t i = 0; i < s->vertices.count; i++)
        if (fabs(kg_dot(g->normal, s->vertices.items[i].position) - g->offset) > 1e-6 * s->size)
            return false;
    return true;
}

/* Does fold `step` + 1 bring back what fold `step` did? */
static bool is_undone(const kg_origami *o, size_t step) {
    if (step + 2 > kg_origami_step(o))
        return false;
    const kg_origami_state *before = kg_origami_state_at(o, step),
                           *after = kg_origami_state_at(o, step + 2);
    for (size_t i = 0; i < before->vertices.count; i++)
        if (kg_dist(before->vertices.items[i].position, after->vertices.items[i].position) >
            1e-6 * before->size)
            return false;
    return true;
}

static kg_status plan_create(const kg_origami *o, size_t step, plan *out, kg_error *error) {
    plan p = {.folds = step < kg_origami_step(o)};
    kg_status status = kg_moment_create(o, step, &p.moment, error);
    if (!status && p.folds)
        status = kg_state_fold_axis(p.moment.layers, kg_origami_fold_at(o, step), &p.axis, error);
    if (status) {
        kg_moment_clear(&p.moment);
        return status;
    }
    p.flat = is_flat(p.moment.layers, &p.normal);
    *out = p;
    return KG_OK;
}

/* ---- from where ------------------------------------------------------------------------- */

static void look_along(kg_diagram *d, kg_vec3 back) {
    kg_vec3 up = fabs(back.y) < 0.999 ? kg_v3(0, 1, 0) : kg_v3(0, 0, 1);
    d->back = back;
    d->up = kg_unit(kg_madd(up, -kg_dot(up, back), back));
    d->right = kg_cross(d->up, back);
}

static bool is_oblique(const plan *p) {
    return !p->flat || (p->folds && fabs(p->axis.angle) < KG_PI - 1e-9);
}

/* The direction that shows most of the paper. */
static kg_vec3 oblique_back(const plan *p, int side) {
    const kg_origami_state *s = p->moment.topology;
    kg_vec3 best = kg_v3(0, 0, 1);
    double most = -1;
    for (size_t k = 0; k < sizeof directions / sizeof *directions; k++) {
        kg_vec3 d =
            kg_v3(sin(TILT) * cos(directions[k]), sin(TILT) * sin(directions[k]), side * cos(TILT));
        double shown = 0;
        for (size_t h = 0; h < s->halves.count; h++) {
            int32_t next = s->halves.items[h].next, loop = s->halves.items[h].loop;
            if (loop < 0)
                continue;
            /* triangles from the loop's first corner, before and after the fold */
            int32_t first = s->halves.items[s->loops.items[loop].first].origin,
                    a = s->halves.items[h].origin, b = s->halves.items[next].origin;
            const kg_vec3 *q = p->moment.positions;
            shown += fabs(kg_dot(d, kg_cross(kg_sub(q[a], q[first]), kg_sub(q[b], q[first]))));
            const kg_paper_vertex *v = s->vertices.items;
            shown += fabs(kg_dot(d, kg_cross(kg_sub(v[a].position, v[first].position),
                                             kg_sub(v[b].position, v[first].position))));
        }
        if (p->folds) /* an arrow is seen best along the line that it turns about */
            shown *= 0.4 + fabs(kg_dot(d, p->axis.axis));
        if (shown > most * (1 + 1e-9))
            most = shown, best = d;
    }
    return best;
}

static kg_vec3 back_of(const plan *p, int side) {
    return is_oblique(p) ? oblique_back(p, side) : kg_scale(p->normal, side);
}

/* Does the moving part start away from an eye in this direction? */
static bool goes_behind(const plan *p, kg_vec3 back) {
    return p->folds && kg_dot(p->axis.normal, back) * p->axis.angle < 0;
}

/* The cheapest sequence of sides (Viterbi); the last picture keeps the side before it. */
static void choose_sides(const plan *plans, size_t count, kg_diagram *diagrams) {
    double cost[2] = {0, BACK_COST};
    for (size_t i = 0; i < count; i++) {
        double now[2];
        int from[2]; /* kept in `side`, a bit each, until the way back is known */
        for (int k = 0; k < 2; k++) {
            double stay = cost[k], turn = cost[1 - k] + TURN_COST;
            bool behind = goes_behind(&plans[i], back_of(&plans[i], k ? -1 : 1));
            from[k] = i == 0 || stay <= turn ? k : 1 - k;
            now[k] = (from[k] == k ? stay : turn) + (behind ? BEHIND_COST : 0);
        }
        diagrams[i].side = from[0] | from[1] << 1;
        cost[0] = now[0], cost[1] = now[1];
    }
    int k = cost[1] < cost[0];
    for (size_t i = count; i-- > 0;) {
        int from = diagrams[i].side >> k & 1;
        diagrams[i].side = k ? -1 : 1;
        k = from;
    }
}

/* ---- what is folded --------------------------------------------------------------------- */

static kg_vec2 seen(const kg_diagram *d, kg_vec3 p) {
    return kg_v2(kg_dot(d->right, p), kg_dot(d->up, p));
}

/* Where the moving part is held: the corner that is folded, or the edge that is farthest from the
 * line, by its middle. */
typedef struct grip {
    kg_vec3 point, ends[2];
    bool edge;
} grip;

static grip find_grip(const plan *p, const kg_fold *fold) {
    const kg_origami_state *s = p->moment.topology;
    const kg_vec3 *q = p->moment.positions;
    double most = 0, lo = INFINITY, hi = -INFINITY;
    kg_vec3 first = fold->vertex, last = first;
    for (int round = 0; round < 2; round++)
        for (size_t h = 0; h < s->halves.count; h++) {
            int32_t loop = s->halves.items[h].loop, v = s->halves.items[h].origin;
            double r = kg_fold_radius(&p->axis, q[v]), t = kg_dot(q[v], p->axis.axis);
            if (loop < 0 || !p->moment.moves[loop])
                continue;
            most = fmax(most, r);
            if (round == 0 || r < 0.999 * most)
                continue;
            if (t < lo)
                lo = t, first = q[v];
            if (t > hi)
                hi = t, last = q[v];
        }
    grip g = {kg_lerp(first, last, 0.5), {first, last}, hi - lo > KG_PICK * s->size};
    for (size_t v = 0; v < p->moment.layers->vertices.count && !fold->by_axis && !g.edge; v++)
        if (kg_dist(q[v], fold->points[0]) < KG_PICK * s->size)
            g.point = g.ends[0] = g.ends[1] = q[v];
    return g;
}

static bool lies_in(const plan *p, size_t loop, kg_vec2 at) {
    const kg_origami_state *s = p->moment.topology;
    int32_t first = s->loops.items[loop].first, h = first;
    bool left = true, right = true;
    do {
        kg_vec3 a = p->moment.positions[s->halves.items[h].origin],
                b = p->moment.positions[s->halves.items[s->halves.items[h].next].origin];
        kg_vec2 u = kg_v2(kg_dot(p->axis.side, a), kg_dot(p->axis.axis, a)),
                v = kg_v2(kg_dot(p->axis.side, b), kg_dot(p->axis.axis, b));
        double c = kg_cross2(kg_sub2(v, u), kg_sub2(at, u));
        left &= c > 0;
        right &= c < 0;
        h = s->halves.items[h].next;
    } while (h != first);
    return left || right;
}

static kg_vec2 middle_of(const plan *p, size_t loop, bool *out_has, kg_vec3 corner) {
    const kg_origami_state *s = p->moment.topology;
    int32_t first = s->loops.items[loop].first, h = first;
    kg_vec3 sum = kg_v3(0, 0, 0);
    double count = 0;
    *out_has = false;
    do {
        kg_vec3 a = p->moment.positions[s->halves.items[h].origin];
        *out_has |= kg_dist(a, corner) < 1e-6 * s->size;
        sum = kg_add(sum, a), count++;
        h = s->halves.items[h].next;
    } while (h != first);
    sum = kg_scale(sum, 1 / count);
    return kg_v2(kg_dot(p->axis.side, sum), kg_dot(p->axis.axis, sum));
}

/* How many layers of the fold's plane move together where it is held, and how many lie there. */
static void count_layers(kg_diagram *d, const plan *p, kg_vec3 held) {
    const kg_moment *m = &p->moment;
    d->layers = 0;
    for (int any = 0; any < 2 && d->layers == 0; any++)
        for (size_t i = 0; i < m->topology->loops.count; i++) {
            bool has;
            kg_vec2 at = middle_of(p, i, &has, held);
            size_t moving = 0, all = 0;
            if (!m->moves[i] || (!has && !any) ||
                m->layers->loops.items[m->parents[i]].group != p->axis.group)
                continue;
            for (size_t k = 0; k < m->topology->loops.count; k++)
                if (m->layers->loops.items[m->parents[k]].group == p->axis.group &&
                    lies_in(p, k, at))
                    all++, moving += m->moves[k];
            if (moving > d->layers)
                d->layers = moving, d->stack = all;
        }
}

/* ---- where the line lies ---------------------------------------------------------------- */

static kg_vec3 paper_edge(const kg_origami_state *s, size_t edge, int end) {
    return s->vertices.items[s->halves.items[2 * edge + (size_t)end].origin].position;
}

/* What a point on the paper is: a corner, on an edge (its nearer end in `out_end`), or neither. */
static kg_diagram_goal place_of(const kg_origami_state *s, kg_vec3 point, kg_vec3 *out_end) {
    double near = KG_PICK * s->size, least = INFINITY;
    for (size_t i = 0; i < s->vertices.count; i++)
        if (kg_dist(s->vertices.items[i].position, point) < near)
            return KG_GOAL_CORNER;
    for (size_t e = 0; e < s->edges.count; e++) {
        kg_vec3 a = paper_edge(s, e, 0), b = paper_edge(s, e, 1), ab = kg_sub(b, a);
        double t = kg_dot(ab, kg_sub(point, a)) / fmax(kg_dot(ab, ab), 1e-300);
        if (s->edges.items[e].kind == KG_PAPER_JOIN || !(t > 0 && t < 1) ||
            kg_dist(kg_lerp(a, b, t), point) > near)
            continue;
        kg_vec3 end = t < 0.5 ? a : b;
        if (kg_dist(end, point) < least)
            least = kg_dist(end, point), *out_end = end;
    }
    return isfinite(least) ? KG_GOAL_EDGE : KG_GOAL_POINT;
}

/* How many loops are seen at a point, one on the other. */
static int count_seen(const kg_diagram *d, const kg_moment *m, kg_vec2 point) {
    const kg_origami_state *s = m->topology;
    int count = 0;
    for (size_t i = 0; i < s->loops.count; i++) {
        int32_t first = s->loops.items[i].first, h = first;
        bool left = true, right = true;
        do {
            int32_t next = s->halves.items[h].next;
            kg_vec2 a = seen(d, m->positions[s->halves.items[h].origin]),
                    b = seen(d, m->positions[s->halves.items[next].origin]);
            double c = kg_cross2(kg_sub2(b, a), kg_sub2(point, a));
            left &= c > 0;
            right &= c < 0;
            h = next;
        } while (h != first);
        count += left || right;
    }
    return count;
}

/* On the side of the edge where less paper is. */
static void add_measure(kg_diagram *d, const kg_moment *moment, kg_vec3 corner, kg_vec3 point) {
    kg_diagram_length m = {
        .from = seen(d, corner), .to = seen(d, point), .length = kg_dist(corner, point)};
    kg_vec2 along = kg_sub2(m.to, m.from), middle = kg_lerp2(m.from, m.to, 0.5);
    double length = kg_len2(along);
    if (!(length > 0) || d->measure_count == KG_DIAGRAM_MEASURES)
        return;
    m.outwards = kg_v2(along.y / length, -along.x / length);
    kg_vec2 aside = kg_scale2(m.outwards, 0.02 * moment->topology->size);
    if (count_seen(d, moment, kg_add2(middle, aside)) >
        count_seen(d, moment, kg_sub2(middle, aside)))
        m.outwards = kg_scale2(m.outwards, -1);
    d->measures[d->measure_count++] = m;
}

/* The ends of the line. */
static void find_line(kg_diagram *d, const plan *p, kg_vec3 ends[2]) {
    const kg_moment *m = &p->moment;
    const kg_origami_state *s = m->topology;
    double lo = INFINITY, hi = -INFINITY;
    ends[0] = ends[1] = p->axis.origin;
    for (size_t e = 0; e < s->edges.count; e++) {
        int32_t x = s->halves.items[2 * e].loop, y = s->halves.items[2 * e + 1].loop;
        if (x < 0 || y < 0 || m->moves[x] == m->moves[y])
            continue;
        for (int k = 0; k < 2; k++) {
            kg_vec3 a = m->positions[s->halves.items[2 * e + (size_t)k].origin];
            double t = kg_dot(kg_sub(a, p->axis.origin), p->axis.axis);
            if (t < lo)
                lo = t, ends[0] = a;
            if (t > hi)
                hi = t, ends[1] = a;
        }
    }
    d->axis[0] = seen(d, ends[0]);
    d->axis[1] = seen(d, ends[1]);
}

static bool begins_at(const kg_origami_state *s, size_t half, kg_vec3 point) {
    return s->edges.items[half / 2].kind != KG_PAPER_JOIN &&
           kg_dist(paper_edge(s, half / 2, (int)(half % 2)), point) < KG_PICK * s->size;
}

/* Does an edge that ends on the line, and moves, come to lie along another one that ends there? */
static bool halves_angle(const plan *p, kg_vec3 point) {
    const kg_origami_state *s = p->moment.layers;
    double near = KG_PICK * s->size;
    for (size_t k = 0; k < 2 * s->edges.count; k++) {
        kg_vec3 far = paper_edge(s, k / 2, 1 - (int)(k % 2));
        if (!begins_at(s, k, point) || kg_dot(kg_sub(far, point), p->axis.side) < near)
            continue;
        kg_vec3 way = kg_unit(kg_sub(kg_fold_turn(&p->axis, far, p->axis.angle), point));
        for (size_t i = 0; i < 2 * s->edges.count; i++)
            if (begins_at(s, i, point) &&
                kg_dist(kg_unit(kg_sub(paper_edge(s, i / 2, 1 - (int)(i % 2)), point)), way) <
                    KG_PICK)
                return true;
    }
    return false;
}

/* Whether both ends of what is held come to lie on corners. */
static bool meets_corners(const plan *p, const grip *held) {
    kg_vec3 ignored;
    for (int k = 0; k < 2; k++)
        if (place_of(p->moment.layers, kg_fold_turn(&p->axis, held->ends[k], p->axis.angle),
                     &ignored) != KG_GOAL_CORNER)
            return false;
    return true;
}

/* What a folder is told to aim at: corners and lines that are there already before lengths. */
static void find_goal(kg_diagram *d, const plan *p, const kg_fold *fold, const grip *held,
                      const kg_vec3 ends[2]) {
    const kg_moment *m = &p->moment;
    kg_vec3 corner, onto = fold->by_axis ? ends[0] : fold->points[1];
    bool flat_fold = d->angle_deg == 180, through_corner = false;
    for (int k = 0; k < 2; k++) {
        through_corner |= place_of(m->layers, ends[k], &corner) == KG_GOAL_CORNER;
        if (flat_fold && halves_angle(p, ends[k]))
            d->goal = KG_GOAL_LINE;
    }
    if (flat_fold && meets_corners(p, held))
        d->goal = KG_GOAL_CORNER;
    else if (!fold->by_axis && !d->edge && d->goal != KG_GOAL_LINE)
        d->goal = place_of(m->layers, onto, &corner);
    if (d->goal == KG_GOAL_EDGE || d->goal == KG_GOAL_POINT)
        d->marks[d->mark_count++] = seen(d, onto);
    if (d->goal == KG_GOAL_EDGE && !through_corner)
        add_measure(d, m, corner, onto);
    for (int k = 0; k < 2 && d->goal == KG_GOAL_NONE; k++)
        if (place_of(m->layers, ends[k], &corner) == KG_GOAL_EDGE)
            add_measure(d, m, corner, ends[k]);
}

/* ---- arrows ----------------------------------------------------------------------------- */

/* Lying flat, an arc beside the way, on its outer side; else the way itself through space. */
static void find_path(kg_diagram *d, const plan *p, kg_vec3 held) {
    kg_vec2 a = seen(d, held), b = seen(d, kg_fold_turn(&p->axis, held, p->axis.angle));
    kg_vec2 way = kg_sub2(b, a), aside = kg_v2(-way.y, way.x), middle = kg_lerp2(a, b, 0.5);
    if (kg_dot2(aside, kg_sub2(middle, kg_lerp2(d->box.lo, d->box.hi, 0.5))) < 0)
        aside = kg_scale2(aside, -1);
    kg_vec2 bend = kg_add2(middle, kg_scale2(aside, 0.38));
    for (int i = 0; i < KG_ARROW_POINTS; i++) {
        double t = 0.04 + 0.91 * i / (KG_ARROW_POINTS - 1);
        d->path[i] = is_oblique(p) ? seen(d, kg_fold_turn(&p->axis, held, t * p->axis.angle))
                                   : kg_lerp2(kg_lerp2(a, bend, t), kg_lerp2(bend, b, t), t);
        kg_box2_add(&d->box, d->path[i]);
    }
}

static void fill(kg_diagram *d, const plan *p) {
    look_along(d, back_of(p, d->side));
    d->oblique = is_oblique(p);
    d->box = kg_box2_empty();
    for (size_t i = 0; i < p->moment.topology->vertices.count; i++)
        kg_box2_add(&d->box, seen(d, p->moment.positions[i]));
    if (!p->folds)
        return;
    const kg_fold *fold = kg_origami_fold_at(d->origami, d->step);
    grip held = find_grip(p, fold);
    kg_vec3 ends[2];
    d->edge = held.edge;
    d->behind = goes_behind(p, d->back);
    d->angle_deg = fabs(fold->angle_deg);
    d->tucked = fold->between[0] >= 0;
    count_layers(d, p, held.point);
    d->arrow = d->folds == 2 ? KG_ARROW_UNFOLD : d->behind ? KG_ARROW_MOUNTAIN : KG_ARROW_VALLEY;
    find_line(d, p, ends);
    find_goal(d, p, fold, &held, ends);
    find_path(d, p, held.point);
}

kg_status kg_diagrams_create(const kg_origami *o, kg_diagram **out_diagrams, size_t *out_count,
                             kg_error *error) {
    size_t folds = kg_origami_step(o), count = 0, made = 0;
    kg_diagram *diagrams = calloc(folds + 1, sizeof *diagrams);
    plan *plans = calloc(folds + 1, sizeof *plans);
    kg_status status = diagrams && plans ? KG_OK : kg_fail(error, KG_ERR_MEMORY, "out of memory");
    for (size_t step = 0; step <= folds && !status;
         step += diagrams[count - 1].folds + (step == folds)) {
        kg_diagram *d = &diagrams[count++];
        d->origami = o;
        d->step = step;
        d->folds = step == folds ? 0 : is_undone(o, step) ? 2 : 1;
        status = plan_create(o, step, &plans[made], error);
        made += !status;
    }
    if (!status)
        choose_sides(plans, count, diagrams);
    for (size_t i = 0; i < count && !status; i++) {
        fill(&diagrams[i], &plans[i]);
        diagrams[i].turned = i > 0 && diagrams[i].side != diagrams[i - 1].side;
    }
    for (size_t i = 0; i < made; i++)
        kg_moment_clear(&plans[i].moment);
    free(plans);
    if (status) {
        free(diagrams);
        return status;
    }
    *out_diagrams = diagrams;
    *out_count = count;
    return KG_OK;
}
