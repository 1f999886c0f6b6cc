#include "app/stand_job.h"

#include "app/task.h"

#include <stdlib.h>

struct kg_stand_job {
    kg_task task;
    kg_stood stood;
    kg_status status;
    kg_error error;
};

void kg_stood_clear(kg_stood *s) {
    kg_oa_destroy(s->before);
    kg_oa_destroy(s->after);
    *s = (kg_stood){0};
}

static void work(void *user) {
    kg_stand_job *j = user;
    const kg_progress progress = kg_task_progress(&j->task);
    j->status = kg_oa_stabilize(j->stood.after, &progress, &j->stood.mended, &j->error);
}

static void destroy(kg_stand_job *j) {
    kg_stood_clear(&j->stood);
    free(j);
}

kg_status kg_stand_job_start(const kg_oa *card, kg_gate *gate, kg_stand_job **out_job,
                             kg_error *error) {
    kg_stand_job *j = calloc(1, sizeof *j);
    if (!j)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    j->stood.before = kg_oa_copy(card);
    j->stood.after = kg_oa_copy(card);
    if (!j->stood.before || !j->stood.after || !kg_task_start(&j->task, gate, work, j)) {
        destroy(j);
        return kg_fail(error, KG_ERR_MEMORY, "no memory for another thread");
    }
    *out_job = j;
    return KG_OK;
}

double kg_stand_job_fraction(const kg_stand_job *j) {
    return kg_task_fraction(&j->task);
}

bool kg_stand_job_is_done(const kg_stand_job *j) {
    return kg_task_is_done(&j->task);
}

void kg_stand_job_cancel(kg_stand_job *j) {
    kg_task_cancel(&j->task);
}

kg_status kg_stand_job_finish(kg_stand_job *j, kg_stood *out, kg_error *error) {
    kg_task_join(&j->task);
    kg_status status = j->status;
    *error = j->error;
    if (!status) {
        *out = j->stood;
        j->stood = (kg_stood){0};
    }
    destroy(j);
    return status;
}
