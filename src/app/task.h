/* Work on a thread of its own, which tells how far it is and can be asked to end. */
#ifndef KG_APP_TASK_H
#define KG_APP_TASK_H

#include "app/gate.h"
#include "katagami/base.h"

typedef struct kg_task {
    pthread_t thread;
    kg_gate *gate; /* may be NULL: always open */
    void (*work)(void *user);
    void *user;
    atomic_bool cancelled, hurries, done;
    atomic_int permille;
} kg_task;

/* Starts `work` on a zeroed task, which stays where it is until it is joined; false: no memory for
 * a thread, nothing was started. */
bool kg_task_start(kg_task *task, kg_gate *gate, void (*work)(void *user), void *user) KG_CHECKED;

/* What the work gives to the kernel: it stores the fraction, passes the gate and ends what was
 * cancelled. */
kg_progress kg_task_progress(kg_task *task);

/* Asks it to end early. */
void kg_task_cancel(kg_task *task);
bool kg_task_is_cancelled(const kg_task *task);
bool kg_task_is_done(const kg_task *task);
/* How far it is, by its last word, in [0,1]. */
double kg_task_fraction(const kg_task *task);
/* Waits for its end, which no gate holds up. */
void kg_task_join(kg_task *task);

#endif
