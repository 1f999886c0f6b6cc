#include "document/folded.h"

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

static float linear(uint32_t colour, int shift) {
    float x = (float)(colour >> shift & 0xff) / 255.0F;
    return x <= 0.04045F ? x / 12.92F : powf((x + 0.055F) / 1.055F, 2.4F);
}

static kg_status add_group(kg_mesh *mesh, int32_t sheet, size_t first, uint32_t colour) {
    char name[32];
    snprintf(name, sizeof name, "sheet %d", sheet + 1);
    kg_mesh_group *g = &mesh->groups[mesh->group_count];
    if (!(g->name = strdup(name)))
        return KG_ERR_MEMORY;
    g->first_face = first;
    g->face_count = mesh->face_count - first;
    for (int k = 0; k < 3; k++)
        g->color[k] = linear(colour, 16 - 8 * k);
    g->color[3] = 1;
    mesh->group_count++;
    return KG_OK;
}

/* Every loop gets corners of its own. */
static void add_loop(const kg_origami_state *s, size_t loop, const double *heights, kg_mesh *mesh) {
    int32_t first = s->loops.items[loop].first, h = first;
    kg_vec3 up = s->groups.items[s->loops.items[loop].group].normal;
    mesh->face_starts[mesh->face_count] = (uint32_t)mesh->vertex_count;
    do {
        const kg_half_edge *half = &s->halves.items[h];
        mesh->face_corners[mesh->vertex_count] = (uint32_t)mesh->vertex_count;
        mesh->positions[mesh->vertex_count++] =
            kg_madd(s->vertices.items[half->origin].position, THICKNESS * s->size * heights[h], up);
        h = half->next;
    } while (h != first);
    mesh->face_starts[++mesh->face_count] = (uint32_t)mesh->vertex_count;
}

static kg_status fill_mesh(const kg_folded *folded, const kg_origami_state *s,
                           const double *heights, kg_mesh *mesh) {
    int32_t sheets = 0;
    for (size_t i = 0; i < s->loops.count; i++)
        sheets = s->loops.items[i].sheet >= sheets ? s->loops.items[i].sheet + 1 : sheets;
    mesh->groups = calloc((size_t)sheets + 1, sizeof *mesh->groups);
    kg_status status = mesh->groups ? KG_OK : KG_ERR_MEMORY;
    for (int32_t sheet = 0; sheet < sheets && !status; sheet++) {
        size_t first = mesh->face_count;
        for (size_t i = 0; i < s->loops.count; i++)
            if (s->loops.items[i].sheet == sheet)
                add_loop(s, i, heights, mesh);
        uint32_t front, back;
        kg_origami_colours(folded->origami, sheet, &front, &back);
        status = add_group(mesh, sheet, first, front);
    }
    return status;
}

kg_status kg_folded_mesh(const kg_folded *folded, kg_mesh **out_mesh, kg_error *error) {
    const kg_origami_state *s = kg_origami_state_at(folded->origami, folded->step);
    double *heights = calloc(s->halves.count + 1, sizeof *heights);
    kg_mesh *mesh = kg_mesh_create();
    kg_status status = heights && mesh ? kg_origami_heights(s, heights, error) : KG_ERR_MEMORY;
    if (!status) {
        mesh->positions = calloc(s->halves.count + 1, sizeof *mesh->positions);
        mesh->face_corners = calloc(s->halves.count + 1, sizeof *mesh->face_corners);
        mesh->face_starts = calloc(s->loops.count + 1, sizeof *mesh->face_starts);
        status = mesh->positions && mesh->face_corners && mesh->face_starts
                     ? fill_mesh(folded, s, heights, mesh)
                     : KG_ERR_MEMORY;
    }
    free(heights);
    if (status) {
        kg_mesh_destroy(mesh);
        return status == KG_ERR_MEMORY ? kg_fail(error, status, "out of memory") : status;
    }
    *out_mesh = mesh;
    return KG_OK;
}
