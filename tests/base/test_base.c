#include "base/array.h"
#include "base/color.h"
#include "base/file.h"
#include "base/phrase.h"
#include "katagami/base.h"
#include "tests/check.h"

#include <errno.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

static void fail_in_puts_the_place_in_front(void **state) {
    (void)state;
    kg_error e;
    assert_int_equal(kg_fail(&e, KG_ERR_INPUT, "bad %s", "v"), KG_ERR_INPUT);
    assert_int_equal(kg_fail_in(&e, e.status, "patch %d: ", 3), KG_ERR_INPUT);
    assert_string_equal(e.message, "patch 3: bad v");
}

static void over_long_messages_are_cut_not_overrun(void **state) {
    (void)state;
    kg_error e;
    char text[3 * KG_ERROR_SIZE];
    memset(text, 'x', sizeof text - 1);
    text[sizeof text - 1] = '\0';
    assert_int_equal(kg_fail(&e, KG_ERR_IO, "%s", text), KG_ERR_IO);
    assert_int_equal(strlen(e.message), KG_ERROR_SIZE - 1);
    assert_int_equal(kg_fail_in(&e, KG_ERR_IO, "%s", text), KG_ERR_IO);
    assert_int_equal(strlen(e.message), KG_ERROR_SIZE - 1);
}

/* Wherever it is cut, what is left is whole characters of one to four bytes. */
static void over_long_phrases_end_with_a_whole_character(void **state) {
    (void)state;
    const char *whole = "a\u00b7\u7d19\U0001f409z";
    const size_t ends[] = {0, 1, 3, 6, 10, 11};
    char text[16];
    for (size_t size = 1; size < sizeof text; size++) {
        memset(text, '?', sizeof text);
        kg_phrase_print(text, size, "%s", whole);
        size_t kept = 0;
        for (size_t i = 0; i < sizeof ends / sizeof *ends; i++)
            kept = ends[i] < size ? ends[i] : kept;
        assert_int_equal(strlen(text), kept);
        assert_memory_equal(text, whole, kept);
    }
    text[0] = '?';
    kg_phrase_print(text, 0, "%s", whole);
    assert_int_equal(text[0], '?');
}

static void without_a_catalogue_texts_stay_as_they_are(void **state) {
    (void)state;
    const char *text = "there is no patch %lld";
    assert_ptr_equal(kg_phrase(text), text);
    assert_string_equal(kg_phrase(""), "");
    assert_string_equal(kg_phrase_of_errno(ENOENT), strerror(ENOENT));
    assert_string_equal(kg_phrase_of_errno(EROFS), strerror(EROFS));
    assert_string_equal(kg_phrase_of_errno(EPERM), strerror(EPERM));
}

static void impossible_reserve_leaves_the_array(void **state) {
    (void)state;
    struct {
        double *items;
        size_t count, capacity;
    } a = {0};
    assert_true(kg_push(&a, 1.5));
    assert_false(kg_reserve(&a, SIZE_MAX / 2));
    assert_true(a.items[0] == 1.5);
    free(a.items);
}

static void writing_replaces_the_whole_file_or_nothing(void **state) {
    (void)state;
    char dir[] = "/tmp/kg-file-XXXXXX";
    assert_non_null(mkdtemp(dir));
    char path[64];
    snprintf(path, sizeof path, "%s/a.txt", dir);
    struct stat s;
    mode_t mask = umask(027);
    assert_int_equal(kg_file_write(path, "old", 3, NULL), KG_OK);
    umask(mask);
    assert_int_equal(stat(path, &s), 0);
    assert_int_equal(s.st_mode & 0777, 0640); /* what every other program would give it */
    assert_int_equal(chmod(path, 0600), 0);
    assert_int_equal(kg_file_write(path, "new text", 8, NULL), KG_OK);
    assert_int_equal(stat(path, &s), 0);
    assert_int_equal(s.st_mode & 0777, 0600);
    char *data;
    size_t size;
    assert_int_equal(kg_file_read(path, &data, &size, NULL), KG_OK);
    assert_int_equal(size, 8);
    assert_string_equal(data, "new text");
    free(data);
    unlink(path);
    rmdir(dir);
    kg_error e;
    assert_int_equal(kg_file_write(path, "x", 1, &e), KG_ERR_IO);
    assert_int_equal(kg_file_read(path, &data, &size, &e), KG_ERR_IO);
}

static void writing_through_a_link_leaves_the_link(void **state) {
    (void)state;
    char dir[] = "/tmp/kg-link-XXXXXX";
    assert_non_null(mkdtemp(dir));
    char path[64], link[64];
    snprintf(path, sizeof path, "%s/a.txt", dir);
    snprintf(link, sizeof link, "%s/b.txt", dir);
    assert_int_equal(kg_file_write(path, "old", 3, NULL), KG_OK);
    assert_int_equal(symlink("a.txt", link), 0);
    assert_int_equal(kg_file_write(link, "new", 3, NULL), KG_OK);
    struct stat s;
    assert_int_equal(lstat(link, &s), 0);
    assert_true(S_ISLNK(s.st_mode));
    char *data;
    size_t size;
    assert_int_equal(kg_file_read(path, &data, &size, NULL), KG_OK);
    assert_string_equal(data, "new");
    free(data);
    unlink(link);
    unlink(path);
    assert_int_equal(rmdir(dir), 0); /* nothing else is left */
}

static void endings_are_found_in_capitals_too(void **state) {
    (void)state;
    assert_true(kg_file_ends_in("a/CRANE.CP", ".cp"));
    assert_true(kg_file_ends_in("a.fold/crane.fold", ".fold"));
    assert_false(kg_file_ends_in("a.fold/crane", ".fold"));
    assert_false(kg_file_ends_in("p", ".cp"));
}

static void stems_lack_folder_and_last_ending(void **state) {
    (void)state;
    static const char *const cases[][2] = {
        {"models.d/cat", "cat"}, {"models/cat.low.obj", "cat.low"}, {"cat", "cat"}, {"a/", ""}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char *stem = kg_file_stem(cases[i][0]);
        assert_string_equal(stem, cases[i][1]);
        free(stem);
    }
}

static void colors_come_back_from_linear_light(void **state) {
    (void)state;
    for (int i = 0; i < 256; i++) {
        float srgb = (float)i / 255;
        assert_near(kg_srgb_of_linear(kg_linear_of_srgb(srgb)), srgb, 1e-6);
    }
    assert_near(kg_linear_of_srgb(0.5f), 0.21404114, 1e-7);
    assert_true(kg_srgb_of_linear(NAN) == 0 && kg_srgb_of_linear(2) == 1);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fail_in_puts_the_place_in_front),
        cmocka_unit_test(over_long_messages_are_cut_not_overrun),
        cmocka_unit_test(over_long_phrases_end_with_a_whole_character),
        cmocka_unit_test(without_a_catalogue_texts_stay_as_they_are),
        cmocka_unit_test(impossible_reserve_leaves_the_array),
        cmocka_unit_test(writing_replaces_the_whole_file_or_nothing),
        cmocka_unit_test(writing_through_a_link_leaves_the_link),
        cmocka_unit_test(endings_are_found_in_capitals_too),
        cmocka_unit_test(stems_lack_folder_and_last_ending),
        cmocka_unit_test(colors_come_back_from_linear_light),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
