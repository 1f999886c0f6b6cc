#include "base/json.h"
#include "reference.h"

#include <stdlib.h>

static kg_status read_text(const char *text, kg_oa **out, kg_error *error) {
    *out = NULL;
    return kg_oa_read_memory(text, strlen(text), "card.katagami", out, error);
}

/* Refused, with a message that has all the words (separated by '|'). */
static void refused(const char *text, const char *words) {
    kg_oa *oa;
    kg_error error = {0};
    char copy[200];
    assert_int_equal(read_text(text, &oa, &error), KG_ERR_PARSE);
    assert_null(oa);
    assert_true(strlen(words) < sizeof copy);
    memcpy(copy, words, strlen(words) + 1);
    for (char *word = strtok(copy, "|"); word; word = strtok(NULL, "|"))
        if (!strstr(error.message, word))
            fail_msg("\"%s\" does not say \"%s\"", error.message, word);
}

#define CARD(members) "{\"katagami\": 1, \"kind\": \"oa\",\n\"oa\": {" members "}}"
#define SIZE "\"size\": [3, 4, 2], \"cell_mm\": 2.5,\n"
#define DEPTH "\"depth\": [[0, 0],\n[3, 1],\n[0, 0]]"

static void card_is_read(void **state) {
    (void)state;
    kg_oa *oa;
    assert_int_equal(read_text(CARD(SIZE DEPTH ", \"windows\": [[1, 0]], \"omitted\": [[1, 1]],"
                                               " \"diagonals\": true, \"margin_cells\": 2"),
                               &oa, NULL),
                     KG_OK);
    assert_int_equal(oa->width, 3);
    assert_int_equal(oa->depth_limit, 4);
    assert_int_equal(oa->height, 2);
    assert_near(oa->cell_mm, 2.5, 0);
    assert_int_equal(kg_oa_depth(oa, 1, 0), 3);
    assert_int_equal(kg_oa_depth(oa, 1, 1), 1);
    assert_true(kg_oa_window(oa, 1, 0) && !kg_oa_window(oa, 1, 1));
    assert_true(kg_oa_omitted(oa, 1, 1) && !kg_oa_omitted(oa, 1, 2));
    assert_true(oa->diagonals);
    assert_int_equal(oa->margin_cells, 2);
    kg_oa_destroy(oa);
}

static void broken_cards_are_refused_with_the_place(void **state) {
    (void)state;
    refused(CARD(SIZE "\"depth\": [[0, 0],\n[1, 3],\n[0, 0]]"),
            "card.katagami:4|column 1, level 1");
    refused(CARD(SIZE "\"depth\": [[0, 0],\n[5, 3],\n[0, 0]]"), ":4|column 1, level 0|0 and 4");
    refused(CARD(SIZE "\"depth\": [[0, 0],\n[-1, 0],\n[0, 0]]"), ":4|column 1, level 0");
    refused(CARD(SIZE "\"depth\": [[0, 0],\n[1.5, 0],\n[0, 0]]"), ":4|whole");
    refused(CARD(SIZE "\"depth\": [[0, 0],\n[1],\n[0, 0]]"), ":4|column 1|2 depths");
    refused(CARD(SIZE "\"depth\": [[0, 0]]"), ":3|3 columns");
    refused(CARD(SIZE), ":3");
    refused(CARD("\"size\": [0, 4, 2], \"cell_mm\": 1"), ":2|width");
    refused(CARD("\"size\": [3, -4, 2], \"cell_mm\": 1"), ":2|depth");
    refused(CARD("\"size\": [3, 4, 1e9], \"cell_mm\": 1"), ":2|height");
    refused(CARD("\"size\": [3, 4, 1e300], \"cell_mm\": 1"), ":2|height");
    refused(CARD("\"size\": [3, 4], \"cell_mm\": 1"), ":2|size");
    refused(CARD("\"size\": [3, 4, 2], \"cell_mm\": 0, " DEPTH), ":2|cell_mm");
    refused(CARD("\"size\": [3, 4, 2], \"cell_mm\": 1e9, " DEPTH), ":2|cell_mm");
    refused(CARD("\"size\": [3, 4, 2], " DEPTH), "cell_mm");
    refused(CARD(SIZE DEPTH ",\n\"windows\": [[1, 0],\n[1, 2]]"), ":7|0 to 1");
    refused(CARD(SIZE DEPTH ",\n\"windows\": [[3, 0]]"), ":6|0 to 2");
    refused(CARD(SIZE DEPTH ",\n\"windows\": [[0, 0]]"), ":6|column 0|level 0");
    refused(CARD(SIZE DEPTH ",\n\"windows\": [1]"), ":6|[x, z]");
    refused(CARD(SIZE DEPTH ",\n\"omitted\": [[1, 0]]"), ":6|column 1|height 0");
    refused(CARD(SIZE DEPTH ",\n\"omitted\": [[1, 3]]"), ":6|0 to 2");
    refused(CARD(SIZE DEPTH ",\n\"margin_cells\": 1.5"), ":6|whole");
    refused(CARD(SIZE DEPTH ",\n\"margin_cells\": 1e6"), ":6|margin_cells");
    refused(CARD(SIZE DEPTH ",\n\"diagonals\": 1"), ":6|diagonals");
    refused(CARD(SIZE DEPTH ",\n\"tiny_mm\": -1"), ":6|tiny_mm");
    refused(CARD(SIZE DEPTH ",\n\"tiny_mm\": \"2\""), ":6|tiny_mm");
    refused("{\"katagami\": 2,\n\"kind\": \"oa\"}", "newer");
    refused("{\"katagami\": 1,\n\"kind\": \"oa\"}", "oa");
    refused("[1]", "katagami");
    refused("{", ":1");
    refused("", "card.katagami");
}

static void unknown_keys_survive(void **state) {
    (void)state;
    kg_oa *oa, *again;
    char *text;
    size_t size;
    const char *input = "{\"katagami\": 1, \"kind\": \"oa\", \"title\": \"t\", \"later\": [1, {}],"
                        "\"net\": {\"paper\": \"A3\", \"colour\": 3},"
                        "\"oa\": {\"wind\": \"north\", " SIZE DEPTH "}}";
    assert_int_equal(read_text(input, &oa, NULL), KG_OK);
    assert_true(kg_oa_add(oa, 2, 1, 0));
    assert_true(kg_oa_set_window(oa, 1, 0, true));
    assert_int_equal(kg_oa_write_memory(oa, &text, &size, NULL), KG_OK);
    json_t *root = json_loads(text, 0, NULL);
    json_t *card = json_object_get(root, "oa");
    assert_int_equal(json_array_size(json_object_get(root, "later")), 2);
    assert_string_equal(json_string_value(json_object_get(card, "wind")), "north");
    assert_int_equal(json_integer_value(json_object_get(json_object_get(root, "net"), "colour")),
                     3);
    json_decref(root);
    assert_int_equal(read_text(text, &again, NULL), KG_OK);
    assert_int_equal(kg_oa_depth(again, 2, 0), 2);
    assert_true(kg_oa_window(again, 1, 0));
    assert_string_equal(again->net.paper, "A3");
    assert_string_equal(again->title, "t");
    free(text);
    kg_oa_destroy(oa);
    kg_oa_destroy(again);
}

static void written_cards_read_back_the_same(void **state) {
    (void)state;
    kg_random r = {41};
    for (int i = 0; i < 200; i++) {
        kg_oa *oa = random_card(&r, 0.2, 0.2, false), *again;
        char *text, *text2;
        size_t size, cells = (size_t)oa->width * (size_t)oa->height;
        oa->margin_cells = i % 3;
        oa->diagonals = i % 2;
        oa->cell_mm = 0.1 * (i + 1);
        oa->tiny_mm = 0.5 * (i % 7);
        assert_int_equal(kg_oa_write_memory(oa, &text, &size, NULL), KG_OK);
        assert_int_equal(read_text(text, &again, NULL), KG_OK);
        assert_memory_equal(oa->depth, again->depth, cells * sizeof *oa->depth);
        assert_memory_equal(oa->window, again->window, cells);
        assert_memory_equal(oa->omitted, again->omitted, cells + (size_t)oa->width);
        assert_true(oa->cell_mm == again->cell_mm && oa->tiny_mm == again->tiny_mm);
        assert_int_equal(!strstr(text, "tiny_mm"), oa->tiny_mm == KG_OA_TINY);
        assert_int_equal(kg_oa_write_memory(again, &text2, &size, NULL), KG_OK);
        assert_string_equal(text, text2);
        free(text);
        free(text2);
        kg_oa_destroy(oa);
        kg_oa_destroy(again);
    }
}

/* ---- editing ---------------------------------------------------------------------------- */

static void editing_keeps_the_staircase(void **state) {
    (void)state;
    kg_random r = {42};
    for (int i = 0; i < 300; i++) {
        kg_oa *oa = random_card(&r, 0.3, 0.3, false);
        for (int step = 0; step < 40; step++) {
            int x = whole(&r, -1, oa->width), y = whole(&r, -1, oa->depth_limit),
                z = whole(&r, -1, oa->height);
            bool in = x >= 0 && y >= 0 && z >= 0 && x < oa->width && y < oa->depth_limit &&
                      z < oa->height;
            bool filled = in && y < kg_oa_depth(oa, x, z);
            bool adds = chance(&r, 0.5);
            bool changed = adds ? kg_oa_add(oa, x, y, z) : kg_oa_remove(oa, x, y, z);
            assert_int_equal(changed, in && filled != adds);
            if (in)
                assert_int_equal(y < kg_oa_depth(oa, x, z), adds);
            assert_int_equal(kg_oa_check(oa, NULL), KG_OK);
        }
        kg_oa_destroy(oa);
    }
}

static void checks_name_the_column(void **state) {
    (void)state;
    kg_oa *oa;
    kg_error error;
    assert_int_equal(kg_oa_create(0, 1, 1, 1, &oa, &error), KG_ERR_INPUT);
    assert_non_null(strstr(error.message, "width"));
    assert_int_equal(kg_oa_create(1, 1, KG_OA_MAX_SIZE + 1, 1, &oa, &error), KG_ERR_INPUT);
    assert_int_equal(kg_oa_create(1, 1, 1, NAN, &oa, &error), KG_ERR_INPUT);
    assert_int_equal(kg_oa_create(4, 5, 6, 1, &oa, NULL), KG_OK);
    oa->depth[2 * 6 + 3] = 2;
    assert_int_equal(kg_oa_check(oa, &error), KG_ERR_INPUT);
    assert_non_null(strstr(error.message, "column 2, level 3"));
    kg_oa_destroy(oa);
}

/* ---- FOLD ------------------------------------------------------------------------------- */

static void fold_is_a_planar_graph_of_the_net(void **state) {
    (void)state;
    kg_random r = {43};
    for (int i = 0; i < 50; i++) {
        kg_oa *oa = random_card(&r, 0.2, 0, true);
        oa->diagonals = i % 2;
        kg_oa_sheet *sheet;
        char *text;
        assert_int_equal(kg_oa_sheet_create(oa, &sheet, NULL), KG_OK);
        assert_int_equal(kg_oa_fold(oa, sheet, &text, NULL), KG_OK);
        json_t *root = json_loads(text, 0, NULL);
        json_t *points = json_object_get(root, "vertices_coords"),
               *edges = json_object_get(root, "edges_vertices"),
               *letters = json_object_get(root, "edges_assignment");
        assert_int_equal(json_array_size(edges), json_array_size(letters));
        double length[2] = {0, 0};
        for (size_t e = 0; e < json_array_size(edges); e++) {
            double p[2][2];
            for (size_t k = 0; k < 2; k++) {
                json_t *v = json_array_get(points, (size_t)json_integer_value(json_array_get(
                                                       json_array_get(edges, e), k)));
                for (size_t c = 0; c < 2; c++)
                    p[k][c] = json_number_value(json_array_get(v, c));
            }
            double d = hypot(p[1][0] - p[0][0], p[1][1] - p[0][1]);
            char letter = json_string_value(json_array_get(letters, e))[0];
            assert_non_null(strchr("BCMV", letter));
            assert_true(d > 0);
            length[letter == 'B'] += d;
            for (size_t v = 0; v < json_array_size(points); v++) { /* none in an edge's inside */
                double x =
                    json_number_value(json_array_get(json_array_get(points, v), 0)) - p[0][0];
                double y =
                    json_number_value(json_array_get(json_array_get(points, v), 1)) - p[0][1];
                double ux = (p[1][0] - p[0][0]) / d, uy = (p[1][1] - p[0][1]) / d;
                double along = x * ux + y * uy, off = fabs(x * uy - y * ux);
                assert_false(off < 1e-9 && along > 1e-9 && along < d - 1e-9);
            }
        }
        kg_oa_line *lines;
        size_t count;
        assert_int_equal(kg_oa_lines(sheet, &lines, &count, NULL), KG_OK);
        for (size_t k = 0; k < count; k++)
            length[0] -= hypot(lines[k].x1 - lines[k].x0, lines[k].row1 - lines[k].row0);
        assert_near(length[0], 0, 1e-9);
        assert_near(length[1], 2 * (sheet->width + sheet->rows), 1e-9);
        free(lines);
        json_decref(root);
        free(text);
        kg_oa_sheet_destroy(sheet);
        kg_oa_destroy(oa);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(card_is_read),
        cmocka_unit_test(broken_cards_are_refused_with_the_place),
        cmocka_unit_test(unknown_keys_survive),
        cmocka_unit_test(written_cards_read_back_the_same),
        cmocka_unit_test(editing_keeps_the_staircase),
        cmocka_unit_test(checks_name_the_column),
        cmocka_unit_test(fold_is_a_planar_graph_of_the_net),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
