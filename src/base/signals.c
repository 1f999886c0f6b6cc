#include "base/signals.h"

#include <stddef.h>

void kg_signals_hold(sigset_t *out_before) {
    static const int requests[] = {SIGINT, SIGTERM, SIGHUP};
    sigset_t held;
    sigemptyset(&held);
    for (size_t i = 0; i < sizeof requests / sizeof *requests; i++)
        sigaddset(&held, requests[i]);
    pthread_sigmask(SIG_BLOCK, &held, out_before);
}

void kg_signals_release(const sigset_t *before) {
    pthread_sigmask(SIG_SETMASK, before, NULL);
}
