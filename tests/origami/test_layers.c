/* Layer orders of crease patterns: found, counted, or proved impossible. */
#include "origami/layers.h"
#include "origami/solver.h"
#include "tests/check.h"
#include "tests/origami/samples.h"
#include "tests/origami/stack.h"

#include <stdlib.h>
#include <unistd.h>

static kg_status import(const char *text, const char *name, kg_origami **out,
                        kg_layer_report *report, kg_error *error) {
    *report = kg_layer_report_default();
    return kg_origami_import_memory(text, strlen(text), name, NULL, out, report, error);
}

/* ---- brute force ------------------------------------------------------------------------ */

static bool creases_hold(const kg_origami_state *s) {
    for (size_t e = 0; e < s->edges.count; e++) {
        int32_t a = s->halves.items[2 * e].loop, b = s->halves.items[2 * e + 1].loop;
        double angle = s->edges.items[e].angle;
        if (a >= 0 && b >= 0 && angle != 0 && s->edges.items[e].kind != KG_PAPER_OPEN &&
            kg_origami_order(s, a, b) != (angle > 0 ? 1 : -1))
            return false;
    }
    return true;
}

static void turn_order(kg_origami_state *s, kg_layer_order o) {
    for (int side = -1; side <= 1; side += 2) {
        kg_layer_row(s, o.a, side)[o.b >> 6] ^= (uint64_t)1 << (o.b & 63);
        kg_layer_row(s, o.b, side)[o.a >> 6] ^= (uint64_t)1 << (o.a & 63);
    }
}

/* All ways to order the pairs of a solved state, tried one by one. */
static size_t count_by_force(kg_origami_state *s) {
    kg_layer_order pairs[16];
    size_t ways = 0, count = 0;
    for (kg_layer_order o = {0}; kg_origami_next_order(s, &o); count++) {
        assert_true(count < sizeof pairs / sizeof *pairs);
        pairs[count] = o;
    }
    /* one bit after the other is turned (Gray 1953): every way once */
    for (size_t step = 1; step <= (size_t)1 << count; step++) {
        ways += creases_hold(s) && stack_check(s) == NULL;
        if (step < (size_t)1 << count)
            turn_order(s, pairs[__builtin_ctzll(step)]);
    }
    return ways;
}

/* A random pattern as FOLD, made by folding and said to be flat again; free() it. */
static void random_pattern(kg_random *r, char **out_text) {
    kg_origami *o = square_sheet(100);
    for (int tries = 0; tries < 8 && kg_origami_step(o) < 3; tries++) {
        const kg_origami_state *s = last(o);
        kg_vec3 from = s->vertices.items[kg_random_bits(r) % s->vertices.count].position;
        double x = kg_random_in(r, 0, 100), y = kg_random_in(r, 0, 100);
        kg_fold f = fold_to(from, kg_v3(x, y, 0), kg_random_bits(r) & 1 ? 180 : -180);
        if (kg_origami_fold(o, &f, NULL)) /* paper cannot do it: another one */
            continue;
    }
    size_t size;
    kg_error error = {0};
    if (kg_origami_fold_text(o, kg_origami_step(o), false, out_text, &size, &error))
        fail_msg("%s", error.message);
    /* without its frames the file says nothing of layers, and without angles letters decide */
    memcpy(strstr(*out_text, "\"file_frames\""), "\"some_frames\"", 13);
    memcpy(strstr(*out_text, "\"edges_foldAngle\""), "\"edges_sameAngle\"", 17);
    kg_origami_destroy(o);
}

/* Writes another letter for an edge of a pattern; what it was. */
static char set_letter(char *text, size_t edge, char letter) {
    char *p = strchr(strstr(text, "\"edges_assignment\""), '[');
    for (size_t quotes = 0; quotes <= 2 * edge; quotes++)
        p = strchr(p, '"') + 1;
    char was = *p;
    *p = letter;
    return was;
}

/* How many states a pattern has as the solver says; 0 when there is proved to be none. */
static double solved(const char *text, uint64_t seed) {
    kg_layer_report report;
    kg_error error = {0};
    kg_origami *o = NULL;
    kg_status status = import(text, "random.fold", &o, &report, &error);
    if (!status)
        assert_sound(last(o), 1e-6);
    kg_origami_destroy(o);
    if (status && (status != KG_ERR_INPUT || !(strstr(error.message, "no order of layers") ||
                                               strstr(error.message, "Maekawa"))))
        fail_msg("seed %d: %s", (int)seed, error.message);
    assert_true(status || report.exact);
    return status ? 0 : report.states;
}

/* Patterns as they were folded, with each crease turned over, and with it left open. */
static void test_counts_equal_brute_force(void **user) {
    (void)user;
    size_t compared = 0, several = 0, none = 0;
    for (uint64_t seed = 0; seed < 800 && compared < 600; seed++) {
        kg_random r = {seed};
        kg_origami *o;
        kg_layer_report report;
        kg_error error = {0};
        char *text;
        random_pattern(&r, &text);
        if (import(text, "random.fold", &o, &report, &error))
            fail_msg("seed %d: %s", (int)seed, error.message);
        kg_origami_state *s = kg_state_copy(last(o)); /* without layers */
        assert_int_equal(kg_state_solve(s, NULL, &report, &error), KG_OK);
        size_t pairs = kg_origami_pair_count(s);
        for (size_t e = 0; e <= s->edges.count && pairs > 1 && pairs <= 9; e++) {
            kg_paper_edge was = {0};
            char letter = 0;
            if (e < s->edges.count) {
                was = s->edges.items[e];
                if (was.angle == 0)
                    continue;
                bool opens = kg_random_bits(&r) % 2;
                letter = set_letter(text, e, opens ? 'U' : was.angle > 0 ? 'M' : 'V');
                assert_int_equal(letter, was.angle > 0 ? 'V' : 'M');
                s->edges.items[e].angle *= -1;
                if (opens)
                    s->edges.items[e].kind = KG_PAPER_OPEN;
            }
            size_t ways = count_by_force(s);
            double states = solved(text, seed);
            if (states != (double)ways)
                fail_msg("seed %d, edge %d: %g states, %zu by force", (int)seed, (int)e, states,
                         ways);
            compared++, several += ways > 1, none += ways == 0;
            if (letter) {
                s->edges.items[e] = was;
                set_letter(text, e, letter);
            }
        }
        kg_state_destroy(s);
        free(text);
        kg_origami_destroy(o);
    }
    print_message("%zu patterns, %zu with several states, %zu with none\n", compared, several,
                  none);
    assert_true(compared >= 400 && several >= 40 && none >= 40);
}

/* ---- known patterns --------------------------------------------------------------------- */

static const char strip[] =
    "{\"vertices_coords\": [[0,0],[1,0],[2,0],[3,0],[4,0],[0,1],[1,1],[2,1],[3,1],[4,1]],"
    "\"edges_vertices\": [[0,1],[1,2],[2,3],[3,4],[5,6],[6,7],[7,8],[8,9],[0,5],[4,9],[1,6],"
    "[2,7],[3,8]],"
    "\"edges_assignment\": [\"B\",\"B\",\"B\",\"B\",\"B\",\"B\",\"B\",\"B\",\"B\",\"B\","
    "\"U\",\"U\",\"U\"]}";

static void test_two_strips_wind_both_ways(void **user) {
    (void)user;
    /* a strip of four with open creases: the number of ways to fold a strip of four stamps, 16 */
    kg_origami *o;
    kg_layer_report report;
    kg_error error = {0};
    if (import(strip, "strip.fold", &o, &report, &error))
        fail_msg("%s", error.message);
    assert_near(report.states, 16, 0);
    assert_true(report.exact);
    assert_sound(last(o), 1e-6);
    kg_origami_destroy(o);
}

/* A strip of four with a flat crease beside its end: what is folded beside that crease cannot take
 * the longer piece between its two layers. */
static void test_a_flat_crease_is_no_gap(void **user) {
    (void)user;
    static const char *letters[] = {"\"F\",\"U\",\"U\"]}", "\"U\",\"U\",\"F\"]}"};
    for (int i = 0; i < 2; i++) {
        kg_origami *o;
        kg_layer_report report;
        kg_error error = {0};
        char text[sizeof strip];
        memcpy(text, strip, sizeof strip);
        memcpy(strstr(text, "\"U\",\"U\",\"U\"]}"), letters[i], strlen(letters[i]));
        if (import(text, "strip.fold", &o, &report, &error))
            fail_msg("%s", error.message);
        assert_near(report.states, 4, 0);
        assert_sound(last(o), 1e-6);
        kg_origami_destroy(o);
    }
}

/* The inner square stands on a corner; a pleat leaves each of its sides. Its four sectors lie over
 * one another in a ring, which no stack of whole faces can hold. */
static void test_square_twist(void **user) {
    (void)user;
    kg_origami *o;
    kg_layer_report report;
    kg_error error = {0};
    const char *text = "1 0 0 8 0\n1 8 0 8 8\n1 8 8 0 8\n1 0 8 0 0\n"
                       "2 5 4 4 5\n2 4 5 3 4\n2 3 4 4 3\n2 4 3 5 4\n"
                       "2 5 4 8 4\n3 4 5 8 5\n2 4 5 4 8\n3 3 4 3 8\n"
                       "2 3 4 0 4\n3 4 3 0 3\n2 4 3 4 0\n3 5 4 5 0\n";
    if (import(text, "twist.cp", &o, &report, &error))
        fail_msg("%s", error.message);
    assert_int_equal(last(o)->loops.count, 9);
    assert_sound(last(o), 1e-6);
    assert_near(report.states, 1, 0);
    kg_origami_destroy(o);
}

static void test_bad_vertices_are_named(void **user) {
    (void)user;
    kg_origami *o = NULL;
    kg_layer_report report;
    kg_error error;
    /* creases at 0, 90, 180 and 260 degrees */
    const char *angles = "1 0 0 4 0\n1 4 0 4 4\n1 4 4 0 4\n1 0 4 0 0\n2 2 2 4 2\n2 2 2 2 0\n"
                         "2 2 2 0 2\n3 2 2 2.3 4\n";
    assert_int_equal(import(angles, "angles.cp", &o, &report, &error), KG_ERR_INPUT);
    assert_non_null(strstr(error.message, "(2, 2)"));
    assert_non_null(strstr(error.message, "Kawasaki"));
    const char *letters = "1 0 0 4 0\n1 4 0 4 4\n1 4 4 0 4\n1 0 4 0 0\n2 2 2 4 2\n2 2 2 2 0\n"
                          "3 2 2 0 2\n3 2 2 2 4\n";
    assert_int_equal(import(letters, "letters.cp", &o, &report, &error), KG_ERR_INPUT);
    assert_non_null(strstr(error.message, "Maekawa"));
}

static void test_wide_middle_between_two_valleys_is_impossible(void **user) {
    (void)user;
    /* stamps of widths 2, 1, 2: valley and valley pass through each other, valley and mountain do
       not; every vertex by itself is on the border and has no say */
    kg_origami *o = NULL;
    kg_layer_report report;
    kg_error error;
    assert_int_equal(import("1 0 0 5 0\n1 5 0 5 1\n1 5 1 0 1\n1 0 1 0 0\n3 2 0 2 1\n3 3 0 3 1\n",
                            "stamps.cp", &o, &report, &error),
                     KG_ERR_INPUT);
    assert_non_null(strstr(error.message, "no order of layers"));
    if (import("1 0 0 5 0\n1 5 0 5 1\n1 5 1 0 1\n1 0 1 0 0\n3 2 0 2 1\n2 3 0 3 1\n", "stamps.cp",
               &o, &report, &error))
        fail_msg("%s", error.message);
    assert_near(report.states, 1, 0);
    kg_origami_destroy(o);
}

/* Six faces, eleven pairs on each other; without two of those pairs there seem to be no orders, or
 * none that are complete. */
static void test_every_pair_that_overlaps_counts(void **user) {
    (void)user;
    static const char text[] =
        "{\"vertices_coords\": [[0, 0], [100, 0], [100, 100], [0, 100], [100, "
        "22.18993356607624], [0, 51.556206517548], [6.508503829203377, 100], "
        "[23.607209604803312, 44.6236489087754], [0, 24.737740284950625], [100, "
        "40.84024880874534], [56.78619576376573, 100], [73.08768627763384, 0], [100, "
        "10.396627002449721]], \"edges_vertices\": [[0, 11], [1, 12], [2, 10], [3, 5], [4, 9], "
        "[5, 8], [5, 7], [6, 3], [7, 4], [6, 7], [8, 0], [7, 8], [9, 2], [10, 6], [10, 9], "
        "[11, 1], [12, 4], [12, 11]], \"edges_assignment\": [\"B\", \"B\", \"B\", \"B\", "
        "\"B\", \"B\", \"M\", \"B\", \"M\", \"M\", \"B\", \"V\", \"B\", \"B\", \"M\", \"B\", "
        "\"B\", \"V\"], \"faces_vertices\": [[9, 2, 10], [11, 1, 12], [6, 3, 5, 7], [7, 5, 8], "
        "[10, 6, 7, 4, 9], [12, 4, 7, 8, 0, 11]]}";
    kg_origami *o;
    kg_layer_report report;
    kg_error error = {0};
    if (import(text, "pairs.fold", &o, &report, &error))
        fail_msg("%s", error.message);
    kg_origami_state *s = kg_state_copy(last(o)); /* without layers */
    assert_int_equal(kg_state_solve(s, NULL, &report, &error), KG_OK);
    assert_int_equal(kg_origami_pair_count(s), 11);
    assert_near(report.states, 2, 0);
    assert_int_equal(count_by_force(s), 2);
    kg_state_destroy(s);
    kg_origami_destroy(o);
}

/* ---- cuts ------------------------------------------------------------------------------- */

/* Upper left flap over the upper right, hinged at x = 2; what was its lower edge is the cut. */
static const char slit[] =
    "{\"vertices_coords\": [[0,0],[4,0],[4,2],[4,4],[2,4],[0,4],[0,2],[2,2]],"
    "\"edges_vertices\": [[0,1],[1,2],[2,3],[3,4],[4,5],[5,6],[6,0],[6,7],[4,7],[2,7]],"
    "\"edges_assignment\": [\"B\",\"B\",\"B\",\"B\",\"B\",\"B\",\"B\",\"C\",\"V\","
    "\"F\"]}";

static void test_paper_opens_along_a_slit(void **user) {
    (void)user;
    kg_origami *o, *again = NULL;
    kg_layer_report report;
    kg_error error = {0};
    if (import(slit, "slit.fold", &o, &report, &error))
        fail_msg("%s", error.message);
    const kg_origami_state *s = last(o);
    assert_int_equal(s->loops.count, 3);
    assert_int_equal(s->vertices.count, 9); /* two where the slit begins, one where it ends */
    assert_near(report.states, 1, 0);
    assert_sound(s, 1e-6);
    char *text;
    size_t size;
    if (kg_origami_fold_text(o, 0, false, &text, &size, &error) ||
        kg_origami_import_memory(text, size, "again.fold", NULL, &again, NULL, &error))
        fail_msg("%s", error.message);
    assert_int_equal(last(again)->vertices.count, 9);
    assert_sound(last(again), 1e-6);
    kg_origami_destroy(again);
    /* without the folded form, too */
    memcpy(strstr(text, "\"file_frames\""), "\"some_frames\"", 13);
    if (kg_origami_import_memory(text, size, "again.fold", NULL, &again, NULL, &error))
        fail_msg("%s", error.message);
    assert_true(same_state(s, last(again)));
    kg_origami_destroy(again);
    free(text);
    kg_origami_destroy(o);
}

/* A slit that ends inside a face, and a fold through its end: beside it the paper is folded on both
 * sides, each on its own. */
static void test_a_cut_ends_inside_a_face(void **user) {
    (void)user;
    kg_origami *o, *again;
    kg_layer_report report;
    kg_error error = {0};
    if (import("{\"frame_unit\": \"mm\", "
               "\"vertices_coords\": [[0,0],[4,0],[4,4],[2,4],[0,4],[2,1]],"
               "\"edges_vertices\": [[0,1],[1,2],[2,3],[3,4],[4,0],[3,5]],"
               "\"edges_assignment\": [\"B\",\"B\",\"B\",\"B\",\"B\",\"C\"]}",
               "slit.fold", &o, &report, &error))
        fail_msg("%s", error.message);
    const kg_origami_state *s = last(o);
    assert_int_equal(s->vertices.count, 7); /* two at the border */
    int borders = 0;
    double area = 0;
    for (size_t e = 0; e < s->edges.count; e++)
        borders += s->edges.items[e].kind == KG_PAPER_BORDER;
    assert_int_equal(borders, 7);
    for (size_t i = 0; i < s->loops.count; i++) {
        kg_vec2 p[16];
        size_t n = kg_state_polygon(s, (int32_t)i, NULL, NULL, p);
        for (size_t k = 0; k < n; k++)
            area += kg_cross2(p[k], p[(k + 1) % n]) / 2;
    }
    assert_near(area, 16, 1e-12);
    assert_sound(s, 1e-9);
    char *text;
    size_t size;
    if (kg_origami_fold_text(o, 0, false, &text, &size, &error) ||
        kg_origami_import_memory(text, size, "again.fold", NULL, &again, NULL, &error))
        fail_msg("%s", error.message);
    assert_int_equal(last(again)->vertices.count, 7);
    assert_sound(last(again), 1e-9);
    /* one flap beside the slit folds down without the other */
    must_fold(o, fold_axis(kg_v3(0, 2, 0), kg_v3(4, 2, 0), kg_v3(0, 4, 0), 180));
    assert_sound(last(o), 1e-9);
    double top = 0;
    for (size_t i = 0; i < last(o)->vertices.count; i++)
        top = fmax(top, last(o)->vertices.items[i].position.y);
    assert_near(top, 4, 1e-9);
    free(text);
    kg_origami_destroy(o);
    kg_origami_destroy(again);
    /* a crease cannot end there */
    assert_int_equal(import("1 0 0 4 0\n1 4 0 4 4\n1 4 4 0 4\n1 0 4 0 0\n2 2 4 2 1\n", "bad.cp", &o,
                            &report, &error),
                     KG_ERR_INPUT);
    assert_non_null(strstr(error.message, "ends inside a face"));
}

/* Cuts in .cp files are lines of the border inside it: a slit whose sides fold apart, one that ends
 * inside a face, and a window. */
static void test_cuts_in_cp_files(void **user) {
    (void)user;
    kg_origami *o, *again;
    kg_layer_report report;
    kg_error error = {0};
    static const char sheet[] = "1 0 0 8 0\n1 8 0 8 8\n1 8 8 0 8\n1 0 8 0 0\n";
    char text[512];
    snprintf(text, sizeof text, "%s1 4 8 4 4\n3 0 4 4 4\n4 4 4 8 4\n", sheet);
    if (import(text, "slit.cp", &o, &report, &error))
        fail_msg("%s", error.message);
    assert_int_equal(last(o)->loops.count, 3);
    assert_int_equal(last(o)->vertices.count, 9);
    assert_near(report.states, 1, 0);
    assert_sound(last(o), 1e-9);
    char folder[] = "/tmp/katagami-cuts-XXXXXX", path[64];
    assert_non_null(mkdtemp(folder));
    snprintf(path, sizeof path, "%s/slit.cp", folder);
    assert_int_equal(kg_origami_export(o, 0, false, path, &error), KG_OK);
    if (kg_origami_import(path, NULL, &again, &report, &error))
        fail_msg("%s", error.message);
    unlink(path);
    rmdir(folder);
    assert_int_equal(last(again)->loops.count, 3);
    assert_int_equal(last(again)->vertices.count, 9);
    assert_sound(last(again), 1e-9);
    kg_origami_destroy(o);
    kg_origami_destroy(again);
    snprintf(text, sizeof text, "%s1 4 8 4 4\n", sheet);
    if (import(text, "tip.cp", &o, &report, &error))
        fail_msg("%s", error.message);
    assert_int_equal(last(o)->vertices.count, 7);
    assert_sound(last(o), 1e-9);
    kg_origami_destroy(o);
    snprintf(text, sizeof text,
             "%s1 2 2 6 2\n1 6 2 6 6\n1 6 6 2 6\n1 2 6 2 2\n4 0 0 2 2\n4 8 0 6 2\n4 8 8 6 6\n4 0 8 "
             "2 6\n",
             sheet);
    if (import(text, "window.cp", &o, &report, &error))
        fail_msg("%s", error.message);
    assert_int_equal(last(o)->loops.count, 4); /* what is bordered all around is a hole */
    assert_sound(last(o), 1e-9);
    kg_origami_destroy(o);
}

/* Both creases that meet at the slit fold on their own: at its middle there are two vertices, and
 * neither has to meet Kawasaki's or Maekawa's condition. */
static void test_creases_end_at_an_inner_slit(void **user) {
    (void)user;
    kg_origami *o;
    kg_layer_report report;
    kg_error error = {0};
    if (import("{\"vertices_coords\": [[0,0],[2,0],[4,0],[4,2],[4,4],[2,4],[0,4],[0,2],[1,2],[2,2],"
               "[3,2]],"
               "\"edges_vertices\": [[0,1],[1,2],[2,3],[3,4],[4,5],[5,6],[6,7],[7,0],[7,8],[8,9],"
               "[9,10],[10,3],[1,9],[9,5]],"
               "\"edges_assignment\": [\"B\",\"B\",\"B\",\"B\",\"B\",\"B\",\"B\",\"B\","
               "\"F\",\"C\",\"C\",\"F\",\"V\",\"V\"]}",
               "slit.fold", &o, &report, &error))
        fail_msg("%s", error.message);
    assert_int_equal(last(o)->loops.count, 4);
    assert_int_equal(last(o)->vertices.count, 12);
    assert_near(report.states, 1, 0);
    assert_sound(last(o), 1e-6);
    kg_origami_destroy(o);
}

static void test_a_ring_of_cuts_makes_two_sheets(void **user) {
    (void)user;
    kg_origami *o;
    kg_layer_report report;
    kg_error error = {0};
    if (import("{\"vertices_coords\": [[0,0],[4,0],[4,4],[0,4],[1,1],[3,1],[3,3],[1,3]],"
               "\"edges_vertices\": [[0,1],[1,2],[2,3],[3,0],[4,5],[5,6],[6,7],[7,4],[0,4],[1,5],"
               "[2,6],[3,7]],"
               "\"edges_assignment\": [\"B\",\"B\",\"B\",\"B\",\"C\",\"C\",\"C\",\"C\","
               "\"F\",\"F\",\"F\",\"F\"]}",
               "ring.fold", &o, &report, &error))
        fail_msg("%s", error.message);
    const kg_origami_state *s = last(o);
    assert_int_equal(s->loops.count, 5);
    assert_int_equal(s->vertices.count, 12);
    int sheets = 0;
    for (size_t i = 0; i < s->loops.count; i++)
        sheets = s->loops.items[i].sheet > sheets ? s->loops.items[i].sheet : sheets;
    assert_int_equal(sheets, 1);
    assert_int_equal(kg_origami_pair_count(s), 0);
    assert_sound(s, 1e-6);
    kg_origami_destroy(o);
}

static void test_search_ends_when_its_steps_are_over(void **user) {
    (void)user;
    kg_origami *o = NULL;
    kg_layer_report report = kg_layer_report_default();
    kg_error error;
    report.most_steps = 1;
    assert_int_equal(
        kg_origami_import_memory(strip, strlen(strip), "s.fold", NULL, &o, &report, &error),
        KG_ERR_CANCELLED);
    report = kg_layer_report_default();
    report.most_states = 2;
    if (kg_origami_import_memory(strip, strlen(strip), "s.fold", NULL, &o, &report, &error))
        fail_msg("%s", error.message);
    assert_false(report.exact);
    assert_in_range((int)report.states, 2, 16);
    kg_origami_destroy(o);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_counts_equal_brute_force),
        cmocka_unit_test(test_two_strips_wind_both_ways),
        cmocka_unit_test(test_a_flat_crease_is_no_gap),
        cmocka_unit_test(test_square_twist),
        cmocka_unit_test(test_bad_vertices_are_named),
        cmocka_unit_test(test_wide_middle_between_two_valleys_is_impossible),
        cmocka_unit_test(test_every_pair_that_overlaps_counts),
        cmocka_unit_test(test_paper_opens_along_a_slit),
        cmocka_unit_test(test_a_cut_ends_inside_a_face),
        cmocka_unit_test(test_cuts_in_cp_files),
        cmocka_unit_test(test_creases_end_at_an_inner_slit),
        cmocka_unit_test(test_a_ring_of_cuts_makes_two_sheets),
        cmocka_unit_test(test_search_ends_when_its_steps_are_over),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
