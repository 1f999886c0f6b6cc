#include "app/convert_job.h"

#include "app/task.h"
#include "base/file.h"

#include <stdlib.h>
#include <string.h>

struct kg_convert_job {
    kg_task task;
    char *path;
    kg_mesh *mesh;
    kg_oa_options options;
    kg_converted converted;
    kg_status status;
    kg_error error;
};

void kg_converted_clear(kg_converted *c) {
    kg_document_destroy(c->document);
    kg_mesh_destroy(c->standing);
    *c = (kg_converted){0};
}

kg_status kg_convert(const kg_mesh *mesh, const char *path, const kg_oa_options *options,
                     const kg_progress *progress, kg_document **out_document, kg_error *error) {
    kg_oa *oa;
    kg_status status = kg_oa_convert(mesh, options, progress, &oa, error);
    if (status)
        return status;
    if (options->cell_mm ==
        kg_document_card_cell((int[]){options->width, options->depth, options->height}))
        kg_document_card_fit(oa); /* nobody asked for another */
    char *title = kg_file_stem(path);
    if (!title) {
        kg_oa_destroy(oa);
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    }
    free(oa->title);
    oa->title = title;
    return kg_document_from_oa(oa, NULL, out_document, error);
}

static kg_status make(kg_convert_job *j, kg_error *error) {
    const kg_progress progress = kg_task_progress(&j->task);
    kg_status status =
        j->mesh ? KG_OK : kg_mesh_read_reporting(j->path, &progress, &j->mesh, error);
    if (!status)
        status =
            kg_convert(j->mesh, j->path, &j->options, &progress, &j->converted.document, error);
    if (!status)
        status = kg_document_solve(j->converted.document, KG_MESH_CHORD, error);
    if (!status)
        status = kg_document_mesh(j->converted.document, NULL, &j->converted.standing, error);
    return status;
}

static void work(void *user) {
    kg_convert_job *j = user;
    j->status = make(j, &j->error);
}

static void destroy(kg_convert_job *j) {
    kg_mesh_destroy(j->mesh);
    kg_converted_clear(&j->converted);
    free(j->path);
    free(j);
}

kg_status kg_convert_job_start(const char *path, kg_mesh *mesh, const kg_oa_options *options,
                               kg_gate *gate, kg_convert_job **out_job, kg_error *error) {
    kg_convert_job *j = calloc(1, sizeof *j);
    if (!j) {
        kg_mesh_destroy(mesh);
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    }
    j->mesh = mesh;
    j->options = *options;
    j->path = strdup(path);
    if (!j->path || !kg_task_start(&j->task, gate, work, j)) {
        destroy(j);
        return kg_fail(error, KG_ERR_MEMORY, "no memory for another thread");
    }
    *out_job = j;
    return KG_OK;
}

double kg_convert_job_fraction(const kg_convert_job *j) {
    return kg_task_fraction(&j->task);
}

bool kg_convert_job_is_done(const kg_convert_job *j) {
    return kg_task_is_done(&j->task);
}

void kg_convert_job_cancel(kg_convert_job *j) {
    kg_task_cancel(&j->task);
}

kg_status kg_convert_job_finish(kg_convert_job *j, kg_mesh **out_mesh, kg_converted *out,
                                kg_error *error) {
    kg_task_join(&j->task);
    kg_status status = j->status;
    *error = j->error;
    *out_mesh = j->mesh;
    j->mesh = NULL;
    if (!status) {
        *out = j->converted;
        j->converted = (kg_converted){0};
    }
    destroy(j);
    return status;
}
