#include "guide/dimension.h"

/* mm: how far lines lie off the paper, what is nearer is better; half the height of a label, and
 * the room that it keeps from its line. */
static const double offs[] = {2.4, 5.2, 8};
#define LABEL_HALF 1.7
#define LABEL_GAP 0.5

/* Of a place: on the paper's side of the edge; a point of the arrow on it; another label on it. */
#define INWARDS_COST 6.0
#define ARROW_COST 1.0
#define LABEL_COST 20.0

/* Lengths that are printed alike, mm. */
#define SAME_LENGTH 0.05

kg_vec2 kg_dimension_at(const kg_dimension *d, int end, double off) {
    return kg_add2(d->feet[end], kg_scale2(d->outwards, off));
}

static kg_box2 grown(kg_box2 box, double by) {
    return (kg_box2){kg_v2(box.lo.x - by, box.lo.y - by), kg_v2(box.hi.x + by, box.hi.y + by)};
}

static bool holds(kg_box2 box, kg_vec2 p) {
    return p.x >= box.lo.x && p.x <= box.hi.x && p.y >= box.lo.y && p.y <= box.hi.y;
}

static bool touch(kg_box2 a, kg_box2 b) {
    return a.lo.x < b.hi.x && b.lo.x < a.hi.x && a.lo.y < b.hi.y && b.lo.y < a.hi.y;
}

static kg_dimension at_place(const kg_diagram_length *l, double off, bool inwards, double width) {
    kg_dimension d = {{l->from, l->to}, l->outwards, off, {{0, 0}, {0, 0}}, l->length};
    if (inwards)
        d.outwards = kg_scale2(d.outwards, -1);
    kg_vec2 half = kg_v2(width / 2, LABEL_HALF);
    double reach = half.x * fabs(d.outwards.x) + half.y * fabs(d.outwards.y) + LABEL_GAP;
    kg_vec2 at =
        kg_lerp2(kg_dimension_at(&d, 0, off + reach), kg_dimension_at(&d, 1, off + reach), 0.5);
    d.label = (kg_box2){kg_sub2(at, half), kg_add2(at, half)};
    return d;
}

static double cost_of(const kg_dimension *d, const kg_vec2 *arrow, size_t count,
                      const kg_dimension *others, size_t other_count) {
    kg_box2 line = kg_box2_empty(), label = grown(d->label, LABEL_GAP);
    kg_box2_add(&line, kg_dimension_at(d, 0, d->off));
    kg_box2_add(&line, kg_dimension_at(d, 1, d->off));
    line = grown(line, LABEL_GAP);
    double cost = d->off / 10;
    for (size_t i = 0; i < count; i++)
        cost += holds(label, arrow[i]) || holds(line, arrow[i]) ? ARROW_COST : 0;
    for (size_t i = 0; i < other_count; i++)
        cost += touch(label, others[i].label) ? LABEL_COST : 0;
    return cost;
}

static kg_dimension best_of(const kg_diagram_length *l, double width, const kg_vec2 *arrow,
                            size_t count, const kg_dimension *others, size_t other_count,
                            double *out_cost) {
    kg_dimension best = {0};
    *out_cost = INFINITY;
    for (int inwards = 0; inwards < 2; inwards++)
        for (size_t k = 0; k < sizeof offs / sizeof *offs; k++) {
            kg_dimension d = at_place(l, offs[k], inwards, width);
            double cost = cost_of(&d, arrow, count, others, other_count) + inwards * INWARDS_COST;
            if (cost < *out_cost)
                *out_cost = cost, best = d;
        }
    return best;
}

static bool says_the_same(const kg_diagram_length *a, const kg_diagram_length *b) {
    kg_vec2 u = kg_sub2(a->to, a->from), v = kg_sub2(b->to, b->from);
    return fabs(a->length - b->length) < SAME_LENGTH &&
           fabs(kg_cross2(u, v)) < 1e-6 * kg_len2(u) * kg_len2(v) && kg_dot2(u, v) > 0;
}

size_t kg_dimensions_place(const kg_diagram_length *lengths, size_t count, const kg_vec2 *arrow,
                           size_t arrow_count, double label_width,
                           kg_dimension out[KG_DIAGRAM_MEASURES]) {
    size_t made = 0;
    double cost, first;
    for (size_t i = 0; i < count; i++) {
        kg_dimension d = best_of(&lengths[i], label_width, arrow, arrow_count, out, made, &cost);
        if (i > 0 && says_the_same(&lengths[0], &lengths[i])) {
            if (cost < first)
                out[0] = d;
            continue;
        }
        first = cost;
        out[made++] = d;
    }
    return made;
}
