#include "tests/net/leaks.h"
#include "tests/net/sample.h"

#include "base/file.h"

static char *net_bytes(const kg_net *net, const kg_net_options *options, const char *name,
                       size_t *out_size) {
    char *data;
    kg_error error;
    if (kg_net_write(net, options, NULL, sample_path(name), NULL, &error))
        fail_msg("%s", error.message);
    assert_int_equal(kg_file_read(sample_path(name), &data, out_size, NULL), KG_OK);
    return data;
}

/* What a program prints, or NULL when the machine lacks it. */
static bool output_of(const char *program, const char *path, char *out, size_t size) {
    char command[512];
    snprintf(command, sizeof command, "%s '%s' 2>/dev/null", program, path);
    FILE *f = popen(command, "r");
    size_t n = f ? fread(out, 1, size - 1, f) : 0;
    out[n] = '\0';
    return f && pclose(f) == 0 && n > 0;
}

static void all_pages_have_the_exact_size(void **state) {
    (void)state;
    kg_net *net = sample_net(14);
    kg_net_options options = kg_net_options_default();
    options.paper = kg_v2(180, 140);
    size_t size;
    free(net_bytes(net, &options, "a.pdf", &size));
    char text[8192];
    if (!output_of("pdfinfo", sample_path("a.pdf"), text, sizeof text)) {
        kg_net_destroy(net);
        skip();
    }
    const char *pages = strstr(text, "Pages:"), *page = strstr(text, "Page size:");
    assert_non_null(pages);
    assert_non_null(page);
    assert_int_equal(atoi(pages + 6), 3);
    double width, height;
    assert_int_equal(sscanf(page + 10, " %lf x %lf", &width, &height), 2);
    assert_near(width, 180 * 72 / 25.4, 0.01);
    assert_near(height, 140 * 72 / 25.4, 0.01);
    assert_null(strstr(text, "CreationDate"));
    assert_non_null(strstr(text, "sample & <test>"));
    kg_net_destroy(net);
}

static void text_can_be_read_back(void **state) {
    (void)state;
    kg_net *net = sample_net(0);
    kg_net_options options = kg_net_options_default();
    size_t size;
    free(net_bytes(net, &options, "b.pdf", &size));
    char text[8192], command[300];
    snprintf(command, sizeof command, "%s' '-", sample_path("b.pdf"));
    bool there = output_of("pdftotext", command, text, sizeof text);
    kg_net_destroy(net);
    if (!there)
        skip();
    assert_non_null(strstr(text, "胴体 body"));
    assert_non_null(strstr(text, "背びれ"));
    assert_non_null(strstr(text, "50 mm"));
}

static void the_same_net_gives_the_same_bytes(void **state) {
    (void)state;
    kg_net *net = sample_net(2);
    kg_net_options options = kg_net_options_default();
    size_t sizes[2];
    char *a = net_bytes(net, &options, "c.pdf", &sizes[0]);
    char *b = net_bytes(net, &options, "d.pdf", &sizes[1]);
    assert_int_equal(sizes[0], sizes[1]);
    assert_memory_equal(a, b, sizes[0]);
    free(a);
    free(b);
    kg_net_destroy(net);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(all_pages_have_the_exact_size),
        cmocka_unit_test(text_can_be_read_back),
        cmocka_unit_test(the_same_net_gives_the_same_bytes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
