/* The reference mesh, ready to be aimed at and to be shown. */
#ifndef KG_APP_BACKDROP_H
#define KG_APP_BACKDROP_H

#include "katagami/document.h"
#include "katagami/render.h"

typedef struct kg_backdrop {
    kg_mesh *mesh; /* NULL: none, or it could not be read */
    kg_mesh_query *query;
    kg_surface surface;
    uint64_t revision; /* another number for every mesh that was put here */
} kg_backdrop;

/* Reads the document's reference; an empty backdrop when it has none. It touches nothing else, so
 * any thread may do it. `progress` may be NULL. Errors: as kg_document_reference. */
kg_status kg_backdrop_load(const kg_document *document, const kg_progress *progress,
                           kg_backdrop *out_backdrop, kg_error *error) KG_CHECKED;
/* Leaves it empty, as another revision. */
void kg_backdrop_clear(kg_backdrop *backdrop);
/* Puts `from` in the place of what is here, and leaves it empty. */
void kg_backdrop_take(kg_backdrop *backdrop, kg_backdrop *from);

#endif
