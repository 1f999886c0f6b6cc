/* Surfaces and crease patterns of documents as files. */
#include "document/document.h"

#include "base/file.h"

#include <stdlib.h>
#include <string.h>

static kg_status export_fold(const kg_document *d, const char *path, kg_error *error) {
    char *text;
    if (d->folded)
        return kg_origami_export(d->folded->origami, d->folded->step, true, path, error);
    if (d->kind != KG_DOCUMENT_OA)
        return kg_fail(error, KG_ERR_INPUT,
                       "%s: curved patches have no crease pattern; FOLD is for pop-up cards and "
                       "folded sheets",
                       path);
    kg_status status = kg_oa_fold(d->card->oa, d->card->sheet, &text, error);
    if (status)
        return status;
    status = kg_file_write(path, text, strlen(text), error);
    free(text);
    return status;
}

/* Sheets are folded fold by fold. */
static kg_status export_folding(const kg_document *d, const char *path, kg_error *error) {
    kg_mesh *mesh;
    kg_mesh_motion *motion;
    kg_status status = kg_folded_motion(d->folded, &mesh, &motion, error);
    if (status)
        return status;
    status =
        motion ? kg_mesh_write_moving(path, mesh, motion, error) : kg_mesh_write(path, mesh, error);
    kg_mesh_destroy(mesh);
    kg_mesh_motion_destroy(motion);
    return status;
}

/* A card's mesh folds up and open again. */
static kg_status export_motion(const kg_document *d, const char *path, kg_error *error) {
    const kg_card *card = d->card;
    kg_mesh *mesh;
    kg_mesh_motion *motion;
    kg_status status =
        kg_oa_motion(card->oa, card->sheet, card->stability, card->open, &mesh, &motion, error);
    if (status)
        return status;
    status = kg_mesh_write_moving(path, mesh, motion, error);
    kg_mesh_destroy(mesh);
    kg_mesh_motion_destroy(motion);
    return status;
}

kg_status kg_document_export(const kg_document *d, const char *path, kg_group_color color,
                             kg_error *error) {
    kg_mesh_format format;
    kg_mesh *mesh;
    if (kg_file_ends_in(path, ".fold") || (d->folded && kg_file_ends_in(path, ".cp")))
        return export_fold(d, path, error);
    kg_status status = kg_mesh_format_of(path, &format, error);
    if (status)
        return status;
    if (d->kind == KG_DOCUMENT_OA && (format == KG_MESH_GLTF || format == KG_MESH_GLB))
        return export_motion(d, path, error);
    if (d->folded && d->folded->fraction == 0 && (format == KG_MESH_GLTF || format == KG_MESH_GLB))
        return export_folding(d, path, error);
    status = kg_document_mesh(d, color, &mesh, error);
    if (status)
        return status;
    status = kg_mesh_write(path, mesh, error);
    kg_mesh_destroy(mesh);
    return status;
}
