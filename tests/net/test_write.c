#include "tests/net/leaks.h"
#include "tests/net/sample.h"

#include "base/file.h"
#include "net/text.h"

#include <libxml/parser.h>

static const char *const names[] = {"",
                                    "a",
                                    "\t\x01\x02\n",
                                    "<&\"'>",
                                    "とても長い名前のとても長い名前のとても長い名前",
                                    "\xef\xbf\xbf",
                                    "\xf0\x9f\x90\xac dolphin",
                                    "%s%n%d"};

/* A polygon that may cross itself, with spikes, doubled points and any corner flags. */
static void random_loop(kg_random *random, sample_line *line, double size) {
    for (;;) {
        line->count = 0;
        size_t n = 3 + (size_t)kg_random_in(random, 0, 60);
        for (size_t i = 0; i < n; i++) {
            double a = 2 * KG_PI * (double)i / (double)n, wild = kg_random_in(random, 0, 1);
            double r = size * (wild < 0.1 ? kg_random_in(random, 0.01, 2) : 1);
            sample_add(line, r * cos(a), r * sin(a), kg_random_in(random, 0, 1) < 0.2);
            if (wild > 0.95)
                sample_add(line, r * cos(a), r * sin(a), false);
        }
        double area = 0;
        for (size_t i = 0, j = line->count - 1; i < line->count; j = i++)
            area += kg_cross2(line->points[j], line->points[i]);
        if (area > 0)
            return;
    }
}

static kg_net *random_net(kg_random *random) {
    static sample_line line;
    kg_net *net = kg_net_create();
    net->title = strdup(names[(size_t)kg_random_in(random, 0, 8)]);
    size_t count = 1 + (size_t)kg_random_in(random, 0, 6);
    for (size_t i = 0; i < count; i++) {
        size_t part;
        double size = pow(10, kg_random_in(random, -2, 1.8));
        assert_int_equal(kg_net_add_part(net, (int64_t)i - 2,
                                         names[(size_t)kg_random_in(random, 0, 8)], &part, NULL),
                         KG_OK);
        random_loop(random, &line, size);
        sample_loop(net, part, &line);
        for (int k = 0; k < 4; k++)
            sample_fold(net, part, (kg_net_kind)(k % 4),
                        kg_v2(kg_random_in(random, -size, size), kg_random_in(random, -size, size)),
                        kg_v2(kg_random_in(random, -size, size), kg_random_in(random, -size, size)),
                        k);
    }
    for (int k = 0; k < 5; k++) {
        kg_net_join join = {0};
        for (int s = 0; s < 2; s++) {
            int part = (int)kg_random_in(random, -1, (double)count);
            kg_net_side side = {.part = part, .loop = 0, .first = 1, .count = 2, .line = -1};
            if (part >= 0 && kg_random_in(random, 0, 1) < 0.3) {
                side.loop = -1;
                side.line = 2;
            }
            join.sides[s] = side;
        }
        assert_int_equal(kg_net_add_join(net, &join, NULL, NULL), KG_OK);
    }
    assert_int_equal(kg_net_check(net, NULL), KG_OK);
    return net;
}

/* No crash, no broken XML, nothing off the page, whatever the shapes are. */
static void any_checked_net_is_written_by_every_writer(void **state) {
    (void)state;
    kg_random random = {11};
    int written = 0;
    for (int n = 0; n < 60; n++) {
        kg_net *net = random_net(&random);
        kg_net_options options = kg_net_options_default();
        kg_net_options_preset(&options, (kg_net_preset)(n % 4));
        options.labels = (kg_net_labels)(n % 3);
        options.mirrored = n % 5 == 0;
        options.nest = n % 7 == 0;
        options.scale = n % 2 ? 1 : 0.3;
        if (n % 6 == 0)
            options.paper = kg_v2(0, 0);
        if (n % 4 == 1)
            options.perforate[0] = options.perforate[1] = 0.7;
        const char *const endings[] = {"any.svg", "any.pdf", "any.dxf"};
        kg_error error;
        kg_net_layout *layout;
        kg_status status = kg_net_layout_create(net, &options, NULL, &layout, &error);
        if (status == KG_OK) {
            for (int k = 0; k < 3; k++)
                if (kg_net_draw(net, layout, &options, sample_path(endings[k]), &error))
                    fail_msg("net %d: %s", n, error.message);
            if (layout->page_count == 1) {
                xmlDocPtr doc = xmlReadFile(sample_path("any.svg"), NULL, 0);
                assert_non_null(doc);
                xmlFreeDoc(doc);
            }
            kg_net_layout_destroy(layout);
            written++;
        } else {
            assert_int_equal(status, KG_ERR_INPUT);
        }
        kg_net_destroy(net);
    }
    assert_true(written > 40);
}

static void names_that_are_no_utf8_are_refused(void **state) {
    (void)state;
    const char *const wrong[] = {
        "\x80",   "\xc3",    "\xc0\x80", "\xed\xa0\x80", "\xf8\x88\x80\x80\x80", "\xf4\x90\x80\x80",
        "a\xffz", "\xe3\x81"};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        assert_false(kg_text_valid(wrong[i]));
        kg_net *net = sample_net(0);
        free(net->parts[0].name);
        net->parts[0].name = strdup(wrong[i]);
        kg_net_options options = kg_net_options_default();
        assert_int_equal(kg_net_write(net, &options, NULL, sample_path("utf8.svg"), NULL, NULL),
                         KG_ERR_INPUT);
        kg_net_destroy(net);
    }
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        assert_true(kg_text_valid(names[i]));
}

static void a_net_without_parts_is_refused(void **state) {
    (void)state;
    kg_net *net = kg_net_create();
    kg_net_options options = kg_net_options_default();
    kg_error error;
    assert_int_equal(kg_net_write(net, &options, NULL, sample_path("x.svg"), NULL, &error),
                     KG_ERR_INPUT);
    assert_non_null(strstr(error.message, "no parts"));
    kg_net_destroy(net);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(any_checked_net_is_written_by_every_writer),
        cmocka_unit_test(names_that_are_no_utf8_are_refused),
        cmocka_unit_test(a_net_without_parts_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
