/* What the benchmarks share. */
#ifndef KG_TESTS_BENCH_H
#define KG_TESTS_BENCH_H

#include "katagami/patch.h"

/* Seconds of a clock that only runs forward. */
double bench_now(void);

/* Seconds of work that this process has done: what one core needs, whatever else the machine does.
 */
double bench_work(void);

/* Prints a line; `unit` is "ns", "us" or "ms". A target of 0 is none. */
void bench_row(const char *what, double seconds, const char *unit, double target);

/* The i-th of a fixed row of gently bent patches about 100 mm long around the origin. */
kg_patch_input bench_patch(int i);

void bench_patches(void);
void bench_crossings(void);
void bench_models(void);
void bench_cards(void);
void bench_origami(void);

/* How many times `seconds` rabbit-ear needs for a task of rabbit.mjs on a FOLD file. */
void bench_rabbit(const char *task, const char *fold_text, size_t size, double seconds,
                  double target);

#endif
