/* The sheet as a net of one part. */
#include "oa/sheet.h"

#include <stdlib.h>
#include <string.h>

static kg_status add_line(kg_net *net, size_t part, const kg_oa_line *line, double cell,
                          kg_error *error) {
    static const kg_net_kind kinds[] = {KG_NET_MARK, KG_NET_CUT, KG_NET_MOUNTAIN, KG_NET_VALLEY};
    kg_vec2 points[2] = {kg_v2(line->x0 * cell, line->row0 * cell),
                         kg_v2(line->x1 * cell, line->row1 * cell)};
    kg_net_line made = {.kind = kinds[line->kind], .count = 2, .points = points, .join = -1};
    return kg_net_add_line(net, part, &made, NULL, error);
}

/* Area in space of one whole cell of a piece's plane, with the card standing, and how far the sides
 * of a cell are from being as long as on paper. */
static double cell_area(const kg_oa_piece *piece, const kg_vec3 axes[5], double *out_error) {
    kg_oa_tuple o = kg_oa_piece_point(piece, 0, 0);
    kg_oa_tuple a = kg_oa_piece_point(piece, 1, 0), b = kg_oa_piece_point(piece, 0, 1);
    kg_vec3 u = {0, 0, 0}, v = {0, 0, 0};
    for (int i = 0; i < 5; i++) {
        u = kg_madd(u, a.v[i] - o.v[i], axes[i]);
        v = kg_madd(v, b.v[i] - o.v[i], axes[i]);
    }
    *out_error = fmax(*out_error, fmax(fabs(kg_len(u) - 1), fabs(kg_len(v) - 1)));
    return kg_len(kg_cross(u, v));
}

static void measure_surface(const kg_oa_sheet *s, double cell, kg_net_part *p) {
    kg_vec3 axes[5];
    double cells = 0;
    kg_oa_axes(KG_PI / 2, axes);
    for (int row = 0; row < s->rows; row++)
        for (int x = 0; x < s->width; x++) {
            bool whole = kg_oa_cell_shape(s, x, row) == KG_OA_WHOLE;
            for (int side = 0; side < (whole ? 1 : 2); side++) {
                kg_oa_piece piece = kg_oa_cell_piece(s, x, row, side);
                cells += (whole ? 1 : 0.5) * cell_area(&piece, axes, &p->isometry_error);
            }
        }
    p->surface = cells * cell * cell;
}

/* Outline, lines and measures. */
static kg_status fill(const kg_oa *oa, const kg_oa_sheet *s, kg_net *net, kg_error *error) {
    double cell = oa->cell_mm, w = s->width * cell, h = s->rows * cell;
    kg_vec2 outline[4] = {{0, 0}, {w, 0}, {w, h}, {0, h}};
    kg_oa_line *lines;
    size_t count, part;
    kg_status status = kg_oa_lines(s, &lines, &count, error);
    if (status)
        return status;
    status = kg_net_add_part(net, 0, oa->title, &part, error);
    if (!status)
        status = kg_net_add_loop(net, part, outline, NULL, 4, error);
    for (size_t i = 0; i < count && !status; i++)
        status = add_line(net, part, &lines[i], cell, error);
    free(lines);
    if (status)
        return status;
    kg_net_part *p = &net->parts[part];
    p->area = w * h;
    measure_surface(s, cell, p);
    p->perimeter = 2 * (w + h);
    net->title = strdup(oa->title);
    return net->title ? KG_OK : kg_fail(error, KG_ERR_MEMORY, "out of memory");
}

kg_status kg_oa_net(const kg_oa *oa, const kg_oa_sheet *sheet, kg_net **out_net, kg_error *error) {
    kg_net *net = kg_net_create();
    if (!net)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    kg_status status = fill(oa, sheet, net, error);
    if (status)
        kg_net_destroy(net);
    else
        *out_net = net;
    return status;
}
