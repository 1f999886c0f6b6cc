#include "app/load_job.h"

#include "app/settings.h"

#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

struct kg_load_job {
    pthread_t thread;
    char *path; /* may be NULL */
    double chord;
    bool is_document;
    kg_document *document; /* what was read, or a copy that has the reference */
    kg_backdrop backdrop;
    atomic_bool cancelled, done;
    atomic_int step;
    kg_status status;
    kg_error error, reference_error;
};

/* Goes on to the next step unless the job was given up. */
static kg_status begin(kg_load_job *j, kg_load_step step) {
    atomic_store(&j->step, step);
    return atomic_load(&j->cancelled) ? kg_fail(&j->error, KG_ERR_CANCELLED, "cancelled") : KG_OK;
}

static kg_status load_document(kg_load_job *j) {
    kg_status status = kg_document_read(j->path, &j->document, &j->error);
    if (!status)
        status = begin(j, KG_LOAD_SOLVING);
    if (!status)
        status = kg_document_solve(j->document, j->chord, &j->error);
    if (!status)
        status = begin(j, KG_LOAD_REFERENCE);
    if (!status && kg_backdrop_load(j->document, &j->backdrop, &j->reference_error) == KG_OK)
        j->reference_error.message[0] = '\0';
    return status;
}

static void *run(void *user) {
    kg_load_job *j = user;
    j->status =
        j->is_document ? load_document(j) : kg_backdrop_load(j->document, &j->backdrop, &j->error);
    if (!j->status)
        j->status = begin(j, KG_LOAD_REFERENCE);
    atomic_store(&j->done, true);
    return NULL;
}

/* Of a job whose thread has ended, or never began. */
static void clear(kg_load_job *j) {
    kg_backdrop_clear(&j->backdrop);
    kg_document_destroy(j->document);
    free(j->path);
    free(j);
}

static kg_status start(kg_load_job *j, kg_load_job **out_job, kg_error *error) {
    if (pthread_create(&j->thread, NULL, run, j)) {
        clear(j);
        return kg_fail(error, KG_ERR_MEMORY, "no memory for another thread");
    }
    *out_job = j;
    return KG_OK;
}

static kg_load_job *create(const char *path) {
    kg_load_job *j = calloc(1, sizeof *j);
    if (j && path && !(j->path = strdup(path))) {
        free(j);
        return NULL;
    }
    return j;
}

kg_status kg_load_job_document(const char *path, double chord, kg_load_job **out_job,
                               kg_error *error) {
    kg_load_job *j = create(path);
    if (!j)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    j->is_document = true;
    j->chord = chord;
    return start(j, out_job, error);
}

/* Names another mesh as the reference, wherever the document lies. */
static bool rename_reference(kg_document *document, const char *path) {
    kg_reference *reference = &kg_document_model(document)->reference;
    char folder[KG_PATH_SIZE] = "";
    if (path[0] != '/' && !getcwd(folder, sizeof folder - 1))
        return false;
    size_t n = strlen(folder);
    char *whole = malloc(n + strlen(path) + 2);
    if (!whole)
        return false;
    memcpy(whole, folder, n);
    if (n > 0)
        whole[n++] = '/';
    strcpy(whole + n, path);
    free(reference->file);
    reference->file = whole;
    return true;
}

kg_status kg_load_job_reference(const kg_document *document, const char *path,
                                kg_load_job **out_job, kg_error *error) {
    kg_load_job *j = create(path);
    if (!j)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    atomic_init(&j->step, KG_LOAD_REFERENCE);
    kg_status status = kg_document_copy(document, &j->document, error);
    if (!status && path && !rename_reference(j->document, path))
        status = kg_fail(error, KG_ERR_MEMORY, "out of memory");
    if (status) {
        clear(j);
        return status;
    }
    return start(j, out_job, error);
}

const char *kg_load_job_path(const kg_load_job *j) {
    return j->path;
}

bool kg_load_job_is_document(const kg_load_job *j) {
    return j->is_document;
}

kg_load_step kg_load_job_step(const kg_load_job *j) {
    return (kg_load_step)atomic_load(&j->step);
}

bool kg_load_job_is_done(const kg_load_job *j) {
    return atomic_load(&j->done);
}

kg_status kg_load_job_finish(kg_load_job *j, kg_document **out_document, kg_backdrop *out_backdrop,
                             kg_error *reference_error, kg_error *error) {
    pthread_join(j->thread, NULL);
    kg_status status = j->status;
    *error = j->error;
    if (!status) {
        *out_document = j->is_document ? j->document : NULL;
        *out_backdrop = j->backdrop;
        *reference_error = j->reference_error;
        if (j->is_document)
            j->document = NULL;
        j->backdrop = (kg_backdrop){0};
    }
    clear(j);
    return status;
}

void kg_load_job_cancel(kg_load_job *j) {
    atomic_store(&j->cancelled, true);
}

void kg_load_job_destroy(kg_load_job *j) {
    if (!j)
        return;
    kg_load_job_cancel(j);
    pthread_join(j->thread, NULL);
    clear(j);
}
