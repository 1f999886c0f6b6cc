/* Flat sheets to begin with. */
#include "origami/convex.h"
#include "origami/layers.h"
#include "origami/origami.h"

#include <stdlib.h>

/* Tests of polygons grow with the square of their corners. */
enum { MAX_CORNERS = 500 };

#define MAX_COORDINATE 1e6 /* mm */

/* Distance between two segments that do not cross, 0 when they do. */
static double segment_distance(kg_vec2 a, kg_vec2 b, kg_vec2 c, kg_vec2 d) {
    kg_vec2 ab = kg_sub2(b, a), cd = kg_sub2(d, c);
    double ca = kg_cross2(ab, kg_sub2(c, a)), da = kg_cross2(ab, kg_sub2(d, a)),
           ac = kg_cross2(cd, kg_sub2(a, c)), bc = kg_cross2(cd, kg_sub2(b, c));
    if (((ca > 0) != (da > 0)) && ((ac > 0) != (bc > 0)))
        return 0;
    kg_vec2 points[4] = {a, b, c, d}, from[4] = {c, c, a, a}, along[4] = {cd, cd, ab, ab};
    double least = INFINITY;
    for (int k = 0; k < 4; k++) {
        double n = kg_dot2(along[k], along[k]);
        double t = n > 0 ? kg_dot2(along[k], kg_sub2(points[k], from[k])) / n : 0;
        kg_vec2 foot = kg_add2(from[k], kg_scale2(along[k], fmax(0, fmin(1, t))));
        least = fmin(least, kg_dist2(points[k], foot));
    }
    return least;
}

kg_status kg_sheet_check(const kg_paper_sheet *sheet, kg_error *error) {
    size_t n = sheet->count;
    const kg_vec2 *p = sheet->polygon;
    if (n < 3 || n > MAX_CORNERS)
        return kg_fail(error, KG_ERR_INPUT, "a sheet has 3 to %d corners, not %zu", MAX_CORNERS, n);
    kg_box2 box = kg_box2_empty();
    for (size_t i = 0; i < n; i++) {
        if (!(fabs(p[i].x) <= MAX_COORDINATE && fabs(p[i].y) <= MAX_COORDINATE))
            return kg_fail(error, KG_ERR_INPUT, "corner %zu of the sheet is beyond %g mm", i + 1,
                           MAX_COORDINATE);
        kg_box2_add(&box, p[i]);
    }
    double least = KG_PICK * fmax(box.hi.x - box.lo.x, box.hi.y - box.lo.y);
    for (size_t i = 0; i < n; i++) {
        kg_vec2 a = p[i], b = p[(i + 1) % n], c = p[(i + 2) % n];
        if (!(kg_dist2(a, b) > least))
            return kg_fail(error, KG_ERR_INPUT, "corners %zu and %zu of the sheet are the same",
                           i + 1, (i + 1) % n + 1);
        kg_vec2 in = kg_sub2(a, b), out = kg_sub2(c, b);
        if (kg_dot2(in, out) > 0 && fabs(kg_cross2(in, out)) < least * kg_len2(in))
            return kg_fail(error, KG_ERR_INPUT, "the sheet turns back on itself at corner %zu",
                           (i + 1) % n + 1);
        for (size_t k = i + 2; k < n; k++)
            if ((k + 1) % n != i && !(segment_distance(a, b, p[k], p[(k + 1) % n]) > least))
                return kg_fail(error, KG_ERR_INPUT,
                               "the outline of the sheet crosses or touches itself: the sides "
                               "after corners %zu and %zu",
                               i + 1, k + 1);
    }
    if (!(fabs(kg_polygon_area(p, n)) > least * least))
        return kg_fail(error, KG_ERR_INPUT, "the sheet has no area");
    return KG_OK;
}

static kg_status add_sheet(kg_origami_state *s, int32_t index, const kg_paper_sheet *sheet,
                           kg_error *error) {
    int32_t first = (int32_t)s->vertices.count, n = (int32_t)sheet->count;
    bool reversed = kg_polygon_area(sheet->polygon, sheet->count) < 0;
    int32_t *corners = malloc(sheet->count * sizeof *corners);
    kg_face_list faces = {0};
    kg_status status = corners ? KG_OK : KG_ERR_MEMORY;
    for (int32_t i = 0; i < n && !status; i++) {
        kg_vec2 p = sheet->polygon[reversed ? n - 1 - i : i];
        corners[i] = first + i;
        if (!kg_push(&s->vertices, ((kg_paper_vertex){p, kg_v3(p.x, p.y, 0), index})))
            status = KG_ERR_MEMORY;
    }
    for (int32_t i = 0; i < n && !status; i++)
        status = kg_state_add_edge(s, first + i, first + (i + 1) % n, KG_PAPER_BORDER, 0);
    if (!status)
        status = kg_face_list_add(&faces, corners, sheet->count);
    if (!status)
        status = kg_state_add_faces(s, index, &faces, error);
    kg_face_list_clear(&faces);
    free(corners);
    return status;
}

kg_status kg_state_from_sheets(const kg_paper_sheet *sheets, size_t count,
                               kg_origami_state **out_state, kg_error *error) {
    kg_origami_state *s = kg_state_create();
    kg_outlines o = {0};
    kg_status status =
        s && kg_push(&s->groups, ((kg_face_group){kg_v3(0, 0, 1), 0})) ? KG_OK : KG_ERR_MEMORY;
    for (size_t i = 0; i < count && !status; i++)
        status = add_sheet(s, (int32_t)i, &sheets[i], error);
    if (!status) {
        kg_state_measure(s);
        status = kg_outlines_create(s, &o);
    }
    if (!status)
        status = kg_layers_create(s);
    for (size_t i = 0; s && i < s->loops.count && !status; i++)
        for (size_t k = i + 1; k < s->loops.count && !status; k++)
            if (s->loops.items[i].sheet != s->loops.items[k].sheet &&
                kg_outlines_overlap(&o, (int32_t)i, (int32_t)k, s->touch))
                kg_layer_put(s, &o, (int32_t)i, (int32_t)k, 1);
    kg_outlines_clear(&o);
    if (status) {
        kg_state_destroy(s);
        return status == KG_ERR_MEMORY ? kg_fail(error, status, "out of memory") : status;
    }
    *out_state = s;
    return KG_OK;
}
