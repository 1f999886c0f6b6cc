#include "katagami/document.h"

#include "document/document.h"

#include "base/file.h"

#include <jansson.h>

#include <stdlib.h>
#include <string.h>

static kg_document *create(kg_document_kind kind, const char *path) {
    kg_document *d = calloc(1, sizeof *d);
    if (d && path && !(d->path = strdup(path))) {
        free(d);
        return NULL;
    }
    if (d)
        d->kind = kind;
    return d;
}

kg_status kg_document_from_model(kg_model *model, const char *path, kg_document **out_document,
                                 kg_error *error) {
    kg_document *d = create(KG_DOCUMENT_PATCHES, path);
    if (!d) {
        kg_model_destroy(model);
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    }
    d->model = model;
    *out_document = d;
    return KG_OK;
}

kg_status kg_document_from_oa(kg_oa *oa, const char *path, kg_document **out_document,
                              kg_error *error) {
    kg_document *d = create(KG_DOCUMENT_OA, path);
    kg_card *card = kg_card_create(oa);
    if (!d || !card) {
        kg_document_destroy(d);
        kg_card_destroy(card);
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    }
    d->card = card;
    *out_document = d;
    return KG_OK;
}

kg_status kg_document_from_origami(kg_origami *origami, const char *path,
                                   kg_document **out_document, kg_error *error) {
    kg_document *d = create(KG_DOCUMENT_ORIGAMI, path);
    kg_folded *folded = kg_folded_create(origami);
    if (!d || !folded) {
        kg_document_destroy(d);
        kg_folded_destroy(folded);
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    }
    d->folded = folded;
    *out_document = d;
    return KG_OK;
}

static kg_status read_pattern(const char *path, const kg_progress *progress,
                              kg_document **out_document, kg_error *error) {
    kg_origami *origami;
    kg_layer_report report = kg_layer_report_default();
    kg_status status = kg_origami_import(path, progress, &origami, &report, error);
    if (!status)
        status = kg_document_from_origami(origami, path, out_document, error);
    if (!status) {
        (*out_document)->folded->imported = true;
        (*out_document)->folded->report = report;
    }
    return status;
}

/* Is it JSON that says it is of this kind? What is no JSON is left to the reader of models to
 * refuse. */
static bool is_kind(const char *data, size_t size, const char *wanted) {
    if (!strstr(data, wanted)) /* most are not: spare them a parse */
        return false;
    size_t mark = size >= 3 && memcmp(data, "\xef\xbb\xbf", 3) == 0 ? 3 : 0;
    json_t *root = json_loadb(data + mark, size - mark, 0, NULL);
    const char *kind = json_string_value(json_object_get(root, "kind"));
    bool is = kind && strcmp(kind, wanted) == 0;
    json_decref(root);
    return is;
}

kg_status kg_document_read_memory(const char *data, size_t size, const char *name, const char *path,
                                  kg_document **out_document, kg_error *error) {
    kg_model *model;
    kg_oa *oa;
    kg_origami *origami;
    kg_status status;
    if (is_kind(data, size, "oa")) {
        status = kg_oa_read_memory(data, size, name, &oa, error);
        return status ? status : kg_document_from_oa(oa, path, out_document, error);
    }
    if (is_kind(data, size, "origami")) {
        status = kg_origami_read_memory(data, size, name, &origami, error);
        return status ? status : kg_document_from_origami(origami, path, out_document, error);
    }
    status = kg_model_read_memory(data, size, name, &model, error);
    return status ? status : kg_document_from_model(model, path, out_document, error);
}

kg_status kg_document_read(const char *path, kg_document **out_document, kg_error *error) {
    return kg_document_read_reporting(path, NULL, out_document, error);
}

kg_status kg_document_read_reporting(const char *path, const kg_progress *progress,
                                     kg_document **out_document, kg_error *error) {
    const char *name = strcmp(path, "-") ? path : "standard input";
    char *data;
    size_t size;
    if (kg_file_ends_in(path, ".fold") || kg_file_ends_in(path, ".cp"))
        return read_pattern(path, progress, out_document, error);
    kg_status status = kg_file_read(path, &data, &size, error);
    if (status)
        return status;
    status = kg_document_read_memory(data, size, name, path, out_document, error);
    free(data);
    return status;
}

void kg_document_destroy(kg_document *d) {
    if (!d)
        return;
    kg_model_destroy(d->model);
    kg_solution_destroy(d->solution);
    kg_card_destroy(d->card);
    kg_folded_destroy(d->folded);
    free(d->path);
    free(d);
}

kg_document_kind kg_document_get_kind(const kg_document *d) {
    return d->kind;
}

const char *kg_document_title(const kg_document *d) {
    return d->card     ? d->card->oa->title
           : d->folded ? kg_origami_title(d->folded->origami)
                       : d->model->title;
}

kg_model *kg_document_model(const kg_document *d) {
    return d->model;
}

kg_oa *kg_document_oa(const kg_document *d) {
    return d->card ? d->card->oa : NULL;
}

const kg_oa_sheet *kg_document_sheet(const kg_document *d) {
    return d->card ? d->card->sheet : NULL;
}

const kg_oa_stability *kg_document_stability(const kg_document *d) {
    return d->card ? d->card->stability : NULL;
}

const kg_oa_remarks *kg_document_remarks(const kg_document *d) {
    return d->card ? d->card->remarks : NULL;
}

void kg_document_set_open(kg_document *d, double angle) {
    if (d->card)
        d->card->open = angle;
}

kg_origami *kg_document_origami(const kg_document *d) {
    return d->folded ? d->folded->origami : NULL;
}

const kg_layer_report *kg_document_layers(const kg_document *d) {
    return d->folded && d->folded->imported ? &d->folded->report : NULL;
}

kg_status kg_document_set_step(kg_document *d, size_t step, kg_error *error) {
    if (!d->folded)
        return KG_OK;
    size_t count = kg_origami_step(d->folded->origami);
    if (step > count)
        return kg_fail(error, KG_ERR_INPUT, "there is no step %zu: the sheets are folded %zu times",
                       step, count);
    d->folded->step = step;
    return KG_OK;
}

void kg_document_set_fraction(kg_document *d, double fraction) {
    if (d->folded)
        d->folded->fraction = fraction;
}

kg_status kg_document_solve(kg_document *d, double chord, kg_error *error) {
    if (d->card)
        return kg_card_solve(d->card, error);
    if (d->folded) /* its folds were replayed as it was read */
        return KG_OK;
    kg_solution *previous = d->solution;
    d->solution = NULL;
    return kg_solution_create(d->model, chord, previous, &d->solution, error);
}

const kg_solution *kg_document_solution(const kg_document *d) {
    return d->solution;
}

size_t kg_document_issue_count(const kg_document *d) {
    return d->card ? d->card->issues.count : d->folded ? 0 : kg_solution_issue_count(d->solution);
}

const kg_issue *kg_document_issue(const kg_document *d, size_t index) {
    return d->card ? &d->card->issues.items[index] : kg_solution_issue(d->solution, index);
}

kg_status kg_document_check(const kg_document *d, kg_error *error) {
    kg_status status = KG_OK;
    if (d->model)
        status = kg_solution_check(d->solution, error);
    for (size_t i = 0; d->card && i < d->card->issues.count && !status; i++)
        if (d->card->issues.items[i].severity == KG_FAULT)
            status = kg_fail(error, KG_ERR_INPUT, "%s", d->card->issues.items[i].message);
    if (!status || !d->path)
        return status;
    return kg_fail_in(error, status, "%s: ", strcmp(d->path, "-") ? d->path : "standard input");
}

/* ---- reference -------------------------------------------------------------------------- */

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

kg_status kg_document_reference(const kg_document *d, const kg_progress *progress,
                                kg_mesh **out_mesh, kg_error *error) {
    const kg_reference *ref = d->model ? &d->model->reference : NULL;
    kg_mesh *mesh = NULL;
    if (!ref || !ref->file) {
        *out_mesh = NULL;
        return KG_OK;
    }
    char *path = kg_document_reference_path(d);
    kg_status status = path ? kg_mesh_read_reporting(path, progress, &mesh, error)
                            : kg_fail(error, KG_ERR_MEMORY, "out of memory");
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
