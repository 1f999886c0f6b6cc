/*
 * Ctrl+C and other requests to end, held back while something half done would stay behind, a
 * temporary file for one. They wait as far as no other thread takes them: threads are started while
 * signals are held, which they then hold for good.
 */
#ifndef KG_BASE_SIGNALS_H
#define KG_BASE_SIGNALS_H

#include <signal.h>

/* `*out_before` is for kg_signals_release, where what came meanwhile is served. May be nested. */
void kg_signals_hold(sigset_t *out_before);
void kg_signals_release(const sigset_t *before);

#endif
