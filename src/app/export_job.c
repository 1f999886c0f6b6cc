#include "app/export_job.h"

#include "app/export.h"
#include "app/task.h"

#include <stdlib.h>
#include <string.h>

struct kg_export_job {
    kg_task task;
    kg_document *document; /* NULL: the image is written */
    kg_image image;
    bool guide;
    char *path;
    kg_export_choice choice;
    kg_status status;
    kg_error error;
};

static kg_status write_net(kg_export_job *j, kg_error *error) {
    const kg_progress progress = kg_task_progress(&j->task);
    kg_net_options options;
    double tab_width;
    kg_status status = kg_document_net_options(j->document, &options, &tab_width, error);
    if (status)
        return status;
    options.separate = j->choice.separate;
    options.mirrored = j->choice.mirrored;
    if (j->choice.perforate) {
        options.perforate[0] = j->choice.dash;
        options.perforate[1] = j->choice.gap;
    }
    return kg_export_net(j->document, &options, tab_width, j->path, &progress, error);
}

static void work(void *user) {
    kg_export_job *j = user;
    const kg_progress progress = kg_task_progress(&j->task);
    j->status = !j->document ? kg_image_write_png(&j->image, j->path, &j->error)
                : j->guide   ? kg_export_guide(j->document, j->path, &progress, &j->error)
                : kg_export_is_net(j->path) ? write_net(j, &j->error)
                                            : kg_export_mesh(j->document, j->path, &j->error);
}

static void destroy(kg_export_job *j) {
    kg_document_destroy(j->document);
    kg_image_destroy(&j->image);
    free(j->path);
    free(j);
}

static kg_export_job *create(const char *path) {
    kg_export_job *j = calloc(1, sizeof *j);
    if (j && !(j->path = strdup(path))) {
        free(j);
        return NULL;
    }
    return j;
}

static kg_status start(kg_export_job *j, kg_gate *gate, kg_export_job **out_job, kg_error *error) {
    if (!kg_task_start(&j->task, gate, work, j)) {
        destroy(j);
        return kg_fail(error, KG_ERR_MEMORY, "no memory for another thread");
    }
    *out_job = j;
    return KG_OK;
}

kg_status kg_export_job_start(const kg_editor *e, const char *path, bool guide, kg_gate *gate,
                              kg_export_job **out_job, kg_error *error) {
    kg_export_job *j = create(path);
    if (!j)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    j->choice = e->settings.export;
    j->guide = guide;
    kg_status status = kg_export_copy(e, path, &j->document, error);
    if (status) {
        destroy(j);
        return status;
    }
    return start(j, gate, out_job, error);
}

kg_status kg_export_job_picture(kg_image *image, const char *path, kg_gate *gate,
                                kg_export_job **out_job, kg_error *error) {
    kg_export_job *j = create(path);
    if (!j) {
        kg_image_destroy(image);
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    }
    j->image = *image;
    *image = (kg_image){0};
    return start(j, gate, out_job, error);
}

double kg_export_job_fraction(const kg_export_job *j) {
    return kg_task_fraction(&j->task);
}

const char *kg_export_job_path(const kg_export_job *j) {
    return j->path;
}

void kg_export_job_cancel(kg_export_job *j) {
    kg_task_cancel(&j->task);
}

bool kg_export_job_is_done(const kg_export_job *j) {
    return kg_task_is_done(&j->task);
}

kg_status kg_export_job_finish(kg_export_job *j, kg_error *error) {
    kg_task_join(&j->task);
    kg_status status = j->status;
    *error = j->error;
    destroy(j);
    return status;
}
