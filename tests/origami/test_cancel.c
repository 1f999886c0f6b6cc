/* Long work on layers tells how far it is, and ends when it is told to. */
#include "tests/check.h"
#include "tests/origami/samples.h"
#include "tests/origami/stack.h"

#include <stdlib.h>

typedef struct listener {
    size_t calls, last; /* the call that cancels; 0: none */
    double fraction;
} listener;

static bool listen(void *user, double fraction, const char *what) {
    listener *l = user;
    assert_non_null(what);
    assert_true(fraction >= l->fraction && fraction <= 1);
    l->fraction = fraction;
    return ++l->calls != l->last;
}

/* A square folded flat to and fro, as a crease pattern without its layers; free() it. */
static char *pattern(size_t *out_size) {
    kg_random r = {5};
    kg_origami *o = square_sheet(100);
    for (int tries = 0; tries < 200 && last(o)->loops.count < 150; tries++) {
        const kg_origami_state *s = last(o);
        kg_vec3 from = s->vertices.items[kg_random_bits(&r) % s->vertices.count].position;
        double x = kg_random_in(&r, -60, 60), y = kg_random_in(&r, -60, 60);
        kg_fold f =
            fold_to(from, kg_add(from, kg_v3(x, y, 0)), kg_random_bits(&r) & 1 ? 180 : -180);
        if (kg_origami_fold(o, &f, NULL)) /* paper cannot do it: another one */
            continue;
    }
    char *text;
    kg_error error = {0};
    if (kg_origami_fold_text(o, kg_origami_step(o), false, &text, out_size, &error))
        fail_msg("%s", error.message);
    memcpy(strstr(text, "\"file_frames\""), "\"some_frames\"", 13);
    kg_origami_destroy(o);
    return text;
}

static void assert_same_report(const kg_layer_report *a, const kg_layer_report *b) {
    assert_true(a->most_states == b->most_states && a->most_steps == b->most_steps);
    assert_true(a->pairs == b->pairs && a->variables == b->variables);
    assert_true(a->components == b->components && a->states == b->states && a->exact == b->exact);
}

/* Whichever call it is that says no more is the last one, and nothing has changed. */
static void test_any_call_ends_it(void **user) {
    (void)user;
    size_t size;
    char *text = pattern(&size);
    listener all = {0};
    kg_progress progress = {listen, &all};
    kg_layer_report report = kg_layer_report_default(), before = report, counted = report;
    kg_error error = {0};
    kg_origami *o = NULL, *none = NULL;
    if (kg_origami_import_memory(text, size, "a.fold", &progress, &o, &report, &error))
        fail_msg("%s", error.message);
    assert_true(all.calls > 100 && all.fraction > 0.5);
    for (size_t n = 1; n <= all.calls; n += 1 + n / 4) {
        listener some = {.last = n};
        kg_layer_report untouched = before;
        progress.user = &some;
        assert_int_equal(
            kg_origami_import_memory(text, size, "a.fold", &progress, &none, &untouched, &error),
            KG_ERR_CANCELLED);
        assert_int_equal(some.calls, n);
        assert_null(none);
        assert_same_report(&untouched, &before);
        assert_string_equal(error.message, "a.fold: cancelled");
    }
    /* counting once more, of a state that stays as it is */
    listener end = {.last = all.calls};
    progress.user = &end;
    assert_int_equal(kg_origami_count_orders(o, &progress, &counted, &error), KG_ERR_CANCELLED);
    assert_same_report(&counted, &before);
    assert_int_equal(kg_origami_count_orders(o, NULL, &counted, &error), KG_OK);
    assert_same_report(&counted, &report);
    kg_origami_destroy(o);
    free(text);
}

/* A search that would go on for its steps is told of as it goes. */
static void test_the_search_itself_ends(void **user) {
    (void)user;
    size_t size;
    char *text = pattern(&size);
    listener all = {0};
    kg_progress progress = {listen, &all};
    kg_layer_report report = kg_layer_report_default();
    kg_error error = {0};
    kg_origami *o = NULL;
    for (char *at = strstr(text, "\"edges_assignment\""); *at != ']'; at++)
        if (*at == 'M' || *at == 'V') /* all left open: many more ways */
            *at = 'U';
    report.most_states = 1e300;
    report.most_steps = 1e7;
    if (kg_origami_import_memory(text, size, "a.fold", &progress, &o, &report, &error))
        fail_msg("%s", error.message);
    listener some = {.last = all.calls - 20}; /* of the last steps */
    progress.user = &some;
    kg_origami_destroy(o);
    o = NULL;
    assert_int_equal(kg_origami_import_memory(text, size, "a.fold", &progress, &o, &report, &error),
                     KG_ERR_CANCELLED);
    assert_true(some.calls == all.calls - 20 && some.fraction > 0.7);
    assert_null(o);
    free(text);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_any_call_ends_it),
        cmocka_unit_test(test_the_search_itself_ends),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
