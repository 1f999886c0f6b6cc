/* What every test file starts from: cmocka with the headers it wants first. */
#ifndef KG_TESTS_CHECK_H
#define KG_TESTS_CHECK_H

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

/* |a - b| <= tolerance, with both numbers in the message. */
#define assert_near(a, b, tolerance) kg_assert_near((a), (b), (tolerance), __FILE__, __LINE__)

static inline void kg_assert_near(double a, double b, double tolerance, const char *file,
                                  int line) {
    if (!(fabs(a - b) <= tolerance)) {
        print_error("%.17g and %.17g differ by %.3g, more than %.3g\n", a, b, fabs(a - b),
                    tolerance);
        _fail(file, line);
    }
}

/* A small repeatable generator (splitmix64) for property tests. */
typedef struct kg_random {
    uint64_t state;
} kg_random;

static inline uint64_t kg_random_bits(kg_random *r) {
    uint64_t z = (r->state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}
/* Uniform in [lo, hi). */
static inline double kg_random_in(kg_random *r, double lo, double hi) {
    return lo + (hi - lo) * ((double)(kg_random_bits(r) >> 11) * 0x1p-53);
}

#endif
