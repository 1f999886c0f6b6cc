#include "app/task.h"

#include "base/signals.h"

static void pass(kg_task *t) {
    if (t->gate)
        kg_gate_pass(t->gate, &t->hurries);
}

static void *run(void *user) {
    kg_task *t = user;
    pass(t);
    t->work(t->user);
    atomic_store(&t->done, true);
    if (t->gate)
        kg_gate_leave(t->gate);
    return NULL;
}

bool kg_task_start(kg_task *t, kg_gate *gate, void (*work)(void *user), void *user) {
    t->gate = gate;
    t->work = work;
    t->user = user;
    if (gate)
        kg_gate_enter(gate);
    sigset_t before;
    kg_signals_hold(&before); /* the first thread is the one that is asked to end */
    bool started = pthread_create(&t->thread, NULL, run, t) == 0;
    kg_signals_release(&before);
    if (started)
        return true;
    if (gate)
        kg_gate_leave(gate);
    return false;
}

static bool go_on(void *user, double fraction, const char *what) {
    kg_task *t = user;
    (void)what;
    atomic_store(&t->permille, (int)(1000 * fraction));
    pass(t);
    return !atomic_load(&t->cancelled);
}

kg_progress kg_task_progress(kg_task *t) {
    return (kg_progress){go_on, t};
}

static void hurry(kg_task *t) {
    atomic_store(&t->hurries, true);
    if (t->gate)
        kg_gate_wake(t->gate);
}

void kg_task_cancel(kg_task *t) {
    atomic_store(&t->cancelled, true);
    hurry(t);
}

bool kg_task_is_cancelled(const kg_task *t) {
    return atomic_load(&t->cancelled);
}

bool kg_task_is_done(const kg_task *t) {
    return atomic_load(&t->done);
}

double kg_task_fraction(const kg_task *t) {
    return atomic_load(&t->permille) / 1000.0;
}

void kg_task_join(kg_task *t) {
    hurry(t);
    pthread_join(t->thread, NULL);
}
