/* Whole models: recomputed, unrolled, growing. */
#include "bench/bench.h"
#include "katagami/unroll.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A row of `count` patches; each is cut by the next ones around it so that there are about
 * `trims` cuts in all. Groups of six share a place, so that pairs cross as in a real model. */
static kg_model *row_model(int count, int trims) {
    enum { GROUP = 6 };
    kg_model *m = kg_model_create();
    if (!m || !(m->patches = calloc((size_t)count, sizeof *m->patches)))
        abort();
    for (int i = 0; i < count; i++) {
        kg_model_patch *p = &m->patches[m->patch_count++];
        p->id = i + 1;
        p->name = strdup("");
        p->input = bench_patch(i);
        for (size_t k = 0; k < p->input.point_count; k++)
            p->input.points[k] = kg_add(p->input.points[k], kg_v3(200.0 * (i / GROUP), 0, 0));
        p->trims = calloc(GROUP, sizeof *p->trims);
    }
    /* only pairs that cross can cut each other */
    for (int step = 1; step < GROUP && trims > 0; step++)
        for (int i = 0; i < count && trims > 0; i++) {
            int j = i / GROUP * GROUP + (i + step) % GROUP;
            kg_patch a, b;
            kg_crossings c;
            if (j >= count || j == i || kg_patch_init(&m->patches[i].input, &a, NULL) ||
                kg_patch_init(&m->patches[j].input, &b, NULL) ||
                kg_crossings_find(&a, &b, 0.01, &c, NULL))
                continue;
            if (c.count > 0) {
                kg_model_patch *p = &m->patches[i];
                kg_trim_op *op = &p->trims[p->trim_count++];
                op->by = malloc(sizeof *op->by);
                op->keep = malloc(sizeof *op->keep);
                op->by[0] = j + 1;
                op->keep[0] = kg_patch_point(&a, a.extent[1], 1);
                op->by_count = op->keep_count = 1;
                trims--;
            }
            kg_crossings_clear(&c);
        }
    return m;
}

static double solve_time(const kg_model *m, int runs, double chord) {
    double best = HUGE_VAL;
    for (int i = 0; i < runs; i++) {
        kg_solution *s;
        double start = bench_work();
        if (kg_solution_create(m, chord, NULL, &s, NULL))
            abort();
        best = fmin(best, bench_work() - start);
        kg_solution_destroy(s);
    }
    return best;
}

/* The time a dragged point costs: one patch changes, the rest is lent. */
static double drag_time(kg_model *m, double chord) {
    enum { STEPS = 50 };
    kg_solution *s = NULL;
    if (kg_solution_create(m, chord, NULL, &s, NULL))
        abort();
    double start = bench_work();
    for (int i = 0; i < STEPS; i++) {
        m->patches[0].input.points[1].x += i % 2 ? 0.25 : -0.25;
        if (kg_solution_create(m, chord, s, &s, NULL))
            abort();
    }
    double each = (bench_work() - start) / STEPS;
    kg_solution_destroy(s);
    return each;
}

void bench_models(void) {
    kg_model *m = row_model(60, 100);
    size_t trims = 0;
    for (size_t i = 0; i < m->patch_count; i++)
        trims += m->patches[i].trim_count;
    printf("model: %zu patches, %zu trims\n", m->patch_count, trims);
    bench_row("model: recomputed from nothing, chord 0.02 mm", solve_time(m, 10, 0.02), "ms",
              0.016);
    bench_row("model: recomputed from nothing, chord 0.001 mm", solve_time(m, 5, 0.001), "ms", 0);
    bench_row("model: one point dragged, chord 0.02 mm", drag_time(m, 0.02), "ms", 0.008);
    kg_solution *s;
    kg_unrolled *u;
    if (kg_solution_create(m, 0.001, NULL, &s, NULL))
        abort();
    double start = bench_work();
    if (kg_unroll(m, s, &u, NULL))
        abort();
    bench_row("model: unrolled with joins, chord 0.001 mm", bench_work() - start, "ms", 0);
    kg_unrolled_destroy(u);
    kg_solution_destroy(s);
    kg_model_destroy(m);
    for (int n = 10; n <= 1000; n *= 10) {
        char what[64];
        m = row_model(n, 5 * n / 3);
        snprintf(what, sizeof what, "growth: %d patches, %d trims, each patch", n, 5 * n / 3);
        bench_row(what, solve_time(m, 3, 0.02) / n, "us", 0);
        kg_model_destroy(m);
    }
}
