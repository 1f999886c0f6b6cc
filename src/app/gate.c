#include "app/gate.h"

void kg_gate_init(kg_gate *g) {
    *g = (kg_gate){.closed = false};
    pthread_mutex_init(&g->mutex, NULL);
    pthread_cond_init(&g->changed, NULL);
}

void kg_gate_clear(kg_gate *g) {
    pthread_cond_destroy(&g->changed);
    pthread_mutex_destroy(&g->mutex);
}

static void count(kg_gate *g, int working) {
    pthread_mutex_lock(&g->mutex);
    g->working += working;
    pthread_cond_broadcast(&g->changed);
    pthread_mutex_unlock(&g->mutex);
}

void kg_gate_enter(kg_gate *g) {
    count(g, 1);
}

void kg_gate_leave(kg_gate *g) {
    count(g, -1);
}

void kg_gate_pass(kg_gate *g, const atomic_bool *hurries) {
    pthread_mutex_lock(&g->mutex);
    uint64_t step = g->steps;
    if (g->closed && !atomic_load(hurries)) {
        g->working--;
        g->waiting++;
        pthread_cond_broadcast(&g->changed);
        while (g->closed && g->steps == step && !atomic_load(hurries))
            pthread_cond_wait(&g->changed, &g->mutex);
        if (g->steps == step) { /* else kg_gate_step has counted it */
            g->working++;
            g->waiting--;
        }
    }
    pthread_mutex_unlock(&g->mutex);
}

void kg_gate_wake(kg_gate *g) {
    count(g, 0);
}

void kg_gate_set_closed(kg_gate *g, bool closed) {
    pthread_mutex_lock(&g->mutex);
    g->closed = closed;
    pthread_cond_broadcast(&g->changed);
    pthread_mutex_unlock(&g->mutex);
}

static void await_all(kg_gate *g) {
    while (g->working > 0)
        pthread_cond_wait(&g->changed, &g->mutex);
}

void kg_gate_step(kg_gate *g) {
    pthread_mutex_lock(&g->mutex);
    await_all(g); /* those on their way are let pass as well */
    g->steps++;
    g->working += g->waiting;
    g->waiting = 0;
    pthread_cond_broadcast(&g->changed);
    await_all(g);
    pthread_mutex_unlock(&g->mutex);
}
