/* Random patch models for property tests: patches around one place, trimmed by each other. */
#ifndef KG_TESTS_RANDOM_MODEL_H
#define KG_TESTS_RANDOM_MODEL_H

#include "katagami/model.h"
#include "tests/patch/random_patch.h"

#include <stdlib.h>

static inline void *checked(void *memory) {
    assert_non_null(memory);
    return memory;
}

/* Puts a trim at position `at` of a patch's list; the model owns its arrays. */
static inline void insert_trim(kg_model_patch *p, size_t at, kg_trim_op op) {
    p->trims = checked(realloc(p->trims, (p->trim_count + 1) * sizeof *p->trims));
    memmove(p->trims + at + 1, p->trims + at, (p->trim_count - at) * sizeof *p->trims);
    p->trims[at] = op;
    p->trim_count++;
}

static inline kg_trim_op trim_by(int64_t by) {
    kg_trim_op op = {.kind = KG_TRIM_BY, .by_count = 1, .by = checked(malloc(sizeof *op.by))};
    op.by[0] = by;
    return op;
}

static inline void keep_near(kg_trim_op *op, kg_vec3 point) {
    op->keep = checked(realloc(op->keep, (op->keep_count + 1) * sizeof *op->keep));
    op->keep[op->keep_count++] = point;
}

static inline kg_model_patch *add_patch(kg_model *m, int64_t id, kg_patch_input input) {
    m->patches = checked(realloc(m->patches, (m->patch_count + 1) * sizeof *m->patches));
    kg_model_patch *p = &m->patches[m->patch_count++];
    *p = (kg_model_patch){.id = id, .name = checked(strdup("")), .input = input};
    return p;
}

/* A plane: geodesic from `from` to `to`, rulings along `ruling`. */
static inline kg_patch_input flat_input(kg_vec3 from, kg_vec3 to, kg_vec3 ruling, double lo,
                                        double hi) {
    kg_patch_input in = {
        .point_count = 4, .extent = {lo, hi}, .has_ruling = true, .ruling = ruling};
    for (int i = 0; i < 4; i++)
        in.points[i] = kg_lerp(from, to, i / 3.0);
    return in;
}

static inline kg_vec3 random_place(kg_random *r) {
    return kg_random_v3(r, (double[6]){-40, 60, -30, 70, -80, 20});
}

/* A trim of a patch by one of the others. */
static inline kg_trim_op random_trim(kg_random *r, const kg_model *m, int64_t id) {
    if (kg_random_bits(r) % 5 == 0) {
        kg_trim_op op = {.kind = KG_TRIM_CONTOUR,
                         .outside = kg_random_bits(r) & 1,
                         .contour_count = 3,
                         .contour = checked(malloc(3 * sizeof *op.contour))};
        for (int i = 0; i < 3; i++)
            op.contour[i] = kg_random_v2(r, (double[4]){-20, 20, 0, 1});
        return op;
    }
    int64_t by;
    do
        by = m->patches[kg_random_bits(r) % m->patch_count].id;
    while (by == id);
    kg_trim_op op = trim_by(by);
    if (kg_random_bits(r) % 4 == 0 && m->patch_count > 3) { /* by several */
        op.kind = KG_TRIM_INSIDE;
        op.trim_cutters = kg_random_bits(r) & 1;
        op.by = checked(realloc(op.by, 2 * sizeof *op.by));
        do
            op.by[1] = m->patches[kg_random_bits(r) % m->patch_count].id;
        while (op.by[1] == id || op.by[1] == by);
        op.by_count = 2;
    }
    op.bounded = kg_random_bits(r) % 6 == 0;
    for (uint64_t n = kg_random_bits(r) % 3; n > 0; n--)
        keep_near(&op, random_place(r));
    return op;
}

/* `count` patches of all kinds with one trim or two each; some trims fail. */
static inline kg_model *random_model(kg_random *r, size_t count) {
    kg_model *m = checked(kg_model_create());
    for (size_t i = 0; i < count; i++) {
        kg_patch_input in;
        kg_patch probe;
        do {
            in = random_input(r, (patch_kind)(kg_random_bits(r) % (KIND_COUNT - 1) + 1), 4);
            kg_vec3 move = kg_random_v3(r, (double[6]){-20, 20, -20, 20, -20, 20});
            kg_vec3 middle = kg_scale(kg_add(in.points[1], in.points[2]), 0.5);
            for (size_t k = 0; k < in.point_count; k++)
                in.points[k] = kg_add(kg_sub(in.points[k], middle), move);
        } while (kg_patch_init(&in, &probe, NULL) != KG_OK);
        add_patch(m, (int64_t)(i + 1), in);
    }
    for (size_t i = 0; i < count && count > 1; i++)
        for (uint64_t n = kg_random_bits(r) % 3; n > 0; n--)
            insert_trim(&m->patches[i], m->patches[i].trim_count,
                        random_trim(r, m, m->patches[i].id));
    return m;
}

#endif
