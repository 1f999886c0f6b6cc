/* Patch models from and to files: what is kept, what is refused and where the message points. */
#include "base/file.h"
#include "katagami/model.h"
#include "model/edit.h"
#include "tests/check.h"

#include <jansson.h>
#include <stdlib.h>
#include <unistd.h>

/* Everything the format knows, with an unknown key at every level. */
static const char FULL[] =
    "{\n"
    "  \"katagami\": 1,\n"
    "  \"kind\": \"patches\",\n"
    "  \"title\": \"いるか 海豚\",\n"
    "  \"x-root\": {\"a\": [1, 2.5, null, true, \"\\u3042\"]},\n"
    "  \"reference\": {\"file\": \"dolphin.obj\", \"size_mm\": 250, \"visible\": false,\n"
    "    \"opacity\": 0.25, \"up\": \"y\", \"x-reference\": 1,\n"
    "    \"matrix\": [[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]},\n"
    "  \"net\": {\"paper\": \"A3\", \"margin\": 9, \"scale\": 2, \"tab_width\": 4.5,\n"
    "    \"joins\": [{\"patches\": [3, 1], \"tab\": \"other\", \"width\": 3, \"shape\": "
    "\"teeth\",\n"
    "      \"merge\": true, \"x-join\": 0}, {\"patches\": [2, 1], \"at\": [-4.25, 0.5], \"tab\":\n"
    "      \"none\"}, {\"patches\": [1, 2]}], \"x-net\": []},\n"
    "  \"history\": [{\"undo\": 1}],\n"
    "  \"patches\": [\n"
    "    {\"id\": 1, \"name\": \"背中\", \"points\": [[0,0,0],[40,5,20],[80,-10,20],[120,0,0.1]],\n"
    "     \"extent\": [-30, 30], \"flip\": true, \"hidden\": true, \"construction\": true,\n"
    "     \"x-patch\": {\"deep\": {\"deeper\": 3}},\n"
    "     \"trims\": [{\"by\": [2], \"keep\": [[60,0,30]], \"bounded\": true, \"x-trim\": 7},\n"
    "               {\"by\": [2, 3], \"inside\": true, \"trim_cutters\": true, \"off\": true},\n"
    "               {\"contour\": [[-5,0.2],[5,0.2],[0,0.4]], \"keep\": \"outside\"}]},\n"
    "    {\"id\": 2, \"points\": [[0,0,0],[1,0,0],[2,0,0],[3,0,0]], \"extent\": [-1, 1],\n"
    "     \"ruling\": [0, 0.5, 1]},\n"
    "    {\"id\": 3, \"points\": [[0,0,0],[1,0,0],[2,1,0],[3,0,0],[4,0,0],[5,1,0]],\n"
    "     \"extent\": [-1e-3, 1]}\n"
    "  ]\n"
    "}\n";

static kg_model *read_text(const char *text) {
    kg_model *m = NULL;
    kg_error error;
    if (kg_model_read_memory(text, strlen(text), "m.katagami", &m, &error))
        fail_msg("%s", error.message);
    return m;
}

static char *write_text(const kg_model *m) {
    char *text = NULL;
    size_t size;
    kg_error error;
    if (kg_model_write_memory(m, &text, &size, &error))
        fail_msg("%s", error.message);
    assert_int_equal(strlen(text), size);
    return text;
}

static void every_member_is_read(void **state) {
    (void)state;
    kg_model *m = read_text(FULL);
    assert_string_equal(m->title, "いるか 海豚");
    assert_string_equal(m->reference.file, "dolphin.obj");
    assert_near(m->reference.size_mm, 250, 0);
    assert_near(m->reference.opacity, 0.25, 0);
    assert_false(m->reference.visible);
    assert_true(m->reference.up_y);
    assert_true(m->reference.has_matrix);
    assert_near(m->reference.matrix[5], 1, 0);
    assert_string_equal(m->net.paper, "A3");
    assert_near(m->net.margin, 9, 0);
    assert_near(m->net.scale, 2, 0);
    assert_near(m->net.tab_width, 4.5, 0);
    assert_int_equal(m->join_count, 3);
    const kg_model_join *join = kg_model_find_join(m, 1, 3);
    assert_ptr_equal(join, &m->joins[0]);
    assert_int_equal(join->tab, KG_TAB_OTHER);
    assert_int_equal(join->shape, KG_TAB_TEETH);
    assert_near(join->width, 3, 0);
    assert_true(join->merge);
    assert_int_equal(kg_model_find_join(m, 2, 1)->tab, KG_TAB_AUTO);
    const int64_t pair[2] = {2, 1}, other[2] = {1, 2};
    assert_ptr_equal(kg_model_find_join_at(m, pair, kg_v2(-4.25, 0.5)), &m->joins[1]);
    assert_null(kg_model_find_join_at(m, pair, kg_v2(-4.25, 0.25)));
    assert_null(kg_model_find_join_at(m, other, kg_v2(-4.25, 0.5)));
    assert_true(!m->joins[0].has_at && !m->joins[2].has_at);
    assert_null(kg_model_find_join(m, 2, 3));
    assert_int_equal(m->patch_count, 3);
    const kg_model_patch *p = &m->patches[0];
    assert_string_equal(p->name, "背中");
    assert_true(p->input.flip && p->hidden && p->construction);
    assert_int_equal(p->input.point_count, 4);
    assert_near(p->input.points[2].y, -10, 0);
    assert_near(p->input.extent[0], -30, 0);
    assert_int_equal(p->trim_count, 3);
    assert_int_equal(p->trims[0].kind, KG_TRIM_BY);
    assert_true(p->trims[0].bounded);
    assert_int_equal(p->trims[0].by[0], 2);
    assert_near(p->trims[0].keep[0].z, 30, 0);
    assert_int_equal(p->trims[1].kind, KG_TRIM_INSIDE);
    assert_int_equal(p->trims[1].by_count, 2);
    assert_true(p->trims[1].trim_cutters && p->trims[1].off);
    assert_int_equal(p->trims[2].kind, KG_TRIM_CONTOUR);
    assert_true(p->trims[2].outside);
    assert_near(p->trims[2].contour[2].y, 0.4, 0);
    assert_true(m->patches[1].input.has_ruling);
    assert_near(m->patches[1].input.ruling.y, 0.5, 0);
    assert_int_equal(m->patches[2].input.point_count, 6);
    kg_model_destroy(m);
}

static void only_the_required_is_required(void **state) {
    (void)state;
    kg_model *m = read_text("{\"katagami\": 1, \"kind\": \"patches\"}");
    assert_int_equal(m->patch_count, 0);
    assert_null(m->reference.file);
    assert_near(m->net.margin, 8, 0);
    kg_model_destroy(m);
}

static void a_byte_order_mark_is_no_error(void **state) {
    (void)state;
    kg_model_destroy(read_text("\xef\xbb\xbf{\"katagami\": 1, \"kind\": \"patches\"}"));
}

/* Is everything in `a` also in `b`? Numbers compare by value. */
static void assert_contains(const json_t *a, const json_t *b, const char *where) {
    const char *key;
    json_t *member;
    if (!b)
        fail_msg("%s is lost", where);
    if (json_is_object(a)) {
        json_object_foreach((json_t *)(uintptr_t)a, key, member)
            assert_contains(member, json_object_get(b, key), key);
    } else if (json_is_array(a)) {
        assert_int_equal(json_array_size(a), json_array_size(b));
        for (size_t i = 0; i < json_array_size(a); i++)
            assert_contains(json_array_get(a, i), json_array_get(b, i), where);
    } else if (json_is_number(a)) {
        assert_near(json_number_value(a), json_number_value(b), 0);
    } else {
        assert_true(json_equal(a, b));
    }
}

static void unknown_keys_survive_at_every_level(void **state) {
    (void)state;
    kg_model *m = read_text(FULL), *copy = kg_model_copy(m);
    assert_non_null(copy);
    kg_model_destroy(m);
    char *text = write_text(copy);
    json_t *before = json_loads(FULL, 0, NULL), *after = json_loads(text, 0, NULL);
    assert_non_null(after);
    assert_contains(before, after, "the file");
    assert_contains(after, before, "the file");
    json_decref(before);
    json_decref(after);
    free(text);
    kg_model_destroy(copy);
}

static void a_reference_without_a_file_keeps_its_keys(void **state) {
    (void)state;
    kg_model *m = read_text("{\"katagami\": 1, \"kind\": \"patches\", \"reference\": {\"x\": 5}}");
    char *text = write_text(m);
    assert_non_null(strstr(text, "\"x\": 5"));
    free(text);
    kg_model_destroy(m);
}

static void writing_twice_gives_the_same_bytes(void **state) {
    (void)state;
    kg_model *m = read_text(FULL);
    char *once = write_text(m);
    kg_model_destroy(m);
    m = read_text(once);
    char *twice = write_text(m);
    assert_string_equal(once, twice);
    free(once);
    free(twice);
    kg_model_destroy(m);
}

static void numbers_come_back_to_the_last_bit(void **state) {
    (void)state;
    kg_random r = {1};
    for (int round = 0; round < 300; round++) {
        kg_model *m = read_text(FULL);
        kg_patch_input *in = &m->patches[0].input;
        for (size_t i = 0; i < in->point_count; i++) {
            double scale = pow(10, kg_random_in(&r, -12, 5));
            in->points[i] = kg_v3(scale * kg_random_in(&r, -1, 1), floor(kg_random_in(&r, -9, 9)),
                                  kg_random_in(&r, -9, 9));
        }
        char *text = write_text(m);
        kg_model *back = read_text(text);
        assert_memory_equal(in->points, back->patches[0].input.points,
                            in->point_count * sizeof in->points[0]);
        free(text);
        kg_model_destroy(m);
        kg_model_destroy(back);
    }
}

static void a_trim_that_changes_its_kind_reads_back(void **state) {
    (void)state;
    kg_model *m = read_text(FULL);
    kg_trim_op *op = &m->patches[0].trims[0];
    op->kind = KG_TRIM_CONTOUR;
    op->contour = calloc(3, sizeof *op->contour);
    assert_non_null(op->contour);
    op->contour_count = 3;
    char *text = write_text(m);
    kg_model *back = read_text(text);
    assert_int_equal(back->patches[0].trims[0].kind, KG_TRIM_CONTOUR);
    free(text);
    kg_model_destroy(m);
    kg_model_destroy(back);
}

/* ---- refusals --------------------------------------------------------------------------- */

#define HEAD "{\"katagami\": 1, \"kind\": \"patches\",\n"
#define POINTS "\"points\": [[0,0,0],[1,0,0],[2,1,0],[3,0,0]], "
#define EXTENT "\"extent\": [-1,1]"
#define OTHER "{\"id\": 2, " POINTS EXTENT "},\n"
#define PATCH(members) HEAD "\"patches\": [\n" OTHER "{\"id\": 7,\n" members "}]}"
#define TRIM(members) PATCH(POINTS EXTENT ",\n\"trims\": [\n{" members "}]")

/* Texts that are refused, and what the message must hold. */
static const struct refusal {
    const char *text, *place, *says;
} refusals[] = {
    {"", "m:1:", ""},
    {"[1, 2]", "m:1:", "no katagami model"},
    {"{", "m:1:", ""},
    {"{\"katagami\": 1}", "m:1:", "kind"},
    {"{\"kind\": \"patches\"}", "m:1:", "no katagami model"},
    {"{\"kind\": \"patches\",\n\"katagami\": 2}", "m:2:", "newer"},
    {"{\"kind\": \"patches\",\n\"katagami\": 0}", "m:2:", "format 0"},
    {"{\"kind\": \"patches\",\n\"katagami\": \"1\"}", "m:1:", "no katagami model"},
    {"{\"katagami\": 1,\n\"kind\": \"boxes\"}", "m:2:", "boxes"},
    {"{\"katagami\": 1,\n\"kind\": \"patches\", \"kind\": \"patches\"}", "m:2:", "duplicate"},
    {HEAD "\"title\": 5}", "m:2:", "title"},
    {HEAD "\"title\": \"\xff\"}", "m:2:", "UTF-8"},
    {HEAD "\"patches\": {}}", "m:2:", "patches"},
    {HEAD "\"patches\": [\n5]}", "m:3:", "patch"},
    {HEAD "\"patches\": [\n{}]}", "m:3:", "id"},
    {HEAD "\"patches\": [\n{\"id\": 1.5}]}", "m:3:", "whole number"},
    {HEAD "\"patches\": [\n{\"id\": 0}]}", "m:3:", "start at 1"},
    {HEAD "\"patches\": [\n{\"id\": 7}]}", "m:3:", "patch 7: a patch needs \"points\""},
    {PATCH("\"points\":\n 5, " EXTENT), "m:6:", "patch 7"},
    {PATCH("\"points\": [[0,0,0],[1,0,0],[2,0,0]], " EXTENT), "m:5:", "4 or 6"},
    {PATCH("\"points\": [[0,0,0],[1,0,0],[2,0,0],[3,0,0],[4,0,0]], " EXTENT), "m:5:", "not 5"},
    {PATCH("\"points\": [[0,0,0],[1,0,0],\n[2,0],[3,0,0]], " EXTENT), "m:6:", "patch 7: 3 numbers"},
    {PATCH("\"points\": [[0,0,0],[1,0,0],\n[2,0,\"x\"],[3,0,0]], " EXTENT), "m:6:", "a number"},
    {PATCH("\"points\": [[0,0,0],[1,0,0],[2,0,0],\n[3,0,1.1e6]], " EXTENT), "m:6:", "beyond 1e+06"},
    {PATCH("\"points\": [[0,0,0],[1,0,0],[2,0,0],\n[3,0,1e999]], " EXTENT), "m:6:", "overflow"},
    {PATCH("\"points\": [[0,0,0],[1,0,0],[2,0,0],\n[3,0,NaN]], " EXTENT), "m:6:", ""},
    {PATCH(POINTS "\"name\": \"no extent\""), "m:4:", "patch 7: a patch needs \"extent\""},
    {PATCH(POINTS "\n\"extent\": [1,-1]"), "m:6:", "must grow"},
    {PATCH(POINTS "\n\"extent\": [1,1]"), "m:6:", "must grow"},
    {PATCH(POINTS "\n\"extent\": [1]"), "m:6:", "2 numbers"},
    {PATCH(POINTS "\n\"extent\": [-2e6, 1]"), "m:6:", "beyond"},
    {PATCH(POINTS EXTENT ",\n\"flip\": 1"), "m:6:", "\"flip\" is true or false"},
    {PATCH(POINTS EXTENT ",\n\"name\": 1"), "m:6:", "\"name\" is a text"},
    {PATCH(POINTS EXTENT ",\n\"ruling\": [1]"), "m:6:", "3 numbers"},
    {PATCH(POINTS EXTENT ",\n\"trims\": 3"), "m:6:", "list"},
    {PATCH(POINTS EXTENT ",\n\"trims\": [\n3]"), "m:7:", "patch 7: a trim"},
    {HEAD "\"patches\": [\n" OTHER "{\"id\": 2, " POINTS EXTENT "}]}", "m:4:", "two patches"},
    {TRIM(""), "m:7:", "patch 7: a trim has \"by\""},
    {TRIM("\"by\": [2], \"contour\": [[0,0],[1,0],[0,1]]"), "m:7:", "not both"},
    {TRIM("\"by\": []"), "m:7:", "list of patch ids"},
    {TRIM("\"by\": [\n7]"), "m:8:", "patch 7: a patch cannot cut itself"},
    {TRIM("\"by\": [\n99]"), "m:8:", "patch 7: there is no patch 99"},
    {TRIM("\"by\": [2,\n2], \"inside\": true"), "m:8:", "patch 7: patch 2 is named twice"},
    {TRIM("\"by\": [2.5]"), "m:7:", "whole number"},
    {TRIM("\"by\": [2], \"keep\":\n 1"), "m:8:", "list of points"},
    {TRIM("\"by\": [2], \"keep\": [\n[1,2]]"), "m:8:", "3 numbers"},
    {TRIM("\"contour\": 1"), "m:7:", "list of points"},
    {TRIM("\"contour\": [[0,0],[1,0],[0,1]],\n\"keep\": \"both\""), "m:8:", "\"outside\""},
    {HEAD "\"reference\": []}", "m:2:", "reference"},
    {HEAD "\"reference\": {\n\"size_mm\": -1}}", "m:2:", "size_mm"},
    {HEAD "\"reference\": {\n\"size_mm\": 0}}", "m:2:", "size_mm"},
    {HEAD "\"reference\": {\n\"opacity\": 2}}", "m:2:", "opacity"},
    {HEAD "\"reference\": {\n\"up\": \"x\"}}", "m:3:", "up"},
    {HEAD "\"reference\": {\n\"matrix\": [[1,2],[3,4]]}}", "m:3:", "4 rows"},
    {HEAD "\"net\": {\n\"scale\": 0}}", "m:2:", "scale"},
    {HEAD "\"net\": {\"joins\":\n 1}}", "m:3:", "list"},
    {HEAD "\"net\": {\"joins\": [\n1]}}", "m:3:", "patches"},
    {HEAD "\"net\": {\"joins\": [\n{\"patches\": [1]}]}}", "m:3:", "patches"},
    {HEAD "\"net\": {\"joins\": [{\"patches\": [1, 2],\n\"tab\": 1}]}}",
     "m:3:", "\"none\", \"this\""},
    {HEAD "\"net\": {\"joins\": [{\"patches\": [1, 2],\n\"width\": 0}]}}", "m:2:", "above 0"},
    {HEAD "\"net\": {\"joins\": [{\"patches\": [1, 2],\n\"at\": [1]}]}}", "m:3:", "2 numbers"},
    {HEAD "\"net\": {\"joins\": [{\"patches\": [1, 2],\n\"at\": [1, 1e9]}]}}", "m:3:", "1e+06"},
    {HEAD "\"net\": {\n\"margin\": \"8\"}}", "m:3:", "number"},
};

static void refusals_name_the_line_and_the_patch(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof refusals / sizeof *refusals; i++) {
        const struct refusal *r = &refusals[i];
        kg_model *m = NULL;
        kg_error error;
        kg_status status = kg_model_read_memory(r->text, strlen(r->text), "m", &m, &error);
        if (status != KG_ERR_PARSE)
            fail_msg("status %d for\n%s", status, r->text);
        assert_null(m);
        if (strncmp(error.message, r->place, strlen(r->place)) || !strstr(error.message, r->says))
            fail_msg("\"%s\" is not at %s with \"%s\":\n%s", error.message, r->place, r->says,
                     r->text);
    }
}

static void several_cutters_need_inside(void **state) {
    (void)state;
    const char *text = HEAD "\"patches\": [\n" OTHER "{\"id\": 3, " POINTS EXTENT "},\n"
                            "{\"id\": 7, " POINTS EXTENT ",\n\"trims\": [{\"by\": [2, 3]}]}]}";
    kg_model *m = NULL;
    kg_error error;
    assert_int_equal(kg_model_read_memory(text, strlen(text), "m", &m, &error), KG_ERR_PARSE);
    assert_non_null(strstr(error.message, "m:6: patch 7: several cutters need \"inside\""));
}

static void a_file_cut_off_anywhere_is_refused(void **state) {
    (void)state;
    size_t whole = strlen(FULL) - 1; /* all but the last line break */
    for (size_t size = 0; size < whole; size++) {
        kg_model *m = NULL;
        char *part = malloc(size + 1); /* exactly as long, for the sanitizers */
        assert_non_null(part);
        memcpy(part, FULL, size);
        assert_int_equal(kg_model_read_memory(part, size, "m", &m, NULL), KG_ERR_PARSE);
        free(part);
    }
}

static void deep_nesting_is_refused(void **state) {
    (void)state;
    enum { DEPTH = 200000 };
    char *text = malloc(DEPTH + 1);
    assert_non_null(text);
    memset(text, '[', DEPTH);
    text[DEPTH] = '\0';
    kg_model *m = NULL;
    kg_error error;
    assert_int_equal(kg_model_read_memory(text, DEPTH, "m", &m, &error), KG_ERR_PARSE);
    free(text);
}

/* Every patch is trimmed by the one after it; lookups that walk the list would take minutes. */
static void ten_thousand_patches_are_read_at_once(void **state) {
    (void)state;
    enum { COUNT = 10000, ROOM = 160 };
    char *text = malloc(COUNT * ROOM + 100);
    assert_non_null(text);
    size_t n = (size_t)sprintf(text, "%s\"patches\": [", HEAD);
    for (int i = 0; i < COUNT; i++)
        n += (size_t)sprintf(text + n, "%s{\"id\": %d, %s%s, \"trims\": [{\"by\": [%d]}]}",
                             i ? ",\n" : "", i + 1, POINTS, EXTENT, (i + 1) % COUNT + 1);
    sprintf(text + n, "]}");
    kg_model *m = read_text(text);
    assert_int_equal(m->patch_count, COUNT);
    kg_model_destroy(m);
    free(text);
}

/* ---- files ------------------------------------------------------------------------------ */

static void files_are_written_whole_or_not_at_all(void **state) {
    (void)state;
    char folder[] = "/tmp/katagami-XXXXXX", path[64], missing[64];
    assert_non_null(mkdtemp(folder));
    snprintf(path, sizeof path, "%s/a.katagami", folder);
    snprintf(missing, sizeof missing, "%s/none/a.katagami", folder);
    kg_model *m = read_text(FULL), *back = NULL;
    kg_error error;
    assert_int_equal(kg_model_write(m, path, &error), KG_OK);
    assert_int_equal(kg_model_read(path, &back, &error), KG_OK);
    kg_model_destroy(back);
    assert_int_equal(kg_model_write(m, missing, &error), KG_ERR_IO);
    assert_non_null(strstr(error.message, missing));
    assert_int_equal(kg_model_read(missing, &back, &error), KG_ERR_IO);
    assert_non_null(strstr(error.message, missing));

    /* a name that is not UTF-8 cannot be written: the old file stays, nothing new appears */
    free(m->title);
    m->title = strdup("\xff");
    assert_int_not_equal(kg_model_write(m, path, &error), KG_OK);
    assert_int_equal(kg_model_read(path, &back, &error), KG_OK);
    assert_string_equal(back->title, "いるか 海豚");
    kg_model_destroy(back);
    kg_model_destroy(m);
    assert_int_equal(unlink(path), 0);
    assert_int_equal(rmdir(folder), 0); /* empty: no temporary file is left */
}

static void a_copy_gets_an_id_of_its_own_after_the_last_there_is(void **state) {
    (void)state;
    kg_model *m = read_text(HEAD "\"patches\": [\n{\"id\": 9223372036854775807, " POINTS EXTENT
                                 "},\n{\"id\": 9223372036854775806, " POINTS EXTENT "}]}");
    int64_t id;
    kg_error error;
    assert_int_equal(kg_model_duplicate_patch(m, INT64_MAX, &id, &error), KG_OK);
    assert_int_equal(id, 1);
    assert_int_equal(kg_model_duplicate_patch(m, INT64_MAX, &id, &error), KG_OK);
    assert_int_equal(id, 2);
    kg_model_destroy(m);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_member_is_read),
        cmocka_unit_test(only_the_required_is_required),
        cmocka_unit_test(a_byte_order_mark_is_no_error),
        cmocka_unit_test(unknown_keys_survive_at_every_level),
        cmocka_unit_test(a_reference_without_a_file_keeps_its_keys),
        cmocka_unit_test(writing_twice_gives_the_same_bytes),
        cmocka_unit_test(numbers_come_back_to_the_last_bit),
        cmocka_unit_test(a_trim_that_changes_its_kind_reads_back),
        cmocka_unit_test(refusals_name_the_line_and_the_patch),
        cmocka_unit_test(several_cutters_need_inside),
        cmocka_unit_test(a_file_cut_off_anywhere_is_refused),
        cmocka_unit_test(deep_nesting_is_refused),
        cmocka_unit_test(ten_thousand_patches_are_read_at_once),
        cmocka_unit_test(files_are_written_whole_or_not_at_all),
        cmocka_unit_test(a_copy_gets_an_id_of_its_own_after_the_last_there_is),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
