#include "guide/sight.h"

#include <stdlib.h>
#include <string.h>

/* Rays start this far from a surface, over the size of what is shown, so that they do not meet it
 * again where they start. */
#define LIFT 0.003

/* Places looked at along each join. */
enum { JOIN_PLACES = 7 };

struct kg_sight {
    const kg_assembly *assembly;
    const kg_view_of *view;
    kg_mesh_query *query;
    double lift; /* mm */
};

static kg_vec3 offset_of(const kg_view_of *view, size_t part) {
    return view->roles[part] == KG_ROLE_NEW ? view->offset : kg_v3(0, 0, 0);
}

kg_vec3 kg_view_sample(const kg_assembly *assembly, const kg_view_of *view, size_t part,
                       size_t sample) {
    return kg_add(assembly->parts[part].samples[sample], offset_of(view, part));
}

kg_box3 kg_view_box(const kg_assembly *assembly, const kg_view_of *view, kg_role role) {
    kg_box3 box = kg_box3_empty();
    for (size_t i = 0; i < assembly->net->part_count; i++) {
        const kg_assembly_part *part = &assembly->parts[i];
        bool wanted = view->roles[i] != KG_ROLE_ABSENT && part->surface.vertex_count > 0 &&
                      (role == KG_ROLE_ABSENT || view->roles[i] == role);
        if (wanted) {
            kg_box3_add(&box, kg_add(part->box.lo, offset_of(view, i)));
            kg_box3_add(&box, kg_add(part->box.hi, offset_of(view, i)));
        }
    }
    return box;
}

/* All triangles shown, as one mesh. */
static kg_status mesh_of(const kg_assembly *assembly, const kg_view_of *view, kg_mesh *out) {
    size_t vertices = 0, triangles = 0;
    for (size_t i = 0; i < assembly->net->part_count; i++) {
        vertices += assembly->parts[i].surface.vertex_count;
        triangles += assembly->parts[i].surface.triangle_count;
    }
    kg_mesh mesh = {.positions = calloc(vertices + 1, sizeof *mesh.positions),
                    .face_starts = calloc(triangles + 1, sizeof *mesh.face_starts),
                    .face_corners = calloc(3 * triangles + 1, sizeof *mesh.face_corners)};
    *out = mesh;
    if (!mesh.positions || !mesh.face_starts || !mesh.face_corners)
        return KG_ERR_MEMORY;
    for (size_t i = 0; i < assembly->net->part_count; i++) {
        const kg_surface *s = &assembly->parts[i].surface;
        if (view->roles[i] == KG_ROLE_ABSENT)
            continue;
        for (size_t k = 0; k < 3 * s->triangle_count; k++)
            mesh.face_corners[3 * mesh.face_count + k] =
                (uint32_t)mesh.vertex_count + s->triangles[k];
        for (size_t k = 0; k < s->vertex_count; k++)
            mesh.positions[mesh.vertex_count + k] = kg_add(s->positions[k], offset_of(view, i));
        mesh.vertex_count += s->vertex_count;
        mesh.face_count += s->triangle_count;
    }
    for (size_t i = 0; i <= mesh.face_count; i++)
        mesh.face_starts[i] = (uint32_t)(3 * i);
    *out = mesh;
    return KG_OK;
}

kg_status kg_sight_create(const kg_assembly *assembly, const kg_view_of *view, kg_sight **out_sight,
                          kg_error *error) {
    kg_sight *sight = calloc(1, sizeof *sight);
    kg_mesh mesh = {0};
    kg_status status = sight ? mesh_of(assembly, view, &mesh) : KG_ERR_MEMORY;
    if (!status && mesh.face_count > 0)
        status = kg_mesh_query_create(&mesh, NULL, &sight->query, error);
    free(mesh.positions);
    free(mesh.face_starts);
    free(mesh.face_corners);
    if (status) {
        free(sight);
        return kg_fail(error, status, "out of memory");
    }
    sight->assembly = assembly;
    sight->view = view;
    sight->lift = LIFT * kg_box_size(kg_view_box(assembly, view, KG_ROLE_ABSENT));
    *out_sight = sight;
    return KG_OK;
}

void kg_sight_destroy(kg_sight *sight) {
    if (!sight)
        return;
    kg_mesh_query_destroy(sight->query);
    free(sight);
}

bool kg_sight_is_free(const kg_sight *sight, kg_vec3 point, kg_vec3 direction) {
    kg_mesh_hit hit;
    return !sight->query || !kg_mesh_query_ray(sight->query, kg_madd(point, sight->lift, direction),
                                               direction, &hit);
}

kg_vec3 kg_view_offset(const kg_assembly *assembly, int part, const int *joins, size_t join_count) {
    const kg_assembly_part *p = &assembly->parts[part];
    double size = kg_box_size(p->box), weight = 0;
    kg_vec3 middle = kg_v3(0, 0, 0);
    for (size_t i = 0; i < join_count; i++) {
        const kg_assembly_join *join = &assembly->joins[joins[i]];
        for (size_t k = 1; k < join->count; k++) {
            double length = kg_dist(join->points[k - 1], join->points[k]);
            middle = kg_madd(middle, length, kg_lerp(join->points[k - 1], join->points[k], 0.5));
            weight += length;
        }
    }
    if (weight == 0)
        return kg_v3(0, 0, 0);
    kg_vec3 away = kg_sub(p->center, kg_scale(middle, 1 / weight));
    if (kg_len(away) < 0.12 * size)
        away = p->front;
    return kg_scale(kg_unit(away), fmax(0.3 * size, 0.08 * kg_box_size(assembly->box)));
}

/* ---- where to look from ----------------------------------------------------------------- */

/* Share of the new parts' area that is seen: as large as it looks, the front preferred. */
static double area_seen(const kg_sight *sight, kg_vec3 back) {
    double seen = 0;
    size_t count = 0;
    for (size_t i = 0; i < sight->assembly->net->part_count; i++) {
        const kg_assembly_part *part = &sight->assembly->parts[i];
        if (sight->view->roles[i] != KG_ROLE_NEW)
            continue;
        count += part->sample_count;
        for (size_t k = 0; k < part->sample_count; k++) {
            double facing = kg_dot(part->normals[k], back);
            kg_vec3 at = kg_madd(kg_view_sample(sight->assembly, sight->view, i, k),
                                 facing > 0 ? sight->lift : -sight->lift, part->normals[k]);
            if (kg_sight_is_free(sight, at, back))
                seen += facing > 0 ? facing : -0.6 * facing;
        }
    }
    return count > 0 ? seen / (double)count : 0;
}

/* Share of the joins' length that is seen where they are glued. */
static double joins_seen(const kg_sight *sight, kg_vec3 back) {
    double seen = 0, total = 0;
    for (size_t i = 0; i < sight->view->join_count; i++) {
        int index = sight->view->joins[i];
        const kg_assembly_join *join = &sight->assembly->joins[index];
        double share = sight->assembly->net->joins[index].sides[0].length / JOIN_PLACES;
        for (size_t k = 0; k < JOIN_PLACES && join->count > 0; k++) {
            kg_vec3 at = join->points[(2 * k + 1) * (join->count - 1) / (2 * JOIN_PLACES)];
            total += share;
            seen += kg_sight_is_free(sight, at, back) ? share : 0;
        }
    }
    return total > 0 ? seen / total : 0;
}

void kg_sight_aim(const kg_sight *sight, kg_camera *camera) {
    enum { YAWS = 12 };
    static const double pitches[] = {-0.5, 0.15, 0.4, 0.8};
    kg_camera best = *camera;
    double best_score = -INFINITY;
    kg_vec3 right, up, before, back, move = kg_unit(sight->view->offset);
    kg_camera_axes(camera, &right, &up, &before);
    for (size_t p = 0; p < sizeof pitches / sizeof *pitches; p++)
        for (int y = 0; y < YAWS; y++) {
            kg_camera trial = *camera;
            trial.pitch = pitches[p];
            trial.yaw = camera->yaw + 2 * KG_PI * y / YAWS;
            kg_camera_axes(&trial, &right, &up, &back);
            double along = kg_dot(move, back);
            double score = 2.5 * area_seen(sight, back) + joins_seen(sight, back) +
                           0.2 * kg_dot(before, back) - 1.3 * along * along -
                           (trial.pitch < 0 ? 0.2 : 0);
            if (score > best_score + 1e-9) {
                best_score = score;
                best = trial;
            }
        }
    *camera = best;
}
