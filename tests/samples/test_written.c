#include "base/file.h"
#include "samples/samples.h"
#include "tests/check.h"

#include <ctype.h>
#include <stdlib.h>

/* Compilers may round the last step of a fit differently. */
#define WRITTEN_TOLERANCE 2e-3 /* mm, or v */

static bool starts_number(const char *p) {
    return isdigit((unsigned char)*p) || (*p == '-' && isdigit((unsigned char)p[1]));
}

/* The same text, numbers within the tolerance; decimals have no fixed count. */
static void assert_same_text(const char *name, const char *a, const char *b) {
    const char *a0 = a;
    while (*a && *b) {
        if (starts_number(a) && starts_number(b)) {
            char *a_end, *b_end;
            double x = strtod(a, &a_end), y = strtod(b, &b_end);
            if (!(fabs(x - y) <= WRITTEN_TOLERANCE))
                print_error("%s, byte %zu: %g is now %g; run make-samples\n", name,
                            (size_t)(a - a0), x, y);
            assert_near(x, y, WRITTEN_TOLERANCE);
            a = a_end, b = b_end;
            continue;
        }
        if (*a != *b)
            print_error("%s, byte %zu: differs; run make-samples\n", name, (size_t)(a - a0));
        assert_int_equal(*a++, *b++);
    }
    assert_int_equal(*a, *b);
}

static void committed_samples_are_what_the_program_writes(void **state) {
    (void)state;
    for (size_t i = 0; i < SAMPLE_FILE_COUNT; i++) {
        text made = {0};
        kg_error error;
        if (sample_files[i].write(&made, &error) != KG_OK)
            fail_msg("%s: %s", sample_files[i].name, error.message);
        text_add(&made, "%c", '\0');
        assert_false(made.failed);
        char path[1024], *committed;
        size_t size;
        snprintf(path, sizeof path, KG_SAMPLES "/%s", sample_files[i].name);
        assert_int_equal(kg_file_read(path, &committed, &size, NULL), KG_OK);
        assert_same_text(sample_files[i].name, committed, made.items);
        free(committed);
        text_clear(&made);
    }
}

static void written_numbers_have_no_negative_zero_and_no_tail(void **state) {
    (void)state;
    const double values[] = {0, -0.0, -0.00004, 1.5, -0.25, 0.00005, 12, -3.10004, 99999.99996};
    text t = {0};
    for (size_t i = 0; i < sizeof values / sizeof *values; i++) {
        text_number(&t, values[i], 4);
        text_add(&t, " ");
    }
    text_add(&t, "%c", '\0');
    assert_string_equal(t.items, "0 0 0 1.5 -0.25 0.0001 12 -3.1 100000 ");
    text_clear(&t);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(committed_samples_are_what_the_program_writes),
        cmocka_unit_test(written_numbers_have_no_negative_zero_and_no_tail),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
