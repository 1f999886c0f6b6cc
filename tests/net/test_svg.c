#include "tests/net/sample.h"

#include "base/file.h"

#include <dirent.h>
#include <libxml/parser.h>
#include <libxml/xpath.h>
#include <libxml/xpathInternals.h>
#include <sys/stat.h>
#include <unistd.h>

#define XML(text) ((const xmlChar *)(text))

typedef struct page {
    xmlDocPtr doc;
    xmlXPathContextPtr context;
} page;

static page page_read(const char *path) {
    page p = {.doc = xmlReadFile(path, NULL, 0)};
    assert_non_null(p.doc);
    p.context = xmlXPathNewContext(p.doc);
    xmlXPathRegisterNs(p.context, XML("s"), XML("http://www.w3.org/2000/svg"));
    xmlXPathRegisterNs(p.context, XML("i"), XML("http://www.inkscape.org/namespaces/inkscape"));
    return p;
}

static void page_free(page *p) {
    xmlXPathFreeContext(p->context);
    xmlFreeDoc(p->doc);
}

static double number(page *p, const char *xpath) {
    xmlXPathObjectPtr o = xmlXPathEval(XML(xpath), p->context);
    assert_non_null(o);
    double value = xmlXPathCastToNumber(o);
    xmlXPathFreeObject(o);
    return value;
}

static void assert_string_at(page *p, const char *xpath, const char *expected) {
    xmlXPathObjectPtr o = xmlXPathEval(XML(xpath), p->context);
    xmlChar *text = xmlXPathCastToString(o);
    assert_string_equal((char *)text, expected);
    xmlFree(text);
    xmlXPathFreeObject(o);
}

/* What one path holds: how many moves and closes, its box, its signed area and length. */
typedef struct outline {
    int moves, closes, others;
    kg_box2 box;
    double area, length;
} outline;

static outline outline_read(const char *d) {
    outline o = {.box = kg_box2_empty()};
    kg_vec2 at = {0, 0}, start = {0, 0};
    const char *s = d;
    while (*s) {
        char verb = *s++;
        double v[6];
        int wanted = verb == 'C' ? 6 : verb == 'Z' ? 0 : 2, used = 0;
        for (int i = 0; i < wanted; i += 2) {
            assert_int_equal(sscanf(s, " %lf,%lf%n", &v[i], &v[i + 1], &used), 2);
            s += used;
        }
        kg_vec2 b[4] = {at, {v[0], v[1]}, {v[2], v[3]}, {v[4], v[5]}};
        int steps = verb == 'C' ? 100 : 1;
        if (verb == 'M') {
            o.moves++;
            at = start = b[1];
            kg_box2_add(&o.box, at);
        } else {
            assert_non_null(strchr("LCZ", verb));
            o.closes += verb == 'Z';
            for (int k = 1; k <= steps; k++) {
                double t = (double)k / steps, u = 1 - t;
                kg_vec2 q = verb == 'Z'   ? start
                            : verb == 'L' ? b[1]
                                          : kg_v2(u * u * u * b[0].x + 3 * u * u * t * b[1].x +
                                                      3 * u * t * t * b[2].x + t * t * t * b[3].x,
                                                  u * u * u * b[0].y + 3 * u * u * t * b[1].y +
                                                      3 * u * t * t * b[2].y + t * t * t * b[3].y);
                o.area += kg_cross2(at, q) / 2;
                o.length += kg_dist2(at, q);
                kg_box2_add(&o.box, q);
                at = q;
            }
        }
        while (*s == ' ')
            s++;
    }
    return o;
}

/* Reads every path, checks that it lies on the page, and sums areas of the cut layer. */
static double page_check(page *p, double width, double height, int *out_contours) {
    xmlXPathObjectPtr o = xmlXPathEval(XML("//s:path"), p->context);
    double area = 0;
    for (int i = 0; i < o->nodesetval->nodeNr; i++) {
        xmlNodePtr node = o->nodesetval->nodeTab[i];
        xmlChar *d = xmlGetProp(node, XML("d")), *id = xmlGetProp(node->parent, XML("id"));
        outline line = outline_read((char *)d);
        assert_true(line.box.lo.x >= 0 && line.box.lo.y >= 0);
        assert_true(line.box.hi.x <= width && line.box.hi.y <= height);
        xmlChar *fill = xmlGetProp(node, XML("fill"));
        xmlChar *stroke = xmlGetProp(node, XML("stroke"));
        xmlChar *pen = xmlGetProp(node, XML("stroke-width"));
        assert_non_null(stroke);
        assert_non_null(fill);
        assert_true(pen || strcmp((char *)stroke, "none") == 0);
        if (strcmp((char *)id, "cut") == 0) {
            assert_int_equal(line.moves, 1);
            assert_int_equal(line.closes, 1);
            assert_string_equal((char *)fill, "none");
            area += line.area;
            ++*out_contours;
        }
        xmlFree(pen);
        xmlFree(fill);
        xmlFree(stroke);
        xmlFree(d);
        xmlFree(id);
    }
    xmlXPathFreeObject(o);
    return area;
}

static void page_holds_layers_closed_cuts_and_data(void **state) {
    (void)state;
    kg_net *net = sample_net(0);
    kg_net_options options = kg_net_options_default();
    const char *path = sample_path("a.svg");
    kg_error error;
    assert_int_equal(kg_net_write(net, &options, NULL, path, NULL, &error), KG_OK);
    page p = page_read(path);
    assert_string_at(&p, "/s:svg/@width", "210mm");
    assert_string_at(&p, "/s:svg/@height", "297mm");
    assert_string_at(&p, "/s:svg/@viewBox", "0 0 210 297");
    assert_string_at(&p, "/s:svg/s:title", "sample & <test>");
    assert_string_at(&p, "//s:g[@id='cut']/@i:label", "Cut");
    assert_string_at(&p, "//s:g[@id='mountain']/@i:groupmode", "layer");
    assert_near(number(&p, "count(//s:g[@i:label])"), 6, 0);
    assert_near(number(&p, "count(//s:g[@id='cut']/s:path)"), 3, 0);
    assert_near(number(&p, "count(//s:g[@id='cut']/s:path[@data-patch='11'][@data-part='1'])"), 2,
                0);
    assert_near(number(&p, "count(//s:g[@id='mark']/s:path[@data-contact='12'])"), 1, 0);
    assert_string_at(&p, "//s:g[@id='valley']/s:path/@stroke", "#0057b8");
    assert_string_at(&p, "//s:g[@id='cut']/s:path[1]/@stroke", "#000000");
    int contours = 0;
    double area = page_check(&p, 210, 297, &contours);
    assert_int_equal(contours, 3);
    assert_near(area, net->parts[0].area + net->parts[1].area, 1);
    page_free(&p);
    kg_net_destroy(net);
}

static void without_paper_the_page_is_as_large_as_the_parts(void **state) {
    (void)state;
    kg_net *net = kg_net_create();
    size_t part;
    const kg_vec2 sheet[] = {{-5, 20}, {70, 20}, {70, 50}, {-5, 50}};
    assert_int_equal(kg_net_add_part(net, 1, "", &part, NULL), KG_OK);
    assert_int_equal(kg_net_add_loop(net, part, sheet, NULL, 4, NULL), KG_OK);
    kg_net_options options = kg_net_options_default();
    options.paper = kg_v2(0, 0);
    options.labels = KG_LABELS_NONE;
    const char *path = sample_path("none.svg");
    assert_int_equal(kg_net_write(net, &options, NULL, path, NULL, NULL), KG_OK);
    page p = page_read(path);
    assert_string_at(&p, "/s:svg/@viewBox", "0 0 75 30");
    assert_near(number(&p, "count(//s:g)"), 1, 0);
    assert_string_at(&p, "//s:path/@d", "M 0,0 L 75,0 L 75,30 L 0,30 Z");
    page_free(&p);
    kg_net_destroy(net);
}

static void a_part_as_large_as_the_page_fits_however_it_is_placed(void **state) {
    (void)state;
    kg_net *net = kg_net_create();
    size_t part;
    const kg_vec2 sheet[] = {{0, 0}, {120, 0}, {120, 90}, {0, 90}};
    assert_int_equal(kg_net_add_part(net, 1, "", &part, NULL), KG_OK);
    assert_int_equal(kg_net_add_loop(net, part, sheet, NULL, 4, NULL), KG_OK);
    for (int nest = 0; nest < 2; nest++) {
        kg_net_options options = kg_net_options_default();
        options.paper = kg_v2(106, 136); /* it must lie on its side */
        options.nest = nest;
        kg_error error;
        kg_net_layout *layout;
        if (kg_net_layout_create(net, &options, NULL, &layout, &error))
            fail_msg("%s", error.message);
        assert_int_equal(layout->page_count, 1);
        kg_net_layout_destroy(layout);
        options.grain = true; /* which it may not */
        assert_int_equal(kg_net_layout_create(net, &options, NULL, &layout, &error), KG_ERR_INPUT);
        assert_non_null(strstr(error.message, "120.0 x 90.0"));
    }
    kg_net_destroy(net);
}

static void many_parts_go_to_numbered_pages_of_true_size(void **state) {
    (void)state;
    kg_net *net = sample_net(14);
    kg_net_options options = kg_net_options_default();
    options.paper = kg_v2(180, 140);
    options.scale = 0.9;
    kg_net_layout *layout;
    assert_int_equal(kg_net_write(net, &options, NULL, sample_path("many.svg"), &layout, NULL),
                     KG_OK);
    assert_true(layout->page_count > 1);
    double area = 0, expected = 0;
    int contours = 0;
    for (size_t i = 1; i <= layout->page_count; i++) {
        char name[32];
        snprintf(name, sizeof name, "many-%zu.svg", i);
        page p = page_read(sample_path(name));
        area += page_check(&p, 180, 140, &contours);
        page_free(&p);
    }
    for (size_t i = 0; i < net->part_count; i++)
        expected += net->parts[i].area;
    assert_int_equal(contours, 17);
    assert_near(area / (0.81 * expected), 1, 1e-3);
    assert_int_not_equal(access(sample_path("many.svg"), F_OK), 0);
    kg_net_layout_destroy(layout);
    kg_net_destroy(net);
}

static void the_same_net_gives_the_same_bytes(void **state) {
    (void)state;
    kg_net *net = sample_net(3);
    kg_net_options options = kg_net_options_default();
    char *text[2];
    size_t size[2];
    for (int i = 0; i < 2; i++) {
        const char *path = sample_path(i ? "twice-b.svg" : "twice-a.svg");
        assert_int_equal(kg_net_write(net, &options, NULL, path, NULL, NULL), KG_OK);
        assert_int_equal(kg_file_read(path, &text[i], &size[i], NULL), KG_OK);
    }
    assert_int_equal(size[0], size[1]);
    assert_memory_equal(text[0], text[1], size[0]);
    free(text[0]);
    free(text[1]);
    kg_net_destroy(net);
}

static void a_part_larger_than_the_page_is_named_with_what_helps(void **state) {
    (void)state;
    kg_net *net = sample_net(0);
    kg_net_options options = kg_net_options_default();
    options.paper = kg_v2(100, 80);
    kg_error error;
    assert_int_equal(kg_net_write(net, &options, NULL, sample_path("large.svg"), NULL, &error),
                     KG_ERR_INPUT);
    assert_non_null(strstr(error.message, "part 1 (胴体 body)"));
    assert_non_null(strstr(error.message, "scale"));
    assert_int_not_equal(access(sample_path("large.svg"), F_OK), 0);
    kg_net_destroy(net);
}

static void wrong_options_are_refused(void **state) {
    (void)state;
    kg_net *net = sample_net(0);
    const kg_net_options good = kg_net_options_default();
    for (int i = 0; i < 8; i++) {
        kg_net_options o = good;
        switch (i) {
        case 0:
            o.paper.x = -1;
            break;
        case 1:
            o.margin = NAN;
            break;
        case 2:
            o.margin = 200;
            break;
        case 3:
            o.scale = 0;
            break;
        case 4:
            o.tolerance = 0;
            break;
        case 5:
            o.gap = -2;
            break;
        case 6:
            o.perforate[0] = 2;
            break;
        case 7:
            o.paper = kg_v2(INFINITY, 10);
            break;
        }
        kg_error error;
        assert_int_equal(kg_net_write(net, &o, NULL, sample_path("bad.svg"), NULL, &error),
                         KG_ERR_INPUT);
        assert_true(strlen(error.message) > 10);
    }
    kg_net_options o = good;
    assert_int_equal(kg_net_write(net, &o, NULL, sample_path("bad.png"), NULL, NULL), KG_ERR_INPUT);
    assert_int_not_equal(access(sample_path("bad.svg"), F_OK), 0);
    kg_vec2 paper;
    assert_int_equal(kg_net_paper_parse("a3", &paper, NULL), KG_OK);
    assert_near(paper.y, 420, 0);
    assert_int_equal(kg_net_paper_parse("300.5x200", &paper, NULL), KG_OK);
    assert_near(paper.x, 300.5, 1e-12);
    const char *const wrong[] = {"", "A9", "300", "300x", "0x10", "10x20mm", "-5x5", "1e3x5"};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        assert_int_equal(kg_net_paper_parse(wrong[i], &paper, NULL), KG_ERR_INPUT);
    kg_net_destroy(net);
}

static int files_in(const char *folder) {
    DIR *d = opendir(folder);
    assert_non_null(d);
    int n = 0;
    for (struct dirent *e; (e = readdir(d));)
        n += e->d_name[0] != '.';
    closedir(d);
    return n;
}

static void a_page_that_cannot_be_written_leaves_no_page(void **state) {
    (void)state;
    kg_net *net = sample_net(14);
    kg_net_options options = kg_net_options_default();
    options.paper = kg_v2(180, 140);
    char folder[256], blocked[512];
    snprintf(folder, sizeof folder, "%s", sample_path("blocked"));
    assert_int_equal(mkdir(folder, 0700), 0);
    /* A folder in the second page's place: it cannot be replaced by a file. */
    snprintf(blocked, sizeof blocked, "%s/x-2.svg", folder);
    assert_int_equal(mkdir(blocked, 0700), 0);
    char path[512];
    snprintf(path, sizeof path, "%s/x.svg", folder);
    kg_error error;
    assert_int_equal(kg_net_write(net, &options, NULL, path, NULL, &error), KG_ERR_IO);
    assert_int_equal(files_in(folder), 1);
    snprintf(path, sizeof path, "%s/missing/x.svg", folder);
    assert_int_equal(kg_net_write(net, &options, NULL, path, NULL, &error), KG_ERR_IO);
    assert_int_equal(files_in(folder), 1);
    kg_net_destroy(net);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(page_holds_layers_closed_cuts_and_data),
        cmocka_unit_test(without_paper_the_page_is_as_large_as_the_parts),
        cmocka_unit_test(a_part_as_large_as_the_page_fits_however_it_is_placed),
        cmocka_unit_test(many_parts_go_to_numbered_pages_of_true_size),
        cmocka_unit_test(the_same_net_gives_the_same_bytes),
        cmocka_unit_test(a_part_larger_than_the_page_is_named_with_what_helps),
        cmocka_unit_test(wrong_options_are_refused),
        cmocka_unit_test(a_page_that_cannot_be_written_leaves_no_page),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
