#include "tests/net/sample.h"

#include "base/file.h"

/* A small reader of its own: groups of code and value, entities after the ENTITIES line. */
typedef struct group {
    int code;
    char value[256];
} group;

typedef struct reader {
    const char *at;
} reader;

static bool next(reader *r, group *g) {
    int used = 0;
    if (sscanf(r->at, "%d%n", &g->code, &used) != 1)
        return false;
    assert_int_equal(r->at[used], '\n');
    r->at += used + 1;
    const char *end = strchr(r->at, '\n');
    assert_non_null(end);
    size_t n = (size_t)(end - r->at);
    assert_true(n < sizeof g->value);
    memcpy(g->value, r->at, n);
    g->value[n] = '\0';
    r->at = end + 1;
    return true;
}

static char *net_text(const kg_net *net, const kg_net_options *options, const char *name) {
    char *text;
    size_t size;
    kg_error error;
    if (kg_net_write(net, options, NULL, sample_path(name), NULL, &error))
        fail_msg("%s", error.message);
    assert_int_equal(kg_file_read(sample_path(name), &text, &size, NULL), KG_OK);
    return text;
}

typedef struct shape {
    char layer[32];
    bool closed;
    int vertices, declared;
    kg_vec2 points[4000];
} shape;

static double area_of(const shape *s) {
    double sum = 0;
    for (int i = 0, j = s->vertices - 1; i < s->vertices; j = i++)
        sum += kg_cross2(s->points[j], s->points[i]) / 2;
    return sum;
}

/* Distance from a shape's vertices to a part's contour on the page. */
static double stray(const shape *s, const kg_net_line *line, kg_net_placement place,
                    double height) {
    double worst = 0, c = cos(place.angle), sn = sin(place.angle);
    for (int v = 0; v < s->vertices; v++) {
        kg_vec2 q = kg_sub2(kg_v2(s->points[v].x, height - s->points[v].y), place.offset);
        q = kg_v2(c * q.x + sn * q.y, c * q.y - sn * q.x);
        double best = INFINITY;
        for (size_t i = 0, j = line->count - 1; i < line->count; j = i++) {
            kg_vec2 ab = kg_sub2(line->points[i], line->points[j]);
            kg_vec2 aq = kg_sub2(q, line->points[j]);
            double t = fmin(fmax(kg_dot2(ab, aq) / kg_dot2(ab, ab), 0), 1);
            best = fmin(best, kg_len2(kg_sub2(aq, kg_scale2(ab, t))));
        }
        worst = fmax(worst, best);
    }
    return worst;
}

/* Reads all LWPOLYLINEs; returns how many. */
static int shapes_read(const char *text, shape *shapes, int most) {
    reader r = {strstr(text, "ENTITIES")};
    assert_non_null(r.at);
    r.at = strchr(r.at, '\n') + 1;
    int count = 0;
    shape *s = NULL;
    for (group g; next(&r, &g) && !(g.code == 0 && strcmp(g.value, "ENDSEC") == 0);) {
        if (g.code == 0) {
            s = NULL;
            if (strcmp(g.value, "LWPOLYLINE") == 0) {
                assert_true(count < most);
                s = &shapes[count++];
                s->vertices = 0;
            }
        } else if (s && g.code == 8) {
            snprintf(s->layer, sizeof s->layer, "%.31s", g.value);
        } else if (s && g.code == 70) {
            s->closed = atoi(g.value) & 1;
        } else if (s && g.code == 90) {
            s->declared = atoi(g.value);
        } else if (s && g.code == 10) {
            s->points[s->vertices].x = atof(g.value);
        } else if (s && g.code == 20) {
            s->points[s->vertices++].y = atof(g.value);
        }
    }
    return count;
}

static void contours_come_back_closed_unmirrored_and_true(void **state) {
    (void)state;
    static shape shapes[64];
    kg_net *net = sample_net(0);
    kg_net_options options = kg_net_options_default();
    kg_net_layout *layout;
    assert_int_equal(kg_net_layout_create(net, &options, NULL, &layout, NULL), KG_OK);
    char *text = net_text(net, &options, "a.dxf");
    int count = shapes_read(text, shapes, 64), cuts = 0, valleys = 0;
    for (int i = 0; i < count; i++) {
        const shape *s = &shapes[i];
        assert_int_equal(s->vertices, s->declared);
        valleys += strcmp(s->layer, "Valley") == 0;
        if (strcmp(s->layer, "Cut") != 0)
            continue;
        /* In the order of the net: body, its hole, leaf. */
        const kg_net_line *line = &net->parts[cuts / 2].loops[cuts % 2].line;
        assert_true(s->closed);
        assert_true(stray(s, line, layout->placements[cuts / 2], 297) <= 0.011);
        assert_true(kg_dist2(s->points[0], s->points[s->vertices - 1]) > 1e-3);
        /* y up turns the sense of rotation: an outline mirrored by mistake would keep it. */
        assert_true((area_of(s) < 0) == (cuts != 1));
        cuts++;
    }
    assert_int_equal(cuts, 3);
    assert_int_equal(valleys, 1);
    free(text);
    kg_net_layout_destroy(layout);
    kg_net_destroy(net);
}

static void structure_is_what_readers_insist_on(void **state) {
    (void)state;
    kg_net *net = sample_net(0);
    kg_net_options options = kg_net_options_default();
    char *text = net_text(net, &options, "b.dxf");
    assert_non_null(strstr(text, "$ACADVER\n  1\nAC1015\n"));
    assert_non_null(strstr(text, "$INSUNITS\n 70\n4\n"));
    assert_non_null(strstr(text, "\\U+80F4\\U+4F53 body"));
    static unsigned handles[4096];
    int count = 0, sections = 0, ends = 0, tables = 0, endtabs = 0, layers = 0;
    unsigned seed = 0;
    bool seed_next = false;
    reader r = {text};
    group g, last = {-1, ""};
    while (next(&r, &g)) {
        if (g.code == 5 && seed_next) {
            seed = (unsigned)strtoul(g.value, NULL, 16);
        } else if (g.code == 5) {
            unsigned h = (unsigned)strtoul(g.value, NULL, 16);
            for (int i = 0; i < count; i++)
                assert_int_not_equal(handles[i], h);
            assert_true(h != 0 && count < 4096);
            handles[count++] = h;
        }
        seed_next = g.code == 9 && strcmp(g.value, "$HANDSEED") == 0;
        sections += g.code == 0 && strcmp(g.value, "SECTION") == 0;
        ends += g.code == 0 && strcmp(g.value, "ENDSEC") == 0;
        tables += g.code == 0 && strcmp(g.value, "TABLE") == 0;
        endtabs += g.code == 0 && strcmp(g.value, "ENDTAB") == 0;
        layers += g.code == 0 && strcmp(g.value, "LAYER") == 0;
        last = g;
    }
    assert_string_equal(last.value, "EOF");
    assert_int_equal(*r.at, '\0');
    assert_int_equal(sections, 6);
    assert_int_equal(ends, 6);
    assert_int_equal(tables, 9);
    assert_int_equal(endtabs, 9);
    assert_int_equal(layers, 7);
    for (int i = 0; i < count; i++)
        assert_true(handles[i] < seed);
    /* Every owner and pointer names a handle that exists, or 0. */
    r.at = text;
    while (next(&r, &g)) {
        if (g.code != 330 && g.code != 350)
            continue;
        unsigned h = (unsigned)strtoul(g.value, NULL, 16);
        bool known = h == 0;
        for (int i = 0; i < count && !known; i++)
            known = handles[i] == h;
        assert_true(known);
    }
    free(text);
    kg_net_destroy(net);
}

static void perforated_folds_are_separate_lines_with_gaps(void **state) {
    (void)state;
    static shape shapes[256];
    kg_net *net = sample_net(0);
    kg_net_options options = kg_net_options_default();
    options.perforate[0] = 1;
    options.perforate[1] = 0.5;
    options.labels = KG_LABELS_NONE;
    char *text = net_text(net, &options, "c.dxf");
    int count = shapes_read(text, shapes, 256), pieces = 0;
    const shape *before = NULL;
    for (int i = 0; i < count; i++) {
        const shape *s = &shapes[i];
        if (strcmp(s->layer, "Mountain") != 0)
            continue;
        if (before)
            assert_near(kg_dist2(before->points[before->vertices - 1], s->points[0]), 0.5, 0.01);
        before = s;
        pieces++;
    }
    /* About 20.5 mm: 14 dashes of 1 mm and 13 gaps of 0.5 mm take all of it. */
    assert_in_range(pieces, 13, 14);
    free(text);
    kg_net_destroy(net);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(contours_come_back_closed_unmirrored_and_true),
        cmocka_unit_test(structure_is_what_readers_insist_on),
        cmocka_unit_test(perforated_folds_are_separate_lines_with_gaps),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
