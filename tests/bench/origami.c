/* Folding and the layers of finished patterns, on sheets folded flat many times over. */
#include "katagami/origami.h"
#include "bench/bench.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A repeatable generator (splitmix64). */
static double random_in(uint64_t *state, double lo, double hi) {
    uint64_t z = (*state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return lo + (hi - lo) * ((double)((z ^ (z >> 31)) >> 11) * 0x1p-53);
}

static kg_fold random_fold(const kg_origami_state *s, uint64_t *seed) {
    kg_fold f = kg_fold_default();
    size_t v = (size_t)random_in(seed, 0, (double)s->vertices.count);
    f.points[0] = s->vertices.items[v].position;
    f.points[1] = kg_add(f.points[0], kg_v3(random_in(seed, -60, 60), random_in(seed, -60, 60), 0));
    f.angle_deg = random_in(seed, -1, 1) < 0 ? -180 : 180;
    return f;
}

/* A square folded flat until it has at least `faces` of them. */
static kg_origami *folded_square(size_t faces, uint64_t seed) {
    kg_vec2 p[] = {{0, 0}, {100, 0}, {100, 100}, {0, 100}};
    kg_paper_sheet sheet = {.count = 4, .polygon = p};
    kg_origami *o = kg_origami_create();
    if (!o || kg_origami_add_sheet(o, &sheet, NULL))
        return o;
    for (int tries = 0; tries < 2000; tries++) {
        const kg_origami_state *s = kg_origami_state_at(o, kg_origami_step(o));
        if (s->loops.count >= faces)
            break;
        kg_fold f = random_fold(s, &seed);
        if (kg_origami_fold(o, &f, NULL) != KG_OK)
            continue;
    }
    return o;
}

static void bench_fold(size_t faces) {
    kg_origami *o = folded_square(faces, 7);
    const kg_origami_state *s = kg_origami_state_at(o, kg_origami_step(o));
    char what[80];
    uint64_t seed = 11;
    double total = 0, worst = 0;
    int count = 0;
    for (int tries = 0; tries < 500 && count < 20; tries++) {
        kg_fold f = random_fold(s, &seed);
        double start = bench_now();
        bool done = kg_origami_fold(o, &f, NULL) == KG_OK;
        double time = bench_now() - start;
        if (!done)
            continue;
        count++;
        total += time;
        worst = fmax(worst, time);
        kg_origami_undo(o);
    }
    snprintf(what, sizeof what, "origami: one fold, %zu faces, %zu pairs on each other",
             s->loops.count, kg_origami_pair_count(s));
    bench_row(what, total / fmax(count, 1), "ms", 0.010);
    bench_row("  the slowest of them", worst, "ms", 0);
    char *text;
    size_t size;
    if (kg_origami_fold_text(o, kg_origami_step(o), false, &text, &size, NULL) == KG_OK) {
        bench_rabbit("fold", text, size, total / fmax(count, 1), 0);
        bench_rabbit("fold-orders", text, size, total / fmax(count, 1), 1000);
        free(text);
    }
    kg_origami_destroy(o);
}

/* The crease pattern alone, as a file, to be folded and ordered. */
static void bench_layers(size_t faces) {
    kg_origami *o = folded_square(faces, faces), *read = NULL;
    char *text, what[80];
    size_t size;
    kg_error error;
    kg_layer_report report = kg_layer_report_default();
    if (kg_origami_fold_text(o, kg_origami_step(o), false, &text, &size, &error) == KG_OK) {
        memcpy(strstr(text, "\"file_frames\""), "\"some_frames\"", 13);
        double start = bench_now();
        kg_status status =
            kg_origami_import_memory(text, size, "b.fold", NULL, &read, &report, &error);
        double time = bench_now() - start;
        snprintf(what, sizeof what, "origami: layers of %zu faces, %zu pairs, %s%g states",
                 kg_origami_state_at(o, kg_origami_step(o))->loops.count, report.pairs,
                 report.exact ? "" : "over ", report.states);
        bench_row(status ? error.message : what, time, "ms", 0);
        bench_rabbit("layers", text, size, time, 20);
        free(text);
    }
    kg_origami_destroy(o);
    kg_origami_destroy(read);
}

void bench_origami(void) {
    bench_fold(1000);
    bench_layers(70);
    bench_layers(150);
    bench_layers(250);
    bench_layers(400);
}
