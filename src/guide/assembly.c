#include "guide/assembly.h"

#include "document/document.h"
#include "guide/bend.h"
#include "unroll/stretch.h"

#include <stdlib.h>
#include <string.h>

double kg_box_size(kg_box3 box) {
    return box.lo.x > box.hi.x ? 0 : kg_dist(box.lo, box.hi);
}

/* ---- which piece is in which part --------------------------------------------------------- */

static int root_of(int *parent, int i) {
    while (parent[i] != i)
        i = parent[i] = parent[parent[i]];
    return i;
}

/* The net's join with a printed number, or -1: seams that became folds of one part are gone. */
static int join_numbered(const kg_net *net, int number) {
    for (size_t i = 0; i < net->join_count; i++)
        if (net->joins[i].number == number)
            return (int)i;
    return -1;
}

/* Stretches become joins in their order, numbered from 1, a seam with the first of its two. */
static bool makes_join(const kg_pieces *pieces, size_t stretch) {
    const kg_stretch *s = &pieces->stretches[stretch];
    return !s->single && !(s->mate < stretch && pieces->stretches[s->mate].mate == stretch);
}

/* Names the part of each piece, or -1: pieces held together by seams that are joins no more are one
 * part, and the joins that are left tell which. */
static void find_parts(const kg_pieces *pieces, const kg_net *net, int *out, int *parent) {
    int number = 0;
    for (size_t i = 0; i < pieces->count; i++) {
        parent[i] = (int)i;
        out[i] = -1;
    }
    for (size_t i = 0; i < pieces->stretch_count; i++)
        if (makes_join(pieces, i) && join_numbered(net, ++number) < 0) {
            const kg_stretch *s = &pieces->stretches[i];
            parent[root_of(parent, (int)s->edge.piece)] = root_of(parent, (int)s->partner.piece);
        }
    number = 0;
    for (size_t i = 0; i < pieces->stretch_count; i++) {
        int join = makes_join(pieces, i) ? join_numbered(net, ++number) : -1;
        if (join < 0)
            continue;
        const kg_stretch *s = &pieces->stretches[i];
        out[root_of(parent, (int)s->edge.piece)] = net->joins[join].sides[0].part;
        out[root_of(parent, (int)s->partner.piece)] = net->joins[join].sides[1].part;
    }
    /* what is joined to nothing keeps its order */
    size_t part = 0;
    for (size_t i = 0; i < pieces->count; i++) {
        if (root_of(parent, (int)i) != (int)i || out[i] >= 0)
            continue;
        while (part < net->part_count && net->parts[part].source != pieces->items[i].patch->id)
            part++;
        if (part < net->part_count)
            out[i] = (int)part++;
    }
    for (size_t i = 0; i < pieces->count; i++)
        out[i] = out[root_of(parent, (int)i)];
}

/* ---- surfaces --------------------------------------------------------------------------- */

static bool grow(void **items, size_t count, size_t more, size_t size) {
    void *bigger = realloc(*items, (count + more + 1) * size);
    if (bigger)
        *items = bigger;
    return bigger != NULL;
}

static kg_status add_piece(const kg_piece *piece, kg_assembly_part *part, kg_error *error) {
    kg_tessellation t;
    kg_surface *s = &part->surface;
    kg_status status = kg_region_tessellate(&piece->patch->patch, piece->region, &t, error);
    if (status)
        return status;
    if (!grow((void **)&s->positions, s->vertex_count, t.vertex_count, sizeof *s->positions) ||
        !grow((void **)&s->normals, s->vertex_count, t.vertex_count, sizeof *s->normals) ||
        !grow((void **)&s->triangles, 3 * s->triangle_count, 3 * t.triangle_count,
              sizeof *s->triangles)) {
        kg_tessellation_clear(&t);
        return KG_ERR_MEMORY;
    }
    for (size_t i = 0; i < t.vertex_count; i++) {
        s->positions[s->vertex_count + i] = t.vertices[i].position;
        s->normals[s->vertex_count + i] = t.vertices[i].normal;
        kg_box3_add(&part->box, t.vertices[i].position);
    }
    for (size_t i = 0; i < 3 * t.triangle_count; i++)
        s->triangles[3 * s->triangle_count + i] = (uint32_t)s->vertex_count + t.triangles[i];
    s->vertex_count += t.vertex_count;
    s->triangle_count += t.triangle_count;
    kg_bend bend = kg_bend_of(&piece->patch->patch, &t);
    part->radius_in = fmin(part->radius_in, bend.radius_in);
    part->radius_out = fmin(part->radius_out, bend.radius_out);
    part->piece_count++;
    kg_tessellation_clear(&t);
    return KG_OK;
}

/* Spreads the samples over the area: each stands for an equal share of it, in the order of the
 * triangles, at places that do not line up. */
static void spread_samples(kg_assembly_part *part) {
    const kg_surface *s = &part->surface;
    double total = 0, passed = 0, share;
    for (size_t pass = 0; pass < 2; pass++) {
        share = total / KG_ASSEMBLY_SAMPLES;
        for (size_t i = 0; i < s->triangle_count; i++) {
            const uint32_t *c = &s->triangles[3 * i];
            kg_vec3 a = s->positions[c[0]], b = s->positions[c[1]], d = s->positions[c[2]];
            kg_vec3 normal = kg_cross(kg_sub(b, a), kg_sub(d, a));
            double area = kg_len(normal) / 2;
            if (pass == 0) {
                total += area;
                part->center = kg_madd(part->center, area / 3, kg_add(a, kg_add(b, d)));
                part->front = kg_madd(part->front, 0.5, normal);
                continue;
            }
            passed += area;
            while (share > 0 && part->sample_count < KG_ASSEMBLY_SAMPLES &&
                   passed >= ((double)part->sample_count + 0.5) * share) {
                size_t n = part->sample_count++;
                /* Roberts (2018), "The unreasonable effectiveness of quasirandom sequences" */
                double p = fmod(0.5 + 0.7548776662466927 * (double)n, 1);
                double q = fmod(0.5 + 0.5698402909980532 * (double)n, 1);
                if (p + q > 1)
                    p = 1 - p, q = 1 - q;
                part->samples[n] = kg_madd(kg_madd(a, p, kg_sub(b, a)), q, kg_sub(d, a));
                part->normals[n] = kg_unit(normal);
            }
        }
    }
    if (total > 0) {
        part->center = kg_scale(part->center, 1 / total);
        part->front = kg_scale(part->front, 1 / total);
    }
}

/* ---- joins ------------------------------------------------------------------------------ */

/* Is the stretch's paper on the back of the part that it touches? */
static bool is_inside(const kg_pieces *pieces, const kg_stretch *s) {
    enum { PLACES = 9 };
    int back = 0;
    const kg_patch *a = kg_piece_patch(pieces, s->edge.piece);
    for (int i = 0; i < PLACES; i++) {
        kg_cross_point slope;
        double position = s->from + (i + 0.5) / PLACES * (s->to - s->from);
        kg_cross_point at = kg_piece_point(pieces, s->edge, position, &slope);
        /* the paper lies on the left of the loop in the (u,v) plane, which is seen from the back of
         * an unflipped patch */
        kg_vec3 inward = kg_scale(kg_cross(kg_patch_normal(a, at.v), slope.x), a->flip ? 1 : -1);
        back += kg_dot(inward, kg_patch_normal(kg_piece_patch(pieces, s->partner.piece), at.t)) < 0;
    }
    return 2 * back > PLACES;
}

static kg_status add_join(const kg_pieces *pieces, const kg_stretch *s, kg_assembly_join *out) {
    size_t capacity = (size_t)(s->to - s->from) + 3;
    out->points = calloc(capacity, sizeof *out->points);
    if (!out->points)
        return KG_ERR_MEMORY;
    for (double position = s->from;; position = fmin(floor(position) + 1, s->to)) {
        out->points[out->count++] = kg_piece_point(pieces, s->edge, position, NULL).x;
        if (position >= s->to || out->count == capacity)
            break;
    }
    out->inside = !s->seam && is_inside(pieces, s);
    return KG_OK;
}

static kg_status add_joins(const kg_pieces *pieces, kg_assembly *assembly) {
    int number = 0;
    for (size_t i = 0; i < pieces->stretch_count; i++) {
        int join = makes_join(pieces, i) ? join_numbered(assembly->net, ++number) : -1;
        if (join >= 0 && add_join(pieces, &pieces->stretches[i], &assembly->joins[join]))
            return KG_ERR_MEMORY;
    }
    return KG_OK;
}

/* ---- all -------------------------------------------------------------------------------- */

static kg_status fill(const kg_pieces *pieces, const int *parts, kg_assembly *out,
                      kg_error *error) {
    kg_status status = KG_OK;
    size_t n = out->net->part_count;
    for (size_t i = 0; i < n; i++) {
        out->parts[i].box = kg_box3_empty();
        out->parts[i].radius_in = out->parts[i].radius_out = INFINITY;
    }
    for (size_t i = 0; i < pieces->count && !status; i++)
        if (parts[i] >= 0)
            status = add_piece(&pieces->items[i], &out->parts[parts[i]], error);
    for (size_t i = 0; i < pieces->count && !status; i++) {
        /* a part of several pieces does not lie on paper as they do */
        if (parts[i] >= 0 && out->parts[parts[i]].piece_count == 1)
            status = kg_bend_rulings(&pieces->items[i].patch->patch, pieces->items[i].region,
                                     &out->parts[parts[i]]);
    }
    out->box = kg_box3_empty();
    for (size_t i = 0; i < n && !status; i++) {
        spread_samples(&out->parts[i]);
        if (out->parts[i].surface.vertex_count > 0) {
            kg_box3_add(&out->box, out->parts[i].box.lo);
            kg_box3_add(&out->box, out->parts[i].box.hi);
        }
    }
    return status ? status : add_joins(pieces, out);
}

/* Parts are made from one patch each, or merged into that of one. */
static void add_colors(const kg_model *model, kg_assembly *out) {
    for (size_t i = 0; i < out->net->part_count; i++) {
        const kg_model_patch *p = kg_model_find(model, out->net->parts[i].source);
        out->parts[i].color = p ? kg_patch_color(p) : kg_palette(i);
    }
}

kg_status kg_assembly_create(const kg_document *document, const kg_net *net, kg_vec2 room,
                             kg_assembly **out_assembly, kg_error *error) {
    kg_pieces pieces = {0};
    int *parts = NULL, *parent = NULL;
    kg_assembly *out = calloc(1, sizeof *out);
    kg_status status = KG_ERR_MEMORY;
    if (out) {
        out->net = net;
        out->parts = calloc(net->part_count + 1, sizeof *out->parts);
        out->joins = calloc(net->join_count + 1, sizeof *out->joins);
        if (out->parts && out->joins)
            status = kg_pieces_create(document->model, document->solution, room, &pieces);
    }
    if (!status)
        status = kg_pieces_find_stretches(&pieces);
    if (!status) {
        parts = calloc(pieces.count + 1, sizeof *parts);
        parent = calloc(pieces.count + 1, sizeof *parent);
        status = parts && parent ? KG_OK : KG_ERR_MEMORY;
    }
    if (!status) {
        find_parts(&pieces, net, parts, parent);
        add_colors(document->model, out);
        status = fill(&pieces, parts, out, error);
    }
    free(parts);
    free(parent);
    kg_pieces_clear(&pieces);
    if (status) {
        kg_assembly_destroy(out);
        return status == KG_ERR_MEMORY ? kg_fail(error, status, "out of memory") : status;
    }
    *out_assembly = out;
    return KG_OK;
}

void kg_assembly_destroy(kg_assembly *assembly) {
    if (!assembly)
        return;
    for (size_t i = 0; assembly->parts && i < assembly->net->part_count; i++) {
        kg_surface_destroy(&assembly->parts[i].surface);
        free(assembly->parts[i].rulings);
    }
    for (size_t i = 0; assembly->joins && i < assembly->net->join_count; i++)
        free(assembly->joins[i].points);
    free(assembly->parts);
    free(assembly->joins);
    free(assembly);
}
