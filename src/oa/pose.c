/*
 * The card in space: eq. 6, X = x, Y = y - z cos θ, Z = z sin θ, and for pyramids the vectors s and
 * r that bisect them (oa.h). With g = θ = π - open: f = (0,1,0), b = (0, -cos g, sin g),
 * a = (1 + cos g) / (3 - cos g), c = 2 / (3 - cos g), s = (a, c (f + b)), r = (a, -c (f + b)).
 */
#include "base/array.h"
#include "oa/sheet.h"

#include <stdlib.h>
#include <string.h>

void kg_oa_axes(double open, kg_vec3 out_axes[5]) {
    double g = KG_PI - open;
    double a = (1 + cos(g)) / (3 - cos(g)), c = 2 / (3 - cos(g));
    out_axes[0] = kg_v3(1, 0, 0);
    out_axes[1] = kg_v3(0, 1, 0);
    out_axes[2] = kg_v3(0, -cos(g), sin(g));
    out_axes[3] = kg_v3(a, c * (1 - cos(g)), c * sin(g));
    out_axes[4] = kg_v3(a, -c * (1 - cos(g)), -c * sin(g));
}

kg_vec3 kg_oa_place_point(const kg_oa_tuple *t, const kg_vec3 axes[5], int margin, double cell) {
    kg_vec3 p = kg_v3(-margin, 0, 0);
    for (int i = 0; i < 5; i++)
        p = kg_madd(p, t->v[i], axes[i]);
    return kg_v3(p.x * cell, -p.y * cell, p.z * cell);
}

/* ---- vertices and faces ----------------------------------------------------------------- */

typedef struct frame {
    const kg_oa_sheet *sheet;
    int32_t *heads; /* per lattice point of the sheet: its first vertex, -1: none */
    struct {
        kg_oa_tuple *items;
        size_t count, capacity;
    } tuples; /* of each vertex */
    struct {
        int32_t *items;
        size_t count, capacity;
    } nexts; /* of each vertex: another one at its lattice point */
    struct {
        uint32_t *items;
        size_t count, capacity;
    } corners, starts;
} frame;

/* The vertex where `tuple` lies and the sheet has the lattice point (x, row): neighbours that meet
 * there share it. */
static bool add_corner(frame *f, int x, int row, const kg_oa_tuple *tuple) {
    int32_t *head = &f->heads[(size_t)row * (size_t)(f->sheet->width + 1) + (size_t)x];
    int32_t v = *head;
    while (v >= 0 && !kg_oa_tuple_equal(&f->tuples.items[v], tuple))
        v = f->nexts.items[v];
    if (v < 0) {
        v = (int32_t)f->tuples.count;
        if (!kg_push(&f->tuples, *tuple) || !kg_push(&f->nexts, *head))
            return false;
        *head = v;
    }
    return kg_push(&f->corners, (uint32_t)v);
}

static bool add_face(frame *f, int x, int row, int side) {
    kg_oa_shape shape = kg_oa_cell_shape(f->sheet, x, row);
    kg_oa_piece piece = kg_oa_cell_piece(f->sheet, x, row, side);
    bool done = true;
    const kg_oa_outline *outline = &kg_oa_outlines[shape][side];
    for (int i = 0; i < outline->count && done; i++) {
        const int *c = outline->corners[i];
        kg_oa_tuple tuple = kg_oa_piece_point(&piece, c[0], -c[1]);
        done = add_corner(f, x + c[0], row + c[1], &tuple);
    }
    return done && kg_push(&f->starts, (uint32_t)f->corners.count);
}

/* Faces of the patches that are loose, or that are not. */
static bool add_faces(frame *f, const kg_oa_stability *stability, bool loose) {
    const kg_oa_sheet *s = f->sheet;
    for (int row = 0; row < s->rows; row++)
        for (int x = 0; x < s->width; x++) {
            int sides = kg_oa_cell_shape(s, x, row) == KG_OA_WHOLE ? 1 : 2;
            for (int side = 0; side < sides; side++) {
                bool stable = true;
                if (stability) {
                    size_t piece = 2 * kg_oa_cell(s, x, row) + (size_t)side;
                    stable = stability->patches[stability->patch_of[piece]].stable;
                }
                if (stable != loose && !add_face(f, x, row, side))
                    return false;
            }
        }
    return true;
}

static bool name_groups(kg_mesh *mesh, size_t fixed_faces) {
    static const char *const names[] = {"card", "loose"};
    static const float colors[2][4] = {{0.85F, 0.82F, 0.74F, 1}, {0.86F, 0.55F, 0.22F, 1}};
    size_t ends[] = {fixed_faces, mesh->face_count};
    mesh->groups = calloc(2, sizeof *mesh->groups);
    for (size_t i = 0, done = 0; i < 2 && mesh->groups; done = ends[i++]) {
        kg_mesh_group g = {
            .name = strdup(names[i]), .first_face = done, .face_count = ends[i] - done};
        memcpy(g.color, colors[i], sizeof g.color);
        if (!g.name)
            return false;
        if (g.face_count > 0)
            mesh->groups[mesh->group_count++] = g;
        else
            free(g.name);
    }
    return mesh->groups != NULL;
}

static void frame_clear(frame *f) {
    free(f->heads);
    free(f->tuples.items);
    free(f->nexts.items);
    free(f->corners.items);
    free(f->starts.items);
}

/* Fills the frame and makes the mesh of it; the frame keeps the vertices' tuples. */
static bool build(const kg_oa *oa, frame *f, const kg_oa_stability *stability, double open,
                  kg_mesh *mesh) {
    const kg_oa_sheet *s = f->sheet;
    size_t points = (size_t)(s->width + 1) * (size_t)(s->rows + 1);
    f->heads = malloc(points * sizeof *f->heads);
    if (!f->heads || !kg_push(&f->starts, 0))
        return false;
    for (size_t i = 0; i < points; i++)
        f->heads[i] = -1;
    if (!add_faces(f, stability, false))
        return false;
    size_t fixed_faces = f->starts.count - 1;
    if (!add_faces(f, stability, true))
        return false;
    mesh->positions = malloc(f->tuples.count * sizeof *mesh->positions);
    if (!mesh->positions)
        return false;
    kg_vec3 axes[5];
    kg_oa_axes(open, axes);
    for (size_t i = 0; i < f->tuples.count; i++)
        mesh->positions[i] = kg_oa_place_point(&f->tuples.items[i], axes, s->margin, oa->cell_mm);
    mesh->vertex_count = f->tuples.count;
    mesh->face_count = f->starts.count - 1;
    mesh->face_starts = f->starts.items;
    mesh->face_corners = f->corners.items;
    f->starts.items = f->corners.items = NULL;
    return name_groups(mesh, fixed_faces);
}

kg_status kg_oa_pose(const kg_oa *oa, const kg_oa_sheet *sheet, const kg_oa_stability *stability,
                     double open, kg_mesh **out_mesh, kg_error *error) {
    frame f = {.sheet = sheet};
    kg_mesh *mesh = kg_mesh_create();
    bool done = mesh && build(oa, &f, stability, open, mesh);
    frame_clear(&f);
    if (!done) {
        kg_mesh_destroy(mesh);
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    }
    *out_mesh = mesh;
    return KG_OK;
}

/* ---- motion ----------------------------------------------------------------------------- */

enum { TARGETS = 5, PLAIN_TARGETS = 2, STEPS = 90 };

/* A full cycle of the motion, s. */
static const double cycle = 6;

/* With x, y, z, p, q the multiples of e1, f, b, s, r, a point is (x, y, 0) plus these
 * displacements … */
static void displace(const kg_oa_tuple *t, double cell, kg_vec3 out[TARGETS]) {
    double z = t->v[2] * cell, sum = (t->v[3] + t->v[4]) * cell,
           difference = (t->v[3] - t->v[4]) * cell;
    out[0] = kg_v3(0, z, 0);
    out[1] = kg_v3(0, 0, z);
    out[2] = kg_v3(sum, 0, 0);
    out[3] = kg_v3(0, -difference, 0);
    out[4] = kg_v3(0, 0, difference);
}

/* … times these weights. */
static void weigh(double open, double out[TARGETS]) {
    kg_vec3 axes[5];
    kg_oa_axes(open, axes);
    out[0] = -axes[2].y; /* cos g */
    out[1] = axes[2].z;  /* sin g */
    out[2] = axes[3].x;  /* a */
    out[3] = axes[3].y;  /* c (1 - cos g) */
    out[4] = axes[3].z;  /* c sin g */
}

static kg_mesh_motion *motion_of(const frame *f, double cell, double open) {
    size_t targets = f->sheet->bent ? TARGETS : PLAIN_TARGETS, keys = 2 * STEPS + 1;
    kg_mesh_motion *m = kg_mesh_motion_create(targets, f->tuples.count, keys);
    double start[TARGETS], now[TARGETS];
    if (!m)
        return NULL;
    for (size_t v = 0; v < f->tuples.count; v++) {
        kg_vec3 d[TARGETS];
        displace(&f->tuples.items[v], cell, d);
        for (size_t i = 0; i < targets; i++)
            m->displacements[i][v] = d[i];
    }
    weigh(open, start);
    for (size_t k = 0; k < keys; k++) {
        double closing = 1 - fabs(1 - (double)k / STEPS); /* 0 … 1 … 0 */
        weigh(KG_PI * (1 - closing), now);
        m->times[k] = cycle * (double)k / (2 * STEPS);
        for (size_t i = 0; i < targets; i++)
            m->weights[k * targets + i] = now[i] - start[i];
    }
    return m;
}

kg_status kg_oa_motion(const kg_oa *oa, const kg_oa_sheet *sheet, const kg_oa_stability *stability,
                       double open, kg_mesh **out_mesh, kg_mesh_motion **out_motion,
                       kg_error *error) {
    frame f = {.sheet = sheet};
    kg_mesh *mesh = kg_mesh_create();
    kg_mesh_motion *motion = NULL;
    if (mesh && build(oa, &f, stability, open, mesh))
        motion = motion_of(&f, oa->cell_mm, open);
    frame_clear(&f);
    if (!motion) {
        kg_mesh_destroy(mesh);
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    }
    *out_mesh = mesh;
    *out_motion = motion;
    return KG_OK;
}
