#include "app/convert_job.h"

#include "base/file.h"

#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

struct kg_convert_job {
    pthread_t thread;
    char *path;
    kg_mesh *mesh;
    kg_oa_options options;
    kg_converted converted;
    atomic_bool cancelled, done;
    atomic_int permille;
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
    char *title = kg_file_stem(path);
    if (!title) {
        kg_oa_destroy(oa);
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    }
    free(oa->title);
    oa->title = title;
    return kg_document_from_oa(oa, NULL, out_document, error);
}

static bool keep_on(void *user, double fraction, const char *what) {
    kg_convert_job *j = user;
    (void)what;
    atomic_store(&j->permille, (int)(1000 * fraction));
    return !atomic_load(&j->cancelled);
}

static kg_status work(kg_convert_job *j, kg_error *error) {
    const kg_progress progress = {keep_on, j};
    kg_status status = j->mesh ? KG_OK : kg_mesh_read(j->path, &j->mesh, error);
    if (!status)
        status =
            kg_convert(j->mesh, j->path, &j->options, &progress, &j->converted.document, error);
    if (!status)
        status = kg_document_solve(j->converted.document, KG_MESH_CHORD, error);
    if (!status)
        status = kg_document_mesh(j->converted.document, NULL, &j->converted.standing, error);
    return status;
}

static void *run(void *user) {
    kg_convert_job *j = user;
    j->status = work(j, &j->error);
    atomic_store(&j->done, true);
    return NULL;
}

static void destroy(kg_convert_job *j) {
    kg_mesh_destroy(j->mesh);
    kg_converted_clear(&j->converted);
    free(j->path);
    free(j);
}

kg_status kg_convert_job_start(const char *path, kg_mesh *mesh, const kg_oa_options *options,
                               kg_convert_job **out_job, kg_error *error) {
    kg_convert_job *j = calloc(1, sizeof *j);
    if (!j) {
        kg_mesh_destroy(mesh);
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    }
    j->mesh = mesh;
    j->options = *options;
    j->path = strdup(path);
    if (!j->path || pthread_create(&j->thread, NULL, run, j)) {
        destroy(j);
        return kg_fail(error, KG_ERR_MEMORY, "no memory for another thread");
    }
    *out_job = j;
    return KG_OK;
}

double kg_convert_job_fraction(const kg_convert_job *j) {
    return atomic_load(&j->permille) / 1000.0;
}

bool kg_convert_job_is_done(const kg_convert_job *j) {
    return atomic_load(&j->done);
}

void kg_convert_job_cancel(kg_convert_job *j) {
    atomic_store(&j->cancelled, true);
}

kg_status kg_convert_job_finish(kg_convert_job *j, kg_mesh **out_mesh, kg_converted *out,
                                kg_error *error) {
    pthread_join(j->thread, NULL);
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
