/*
 * What threads in the background pass at every step of their work. It stands open, but in scripts:
 * there the work goes on only while the script waits, so that a run does not depend on how fast the
 * machine is. A script that waits for something to be shown lets the work go on step by step.
 */
#ifndef KG_APP_GATE_H
#define KG_APP_GATE_H

#include <pthread.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>

typedef struct kg_gate {
    pthread_mutex_t mutex;
    pthread_cond_t changed;
    bool closed;
    uint64_t steps;       /* that were let pass one by one */
    int working, waiting; /* threads */
} kg_gate;

void kg_gate_init(kg_gate *gate);
/* No thread may be left. */
void kg_gate_clear(kg_gate *gate);

/* Of the thread that starts another one, before it does so; and of that thread at its end. */
void kg_gate_enter(kg_gate *gate);
void kg_gate_leave(kg_gate *gate);

/* Of a thread at work: waits while the gate is closed, unless `hurries`. Who sets that flag has to
 * call kg_gate_wake. */
void kg_gate_pass(kg_gate *gate, const atomic_bool *hurries);
void kg_gate_wake(kg_gate *gate);

void kg_gate_set_closed(kg_gate *gate, bool closed);
/* Of a closed gate: lets every thread go on to its next step, and comes back when all wait there or
 * are done. */
void kg_gate_step(kg_gate *gate);

#endif
