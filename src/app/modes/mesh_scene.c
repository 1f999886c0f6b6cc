#include "app/modes/mesh_scene.h"

#include <stdlib.h>

/* Edges bent by more than 20 degrees are folds. */
#define CREASE 0.35

typedef struct stage {
    kg_shape *shape;
    uint64_t solved; /* the solution it shows */
} stage;

static kg_status upload(const kg_editor *e, kg_shape **out, kg_error *error) {
    kg_mesh *mesh;
    kg_surface surface;
    kg_status status = kg_document_mesh(e->document, NULL, &mesh, error);
    if (status)
        return status;
    status = kg_surface_from_mesh(mesh, 0, mesh->face_count, CREASE, &surface, error);
    if (!status) {
        status = kg_shape_from_surface(&surface, out, error);
        kg_surface_destroy(&surface);
    }
    kg_mesh_destroy(mesh);
    return status;
}

kg_status kg_mesh_scene_compose(void **cache, const kg_editor *e, kg_overlay *o, kg_error *error) {
    if (!*cache && !(*cache = calloc(1, sizeof(stage))))
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    stage *s = *cache;
    kg_status status = KG_OK;
    if (s->solved != e->solved) {
        kg_shape_destroy(s->shape);
        s->shape = NULL;
        status = upload(e, &s->shape, error);
        s->solved = e->solved;
    }
    kg_overlay_item(o, s->shape, kg_style_default((kg_color){0.93F, 0.92F, 0.88F, 1}));
    return status;
}

void kg_mesh_scene_drop(void *cache) {
    stage *s = cache;
    kg_shape_destroy(s->shape);
    free(s);
}

kg_box3 kg_mesh_scene_box(const kg_editor *e, bool selection) {
    (void)selection;
    kg_mesh *mesh;
    kg_error error;
    kg_box3 box = kg_box3_empty();
    if (!kg_document_mesh(e->document, NULL, &mesh, &error)) {
        box = kg_mesh_bounds(mesh);
        kg_mesh_destroy(mesh);
    }
    return box;
}
