/* Sweeps of random folds beside looking, angle by angle, whether paper is in paper. */
#include "tests/check.h"
#include "tests/origami/samples.h"

#include <stdlib.h>

enum { LOOKS = 90 }; /* through the turn of a fold */

/* mm: deeper than this in a face of the square of 100 is in it. */
#define DEEP 0.02
/* Degrees: a fold that is stopped was free this much before, and is in paper somewhere so soon
 * after. */
#define BEFORE 0.01
#define AFTER 10.0

static int32_t corners_of(const kg_origami_state *s, int32_t loop, const kg_vec3 *at,
                          kg_vec3 *out) {
    int32_t n = 0, first = s->loops.items[loop].first, h = first;
    do
        out[n++] = at[s->halves.items[h].origin];
    while ((h = s->halves.items[h].next) != first && n < 64);
    return n;
}

static kg_vec3 normal_of(const kg_vec3 *p, int32_t n) {
    kg_vec3 sum = kg_v3(0, 0, 0);
    for (int32_t i = 2; i < n; i++)
        sum = kg_add(sum, kg_cross(kg_sub(p[i - 1], p[0]), kg_sub(p[i], p[0])));
    return kg_unit(sum);
}

/* How far a point of its plane is within q, negative outside. */
static double depth(const kg_vec3 *q, int32_t m, kg_vec3 up, kg_vec3 point) {
    double inside = INFINITY;
    for (int32_t k = 0; k < m; k++) {
        kg_vec3 side = kg_unit(kg_sub(q[(k + 1) % m], q[k]));
        inside = fmin(inside, kg_dot(kg_cross(up, side), kg_sub(point, q[k])));
    }
    return inside;
}

/* Whether p goes through the inside of q: whether its cut with the plane of q does. */
static bool pierces(const kg_vec3 *p, int32_t n, const kg_vec3 *q, int32_t m) {
    kg_vec3 up = normal_of(q, m), cut[2];
    double lowest = INFINITY, highest = -INFINITY;
    int ends = 0;
    for (int32_t i = 0; i < n; i++) {
        kg_vec3 a = p[i], b = p[(i + 1) % n];
        double x = kg_dot(up, kg_sub(a, q[0])), y = kg_dot(up, kg_sub(b, q[0]));
        lowest = fmin(lowest, x), highest = fmax(highest, x);
        if ((x < 0) != (y < 0) && ends < 2)
            cut[ends++] = kg_lerp(a, b, x / (x - y));
    }
    if (ends < 2 || lowest > -DEEP || highest < DEEP)
        return false;
    double from = 0, to = 1; /* of the cut, what is deep enough within each side of q */
    for (int32_t k = 0; k < m; k++) {
        kg_vec3 in = kg_cross(up, kg_unit(kg_sub(q[(k + 1) % m], q[k])));
        double x = kg_dot(in, kg_sub(cut[0], q[k])) - DEEP,
               y = kg_dot(in, kg_sub(cut[1], q[k])) - DEEP;
        if (x < 0 && y < 0)
            return false;
        if (x < 0)
            from = fmax(from, x / (x - y));
        if (y < 0)
            to = fmin(to, x / (x - y));
    }
    return from < to;
}

/* Whether p lies on q: in its plane, and somewhere over its inside. */
static bool lies_on(const kg_vec3 *p, int32_t n, const kg_vec3 *q, int32_t m) {
    kg_vec3 up = normal_of(q, m), middle = kg_v3(0, 0, 0);
    bool over = false;
    for (int32_t i = 0; i < n; i++) {
        middle = kg_madd(middle, 1.0 / n, p[i]);
        if (fabs(kg_dot(up, kg_sub(p[i], q[0]))) > DEEP)
            return false;
    }
    for (int32_t i = 0; i < n; i++)
        for (int k = 0; k <= 50; k++)
            over |= depth(q, m, up, kg_lerp(middle, p[i], 0.02 * k)) > DEEP;
    return over;
}

static bool paper_is_in_paper(const kg_origami_state *s, const kg_vec3 *at) {
    kg_vec3 p[64], q[64];
    for (int32_t a = 0; a < (int32_t)s->loops.count; a++) {
        int32_t n = corners_of(s, a, at, p);
        for (int32_t b = 0; b < (int32_t)s->loops.count; b++)
            if (a != b && pierces(p, n, q, corners_of(s, b, at, q)))
                return true;
    }
    return false;
}

static bool is_free(const kg_origami *o, size_t step, kg_vec3 *at) {
    for (int i = 0; i <= LOOKS; i++) {
        kg_origami_between(o, step, (double)i / LOOKS, at);
        if (paper_is_in_paper(kg_origami_state_at(o, step + 1), at))
            return false;
    }
    return true;
}

static bool paper_is_on_paper(const kg_origami_state *s, const kg_vec3 *at, const kg_vec3 *start) {
    kg_vec3 p[64], q[64];
    for (int32_t a = 0; a < (int32_t)s->loops.count; a++) {
        int32_t n = corners_of(s, a, start, q), moved = 0;
        corners_of(s, a, at, p);
        for (int32_t i = 0; i < n; i++)
            moved |= kg_dist(p[i], q[i]) > 1e-6;
        for (int32_t b = 0; b < (int32_t)s->loops.count && moved; b++)
            if (a != b && s->loops.items[a].group != s->loops.items[b].group) {
                int32_t m = corners_of(s, b, at, q);
                if (lies_on(p, n, q, m) || lies_on(q, m, p, n))
                    return true;
            }
    }
    return false;
}

/* Whether the fold just done, turned on by up to AFTER degrees, has paper in paper, or on paper
 * that it then would have gone through. */
static bool would_meet(const kg_origami *o, const kg_fold_preview *p, kg_vec3 *at) {
    const kg_origami_state *s = last(o);
    size_t count = s->vertices.count;
    kg_vec3 *start = malloc(2 * count * sizeof *start), *end = start + count;
    bool meets = false;
    kg_origami_between(o, kg_origami_step(o) - 1, 0, start);
    kg_origami_between(o, kg_origami_step(o) - 1, 1, end);
    for (double more = BEFORE; more <= AFTER && !meets; more += more < 1 ? 0.05 : 0.5) {
        double turn = more * acos(-1) / 180 * (p->angle > 0 ? 1 : -1);
        kg_vec3 axis = kg_unit(p->axis), lift = kg_cross(axis, p->side);
        if (kg_dot(lift, p->normal) < 0)
            axis = kg_scale(axis, -1);
        for (size_t i = 0; i < count; i++) {
            kg_vec3 r = kg_sub(end[i], p->origin);
            at[i] = end[i];
            if (kg_dist(start[i], end[i]) > 1e-6)
                at[i] =
                    kg_add(p->origin,
                           kg_madd(kg_madd(kg_scale(r, cos(turn)), sin(turn), kg_cross(axis, r)),
                                   (1 - cos(turn)) * kg_dot(axis, r), axis));
        }
        meets = (more == BEFORE && paper_is_on_paper(s, at, start)) || paper_is_in_paper(s, at);
    }
    free(start);
    return meets;
}

/* A random fold of a random vertex, of walls at first. */
static kg_fold random_fold(kg_random *r, const kg_origami_state *s, bool wall) {
    static const double angles[] = {180, -180, 170, -150};
    size_t a = kg_random_bits(r) % s->vertices.count, b = kg_random_bits(r) % s->vertices.count;
    kg_vec3 from = s->vertices.items[a].position, to = s->vertices.items[b].position;
    to = kg_lerp(from, to, wall ? kg_random_in(r, 0.3, 0.8) : kg_random_in(r, 0.5, 1.2));
    double up = kg_random_bits(r) & 1 ? 1 : -1;
    double angle = wall ? up * kg_random_in(r, 40, 120) : angles[kg_random_bits(r) % 4];
    return fold_to(from, to, angle);
}

static void test_folds_are_free_and_stopped_where_they_meet(void **user) {
    (void)user;
    size_t done = 0, stopped = 0, grazed = 0;
    for (uint64_t seed = 0; seed < 400; seed++) {
        kg_random r = {seed};
        kg_origami *o = square_sheet(100);
        if (seed % 3 == 0)
            add_rectangle(o, 110, 20, 80, 60);
        for (int i = 0; i < 12 && last(o)->loops.count < 24; i++) {
            kg_fold f = random_fold(&r, last(o), kg_origami_step(o) < 2);
            kg_fold_preview p;
            kg_error error;
            kg_vec3 at[256];
            kg_status status = kg_fold_preview_make(last(o), &f, &p, &error);
            if (!status) {
                must_fold(o, f);
                done++;
                assert_true(last(o)->vertices.count <= 256);
                if (!is_free(o, kg_origami_step(o) - 1, at))
                    fail_msg("seed %d, fold %d goes through paper", (int)seed,
                             (int)kg_origami_step(o));
            } else if (p.fault == KG_FOLD_IN_WAY && p.meets_deg > 1) {
                kg_fold less = f;
                double sign = f.angle_deg > 0 ? 1 : -1;
                less.angle_deg = sign * (p.meets_deg - BEFORE);
                stopped++;
                must_fold(o, less);
                if (!is_free(o, kg_origami_step(o) - 1, at))
                    fail_msg("seed %d: in paper before %g", (int)seed, p.meets_deg);
                grazed += !would_meet(o, &p, at);
                assert_true(kg_origami_undo(o));
                less.angle_deg = sign * (p.meets_deg + BEFORE);
                if (fabs(less.angle_deg) <= 180)
                    must_refuse(o, less, &error);
            }
            kg_fold_preview_clear(&p);
        }
        kg_origami_destroy(o);
    }
    print_message("%zu folds, %zu stopped, %zu of them hardly touching\n", done, stopped, grazed);
    assert_true(done > 800 && stopped > 200 && grazed <= stopped / 100);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_folds_are_free_and_stopped_where_they_meet),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
