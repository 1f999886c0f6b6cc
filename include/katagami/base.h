/*
 * katagami: what every module shares: status codes, error messages, small vectors, progress.
 *
 * Conventions of the whole API: lengths are millimetres, angles radians, z is up. Functions that
 * can fail return kg_status, take inputs first, then outputs, then an optional kg_error; outputs
 * are untouched on failure.
 */
#ifndef KATAGAMI_BASE_H
#define KATAGAMI_BASE_H

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined(__GNUC__)
#define KG_API __attribute__((visibility("default")))
#define KG_CHECKED __attribute__((warn_unused_result))
#define KG_PRINTF(f, a) __attribute__((format(printf, f, a)))
#else
#define KG_API
#define KG_CHECKED
#define KG_PRINTF(f, a)
#endif

/* Coordinates beyond this (mm) are refused: farther out doubles no longer hold 1e-9 mm. */
#define KG_MAX_COORDINATE 1e6

/* Half a turn, in radians. */
#define KG_PI 3.14159265358979323846

typedef enum kg_status {
    KG_OK = 0,
    KG_ERR_MEMORY,    /* an allocation failed */
    KG_ERR_IO,        /* a file could not be read or written */
    KG_ERR_PARSE,     /* a file is not what its format says */
    KG_ERR_INPUT,     /* a value is out of its range, or the model cannot be built as asked */
    KG_ERR_CANCELLED, /* the caller's progress function asked to stop */
    KG_ERR_SYSTEM     /* the machine lacks something (no GL, no font) */
} kg_status;

enum { KG_ERROR_SIZE = 1024 };

/* A message for people: names the file, line, patch or value at fault, and what to do. In the
 * language of the catalogue that the program bound to gettext's domain "katagami", else English. */
typedef struct kg_error {
    kg_status status;
    char message[KG_ERROR_SIZE];
} kg_error;

/* Records a failure (every failure of the program passes here) and returns `status`. `error` may
 * be NULL. */
KG_API kg_status kg_fail(kg_error *error, kg_status status, const char *format, ...)
    KG_PRINTF(3, 4);

/* Puts words in front of a message already recorded ("patch 3: " before "…"); returns its status.
 */
KG_API kg_status kg_fail_in(kg_error *error, kg_status status, const char *format, ...)
    KG_PRINTF(3, 4);

/* The program's version, "0.1.0". */
KG_API const char *kg_version(void);

/* Called now and then by long work with a fraction in [0,1]; return false to cancel. */
typedef bool (*kg_progress_fn)(void *user, double fraction, const char *what);
typedef struct kg_progress {
    kg_progress_fn call; /* may be NULL */
    void *user;
} kg_progress;

/* ---- numbers --------------------------------------------------------------------------- */

/* The smaller and the larger of two, `b` where one is NaN: a single instruction each, while fmin
 * and fmax are calls. */
static inline double kg_min(double a, double b) {
    return a < b ? a : b;
}
static inline double kg_max(double a, double b) {
    return a > b ? a : b;
}

/* ---- vectors --------------------------------------------------------------------------- */

typedef struct kg_vec2 {
    double x, y;
} kg_vec2;

typedef struct kg_vec3 {
    double x, y, z;
} kg_vec3;

typedef struct kg_box3 {
    kg_vec3 lo, hi; /* empty when lo.x > hi.x */
} kg_box3;

typedef struct kg_box2 {
    kg_vec2 lo, hi; /* empty when lo.x > hi.x */
} kg_box2;

static inline kg_vec2 kg_v2(double x, double y) {
    kg_vec2 r;
    r.x = x;
    r.y = y;
    return r;
}
static inline kg_vec2 kg_add2(kg_vec2 a, kg_vec2 b) {
    return kg_v2(a.x + b.x, a.y + b.y);
}
static inline kg_vec2 kg_sub2(kg_vec2 a, kg_vec2 b) {
    return kg_v2(a.x - b.x, a.y - b.y);
}
static inline kg_vec2 kg_scale2(kg_vec2 a, double s) {
    return kg_v2(a.x * s, a.y * s);
}
static inline double kg_dot2(kg_vec2 a, kg_vec2 b) {
    return a.x * b.x + a.y * b.y;
}
static inline double kg_cross2(kg_vec2 a, kg_vec2 b) {
    return a.x * b.y - a.y * b.x;
}
static inline double kg_len2(kg_vec2 a) {
    return sqrt(kg_dot2(a, a));
}
static inline double kg_dist2(kg_vec2 a, kg_vec2 b) {
    return kg_len2(kg_sub2(a, b));
}
static inline kg_vec2 kg_lerp2(kg_vec2 a, kg_vec2 b, double t) {
    return kg_v2(a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t);
}

static inline kg_vec3 kg_v3(double x, double y, double z) {
    kg_vec3 r;
    r.x = x;
    r.y = y;
    r.z = z;
    return r;
}
static inline kg_vec3 kg_add(kg_vec3 a, kg_vec3 b) {
    return kg_v3(a.x + b.x, a.y + b.y, a.z + b.z);
}
static inline kg_vec3 kg_sub(kg_vec3 a, kg_vec3 b) {
    return kg_v3(a.x - b.x, a.y - b.y, a.z - b.z);
}
static inline kg_vec3 kg_neg(kg_vec3 a) {
    return kg_v3(-a.x, -a.y, -a.z);
}
static inline kg_vec3 kg_scale(kg_vec3 a, double s) {
    return kg_v3(a.x * s, a.y * s, a.z * s);
}
/* a + s b */
static inline kg_vec3 kg_madd(kg_vec3 a, double s, kg_vec3 b) {
    return kg_v3(a.x + s * b.x, a.y + s * b.y, a.z + s * b.z);
}
static inline double kg_dot(kg_vec3 a, kg_vec3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
static inline kg_vec3 kg_cross(kg_vec3 a, kg_vec3 b) {
    return kg_v3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}
static inline double kg_det(kg_vec3 a, kg_vec3 b, kg_vec3 c) {
    return kg_dot(a, kg_cross(b, c));
}
static inline double kg_len(kg_vec3 a) {
    return sqrt(kg_dot(a, a));
}
static inline double kg_dist(kg_vec3 a, kg_vec3 b) {
    return kg_len(kg_sub(a, b));
}
static inline kg_vec3 kg_lerp(kg_vec3 a, kg_vec3 b, double t) {
    return kg_v3(a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t, a.z + (b.z - a.z) * t);
}
/* a / |a|; the zero vector stays zero */
static inline kg_vec3 kg_unit(kg_vec3 a) {
    double n = kg_len(a);
    return n > 0 ? kg_scale(a, 1 / n) : a;
}

static inline kg_box3 kg_box3_empty(void) {
    kg_box3 b;
    b.lo = kg_v3(INFINITY, INFINITY, INFINITY);
    b.hi = kg_v3(-INFINITY, -INFINITY, -INFINITY);
    return b;
}
static inline void kg_box3_add(kg_box3 *b, kg_vec3 p) {
    b->lo = kg_v3(kg_min(p.x, b->lo.x), kg_min(p.y, b->lo.y), kg_min(p.z, b->lo.z));
    b->hi = kg_v3(kg_max(p.x, b->hi.x), kg_max(p.y, b->hi.y), kg_max(p.z, b->hi.z));
}
static inline kg_box2 kg_box2_empty(void) {
    kg_box2 b;
    b.lo = kg_v2(INFINITY, INFINITY);
    b.hi = kg_v2(-INFINITY, -INFINITY);
    return b;
}
static inline void kg_box2_add(kg_box2 *b, kg_vec2 p) {
    b->lo = kg_v2(kg_min(p.x, b->lo.x), kg_min(p.y, b->lo.y));
    b->hi = kg_v2(kg_max(p.x, b->hi.x), kg_max(p.y, b->hi.y));
}

#ifdef __cplusplus
}
#endif
#endif
