/* Motions of meshes: their memory. */
#include "katagami/mesh.h"

#include <stdlib.h>

kg_mesh_motion *kg_mesh_motion_create(size_t target_count, size_t vertex_count, size_t key_count) {
    kg_mesh_motion *m = calloc(1, sizeof *m);
    if (!m || (target_count > 0 && key_count > SIZE_MAX / target_count)) {
        free(m);
        return NULL;
    }
    m->key_count = key_count;
    m->displacements = calloc(target_count + 1, sizeof *m->displacements);
    m->times = calloc(key_count + 1, sizeof *m->times);
    m->weights = calloc(key_count * target_count + 1, sizeof *m->weights);
    bool done = m->displacements && m->times && m->weights;
    for (size_t i = 0; i < target_count && done; i++) {
        m->target_count++;
        m->displacements[i] = calloc(vertex_count + 1, sizeof **m->displacements);
        done = m->displacements[i] != NULL;
    }
    if (done)
        return m;
    kg_mesh_motion_destroy(m);
    return NULL;
}

void kg_mesh_motion_destroy(kg_mesh_motion *motion) {
    if (!motion)
        return;
    for (size_t i = 0; motion->displacements && i < motion->target_count; i++)
        free(motion->displacements[i]);
    free(motion->displacements);
    free(motion->times);
    free(motion->weights);
    free(motion);
}
