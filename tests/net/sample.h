/* Nets made by hand for the writers' tests: rounded parts with holes, folds, marks and joins. */
#ifndef KG_TESTS_NET_SAMPLE_H
#define KG_TESTS_NET_SAMPLE_H

#include "tests/check.h"

#include "katagami/net.h"

#include <stdlib.h>

enum { SAMPLE_MAX = 4096 };

typedef struct sample_line {
    kg_vec2 points[SAMPLE_MAX];
    unsigned char corners[SAMPLE_MAX];
    size_t count;
} sample_line;

static inline void sample_add(sample_line *line, double x, double y, bool corner) {
    line->points[line->count] = kg_v2(x, y);
    line->corners[line->count++] = corner;
}

/* Radius of a wavy closed curve, positive shoelace area for turn = 1, a hole for turn = -1. */
static inline void sample_blob(sample_line *line, kg_vec2 center, double radius, double wave,
                               int lobes, int turn) {
    line->count = 0;
    size_t n = (size_t)(8 * sqrt(radius) * (1 + lobes * wave) * 6);
    for (size_t i = 0; i < n; i++) {
        double a = turn * 2 * KG_PI * (double)i / (double)n;
        double r = radius * (1 + wave * cos(lobes * a));
        sample_add(line, center.x + r * cos(a), center.y + r * sin(a), false);
    }
}

/* A leaf between two corners at (0,0) and (length,0), arched by `arch`. */
static inline void sample_leaf(sample_line *line, double length, double arch) {
    line->count = 0;
    const int n = 120;
    for (int side = 0; side < 2; side++)
        for (int i = 0; i < n; i++) {
            double t = side == 0 ? i / (double)n : 1 - i / (double)n;
            double y = arch * sin(KG_PI * t) * (side == 0 ? -1 : 0.6);
            sample_add(line, length * t, y, i == 0);
        }
}

static inline void sample_loop(kg_net *net, size_t part, const sample_line *line) {
    assert_int_equal(kg_net_add_loop(net, part, line->points, line->corners, line->count, NULL),
                     KG_OK);
}

static inline size_t sample_fold(kg_net *net, size_t part, kg_net_kind kind, kg_vec2 a, kg_vec2 b,
                                 int64_t contact) {
    kg_vec2 points[21];
    unsigned char corners[21] = {1};
    corners[20] = 1;
    for (int i = 0; i <= 20; i++) {
        points[i] = kg_lerp2(a, b, i / 20.0);
        points[i].y += 2 * sin(KG_PI * i / 20.0);
    }
    kg_net_line line = {.kind = kind,
                        .count = 21,
                        .points = points,
                        .corners = corners,
                        .contact = contact,
                        .join = -1};
    size_t index;
    assert_int_equal(kg_net_add_line(net, part, &line, &index, NULL), KG_OK);
    return index;
}

/* Shoelace area of all of a part's loops. */
static inline double sample_area(const kg_net_part *part) {
    double sum = 0;
    for (size_t i = 0; i < part->loop_count; i++) {
        const kg_net_line *line = &part->loops[i].line;
        for (size_t k = 0, j = line->count - 1; k < line->count; j = k++)
            sum += kg_cross2(line->points[j], line->points[k]) / 2;
    }
    return sum;
}

/* A body with a hole and folds, a leaf that touches it, and `extra` more leaves. */
static inline kg_net *sample_net(int extra) {
    static sample_line line;
    kg_net *net = kg_net_create();
    net->title = strdup("sample & <test>");
    size_t body, leaf, part;
    assert_int_equal(kg_net_add_part(net, 11, "胴体 body", &body, NULL), KG_OK);
    sample_blob(&line, kg_v2(60, 40), 45, 0.15, 3, 1);
    sample_loop(net, body, &line);
    sample_blob(&line, kg_v2(75, 40), 9, 0.1, 2, -1);
    sample_loop(net, body, &line);
    sample_fold(net, body, KG_NET_MOUNTAIN, kg_v2(25, 30), kg_v2(25, 50), 0);
    sample_fold(net, body, KG_NET_VALLEY, kg_v2(35, 20), kg_v2(55, 20), 0);
    size_t mark = sample_fold(net, body, KG_NET_MARK, kg_v2(30, 60), kg_v2(70, 60), 12);
    assert_int_equal(kg_net_add_part(net, 12, "背びれ", &leaf, NULL), KG_OK);
    sample_leaf(&line, 80, 18);
    sample_loop(net, leaf, &line);
    for (int i = 0; i < extra; i++) {
        assert_int_equal(kg_net_add_part(net, 13 + i, i % 2 ? "flipper" : "", &part, NULL), KG_OK);
        sample_leaf(&line, 60 + 7 * i, 10 + i % 5);
        sample_loop(net, part, &line);
    }
    kg_net_join join = {
        .kind = KG_JOIN_CONTACT,
        .sides =
            {{.part = (int)leaf, .loop = 0, .first = 0, .count = 121, .line = -1, .length = 81},
             {.part = (int)body, .loop = -1, .line = (int)mark, .length = 81}},
        .sources = {12, 11}};
    assert_int_equal(kg_net_add_join(net, &join, NULL, NULL), KG_OK);
    for (size_t i = 0; i < net->part_count; i++)
        net->parts[i].area = net->parts[i].surface = sample_area(&net->parts[i]);
    assert_int_equal(kg_net_check(net, NULL), KG_OK);
    return net;
}

/* A new folder below /tmp; the path of `name` in it. */
static inline const char *sample_path(const char *name) {
    static char folder[64], path[256];
    if (!*folder) {
        strcpy(folder, "/tmp/katagami-net-XXXXXX");
        assert_non_null(mkdtemp(folder));
    }
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return path;
}

#endif
