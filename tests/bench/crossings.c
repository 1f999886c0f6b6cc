/*
 * Crossings and trims of pairs, against the original method: rays along the rulings of one patch
 * against a triangulation of the other (Hosoda and Mitani 2015), at the same accuracy.
 */
#include "bench/bench.h"
#include "katagami/trim.h"

#include <stdio.h>
#include <stdlib.h>

/* Greatest chord error, mm: of the exact crossings, and what the baseline is refined to. */
#define ACCURACY 0.01

enum { PAIRS = 300, MOST = 4096 };

/* ---- baseline --------------------------------------------------------------------------- */

typedef struct strips {
    int count; /* of strips, two triangles each */
    kg_vec3 *lo, *hi;
} strips;

static strips triangulate(const kg_patch *p, int count) {
    strips s = {count, malloc(((size_t)count + 1) * sizeof *s.lo),
                malloc(((size_t)count + 1) * sizeof *s.hi)};
    for (int i = 0; i <= count && s.lo && s.hi; i++) {
        s.lo[i] = kg_patch_point(p, p->extent[0], (double)i / count);
        s.hi[i] = kg_patch_point(p, p->extent[1], (double)i / count);
    }
    return s;
}

/* Moeller and Trumbore 1997. */
static int hits_triangle(kg_vec3 from, kg_vec3 d, double reach, kg_vec3 a, kg_vec3 b, kg_vec3 c) {
    kg_vec3 e1 = kg_sub(b, a), e2 = kg_sub(c, a), p = kg_cross(d, e2);
    double det = kg_dot(e1, p);
    if (fabs(det) < 1e-14)
        return 0;
    kg_vec3 t = kg_sub(from, a), q = kg_cross(t, e1);
    double u = kg_dot(t, p) / det, v = kg_dot(d, q) / det, w = kg_dot(e2, q) / det;
    return u >= 0 && v >= 0 && u + v <= 1 && w >= 0 && w <= reach;
}

static int cast_rays(const kg_patch *a, int rays, const strips *b) {
    int hits = 0;
    for (int i = 0; i <= rays; i++) {
        kg_ruling r = kg_patch_ruling(a, (double)i / rays);
        kg_vec3 from = kg_madd(r.p, a->extent[0], r.d);
        double reach = a->extent[1] - a->extent[0];
        for (int k = 0; k < b->count; k++)
            hits += hits_triangle(from, r.d, reach, b->lo[k], b->hi[k], b->hi[k + 1]) +
                    hits_triangle(from, r.d, reach, b->lo[k], b->hi[k + 1], b->lo[k + 1]);
    }
    return hits;
}

/* Rulings, equally spaced in v, that keep both edges' chords to the accuracy. */
static int rulings_needed(const kg_patch *p) {
    for (int n = 4; n < MOST; n *= 2) {
        double worst = 0;
        for (int i = 0; i < n; i++)
            for (int k = 0; k < 2; k++) {
                kg_vec3 x = kg_patch_point(p, p->extent[k], (double)i / n),
                        y = kg_patch_point(p, p->extent[k], (i + 1.0) / n),
                        m = kg_patch_point(p, p->extent[k], (i + 0.5) / n);
                worst = fmax(worst, kg_dist(m, kg_lerp(x, y, 0.5)));
            }
        if (worst <= ACCURACY)
            return n;
    }
    return MOST;
}

/* ---- exact ------------------------------------------------------------------------------ */

static const kg_patch *find_none(const void *user, int64_t id) {
    (void)id;
    return user;
}

static int trim_pair(const kg_patch *a, const kg_patch *b) {
    kg_crossings crossings;
    kg_regions whole, pieces;
    int count = 0;
    if (kg_crossings_find(a, b, ACCURACY, &crossings, NULL))
        return 0;
    kg_trim trim = {a, {find_none, b}, ACCURACY, NULL};
    kg_cut cut = {1, b, &crossings, NULL};
    kg_vec3 keep = kg_patch_point(a, a->extent[1], 0.5);
    if (kg_regions_rectangle(a, ACCURACY, &whole, NULL) == KG_OK) {
        if (kg_trim_by(&trim, &whole, &cut, &keep, 1, &pieces, NULL) == KG_OK) {
            count = (int)pieces.count;
            kg_regions_clear(&pieces);
        }
        kg_regions_clear(&whole);
    }
    kg_crossings_clear(&crossings);
    return count;
}

void bench_crossings(void) {
    static kg_patch a[PAIRS], b[PAIRS];
    int crossing = 0, missing = 0, total = 0;
    static int meets[PAIRS];
    for (int i = 0; total < PAIRS && i < 4 * PAIRS; i++) {
        kg_patch_input x = bench_patch(2 * i), y = bench_patch(2 * i + 1);
        kg_crossings c;
        if (i % 3 == 2) /* a third of the pairs lie apart, side by side */
            for (int k = 0; k < 4; k++)
                y.points[k] = kg_add(y.points[k], kg_v3(90, 0, 0));
        if (kg_patch_init(&x, &a[total], NULL) || kg_patch_init(&y, &b[total], NULL) ||
            kg_crossings_find(&a[total], &b[total], ACCURACY, &c, NULL))
            continue;
        meets[total] = c.count > 0;
        crossing += meets[total];
        missing += !meets[total];
        kg_crossings_clear(&c);
        total++;
    }
    double spent[2] = {0, 0}, trimming = 0, casting = 0;
    int hits = 0;
    for (int i = 0; i < total; i++) {
        kg_crossings c;
        double start = bench_work();
        if (kg_crossings_find(&a[i], &b[i], ACCURACY, &c, NULL))
            continue;
        spent[meets[i]] += bench_work() - start;
        kg_crossings_clear(&c);
        if (!meets[i])
            continue;
        start = bench_work();
        hits += trim_pair(&a[i], &b[i]);
        trimming += bench_work() - start;
        int rays = rulings_needed(&a[i]), count = rulings_needed(&b[i]);
        start = bench_work();
        strips s = triangulate(&b[i], count);
        hits += cast_rays(&a[i], rays, &s);
        casting += bench_work() - start;
        free(s.lo);
        free(s.hi);
    }
    printf("pairs: %d cross, %d miss, chord error %g mm\n", crossing, missing, ACCURACY);
    bench_row("crossing of a pair that crosses", spent[1] / crossing, "us", 0);
    bench_row("crossing of a pair that misses", spent[0] / (missing ? missing : 1), "us", 0);
    bench_row("trim of a typical pair (crossing, pieces, keep)", trimming / crossing, "us", 150e-6);
    bench_row("baseline: rays against triangles", casting / crossing, "us", 0);
    /* both find where the surfaces meet; pieces and keep points come on top of either */
    printf("%-58s %10.2f\n", "  baseline over exact crossing", hits ? casting / spent[1] : 0);
}
