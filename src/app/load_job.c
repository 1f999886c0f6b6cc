#include "app/load_job.h"

#include "app/settings.h"
#include "app/task.h"
#include "base/file.h"
#include "base/progress.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

struct kg_load_job {
    kg_task task;
    char *path; /* may be NULL */
    double chord;
    bool is_document;
    kg_document *document; /* what was read, or a copy that has the reference */
    kg_backdrop backdrop;
    atomic_int step;
    kg_status status;
    kg_error error, reference_error;
};

/* Where the steps of reading a document begin, as shares of the whole: a reference is mostly larger
 * than the model that has it, and the layers of a crease pattern take longest. */
static double begins(const kg_load_job *j, kg_load_step step) {
    static const double shares[2][KG_LOAD_STEP_COUNT] = {{0, 0.2, 0.4}, {0, 0.9, 0.95}};
    bool pattern =
        j->path && (kg_file_ends_in(j->path, ".fold") || kg_file_ends_in(j->path, ".cp"));
    return shares[pattern][step];
}

/* Goes on to the next step unless the job was given up. */
static kg_status begin(kg_load_job *j, kg_load_step step) {
    kg_progress progress = kg_task_progress(&j->task);
    atomic_store(&j->step, step);
    return kg_progress_tell(&progress, begins(j, step), "", &j->error);
}

/* `from`: how much of the whole is done before. */
static kg_status load_reference(kg_load_job *j, double from, kg_error *error) {
    kg_progress whole = kg_task_progress(&j->task);
    kg_progress_share share = {&whole, from, 1};
    kg_progress progress = kg_progress_of_share(&share);
    return kg_backdrop_load(j->document, &progress, &j->backdrop, error);
}

static kg_status load_document(kg_load_job *j) {
    kg_progress whole = kg_task_progress(&j->task);
    kg_progress_share share = {&whole, 0, begins(j, KG_LOAD_SOLVING)};
    kg_progress progress = kg_progress_of_share(&share);
    kg_status status = kg_document_read_reporting(j->path, &progress, &j->document, &j->error);
    if (!status)
        status = begin(j, KG_LOAD_SOLVING);
    if (!status)
        status = kg_document_solve(j->document, j->chord, &j->error);
    if (!status)
        status = begin(j, KG_LOAD_REFERENCE);
    if (!status && load_reference(j, begins(j, KG_LOAD_REFERENCE), &j->reference_error) == KG_OK)
        j->reference_error.message[0] = '\0';
    return status;
}

static void work(void *user) {
    kg_load_job *j = user;
    j->status = j->is_document ? load_document(j) : load_reference(j, 0, &j->error);
    if (!j->status && kg_task_is_cancelled(&j->task))
        j->status = kg_fail(&j->error, KG_ERR_CANCELLED, "cancelled");
}

/* Of a job whose thread has ended, or never began. */
static void clear(kg_load_job *j) {
    kg_backdrop_clear(&j->backdrop);
    kg_document_destroy(j->document);
    free(j->path);
    free(j);
}

static kg_status start(kg_load_job *j, kg_gate *gate, kg_load_job **out_job, kg_error *error) {
    if (!kg_task_start(&j->task, gate, work, j)) {
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

kg_status kg_load_job_document(const char *path, double chord, kg_gate *gate, kg_load_job **out_job,
                               kg_error *error) {
    kg_load_job *j = create(path);
    if (!j)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    j->is_document = true;
    j->chord = chord;
    return start(j, gate, out_job, error);
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

kg_status kg_load_job_reference(const kg_document *document, const char *path, kg_gate *gate,
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
    return start(j, gate, out_job, error);
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

double kg_load_job_fraction(const kg_load_job *j) {
    return kg_task_fraction(&j->task);
}

bool kg_load_job_is_done(const kg_load_job *j) {
    return kg_task_is_done(&j->task);
}

kg_status kg_load_job_finish(kg_load_job *j, kg_document **out_document, kg_backdrop *out_backdrop,
                             kg_error *reference_error, kg_error *error) {
    kg_task_join(&j->task);
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
    kg_task_cancel(&j->task);
}

void kg_load_job_destroy(kg_load_job *j) {
    if (!j)
        return;
    kg_load_job_cancel(j);
    kg_task_join(&j->task);
    clear(j);
}
