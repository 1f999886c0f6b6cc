/* From random trimmed models, and the samples, to pages: what must hold for every net. */
#include "katagami/document.h"
#include "katagami/unroll.h"
#include "net/clash.h"
#include "net/drawing.h"
#include "net/tab_place.h"
#include "tests/model/random_model.h"
#include "tests/net/tab_check.h"

/* mm by which the two sides of a join may differ */
#define SAME 0.01

static bool has_caption(const kg_drawing *d, int part, int number) {
    char text[16];
    snprintf(text, sizeof text, "%d", number);
    for (size_t p = 0; p < d->page_count; p++)
        for (size_t i = 0; i < d->pages[p].captions.count; i++) {
            const kg_caption *c = &d->pages[p].captions.items[i];
            if (c->part == part && strcmp(c->text, text) == 0)
                return true;
        }
    return false;
}

static void check_joins(const kg_net *net, const kg_drawing *d) {
    for (size_t i = 0; i < net->join_count; i++) {
        const kg_net_join *j = &net->joins[i];
        assert_near(j->sides[0].length, j->sides[1].length, SAME);
        for (int k = 0; k < 2; k++)
            if (!has_caption(d, net->parts[j->sides[k].part].number, j->number))
                fail_msg("join %d has no number on part %d", j->number,
                         net->parts[j->sides[k].part].number);
    }
}

static void check_pages(const kg_net *net, bool nest) {
    kg_error error;
    kg_net_options options = kg_net_options_default();
    options.paper = kg_v2(600, 600);
    options.nest = nest;
    kg_net_layout *layout;
    kg_drawing *drawing;
    if (kg_net_layout_create(net, &options, NULL, &layout, &error))
        fail_msg("%s", error.message);
    unsigned *clashes = checked(calloc(net->part_count, sizeof *clashes));
    assert_int_equal(kg_net_clashes(net, layout, &options, clashes, NULL), KG_OK);
    for (size_t i = 0; i < net->part_count; i++)
        assert_int_equal(clashes[i], 0);
    int overlaps;
    assert_int_equal(kg_net_tab_overlaps(net, layout, &options, &overlaps, NULL), KG_OK);
    assert_int_equal(overlaps, 0);
    assert_int_equal(kg_drawing_create(net, layout, &options, true, &drawing, NULL), KG_OK);
    check_joins(net, drawing);
    kg_drawing_destroy(drawing);
    free(clashes);
    kg_net_layout_destroy(layout);
}

/* Slivers of random models may be thinner than the chords of their two sides are true, so that
 * these cross on paper. */
static bool has_crossing_sliver(const kg_net *net) {
    GEOSContextHandle_t geos = GEOS_init_r();
    bool found = false;
    for (size_t i = 0; i < net->part_count; i++) {
        kg_net_line contours[16];
        kg_vec2 at;
        assert_true(net->parts[i].loop_count <= 16);
        for (size_t k = 0; k < net->parts[i].loop_count; k++)
            contours[k] = net->parts[i].loops[k].line;
        found |= !kg_tab_contours_valid(geos, contours, net->parts[i].loop_count, &at);
    }
    GEOS_finish_r(geos);
    return found;
}

static int slivers;

/* Tabs are checked by GEOS in tab_make. */
static size_t check_model(const kg_model *model, double tolerance, bool nest) {
    kg_solution *solution;
    kg_unrolled *unrolled;
    kg_tab_report report = {0};
    assert_int_equal(kg_solution_create(model, tolerance, NULL, &solution, NULL), KG_OK);
    assert_int_equal(kg_unroll(model, solution, &unrolled, NULL), KG_OK);
    size_t joins = unrolled->net->join_count;
    if (has_crossing_sliver(unrolled->net)) {
        slivers++;
        joins = 0;
    } else if (unrolled->net->part_count > 0) {
        kg_tab_options options = kg_tab_options_default();
        options.bends = (const double *const *)unrolled->bends;
        kg_net *net = tab_make(unrolled->net, &options, &report);
        check_pages(net, nest);
        kg_net_destroy(net);
    }
    kg_tab_report_clear(&report);
    kg_unrolled_destroy(unrolled);
    kg_solution_destroy(solution);
    return joins;
}

static void random_models_have_sound_nets(void **state) {
    (void)state;
    kg_random r = {2026};
    int joined = 0; /* models with something to glue */
    for (int round = 0; round < 1000 && joined < 200; round++) {
        kg_model *model = random_model(&r, 6);
        joined += check_model(model, 0.005, round % 20 == 0) > 0;
        kg_model_destroy(model);
    }
    assert_int_equal(joined, 200);
    assert_in_range(slivers, 0, 4);
}

static void samples_have_sound_nets(void **state) {
    (void)state;
    static const char *const names[] = {"dolphin", "fin", "lantern", "ribbon"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        char path[512];
        kg_model *model;
        kg_error error;
        snprintf(path, sizeof path, "%s/data/%s.katagami", SOURCE_ROOT, names[i]);
        if (kg_model_read(path, &model, &error))
            fail_msg("%s", error.message);
        slivers = 0;
        check_model(model, 0.002, true);
        assert_int_equal(slivers, 0);
        kg_model_destroy(model);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_models_have_sound_nets),
        cmocka_unit_test(samples_have_sound_nets),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
