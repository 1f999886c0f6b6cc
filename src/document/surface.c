/* Surfaces of documents as meshes. */
#include "document/document.h"

#include "base/color.h"
#include "model/edit.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static char *group_name(const kg_model_patch *p) {
    char number[32];
    snprintf(number, sizeof number, "patch %lld", (long long)p->id);
    return strdup(p->name[0] ? p->name : number);
}

/* A patch's own colour, "#rrggbb", as linear light; nothing when it has none. */
static void own_color(const kg_model_patch *p, float out_rgba[4]) {
    const char *text = kg_model_patch_color(p);
    unsigned rgb;
    if (!text || strlen(text) != 7 || sscanf(text, "#%6x", &rgb) != 1)
        return;
    for (int i = 0; i < 3; i++)
        out_rgba[i] = kg_linear_of_srgb((float)(rgb >> (16 - 8 * i) & 255) / 255);
}

/* The pieces of one patch as a mesh with one group. */
static kg_status mesh_of_patch(const kg_solved_patch *p, const kg_model_patch *model,
                               const float color[4], kg_mesh **out_mesh, kg_error *error) {
    kg_mesh *mesh = kg_mesh_create();
    kg_status status = mesh ? KG_OK : KG_ERR_MEMORY;
    for (size_t i = 0; i < p->regions.count && !status; i++) {
        kg_tessellation t;
        status = kg_region_tessellate(&p->patch, &p->regions.items[i], &t, error);
        if (status == KG_ERR_INPUT)
            kg_fail_in(error, status, "patch %lld: ", (long long)p->id);
        if (status)
            break;
        kg_mesh piece = {.vertex_count = t.vertex_count,
                         .positions = calloc(t.vertex_count + 1, sizeof *piece.positions),
                         .normals = calloc(t.vertex_count + 1, sizeof *piece.normals),
                         .face_count = t.triangle_count,
                         .face_starts = calloc(t.triangle_count + 1, sizeof *piece.face_starts),
                         .face_corners = t.triangles};
        if (piece.positions && piece.normals && piece.face_starts) {
            for (size_t k = 0; k < t.vertex_count; k++) {
                piece.positions[k] = t.vertices[k].position;
                piece.normals[k] = t.vertices[k].normal;
            }
            for (size_t k = 0; k <= t.triangle_count; k++)
                piece.face_starts[k] = (uint32_t)(3 * k);
            status = kg_mesh_append(mesh, &piece, error);
        } else {
            status = KG_ERR_MEMORY;
        }
        free(piece.positions);
        free(piece.normals);
        free(piece.face_starts);
        kg_tessellation_clear(&t);
    }
    if (!status) {
        free(mesh->groups); /* appending may have made room for none */
        mesh->groups = calloc(1, sizeof *mesh->groups);
        status = mesh->groups ? KG_OK : KG_ERR_MEMORY;
    }
    if (!status) {
        mesh->group_count = 1;
        mesh->groups[0].face_count = mesh->face_count;
        memcpy(mesh->groups[0].color, color, sizeof mesh->groups[0].color);
        mesh->groups[0].name = group_name(model);
        status = mesh->groups[0].name ? KG_OK : KG_ERR_MEMORY;
    }
    if (status) {
        kg_mesh_destroy(mesh);
        return status;
    }
    *out_mesh = mesh;
    return KG_OK;
}

static kg_status mesh_of_card(const kg_card *card, kg_group_color color, kg_mesh **out_mesh,
                              kg_error *error) {
    kg_status status =
        kg_oa_pose(card->oa, card->sheet, card->stability, card->open, out_mesh, error);
    for (size_t i = 0; !status && color && i < (*out_mesh)->group_count; i++)
        color(i, (*out_mesh)->groups[i].color);
    return status;
}

kg_status kg_document_mesh(const kg_document *d, kg_group_color color, kg_mesh **out_mesh,
                           kg_error *error) {
    if (d->folded)
        return kg_folded_mesh(d->folded, out_mesh, error);
    if (d->card)
        return mesh_of_card(d->card, color, out_mesh, error);
    kg_status status = kg_document_check(d, error);
    if (status)
        return status;
    kg_mesh *all = kg_mesh_create();
    if (!all)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    for (size_t i = 0; i < kg_solution_count(d->solution) && !status; i++) {
        const kg_solved_patch *p = kg_solution_patch(d->solution, i);
        float rgba[4] = {0.6F, 0.6F, 0.6F, 1};
        kg_mesh *mesh = NULL;
        if (p->construction)
            continue;
        if (color)
            color((size_t)(p->id - 1), rgba);
        own_color(&d->model->patches[i], rgba);
        status = mesh_of_patch(p, &d->model->patches[i], rgba, &mesh, error);
        if (!status)
            status = kg_mesh_append(all, mesh, error);
        kg_mesh_destroy(mesh);
    }
    if (status) {
        kg_mesh_destroy(all);
        return status == KG_ERR_MEMORY ? kg_fail(error, status, "out of memory") : status;
    }
    *out_mesh = all;
    return KG_OK;
}
