#include "document/folded.h"

#include "base/color.h"
#include "document/folding.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Of the drawn folded, over the size of the sheets: as thin as can be seen apart. */
#define THICKNESS 0.003

kg_folded *kg_folded_create(kg_origami *origami) {
    kg_folded *folded = calloc(1, sizeof *folded);
    if (!folded) {
        kg_origami_destroy(origami);
        return NULL;
    }
    folded->origami = origami;
    folded->step = kg_origami_step(origami);
    return folded;
}

void kg_folded_destroy(kg_folded *folded) {
    if (!folded)
        return;
    kg_origami_destroy(folded->origami);
    free(folded);
}

kg_status kg_folded_net(const kg_folded *folded, kg_document_net *out_net, kg_error *error) {
    kg_document_net net = {0};
    kg_status status =
        kg_origami_net(folded->origami, kg_origami_step(folded->origami), &net.net, error);
    if (!status)
        *out_net = net;
    return status;
}

/* ---- mesh ------------------------------------------------------------------------------- */

static float linear(uint32_t color, int shift) {
    return kg_linear_of_srgb((float)(color >> shift & 0xff) / 255.0F);
}

static kg_status add_group(kg_mesh *mesh, int32_t sheet, size_t first, uint32_t color) {
    char name[32];
    snprintf(name, sizeof name, "sheet %d", sheet + 1);
    kg_mesh_group *g = &mesh->groups[mesh->group_count];
    if (!(g->name = strdup(name)))
        return KG_ERR_MEMORY;
    g->first_face = first;
    g->face_count = mesh->face_count - first;
    for (int k = 0; k < 3; k++)
        g->color[k] = linear(color, 16 - 8 * k);
    g->color[3] = 1;
    mesh->group_count++;
    return KG_OK;
}

static size_t loop_size(const kg_origami_state *s, size_t loop) {
    int32_t first = s->loops.items[loop].first, h = first;
    size_t n = 0;
    do
        n++;
    while ((h = s->halves.items[h].next) != first);
    return n;
}

/* Every loop gets corners of its own; `corners` are those of all loops. */
static void add_loop(const kg_origami_state *s, size_t loop, const kg_vec3 *corners,
                     kg_mesh *mesh) {
    mesh->face_starts[mesh->face_count] = (uint32_t)mesh->vertex_count;
    for (size_t n = loop_size(s, loop); n > 0; n--) {
        mesh->face_corners[mesh->vertex_count] = (uint32_t)mesh->vertex_count;
        mesh->positions[mesh->vertex_count++] = *corners++;
    }
    mesh->face_starts[++mesh->face_count] = (uint32_t)mesh->vertex_count;
}

static kg_status fill_mesh(const kg_folded *folded, const kg_origami_state *s,
                           const kg_vec3 *corners, kg_mesh *mesh) {
    int32_t sheets = 0;
    for (size_t i = 0; i < s->loops.count; i++)
        sheets = s->loops.items[i].sheet >= sheets ? s->loops.items[i].sheet + 1 : sheets;
    mesh->groups = calloc((size_t)sheets + 1, sizeof *mesh->groups);
    kg_status status = mesh->groups ? KG_OK : KG_ERR_MEMORY;
    for (int32_t sheet = 0; sheet < sheets && !status; sheet++) {
        size_t first = mesh->face_count;
        for (size_t i = 0, at = 0; i < s->loops.count; at += loop_size(s, i++))
            if (s->loops.items[i].sheet == sheet)
                add_loop(s, i, corners + at, mesh);
        uint32_t front, back;
        kg_origami_colors(folded->origami, sheet, &front, &back);
        status = add_group(mesh, sheet, first, front);
    }
    return status;
}

/* Corners of all loops of a state at rest. */
static kg_status rest(const kg_origami_state *s, kg_vec3 *out, kg_error *error) {
    double *heights = calloc(s->halves.count + 1, sizeof *heights);
    kg_status status = heights ? kg_origami_heights(s, heights, error) : KG_ERR_MEMORY;
    for (size_t i = 0; i < s->loops.count && !status; i++) {
        kg_vec3 up = s->groups.items[s->loops.items[i].group].normal;
        int32_t h = s->loops.items[i].first;
        do {
            *out++ = kg_madd(s->vertices.items[s->halves.items[h].origin].position,
                             THICKNESS * s->size * heights[h], up);
        } while ((h = s->halves.items[h].next) != s->loops.items[i].first);
    }
    free(heights);
    return status;
}

/* … and in the middle of the fold that leads to it. */
static kg_status swing(const kg_folded *folded, const kg_origami_state *s, kg_vec3 *out,
                       kg_error *error) {
    kg_turning t;
    double weights[3];
    kg_status status = kg_turning_create(folded->origami, folded->step + 1, folded->step,
                                         THICKNESS * s->size, &t, error);
    if (status)
        return status;
    kg_turning_weights(&t, folded->fraction, weights);
    for (size_t i = 0; i < t.count; i++)
        out[i] =
            kg_madd(kg_madd(kg_madd(t.start[i], weights[0], t.radius[i]), weights[1], t.across[i]),
                    weights[2], t.settle[i]);
    kg_turning_clear(&t);
    return KG_OK;
}

kg_status kg_folded_mesh(const kg_folded *folded, kg_mesh **out_mesh, kg_error *error) {
    bool moving = folded->fraction > 0 && folded->step < kg_origami_step(folded->origami);
    const kg_origami_state *s =
        kg_origami_state_at(folded->origami, folded->step + (moving ? 1 : 0));
    kg_vec3 *corners = calloc(s->halves.count + 1, sizeof *corners);
    kg_mesh *mesh = kg_mesh_create();
    kg_status status = corners && mesh ? KG_OK : KG_ERR_MEMORY;
    if (!status)
        status = moving ? swing(folded, s, corners, error) : rest(s, corners, error);
    if (!status) {
        mesh->positions = calloc(s->halves.count + 1, sizeof *mesh->positions);
        mesh->face_corners = calloc(s->halves.count + 1, sizeof *mesh->face_corners);
        mesh->face_starts = calloc(s->loops.count + 1, sizeof *mesh->face_starts);
        status = mesh->positions && mesh->face_corners && mesh->face_starts
                     ? fill_mesh(folded, s, corners, mesh)
                     : KG_ERR_MEMORY;
    }
    free(corners);
    if (status) {
        kg_mesh_destroy(mesh);
        return status == KG_ERR_MEMORY ? kg_fail(error, status, "out of memory") : status;
    }
    *out_mesh = mesh;
    return KG_OK;
}

/* ---- motion ----------------------------------------------------------------------------- */

/* s for half a turn, and at rest before each fold and after the last. */
#define TURN_TIME 2.0
#define REST_TIME 0.5

static size_t key_count(double angle) {
    return (size_t)ceil(fabs(angle) * 180 / KG_PI / KG_FOLDING_KEY_DEG - 1e-9);
}

/* Corners as the mesh has them: loops in the order of their sheets. */
static void place_target(const kg_origami_state *s, const kg_vec3 *corners, kg_vec3 *out) {
    int32_t last = 0;
    for (size_t i = 0; i < s->loops.count; i++)
        last = s->loops.items[i].sheet > last ? s->loops.items[i].sheet : last;
    for (int32_t sheet = 0; sheet <= last; sheet++)
        for (size_t i = 0, at = 0; i < s->loops.count; at += loop_size(s, i++))
            for (size_t k = 0; k < loop_size(s, i) && s->loops.items[i].sheet == sheet; k++)
                *out++ = corners[at + k];
}

/* The keys of fold `index`, from `*time` and `*key` on. Folds to come keep what takes them back. */
static void add_keys(kg_mesh_motion *m, size_t folds, size_t index, const kg_turning *turnings,
                     size_t *key, double *time) {
    size_t steps = key_count(turnings[index].angle);
    for (size_t k = 0; k <= steps; k++) {
        double fraction = (double)k / (double)steps, now[3], end[3];
        double *weights = &m->weights[*key * m->target_count];
        for (size_t fold = index; fold < folds; fold++) {
            kg_turning_weights(&turnings[fold], fold == index ? fraction : 0, now);
            kg_turning_weights(&turnings[fold], 1, end);
            for (int i = 0; i < 3; i++)
                weights[3 * fold + (size_t)i] = now[i] - end[i];
        }
        m->times[(*key)++] = *time + fraction * TURN_TIME * fabs(turnings[index].angle) / KG_PI;
    }
    *time = m->times[*key - 1] + REST_TIME;
}

static kg_mesh_motion *join(const kg_origami_state *s, const kg_turning *turnings, size_t folds,
                            size_t vertices) {
    size_t keys = 2, key = 0;
    for (size_t i = 0; i < folds; i++)
        keys += key_count(turnings[i].angle) + 1;
    kg_mesh_motion *m = kg_mesh_motion_create(3 * folds, vertices, keys);
    if (!m)
        return NULL;
    for (size_t i = 0; i < folds; i++) {
        place_target(s, turnings[i].radius, m->displacements[3 * i]);
        place_target(s, turnings[i].across, m->displacements[3 * i + 1]);
        place_target(s, turnings[i].settle, m->displacements[3 * i + 2]);
    }
    double time = REST_TIME;
    key = 1;
    for (size_t i = 0; i < folds; i++)
        add_keys(m, folds, i, turnings, &key, &time);
    for (size_t i = 0; i < m->target_count; i++) /* at rest before the first fold */
        m->weights[i] = m->weights[m->target_count + i];
    m->times[key] = time; /* and after the last, where all weights are 0 */
    return m;
}

kg_status kg_folded_motion(const kg_folded *folded, kg_mesh **out_mesh, kg_mesh_motion **out_motion,
                           kg_error *error) {
    kg_folded still = *folded;
    still.fraction = 0;
    kg_mesh *mesh;
    kg_mesh_motion *motion = NULL;
    size_t folds = folded->step, made = 0;
    const kg_origami_state *s = kg_origami_state_at(folded->origami, folds);
    kg_turning *turnings = calloc(folds + 1, sizeof *turnings);
    kg_status status = turnings ? kg_folded_mesh(&still, &mesh, error)
                                : kg_fail(error, KG_ERR_MEMORY, "out of memory");
    if (status) {
        free(turnings);
        return status;
    }
    for (; made < folds && !status; made += !status)
        status = kg_turning_create(folded->origami, folds, made, THICKNESS * s->size,
                                   &turnings[made], error);
    if (!status && folds > 0 && !(motion = join(s, turnings, folds, mesh->vertex_count)))
        status = kg_fail(error, KG_ERR_MEMORY, "out of memory");
    while (made > 0)
        kg_turning_clear(&turnings[--made]);
    free(turnings);
    if (status) {
        kg_mesh_destroy(mesh);
        return status;
    }
    *out_mesh = mesh;
    *out_motion = motion;
    return KG_OK;
}
