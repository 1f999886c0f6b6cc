/* Parts of nets in space, against what the net says of them on paper. */
#include "guide/assembly.h"
#include "katagami/unroll.h"
#include "net/merge.h"
#include "tests/guide/model.h"

#include <stdlib.h>

static double area_of(const kg_surface *s) {
    double area = 0;
    for (size_t i = 0; i < s->triangle_count; i++) {
        kg_vec3 a = s->positions[s->triangles[3 * i]], b = s->positions[s->triangles[3 * i + 1]],
                c = s->positions[s->triangles[3 * i + 2]];
        area += kg_len(kg_cross(kg_sub(b, a), kg_sub(c, a))) / 2;
    }
    return area;
}

static double length_of(const kg_assembly_join *join) {
    double length = 0;
    for (size_t i = 1; i < join->count; i++)
        length += kg_dist(join->points[i - 1], join->points[i]);
    return length;
}

/* Every part and join of the net is there, as large and as long as on paper. */
static void assert_matches(const kg_assembly *assembly, const kg_net *net) {
    for (size_t i = 0; i < net->part_count; i++) {
        assert_near(area_of(&assembly->parts[i].surface), net->parts[i].surface, 0.5);
        assert_int_equal(assembly->parts[i].sample_count, KG_ASSEMBLY_SAMPLES);
    }
    for (size_t i = 0; i < net->join_count; i++)
        assert_near(length_of(&assembly->joins[i]), net->joins[i].sides[0].length, 0.01);
}

static kg_net *net_of(kg_document *document, bool merged) {
    kg_unrolled *unrolled;
    kg_merge_report report;
    assert_int_equal(
        kg_unroll(kg_document_model(document), kg_document_solution(document), &unrolled, NULL),
        KG_OK);
    kg_net *net = unrolled->net;
    unrolled->net = NULL;
    kg_unrolled_destroy(unrolled);
    if (merged) {
        assert_int_equal(kg_net_merge(net, &(kg_merge_options){.all = true}, &report, NULL), KG_OK);
        assert_true(report.merged > 0);
        free(report.remarks);
    }
    return net;
}

static void parts_and_joins_are_as_large_as_on_paper(void **state) {
    (void)state;
    for (int trimmed = 0; trimmed < 2; trimmed++) {
        kg_document *document = box_document(trimmed);
        kg_net *net = net_of(document, false);
        kg_assembly *assembly;
        assert_int_equal(kg_assembly_create(document, net, kg_v2(0, 0), &assembly, NULL), KG_OK);
        assert_int_equal(net->part_count, 6);
        assert_int_equal(net->join_count, 12);
        assert_matches(assembly, net);
        for (size_t i = 0; i < net->join_count; i++)
            assert_int_equal(assembly->joins[i].inside, net->joins[i].kind == KG_JOIN_CONTACT);
        for (size_t i = 0; i < net->part_count; i++) {
            const kg_assembly_part *part = &assembly->parts[i];
            assert_true(isinf(part->radius_in) && isinf(part->radius_out));
            assert_near(kg_len(part->front), 1, 1e-6);
            /* as the app shows the patch, whatever its place in the net is */
            assert_int_equal(kg_color_to_rgb(part->color),
                             kg_color_to_rgb(kg_palette((size_t)(net->parts[i].source - 1))));
            /* fronts outward */
            assert_true(kg_dot(part->front, part->center) > 0);
        }
        kg_assembly_destroy(assembly);
        kg_net_destroy(net);
        kg_document_destroy(document);
    }
}

static void merged_parts_have_all_their_pieces(void **state) {
    (void)state;
    kg_document *document = box_document(true);
    kg_net *net = net_of(document, true);
    kg_assembly *assembly;
    assert_int_equal(kg_assembly_create(document, net, kg_v2(0, 0), &assembly, NULL), KG_OK);
    size_t pieces = 0;
    for (size_t i = 0; i < net->part_count; i++)
        pieces += assembly->parts[i].piece_count;
    assert_true(net->part_count < 6);
    assert_int_equal(pieces, 6);
    assert_matches(assembly, net);
    kg_assembly_destroy(assembly);
    kg_net_destroy(net);
    kg_document_destroy(document);
}

static void halves_of_a_part_too_large_are_parts_of_their_own(void **state) {
    (void)state;
    const kg_vec2 room = {190, 277};
    kg_document *document = solved_document(
        "{\"katagami\":1,\"kind\":\"patches\",\"patches\":[{\"id\":1,\"points\":[[0,0,0],"
        "[150,0,60],[250,0,60],[400,0,0]],\"extent\":[-40,40],\"color\":\"#12Ab56\"}]}");
    kg_unrolled *unrolled;
    assert_int_equal(kg_unroll_to_fit(kg_document_model(document), kg_document_solution(document),
                                      room, &unrolled, NULL),
                     KG_OK);
    kg_assembly *assembly;
    assert_int_equal(kg_assembly_create(document, unrolled->net, room, &assembly, NULL), KG_OK);
    assert_int_equal(unrolled->net->part_count, 2);
    assert_int_equal(unrolled->net->join_count, 1);
    assert_matches(assembly, unrolled->net);
    for (int i = 0; i < 2; i++)
        assert_int_equal(kg_color_to_rgb(assembly->parts[i].color), 0x12ab56);
    /* each half lies on its own side of the seam */
    double at = assembly->joins[0].points[0].x;
    assert_true((assembly->parts[0].center.x < at) != (assembly->parts[1].center.x < at));
    kg_assembly_destroy(assembly);
    kg_unrolled_destroy(unrolled);
    kg_document_destroy(document);
}

/* An arc with its front on the hollow or the bulging side. */
static void bends_have_their_radius_and_side(void **state) {
    (void)state;
    for (int flip = 0; flip < 2; flip++) {
        /* a quarter of a circle of radius 40, to 0.03 % */
        char json[512];
        snprintf(json, sizeof json,
                 "{\"katagami\":1,\"kind\":\"patches\",\"patches\":[{\"id\":1,\"points\":[[40,0,0],"
                 "[40,0,22.0914],[22.0914,0,40],[0,0,40]],\"extent\":[-10,10],\"flip\":%s}]}",
                 flip ? "true" : "false");
        kg_document *document = solved_document(json);
        kg_net *net = net_of(document, false);
        kg_assembly *assembly;
        assert_int_equal(kg_assembly_create(document, net, kg_v2(0, 0), &assembly, NULL), KG_OK);
        const kg_assembly_part *part = &assembly->parts[0];
        bool outward = kg_dot(part->front, part->center) > 0;
        assert_near(outward ? part->radius_out : part->radius_in, 40, 1);
        assert_true(isinf(outward ? part->radius_in : part->radius_out));
        assert_true(part->ruling_count > 4);
        for (size_t i = 0; i < part->ruling_count; i++)
            assert_near(kg_dist2(part->rulings[i][0], part->rulings[i][1]), 20, 1e-6);
        kg_assembly_destroy(assembly);
        kg_net_destroy(net);
        kg_document_destroy(document);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(parts_and_joins_are_as_large_as_on_paper),
        cmocka_unit_test(merged_parts_have_all_their_pieces),
        cmocka_unit_test(halves_of_a_part_too_large_are_parts_of_their_own),
        cmocka_unit_test(bends_have_their_radius_and_side),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
