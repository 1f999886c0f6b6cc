#include "app/surfaces.h"

#include "app/aim.h"
#include "base/array.h"

#include <stdlib.h>

static void clear_surface(kg_patch_surface *s) {
    for (size_t i = 0; i < s->piece_count; i++)
        kg_tessellation_clear(&s->pieces[i]);
    free(s->pieces);
    s->pieces = NULL;
    s->piece_count = 0;
}

static kg_status tessellate(const kg_solved_patch *p, kg_patch_surface *out) {
    out->pieces = calloc(p->regions.count + 1, sizeof *out->pieces);
    if (!out->pieces)
        return KG_ERR_MEMORY;
    for (size_t i = 0; i < p->regions.count; i++) {
        kg_status status = kg_region_tessellate(&p->patch, &p->regions.items[i],
                                                &out->pieces[out->piece_count], NULL);
        if (status == KG_ERR_MEMORY)
            return status;
        if (!status)
            out->piece_count++;
    }
    return KG_OK;
}

kg_status kg_surfaces_update(kg_surfaces *surfaces, const kg_solution *solution) {
    kg_surfaces old = *surfaces, now = {.last_revision = old.last_revision};
    kg_status status = KG_OK;
    size_t count = kg_solution_count(solution);
    if (!kg_reserve(&now, count))
        return KG_ERR_MEMORY;
    for (size_t i = 0; i < count; i++) {
        const kg_solved_patch *p = kg_solution_patch(solution, i);
        kg_patch_surface s = {.id = p->id, .signature = p->valid ? p->signature : 0};
        kg_patch_surface *before = NULL;
        for (size_t k = 0; k < old.count && !before; k++)
            if (old.items[k].id == p->id && old.items[k].signature == s.signature)
                before = &old.items[k];
        if (before) {
            s = *before;
            before->pieces = NULL;
            before->piece_count = 0;
        } else {
            s.revision = ++now.last_revision;
            if (p->valid && tessellate(p, &s))
                status = KG_ERR_MEMORY;
        }
        now.items[now.count++] = s;
    }
    kg_surfaces_clear(&old);
    *surfaces = now;
    return status;
}

const kg_patch_surface *kg_surfaces_find(const kg_surfaces *surfaces, int64_t id) {
    for (size_t i = 0; i < surfaces->count; i++)
        if (surfaces->items[i].id == id)
            return &surfaces->items[i];
    return NULL;
}

void kg_surfaces_clear(kg_surfaces *surfaces) {
    for (size_t i = 0; i < surfaces->count; i++)
        clear_surface(&surfaces->items[i]);
    free(surfaces->items);
    *surfaces = (kg_surfaces){.last_revision = surfaces->last_revision};
}

bool kg_surface_hit(const kg_patch_surface *surface, kg_vec3 origin, kg_vec3 direction,
                    kg_hit *out_hit) {
    const kg_ray ray = {origin, direction};
    kg_hit best = {.distance = INFINITY};
    for (size_t i = 0; i < surface->piece_count; i++) {
        const kg_tessellation *piece = &surface->pieces[i];
        for (size_t k = 0; k < piece->triangle_count; k++) {
            const kg_vertex *a = &piece->vertices[piece->triangles[3 * k]],
                            *b = &piece->vertices[piece->triangles[3 * k + 1]],
                            *c = &piece->vertices[piece->triangles[3 * k + 2]];
            const kg_vec3 triangle[] = {a->position, b->position, c->position};
            double t, s, r;
            if (!kg_ray_meets(&ray, triangle, &t, &s, &r) || t >= best.distance)
                continue;
            best = (kg_hit){.patch = surface->id, .piece = i, .distance = t};
            best.point = kg_madd(origin, t, direction);
        }
    }
    if (!isfinite(best.distance))
        return false;
    *out_hit = best;
    return true;
}
