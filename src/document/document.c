#include "katagami/document.h"

#include "document/document.h"

#include <stdlib.h>
#include <string.h>

kg_status kg_document_from_model(kg_model *model, const char *path, kg_document **out_document,
                                 kg_error *error) {
    kg_document *d = calloc(1, sizeof *d);
    if (d && path)
        d->path = strdup(path);
    if (!d || (path && !d->path)) {
        free(d);
        kg_model_destroy(model);
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    }
    d->kind = KG_DOCUMENT_PATCHES;
    d->model = model;
    *out_document = d;
    return KG_OK;
}

kg_status kg_document_read(const char *path, kg_document **out_document, kg_error *error) {
    kg_model *model;
    kg_status status = kg_model_read(path, &model, error);
    return status ? status : kg_document_from_model(model, path, out_document, error);
}

void kg_document_destroy(kg_document *d) {
    if (!d)
        return;
    kg_model_destroy(d->model);
    kg_solution_destroy(d->solution);
    free(d->path);
    free(d);
}

kg_document_kind kg_document_get_kind(const kg_document *d) {
    return d->kind;
}

const char *kg_document_title(const kg_document *d) {
    return d->model->title;
}

kg_model *kg_document_model(kg_document *d) {
    return d->model;
}

kg_status kg_document_solve(kg_document *d, double chord, kg_error *error) {
    kg_solution *previous = d->solution;
    d->solution = NULL;
    return kg_solution_create(d->model, chord, previous, &d->solution, error);
}

const kg_solution *kg_document_solution(const kg_document *d) {
    return d->solution;
}

size_t kg_document_issue_count(const kg_document *d) {
    return kg_solution_issue_count(d->solution);
}

const kg_issue *kg_document_issue(const kg_document *d, size_t index) {
    return kg_solution_issue(d->solution, index);
}

kg_status kg_document_check(const kg_document *d, kg_error *error) {
    kg_status status = kg_solution_check(d->solution, error);
    return status && d->path ? kg_fail_in(error, status, "%s: ", d->path) : status;
}

/* ---- reference -------------------------------------------------------------------------- */

/* The reference's path: relative ones start at the model's folder. */
char *kg_document_reference_path(const kg_document *d) {
    const char *file = d->model->reference.file;
    if (!file)
        return NULL;
    const char *slash = d->path ? strrchr(d->path, '/') : NULL;
    if (file[0] == '/' || !slash)
        return strdup(file);
    size_t folder = (size_t)(slash - d->path) + 1;
    char *path = malloc(folder + strlen(file) + 1);
    if (path) {
        memcpy(path, d->path, folder);
        strcpy(path + folder, file);
    }
    return path;
}

kg_status kg_document_reference(const kg_document *d, kg_mesh **out_mesh, kg_error *error) {
    const kg_reference *ref = &d->model->reference;
    kg_mesh *mesh = NULL;
    if (!ref->file) {
        *out_mesh = NULL;
        return KG_OK;
    }
    char *path = kg_document_reference_path(d);
    kg_status status =
        path ? kg_mesh_read(path, &mesh, error) : kg_fail(error, KG_ERR_MEMORY, "out of memory");
    /* y up is turned to z up: (x, y, z) -> (x, -z, y) */
    static const double turn[16] = {1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1};
    if (!status && ref->up_y)
        status = kg_mesh_transform(mesh, turn, error);
    if (!status && ref->size_mm > 0)
        status = kg_mesh_fit(mesh, ref->size_mm, error);
    if (!status && ref->has_matrix)
        status = kg_mesh_transform(mesh, ref->matrix, error);
    if (status) {
        kg_mesh_destroy(mesh);
        if (path && status == KG_ERR_INPUT)
            kg_fail_in(error, status, "%s: ", path);
    } else {
        *out_mesh = mesh;
    }
    free(path);
    return status;
}
