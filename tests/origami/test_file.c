/* Models and crease patterns, written and read again. */
#include "tests/check.h"
#include "tests/origami/samples.h"
#include "tests/origami/stack.h"

#include <stdlib.h>

static kg_origami *read_text(const char *text) {
    kg_origami *o;
    kg_error error;
    if (kg_origami_read_memory(text, strlen(text), "m.katagami", &o, &error))
        fail_msg("%s", error.message);
    return o;
}

static void assert_refused(const char *text, const char *where, const char *why) {
    kg_origami *o = NULL;
    kg_error error;
    assert_int_equal(kg_origami_read_memory(text, strlen(text), "m.katagami", &o, &error),
                     KG_ERR_PARSE);
    assert_null(o);
    if (strncmp(error.message, where, strlen(where)) != 0 || !strstr(error.message, why))
        fail_msg("%s", error.message);
}

#define HEAD "{\"katagami\": 1, \"kind\": \"origami\", \"origami\":\n"
#define SQUARE "{\"polygon\": [[0,0],[100,0],[100,100],[0,100]]}"

static void test_unknown_keys_and_bits_survive(void **user) {
    (void)user;
    kg_origami *o = read_text(
        HEAD
        "{\"sheets\": [{\"polygon\": [[0,0],[100,0],[100,100],[0,100]], \"front\": \"#C33\", "
        "\"grain\": 3}], \"folds\": [{\"from\": [0,0], \"to\": [100,100,0], \"angle_deg\": "
        "-33.3, \"note\": \"soft\"}, {\"axis\": [[100,50,0],[50,100,0]], \"vertex\": [100,100,0], "
        "\"angle_deg\": 12.345678901234567, \"face\": 0}], \"more\": [1]}, \"own\": {}}");
    char *once, *twice;
    size_t size;
    assert_int_equal(kg_origami_write_memory(o, &once, &size, NULL), KG_OK);
    assert_non_null(strstr(once, "\"grain\": 3"));
    assert_non_null(strstr(once, "\"#C33\""));
    assert_non_null(strstr(once, "\"note\": \"soft\""));
    assert_non_null(strstr(once, "\"more\": [1]"));
    assert_non_null(strstr(once, "\"own\": {}"));
    kg_origami *again = read_text(once);
    assert_true(same_state(last(o), last(again)));
    assert_int_equal(kg_origami_write_memory(again, &twice, &size, NULL), KG_OK);
    assert_string_equal(once, twice);
    free(once);
    free(twice);
    kg_origami_destroy(o);
    kg_origami_destroy(again);
}

static void test_messages_name_the_line(void **user) {
    (void)user;
    assert_refused("{\"katagami\": 2, \"kind\": \"origami\"}", "m.katagami:1:", "update");
    assert_refused(HEAD "{\"sheets\": []}}", "m.katagami:2:", "1 to");
    assert_refused(HEAD "{\"sheets\": [\n{\"polygon\": [[0,0],[1,1],[1,0],[0,1]]}]}}",
                   "m.katagami:3:", "crosses");
    assert_refused(HEAD "{\"sheets\": [" SQUARE "],\n\"folds\": [\n{\"from\": [0,0,0]}]}}",
                   "m.katagami:4:", "\"to\"");
    assert_refused(HEAD "{\"sheets\": [" SQUARE "],\n\"folds\": [\n{\"from\": [50,50,0], \"to\": "
                        "[0,0,0]}]}}",
                   "m.katagami:4:", "fold 1: there is no vertex");
    assert_refused(HEAD "{\"sheets\": [\n{\"polygon\": [[0,0],[1,0],[0,1]], \"front\": \"red\"}]}}",
                   "m.katagami:3:", "#rgb");
}

static void test_concave_sheets_fold(void **user) {
    (void)user;
    kg_origami *o = read_text(HEAD "{\"sheets\": [{\"polygon\": [[0,0],[100,0],[100,100],[60,100],"
                                   "[60,40],[40,40],[40,100],[0,100]]}], \"folds\": [{\"axis\": "
                                   "[[0,50,0],[100,50,0]], \"vertex\": [0,100,0], \"angle_deg\": "
                                   "180}]}}");
    const kg_origami_state *s = last(o);
    assert_null(shape_check(s, 1e-9));
    assert_null(stack_check(s));
    /* one arm of the U goes over, the other stays: its topmost loops are others */
    double area = 0;
    for (size_t i = 0; i < s->vertices.count; i++)
        area = fmax(area, s->vertices.items[i].position.y);
    assert_near(area, 100, 1e-9);
    kg_origami_destroy(o);
}

/* Equal but for rounding of angles to degrees and back, and for the shift of sheets. */
static void assert_equal_states(const kg_origami_state *a, const kg_origami_state *b) {
    assert_int_equal(a->vertices.count, b->vertices.count);
    assert_int_equal(a->edges.count, b->edges.count);
    assert_int_equal(a->loops.count, b->loops.count);
    for (size_t i = 0; i < a->vertices.count; i++)
        assert_memory_equal(&a->vertices.items[i].position, &b->vertices.items[i].position,
                            sizeof(kg_vec3));
    for (size_t e = 0; e < a->edges.count; e++) {
        assert_int_equal(a->halves.items[2 * e].origin, b->halves.items[2 * e].origin);
        assert_int_equal(a->halves.items[2 * e].loop, b->halves.items[2 * e].loop);
        assert_int_equal(a->edges.items[e].kind, b->edges.items[e].kind);
        assert_near(a->edges.items[e].angle, b->edges.items[e].angle, 1e-14);
    }
    assert_true(same_orders(a, b));
}

static void test_fold_files_come_back_equal(void **user) {
    (void)user;
    static const double angles[] = {180, -180, 90, -60};
    size_t folds = 0;
    for (uint64_t seed = 0; seed < 300; seed++) {
        kg_random r = {seed};
        kg_origami *o = square_sheet(100), *again;
        if (seed % 4 == 0)
            add_rectangle(o, 30, 40, 90, 50);
        for (int tries = 0; tries < 25 && kg_origami_step(o) < 7; tries++) {
            const kg_origami_state *s = last(o);
            kg_vec3 from = s->vertices.items[kg_random_bits(&r) % s->vertices.count].position,
                    to = s->vertices.items[kg_random_bits(&r) % s->vertices.count].position;
            to = kg_lerp(from, to, kg_random_in(&r, 0.2, 1.2));
            kg_fold f = fold_to(from, to, angles[kg_random_bits(&r) % 4]);
            folds += kg_origami_fold(o, &f, NULL) == KG_OK;
        }
        char *text;
        size_t size;
        kg_error error;
        assert_int_equal(
            kg_origami_fold_text(o, kg_origami_step(o), seed % 2, &text, &size, &error), KG_OK);
        if (kg_origami_import_memory(text, size, "again.fold", NULL, &again, NULL, &error))
            fail_msg("seed %d: %s", (int)seed, error.message);
        assert_equal_states(last(o), last(again));
        free(text);
        /* and as a model that begins with the pattern */
        kg_origami *model;
        assert_int_equal(kg_origami_write_memory(again, &text, &size, NULL), KG_OK);
        model = read_text(text);
        assert_equal_states(last(again), last(model));
        free(text);
        kg_origami_destroy(o);
        kg_origami_destroy(again);
        kg_origami_destroy(model);
    }
    assert_true(folds > 600);
}

/* A square of two halves, from (1, 1) on, folded along its middle. */
#define HALVES(unit, size, assignment)                                                             \
    "{" unit "\"vertices_coords\": [[1,1],[" size ",1],[" size "," size "],[1," size               \
    "],[2,1],[2," size "]], \"edges_vertices\": [[0,4],[4,1],[1,2],[2,5],[5,3],[3,0],[4,5]], "     \
    "\"edges_assignment\": [\"B\",\"B\",\"B\",\"B\",\"B\",\"B\",\"" assignment "\"]}"

static double span(const char *text, const char *name, double *out_scale) {
    kg_origami *o;
    kg_error error;
    kg_layer_report report = kg_layer_report_default();
    if (kg_origami_import_memory(text, strlen(text), name, NULL, &o, &report, &error))
        fail_msg("%s", error.message);
    double lo = HUGE_VAL, hi = -HUGE_VAL;
    const kg_origami_state *s = last(o);
    for (size_t i = 0; i < s->vertices.count; i++) {
        lo = fmin(lo, s->vertices.items[i].paper.x);
        hi = fmax(hi, s->vertices.items[i].paper.x);
    }
    kg_origami_destroy(o);
    *out_scale = report.mm_per_unit;
    return hi - lo;
}

static void test_patterns_without_a_unit_become_sheets_of_usable_size(void **user) {
    (void)user;
    static const struct {
        const char *text;
        double span, scale;
    } cases[] = {
        {HALVES("", "3", "V"), 150, 75},
        {HALVES("\"frame_unit\": \"unit\", ", "3", "V"), 150, 75},
        {HALVES("", "401", "F"), 150, 0.375},
        {HALVES("\"frame_unit\": \"mm\", ", "3", "V"), 2, 0},
        {HALVES("\"frame_unit\": \"cm\", ", "3", "V"), 20, 0},
        {HALVES("\"frame_unit\": \"in\", ", "3", "V"), 50.8, 0},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        double scale;
        assert_near(span(cases[i].text, "x.fold", &scale), cases[i].span, 1e-12);
        assert_near(scale, cases[i].scale, 1e-15);
    }
    double scale; /* numbers of .cp files are mm */
    assert_near(span("1 0 0 2 0\n1 2 0 2 2\n1 2 2 0 2\n1 0 2 0 0\n", "x.cp", &scale), 2, 0);
    assert_near(scale, 0, 0);
}

/* The folded form is scaled along with the pattern. */
static void test_folded_forms_follow_the_size(void **user) {
    (void)user;
    kg_origami *o, *again;
    char *text;
    size_t size;
    kg_error error;
    o = square_sheet(50);
    must_fold(o, fold_to(kg_v3(0, 0, 0), kg_v3(50, 50, 0), 120));
    assert_int_equal(kg_origami_fold_text(o, 1, false, &text, &size, NULL), KG_OK);
    char *unit = strstr(text, "\"mm\"");
    assert_non_null(unit);
    memcpy(unit, "\"??\"", 4);
    if (kg_origami_import_memory(text, size, "x.fold", NULL, &again, NULL, &error))
        fail_msg("%s", error.message);
    const kg_origami_state *a = last(o), *b = last(again);
    assert_int_equal(a->vertices.count, b->vertices.count);
    for (size_t i = 0; i < a->vertices.count; i++)
        assert_near(
            kg_dist(kg_scale(a->vertices.items[i].position, 3), b->vertices.items[i].position), 0,
            1e-10);
    free(text);
    kg_origami_destroy(o);
    kg_origami_destroy(again);
}

static void assert_not_imported(const char *text, const char *name, const char *why) {
    kg_origami *o = NULL;
    kg_error error;
    assert_int_not_equal(kg_origami_import_memory(text, strlen(text), name, NULL, &o, NULL, &error),
                         KG_OK);
    assert_null(o);
    if (!strstr(error.message, why))
        fail_msg("%s", error.message);
}

static void test_messages_speak_the_coordinates_of_the_file(void **user) {
    (void)user;
    /* three creases meet at (10, 20), which cannot fold flat */
    static const char lines[] = "1 0 0 40 0\n1 40 0 40 40\n1 40 40 0 40\n1 0 40 0 0\n"
                                "2 10 20 0 0\n2 10 20 40 0\n2 10 20 0 40\n";
    assert_not_imported(lines, "x.cp", "at (10, 20)");
    assert_not_imported("1 0 0 4 0\n1 4 0 4 4\n1 4 4 0 4\n1 0 4 0 0\n2 0 1 3 1\n", "x.cp",
                        "(0, 1) to (3, 1)");
    assert_not_imported(
        "{\"vertices_coords\": [[0,0],[4,0],[4,4],[0,4],[1,2]], \"edges_vertices\": [[0,1],[1,2],"
        "[2,3],[3,0],[4,0],[4,1],[4,3]], \"edges_assignment\": [\"B\",\"B\",\"B\",\"B\",\"M\","
        "\"M\",\"M\"]}",
        "x.fold", "at (1, 2)");
    assert_not_imported("{\"vertices_coords\": [[0,0],[4,0],[4]], \"edges_vertices\": [[0,1]]}",
                        "x.fold", "x.fold:1: vertices_coords[2]: ");
    assert_not_imported("{\"vertices_coords\": [[0,0],[4,0],[4,4]], \"edges_vertices\": [[0,1],"
                        "[1,7]]}",
                        "x.fold", "x.fold:1: edges_vertices[1]");
}

static void test_net_of_a_state(void **user) {
    (void)user;
    kg_origami *o = square_sheet(100);
    kg_net *net;
    must_fold(o, fold_to(kg_v3(0, 0, 0), kg_v3(100, 100, 0), 180));
    must_fold(o, fold_to(kg_v3(0, 100, 0), kg_v3(100, 0, 0), 180));
    assert_int_equal(kg_origami_net(o, 2, &net, NULL), KG_OK);
    assert_int_equal(kg_net_check(net, NULL), KG_OK);
    assert_int_equal(net->part_count, 1);
    assert_near(net->parts[0].area, 100 * 100, 1e-9);
    assert_near(net->parts[0].perimeter, 400, 1e-9);
    double length[2] = {0, 0};
    for (size_t i = 0; i < net->parts[0].line_count; i++) {
        const kg_net_line *l = &net->parts[0].lines[i];
        length[l->kind == KG_NET_VALLEY] += kg_dist2(l->points[0], l->points[1]);
    }
    assert_near(length[0], 50 * sqrt(2), 1e-9);
    assert_near(length[1], 150 * sqrt(2), 1e-9);
    kg_net_destroy(net);
    kg_origami_destroy(o);
}

static void test_heights_keep_the_order(void **user) {
    (void)user;
    kg_origami *o = square_sheet(100);
    must_fold(o, fold_to(kg_v3(0, 0, 0), kg_v3(100, 100, 0), 180));
    must_fold(o, fold_to(kg_v3(0, 100, 0), kg_v3(100, 0, 0), 180));
    const kg_origami_state *s = last(o);
    double *heights = calloc(s->halves.count, sizeof *heights);
    assert_int_equal(kg_origami_heights(s, heights, NULL), KG_OK);
    kg_layer_order k = {0};
    while (kg_origami_next_order(s, &k)) {
        double up = kg_origami_normal(s, k.a).z > 0 ? 1 : -1;
        double a = heights[s->loops.items[k.a].first], b = heights[s->loops.items[k.b].first];
        assert_true((b - a) * up * k.side > 0);
    }
    free(heights);
    kg_origami_destroy(o);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_unknown_keys_and_bits_survive),
        cmocka_unit_test(test_messages_name_the_line),
        cmocka_unit_test(test_concave_sheets_fold),
        cmocka_unit_test(test_fold_files_come_back_equal),
        cmocka_unit_test(test_patterns_without_a_unit_become_sheets_of_usable_size),
        cmocka_unit_test(test_folded_forms_follow_the_size),
        cmocka_unit_test(test_messages_speak_the_coordinates_of_the_file),
        cmocka_unit_test(test_net_of_a_state),
        cmocka_unit_test(test_heights_keep_the_order),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
