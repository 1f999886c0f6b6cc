/*
 * Which cell of the card a ray meets. In coordinates over (e1, f, b), which are affine at every
 * angle between flat and closed, uprights lie at whole y and levels at whole z, and in each such
 * plane the place (z, y) tells the row: one look-up for each plane. Pyramids are met piece by
 * piece.
 */
#include "oa/sheet.h"

/* Cards nearer than this to flat or closed, radians, are met as if they were this far from it: f
 * and b are independent then, and no corner of a card moves by more than a thousandth of a cell. */
static const double nudge = 1e-7;

/* Cells reach so far beyond their edges, in cells, that no ray slips between two. */
static const double slack = 1e-9;

typedef struct picker {
    const kg_oa_sheet *sheet;
    kg_vec3 origin, direction; /* over e1, f, b */
    double distance;           /* of what is met until now */
    int x, row, side;          /* x is -1: nothing is */
    bool printed;
} picker;

/* Whether the ray meets cell (x, row) where it says it is placed at `place`. */
static bool is_placed(const kg_oa_sheet *s, int x, int row, int32_t place) {
    return x >= 0 && x < s->width && row >= 0 && row < s->rows && kg_oa_bent(s, x, row) < 0 &&
           s->place[kg_oa_cell(s, x, row)] == place;
}

/* The two whole numbers that a coordinate may be counted to, alike but on an edge. */
static bool cells_at(double v, int end, int out[2]) {
    if (!(v > -1 && v < end + 1))
        return false;
    out[0] = (int)floor(v - slack);
    out[1] = (int)floor(v + slack);
    return true;
}

/* The plane of uprights at y = `at`, or of levels at z = `at`. */
static void meet_plane(picker *p, bool level, int at) {
    const kg_oa_sheet *s = p->sheet;
    double speed = level ? p->direction.z : p->direction.y;
    double distance = (at - (level ? p->origin.z : p->origin.y)) / speed;
    if (!(distance >= 0 && distance < p->distance))
        return;
    kg_vec3 point = kg_madd(p->origin, distance, p->direction);
    int columns[2], others[2];
    if (!cells_at(point.x, s->width, columns) ||
        !cells_at(level ? point.y : point.z, s->rows, others))
        return;
    for (int i = 0; i < 4; i++) {
        int x = columns[i & 1], other = others[i >> 1];
        int row = s->height - (level ? at - other : other + 1 - at);
        if (is_placed(s, x, row, kg_oa_place(level ? other : at, level))) {
            p->x = x, p->row = row, p->side = 0;
            p->distance = distance;
            p->printed = speed < 0;
            return;
        }
    }
}

/* ---- pyramids --------------------------------------------------------------------------- */

/* Möller and Trumbore (1997). */
static bool meet_triangle(const kg_vec3 corners[3], kg_vec3 origin, kg_vec3 direction,
                          double *out_distance, bool *out_printed) {
    kg_vec3 a = kg_sub(corners[1], corners[0]), b = kg_sub(corners[2], corners[0]);
    kg_vec3 h = kg_cross(direction, b), from = kg_sub(origin, corners[0]);
    double det = kg_dot(a, h);
    kg_vec3 q = kg_cross(from, a);
    double u = kg_dot(from, h) / det, v = kg_dot(direction, q) / det;
    if (!(u >= -slack && v >= -slack && u + v <= 1 + slack))
        return false;
    *out_distance = kg_dot(b, q) / det;
    *out_printed = det > 0;
    return true;
}

static void meet_piece(picker *p, const kg_vec3 world[2], const kg_vec3 axes[5], double cell, int x,
                       int row, int side) {
    const kg_oa_sheet *s = p->sheet;
    const kg_oa_outline *outline = &kg_oa_outlines[kg_oa_cell_shape(s, x, row)][side];
    kg_oa_piece piece = kg_oa_cell_piece(s, x, row, side);
    kg_vec3 corners[4];
    for (int i = 0; i < outline->count; i++) {
        kg_oa_tuple point =
            kg_oa_piece_point(&piece, outline->corners[i][0], -outline->corners[i][1]);
        corners[i] = kg_oa_place_point(&point, axes, s->margin, cell);
    }
    for (int i = 2; i < outline->count; i++) {
        const kg_vec3 triangle[3] = {corners[0], corners[i - 1], corners[i]};
        double distance;
        bool printed;
        if (meet_triangle(triangle, world[0], world[1], &distance, &printed) && distance >= 0 &&
            distance < p->distance) {
            p->x = x, p->row = row, p->side = side;
            p->distance = distance;
            p->printed = printed;
        }
    }
}

static void meet_pyramid(picker *p, const kg_vec3 world[2], const kg_vec3 axes[5], double cell,
                         const kg_oa_pyramid *pyramid) {
    const kg_oa_sheet *s = p->sheet;
    int middle = s->height - (pyramid->z - pyramid->y);
    for (int row = middle - pyramid->large; row < middle + pyramid->large; row++)
        for (int x = pyramid->first; x <= pyramid->last; x++)
            for (int side = 0; side < 2 && kg_oa_bent(s, x, row) >= 0; side++)
                meet_piece(p, world, axes, cell, x, row, side);
}

/* ---- all -------------------------------------------------------------------------------- */

/* The level whose front the cell is part of by the column's path, -1: none. */
static int level_of(const kg_oa *oa, int x, int row) {
    for (int z = 0; z < oa->height && x >= 0 && x < oa->width; z++)
        if (kg_oa_depth(oa, x, z) > 0 && kg_oa_front_row(oa, x, z) == row)
            return z;
    return -1;
}

/* From mm in the world of models to cells over e1, f, b. */
static kg_vec3 over_axes(kg_vec3 v, const kg_vec3 axes[5], double cell) {
    double z = v.z / (cell * axes[2].z);
    return kg_v3(v.x / cell, -v.y / cell - z * axes[2].y, z);
}

bool kg_oa_pick(const kg_oa *oa, const kg_oa_sheet *sheet, double open, kg_vec3 origin,
                kg_vec3 direction, kg_oa_hit *out_hit) {
    const double flat = KG_PI;
    const kg_vec3 world[2] = {origin, direction};
    kg_vec3 axes[5];
    kg_oa_axes(fmin(fmax(open, nudge), flat - nudge), axes);
    picker p = {.sheet = sheet,
                .origin = over_axes(origin, axes, oa->cell_mm),
                .direction = over_axes(direction, axes, oa->cell_mm),
                .distance = INFINITY,
                .x = -1};
    p.origin.x += sheet->margin;
    for (int y = 0; y <= sheet->depth; y++)
        meet_plane(&p, false, y);
    for (int z = 0; z <= sheet->height; z++)
        meet_plane(&p, true, z);
    for (size_t i = 0; i < sheet->pyramid_count; i++)
        meet_pyramid(&p, world, axes, oa->cell_mm, &sheet->pyramids[i]);
    if (p.x < 0)
        return false;
    kg_oa_piece piece = kg_oa_cell_piece(sheet, p.x, p.row, p.side);
    *out_hit = (kg_oa_hit){.x = p.x,
                           .row = p.row,
                           .side = p.side,
                           .plane = piece.plane,
                           .printed = p.printed,
                           .voxel = kg_oa_faced(sheet, p.x, p.row),
                           .level = level_of(oa, p.x - sheet->margin, p.row - sheet->margin),
                           .distance = p.distance};
    return true;
}
