#include "app/backdrop.h"

#include "base/progress.h"

/* Edges of the reference bent by more than 35 degrees are edges of the object. */
#define CREASE 0.61

/* When the mesh is read and when its search tree stands, as shares of the whole. */
#define READ 0.25
#define TREE 0.75

kg_status kg_backdrop_load(const kg_document *document, const kg_progress *progress,
                           kg_backdrop *out_backdrop, kg_error *error) {
    kg_progress_share shares[] = {{progress, 0, READ}, {progress, READ, TREE}, {progress, TREE, 1}};
    kg_progress read = kg_progress_of_share(&shares[0]), tree = kg_progress_of_share(&shares[1]),
                surface = kg_progress_of_share(&shares[2]);
    kg_backdrop b = {0};
    kg_status status = kg_document_reference(document, &read, &b.mesh, error);
    if (!status && b.mesh)
        status = kg_mesh_query_create(b.mesh, &tree, &b.query, error);
    if (!status && b.mesh)
        status = kg_surface_from_mesh(b.mesh, 0, b.mesh->face_count, CREASE, &surface, &b.surface,
                                      error);
    if (status)
        kg_backdrop_clear(&b);
    else
        *out_backdrop = b;
    return status;
}

void kg_backdrop_clear(kg_backdrop *b) {
    kg_mesh_destroy(b->mesh);
    kg_mesh_query_destroy(b->query);
    kg_surface_destroy(&b->surface);
    *b = (kg_backdrop){.revision = b->revision + 1};
}

void kg_backdrop_take(kg_backdrop *b, kg_backdrop *from) {
    kg_backdrop_clear(b);
    uint64_t revision = b->revision;
    *b = *from;
    b->revision = revision;
    *from = (kg_backdrop){0};
}
