/* Making a card stand on a thread of its own, of a copy. */
#ifndef KG_APP_STAND_JOB_H
#define KG_APP_STAND_JOB_H

#include "app/gate.h"
#include "katagami/oa.h"

typedef struct kg_stand_job kg_stand_job;

/* What came of it: the card as it was given, and as it stands. */
typedef struct kg_stood {
    kg_oa *before, *after;
    kg_oa_mended mended;
} kg_stood;

void kg_stood_clear(kg_stood *stood);

/* `gate` may be NULL. KG_ERR_MEMORY. */
kg_status kg_stand_job_start(const kg_oa *card, kg_gate *gate, kg_stand_job **out_job,
                             kg_error *error) KG_CHECKED;
double kg_stand_job_fraction(const kg_stand_job *job);
bool kg_stand_job_is_done(const kg_stand_job *job);
/* Asks it to end early; kg_stand_job_finish gives KG_ERR_CANCELLED. */
void kg_stand_job_cancel(kg_stand_job *job);
/* Waits for its end, frees it and says what came of it. */
kg_status kg_stand_job_finish(kg_stand_job *job, kg_stood *out_stood, kg_error *error) KG_CHECKED;

#endif
