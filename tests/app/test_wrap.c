/* Breaking text into lines. */
#include "app/ui/wrap.h"
#include "tests/check.h"

/* One for a byte of ASCII, two for other characters, as in a Japanese font. */
static double measure(const char *begin, const char *end) {
    double width = 0;
    for (const char *at = begin; at < end; at++)
        width += (unsigned char)*at < 0x80 ? 1 : ((unsigned char)*at & 0xC0) == 0xC0 ? 2 : 0;
    return width;
}

static void assert_wrapped(const char *text, double width, const char *wanted) {
    char out[256];
    kg_ui_wrap(text, width, measure, out, sizeof out);
    assert_string_equal(out, wanted);
}

static void lines_end_at_spaces(void **state) {
    (void)state;
    assert_wrapped("one two three", 8, "one two\nthree");
    assert_wrapped("one two three", 7, "one two\nthree");
    assert_wrapped("one two three", 6, "one\ntwo\nthree");
    assert_wrapped("one\ntwo three", 9, "one\ntwo three");
    assert_wrapped("", 5, "");
}

static void a_word_that_is_too_wide_stays_whole(void **state) {
    (void)state;
    assert_wrapped("incomprehensible as it is", 6, "incomprehensible\nas it\nis");
}

static void japanese_lines_are_full(void **state) {
    (void)state;
    assert_wrapped("紙が折り返します", 8, "紙が折り\n返します");
    assert_wrapped("パッチ 2 は交わらない", 12, "パッチ 2 は\n交わらない");
}

static void marks_begin_and_end_no_line(void **state) {
    (void)state;
    assert_wrapped("切れません。", 10, "切れませ\nん。");
    assert_wrapped("紙が（最初は）", 6, "紙が\n（最初\nは）");
}

static void numbers_stay_whole(void **state) {
    (void)state;
    assert_wrapped("角度が 0.12 です", 8, "角度が\n0.12 で\nす");
}

/* Nothing is lost, and only what cannot be broken is wider than the line. */
static void any_text_fits(void **state) {
    (void)state;
    static const char *const letters[] = {"a", "b", " ", "紙", "、", "（", "1", ".", "折", "ー"};
    kg_random random = {7};
    for (int n = 0; n < 2000; n++) {
        char text[200] = "", out[512], bare[200] = "";
        for (int i = 0; i < 40; i++)
            strcat(text, letters[kg_random_bits(&random) % 10]);
        double width = 1 + (double)(kg_random_bits(&random) % 30);
        kg_ui_wrap(text, width, measure, out, sizeof out);
        size_t m = 0, k = 0;
        for (const char *at = out; *at; at++)
            if (*at != '\n' && *at != ' ')
                bare[m++] = *at;
        for (const char *at = text; *at; at++)
            if (*at != ' ')
                assert_int_equal(*at, bare[k++]);
        assert_int_equal(k, m);
    }
}

static void what_has_no_room_is_cut_off(void **state) {
    (void)state;
    char out[8];
    kg_ui_wrap("紙が折り返します", 4, measure, out, sizeof out);
    assert_true(strlen(out) < sizeof out);
    assert_memory_equal(out, "紙が", 6);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lines_end_at_spaces),
        cmocka_unit_test(a_word_that_is_too_wide_stays_whole),
        cmocka_unit_test(japanese_lines_are_full),
        cmocka_unit_test(marks_begin_and_end_no_line),
        cmocka_unit_test(numbers_stay_whole),
        cmocka_unit_test(any_text_fits),
        cmocka_unit_test(what_has_no_room_is_cut_off),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
