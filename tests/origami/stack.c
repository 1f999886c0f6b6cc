#include "tests/origami/stack.h"

#include "tests/check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 4096 };

static char message[256];

/* Farther from an edge than rounding, nearer than most slivers are wide. */
#define STEP 1e-5

static int32_t next(const kg_origami_state *s, int32_t h) {
    return s->halves.items[h].next;
}

static kg_vec3 at(const kg_origami_state *s, int32_t h) {
    return s->vertices.items[s->halves.items[h].origin].position;
}

/* What is asked for again and again in one check: of each loop its front and its box, of each two
 * whether the second lies above the first (1), below it (-1) or beside it. */
static struct {
    kg_vec3 normals[MOST];
    kg_box3 boxes[MOST];
    signed char *above;
    size_t count;
} known;

static void learn(const kg_origami_state *s) {
    size_t n = known.count = s->loops.count;
    known.above = n <= MOST ? calloc(n * n + 1, 1) : NULL;
    if (!known.above)
        abort();
    for (size_t i = 0; i < n; i++) {
        known.normals[i] = kg_origami_normal(s, (int32_t)i);
        known.boxes[i] = kg_box3_empty();
        int32_t first = s->loops.items[i].first, h = first;
        do
            kg_box3_add(&known.boxes[i], at(s, h));
        while ((h = next(s, h)) != first);
    }
    kg_layer_order o = {0};
    while (kg_origami_next_order(s, &o)) {
        kg_vec3 up = s->groups.items[s->loops.items[o.a].group].normal;
        int above = o.side * (kg_dot(known.normals[o.a], up) > 0 ? 1 : -1);
        known.above[(size_t)o.a * n + (size_t)o.b] = (signed char)above;
        known.above[(size_t)o.b * n + (size_t)o.a] = (signed char)-above;
    }
}

/* Orders as they are asked for are those of the list, from either side. */
static const char *check_orders(const kg_origami_state *s) {
    size_t count = 0;
    kg_layer_order o = {0}, last = {0};
    for (; kg_origami_next_order(s, &o); last = o, count++) {
        int turned = kg_dot(known.normals[o.a], known.normals[o.b]) > 0 ? -1 : 1;
        if (o.a >= o.b || o.a < last.a || (o.a == last.a && o.b <= last.b))
            return "the orders are in disorder";
        if (kg_origami_order(s, o.a, o.b) != o.side ||
            kg_origami_order(s, o.b, o.a) != turned * o.side)
            return "an order is not found";
    }
    return count == kg_origami_pair_count(s) ? NULL : "orders are miscounted";
}

/* Least distance of a point in the plane from the loop's sides, negative outside. */
static double depth(const kg_origami_state *s, int32_t loop, kg_vec3 p) {
    int32_t first = s->loops.items[loop].first, h = first;
    kg_box3 box = known.boxes[loop];
    double least = 2 * STEP * s->size; /* the point is in the plane: other directions tell enough */
    if (p.x < box.lo.x - least || p.x > box.hi.x + least || p.y < box.lo.y - least ||
        p.y > box.hi.y + least || p.z < box.lo.z - least || p.z > box.hi.z + least)
        return -least;
    kg_vec3 n = known.normals[loop];
    least = INFINITY;
    do {
        kg_vec3 a = at(s, h), d = kg_unit(kg_sub(at(s, next(s, h)), a));
        least = fmin(least, kg_dot(kg_cross(n, d), kg_sub(p, a)));
    } while ((h = next(s, h)) != first);
    return least;
}

static int above(int32_t a, int32_t b) { /* b above a */
    return known.above[(size_t)a * known.count + (size_t)b];
}

/* The loops at a point from the lowest up; -1 when the point is too near an edge to tell, -2 when
 * they are in no order. */
static int stack_at(const kg_origami_state *s, int32_t group, kg_vec3 p, int32_t *out) {
    int n = 0;
    for (size_t i = 0; i < s->loops.count; i++) {
        if (s->loops.items[i].group != group)
            continue;
        double d = depth(s, (int32_t)i, p);
        if (fabs(d) < 0.3 * STEP * s->size)
            return -1;
        if (d > 0 && n < MOST)
            out[n++] = (int32_t)i;
    }
    for (int i = 1; i < n; i++)
        for (int k = i; k > 0 && above(out[k - 1], out[k]) < 0; k--) {
            int32_t t = out[k];
            out[k] = out[k - 1], out[k - 1] = t;
        }
    for (int i = 0; i < n; i++)
        for (int k = i + 1; k < n; k++)
            if (above(out[i], out[k]) != 1)
                return -2;
    return n;
}

/* What a loop does at a line that passes `p`: its edge there, or -1. */
static int32_t edge_at(const kg_origami_state *s, int32_t loop, kg_vec3 p, kg_vec3 along) {
    int32_t first = s->loops.items[loop].first, h = first;
    do {
        kg_vec3 a = at(s, h), b = at(s, next(s, h)), d = kg_unit(kg_sub(b, a));
        double t = kg_dot(kg_sub(p, a), d);
        if (kg_len(kg_cross(d, along)) < 1e-6 && t > 0 && t < kg_dist(a, b) &&
            kg_len(kg_sub(kg_sub(p, a), kg_scale(d, t))) < 1e-6 * s->size)
            return h;
    } while ((h = next(s, h)) != first);
    return -1;
}

/* Links between the places in two stacks, left ones first; each must not cross another. A link
 * within one stack is a fold seen from there, one between both goes on across the line. */
typedef struct link {
    int a, b;   /* places */
    int sa, sb; /* which stack, 0 or 1 */
} link;

static bool links_cross(link x, link y) {
    if (x.sa == x.sb && y.sa == y.sb) {
        if (x.sa != y.sa)
            return false;
        int lo = x.a < x.b ? x.a : x.b, hi = x.a < x.b ? x.b : x.a;
        return (y.a > lo && y.a < hi) != (y.b > lo && y.b < hi);
    }
    if (x.sa != x.sb && y.sa != y.sb) {
        int x0 = x.sa == 0 ? x.a : x.b, x1 = x.sa == 0 ? x.b : x.a;
        int y0 = y.sa == 0 ? y.a : y.b, y1 = y.sa == 0 ? y.b : y.a;
        return (x0 < y0) != (x1 < y1);
    }
    if (x.sa != x.sb) {
        link t = x;
        x = y, y = t;
    }
    int lo = x.a < x.b ? x.a : x.b, hi = x.a < x.b ? x.b : x.a;
    int place = y.sa == x.sa ? y.a : y.b;
    return place > lo && place < hi;
}

static const char *check_line(const kg_origami_state *s, int32_t group, kg_vec3 p, kg_vec3 along) {
    static int32_t stacks[2][MOST];
    static link links[2 * MOST];
    int counts[2], n = 0;
    kg_vec3 across = kg_scale(kg_cross(s->groups.items[group].normal, along), STEP * s->size);
    for (int k = 0; k < 2; k++) {
        counts[k] = stack_at(s, group, kg_madd(p, k ? 1 : -1, across), stacks[k]);
        if (counts[k] == -1)
            return NULL;
        if (counts[k] == -2) {
            snprintf(message, sizeof message, "no order of layers at (%g, %g, %g)", p.x, p.y, p.z);
            return message;
        }
    }
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < counts[k]; i++) {
            int32_t loop = stacks[k][i], h = edge_at(s, loop, p, along),
                    other = h < 0 ? loop : s->halves.items[h ^ 1].loop;
            for (int m = k; m < 2; m++)
                for (int j = m == k ? i + 1 : 0; j < counts[m]; j++)
                    if (stacks[m][j] == other && (h < 0 || edge_at(s, other, p, along) == (h ^ 1)))
                        links[n++] = (link){i, j, k, m};
        }
    for (int i = 0; i < n; i++)
        for (int k = i + 1; k < n; k++)
            if (links_cross(links[i], links[k])) {
                snprintf(message, sizeof message, "layers cross at (%g, %g, %g), loop %d", p.x, p.y,
                         p.z, stacks[links[i].sa][links[i].a]);
                return message;
            }
    return NULL;
}

static int compare_numbers(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return x < y ? -1 : x > y;
}

/* Checks one side of an edge in the middle of every stretch between its crossings with others. */
static const char *check_edge(const kg_origami_state *s, int32_t h, int32_t group) {
    static double cuts[MOST];
    int n = 0;
    kg_vec3 a = at(s, h), d = kg_sub(at(s, h ^ 1), a), normal = s->groups.items[group].normal;
    kg_vec3 across = kg_cross(normal, d);
    cuts[n++] = 0, cuts[n++] = 1;
    for (size_t k = 0; k < s->halves.count && n < MOST; k++) {
        int32_t loop = s->halves.items[k].loop;
        if (loop < 0 || s->loops.items[loop].group != group)
            continue;
        kg_vec3 p = at(s, (int32_t)k), q = at(s, (int32_t)k ^ 1);
        double x = kg_dot(across, kg_sub(p, a)), y = kg_dot(across, kg_sub(q, a));
        if ((x < 0) != (y < 0)) {
            double t = kg_dot(d, kg_sub(kg_lerp(p, q, x / (x - y)), a)) / kg_dot(d, d);
            if (t > 0 && t < 1)
                cuts[n++] = t;
        }
    }
    qsort(cuts, (size_t)n, sizeof *cuts, compare_numbers);
    for (int i = 0; i + 1 < n; i++) {
        if ((cuts[i + 1] - cuts[i]) * kg_len(d) < 10 * STEP * s->size)
            continue;
        const char *wrong =
            check_line(s, group, kg_madd(a, (cuts[i] + cuts[i + 1]) / 2, d), kg_unit(d));
        if (wrong)
            return wrong;
    }
    return NULL;
}

static const char *check_edges(const kg_origami_state *s) {
    for (size_t h = 0; h < s->halves.count; h++) {
        int32_t loop = s->halves.items[h].loop, other = s->halves.items[h ^ 1].loop;
        if (loop < 0 ||
            (h % 2 == 1 && other >= 0 && s->loops.items[other].group == s->loops.items[loop].group))
            continue;
        const char *wrong = check_edge(s, (int32_t)h, s->loops.items[loop].group);
        if (wrong)
            return wrong;
    }
    return NULL;
}

const char *stack_check(const kg_origami_state *s) {
    learn(s);
    const char *wrong = check_orders(s);
    if (!wrong)
        wrong = check_edges(s);
    free(known.above);
    known.above = NULL;
    return wrong;
}

const char *shape_check(const kg_origami_state *s, double tolerance) {
    for (size_t i = 0; i < s->loops.count; i++) {
        int32_t first = s->loops.items[i].first, h = first;
        do {
            if (s->halves.items[h].loop != (int32_t)i)
                return "a half-edge of another loop";
            int32_t k = first;
            do {
                const kg_paper_vertex *a = &s->vertices.items[s->halves.items[h].origin],
                                      *b = &s->vertices.items[s->halves.items[k].origin];
                double off = kg_dist(a->position, b->position) - kg_dist2(a->paper, b->paper);
                if (!(fabs(off) <= tolerance * s->size)) {
                    snprintf(message, sizeof message, "loop %zu is stretched by %g", i, off);
                    return message;
                }
            } while ((k = next(s, k)) != first);
            const kg_face_group *g = &s->groups.items[s->loops.items[i].group];
            if (!(fabs(kg_dot(g->normal, at(s, h)) - g->offset) < 1e-8 * s->size))
                return "a loop is not in its plane";
            if (s->halves.items[next(s, h)].origin != s->halves.items[h ^ 1].origin)
                return "half-edges do not follow each other";
        } while ((h = next(s, h)) != first);
    }
    for (size_t e = 0; e < s->edges.count; e++) {
        int32_t a = s->halves.items[2 * e].loop, b = s->halves.items[2 * e + 1].loop;
        if (a < 0 || b < 0)
            continue;
        kg_vec3 na = kg_origami_normal(s, a), nb = kg_origami_normal(s, b),
                d = kg_unit(kg_sub(at(s, (int32_t)(2 * e + 1)), at(s, (int32_t)(2 * e))));
        /* the front of b, seen along the edge, turned from that of a: valley folds turn it back */
        double angle = s->edges.items[e].angle;
        kg_vec3 turned = kg_add(kg_scale(na, cos(angle)), kg_scale(kg_cross(na, d), sin(angle)));
        if (!(kg_dist(turned, nb) < 1e-6)) {
            snprintf(message, sizeof message, "edge %zu says %g", e, angle);
            return message;
        }
    }
    return NULL;
}

static bool same_numbers(const double *a, const double *b, size_t count) {
    return memcmp(a, b, count * sizeof *a) == 0;
}

void assert_sound(const kg_origami_state *s, double tolerance) {
    const char *wrong = shape_check(s, tolerance);
    if (!wrong)
        wrong = stack_check(s);
    if (wrong)
        fail_msg("%s", wrong);
}

bool same_orders(const kg_origami_state *a, const kg_origami_state *b) {
    kg_layer_order x = {0}, y = {0};
    while (kg_origami_next_order(a, &x))
        if (!kg_origami_next_order(b, &y) || x.a != y.a || x.b != y.b || x.side != y.side)
            return false;
    return !kg_origami_next_order(b, &y);
}

bool same_state(const kg_origami_state *a, const kg_origami_state *b) {
    bool same = a->vertices.count == b->vertices.count && a->halves.count == b->halves.count &&
                a->loops.count == b->loops.count && a->groups.count == b->groups.count &&
                a->size == b->size;
    for (size_t i = 0; same && i < a->vertices.count; i++) {
        const kg_paper_vertex *x = &a->vertices.items[i], *y = &b->vertices.items[i];
        same = same_numbers(&x->paper.x, &y->paper.x, 2) && x->sheet == y->sheet &&
               same_numbers(&x->position.x, &y->position.x, 3);
    }
    for (size_t i = 0; same && i < a->halves.count; i++) {
        const kg_half_edge *x = &a->halves.items[i], *y = &b->halves.items[i];
        const kg_paper_edge *e = &a->edges.items[i / 2], *f = &b->edges.items[i / 2];
        same = x->origin == y->origin && x->loop == y->loop &&
               (x->loop < 0 || x->next == y->next) && e->kind == f->kind &&
               same_numbers(&e->angle, &f->angle, 1);
    }
    for (size_t i = 0; same && i < a->loops.count; i++) {
        const kg_paper_loop *x = &a->loops.items[i], *y = &b->loops.items[i];
        same = x->first == y->first && x->sheet == y->sheet && x->group == y->group &&
               x->parent == y->parent;
    }
    for (size_t i = 0; same && i < a->groups.count; i++)
        same = same_numbers(&a->groups.items[i].normal.x, &b->groups.items[i].normal.x, 3) &&
               same_numbers(&a->groups.items[i].offset, &b->groups.items[i].offset, 1);
    return same && same_orders(a, b);
}
