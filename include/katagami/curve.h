/*
 * katagami: Bézier curves of degree 3 and 5, the geodesics of the patches.
 *
 * The parameter v runs over [0,1]. Primes mean derivatives by v unless a comment says otherwise.
 */
#ifndef KATAGAMI_CURVE_H
#define KATAGAMI_CURVE_H

#include "katagami/base.h"

#ifdef __cplusplus
extern "C" {
#endif

enum {
    KG_CURVE_MAX_POINTS = 6,
    KG_DARBOUX_MAX_COUNT = 19 /* coefficients of a quintic's Darboux polynomial, degree 18 */
};

typedef struct kg_curve {
    int degree; /* 3 or 5 */
    kg_vec3 points[KG_CURVE_MAX_POINTS];
} kg_curve;

typedef enum kg_curve_shape { KG_CURVE_STRAIGHT, KG_CURVE_PLANAR, KG_CURVE_SPATIAL } kg_curve_shape;

/* Frenet frame. curvature in 1/mm, torsion in 1/mm. */
typedef struct kg_frenet {
    kg_vec3 tangent, normal, binormal;
    double curvature, torsion;
} kg_frenet;

/* Makes a curve of 4 or 6 control points.
 * KG_ERR_INPUT: another count; a coordinate that is not finite or beyond KG_MAX_COORDINATE; a
 * stationary point (|p'| vanishes somewhere: coincident end points, a cusp), named with its v. */
KG_API kg_status kg_curve_init(const kg_vec3 *points, size_t count, kg_curve *out_curve,
                               kg_error *error) KG_CHECKED;

/* p(v) */
KG_API kg_vec3 kg_curve_point(const kg_curve *curve, double v);

/* p, p', …, up to the derivative `order` (0 … 5): order + 1 vectors. */
KG_API void kg_curve_derivatives(const kg_curve *curve, double v, int order, kg_vec3 *out);

/* The same curve on [v0, v1], exactly (de Casteljau). v0 < v1. */
KG_API kg_curve kg_curve_segment(const kg_curve *curve, double v0, double v1);

/* Arc length on [v0, v1], to 1e-13 relative (Gauss-Legendre on pieces certified to converge);
 * negative for v1 < v0. */
KG_API double kg_curve_length(const kg_curve *curve, double v0, double v1);

/* The v where the arc length from 0 is `length`, to 1e-12 of the whole; clamped to [0,1]. */
KG_API double kg_curve_at_length(const kg_curve *curve, double length);

/* Where p' × p'' vanishes, normal and binormal are zero vectors and curvature and torsion 0. */
KG_API kg_frenet kg_curve_frenet(const kg_curve *curve, double v);

/* Straight: all control points within `KG_FLATNESS` of their size from a line; planar: from a
 * plane. */
KG_API kg_curve_shape kg_curve_classify(const kg_curve *curve);

/* Greatest distance between two control points, mm. */
KG_API double kg_curve_size(const kg_curve *curve);

/* Bernstein coefficients of the Darboux polynomial
 *
 *     D(v) = (p'·p') det(p',p'',p''') p'  +  |p'×p''|² (p'×p'')
 *
 * which is parallel to τT + κB, the rulings of the rectifying developable (Bo and Wang 2007,
 * "Geodesic-controlled developable surfaces for modeling paper bending"), there written p''×p'''
 * in derivatives by arc length. Degree 6 for a cubic, 18 for a quintic. Returns the degree.
 * `out`: KG_DARBOUX_MAX_COUNT vectors at most. */
KG_API int kg_curve_darboux(const kg_curve *curve, kg_vec3 *out);

/* How far, as a fraction of the curve's size, control points may be off a line or plane and still
 * count as on it. Files hold decimals rounded to about 1e-8 of a model, which is ten times as much
 * of a small patch; a curve treated as planar bends its true ruling by no more than this, so
 * unrolled lengths stay true to a few times 1e-7. */
#define KG_FLATNESS 1e-7

#ifdef __cplusplus
}
#endif
#endif
