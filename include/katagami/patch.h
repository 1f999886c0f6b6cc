/*
 * katagami: developable patches, strips of paper around a geodesic.
 *
 *     X(u,v) = p(v) + u d(v)        v in [0,1], u: signed length along the unit ruling d, mm
 *
 * p is a Bézier curve, the geodesic; d the direction of its Darboux vector, so that the surface is
 * its rectifying developable (Bo and Wang 2007). On paper the patch lies at
 *
 *     (x, y) = (u sin θ, u cos θ + L(v))    θ = angle(p', d), L = arc length of p from 0
 *
 * exactly (y down, seen from the front).
 */
#ifndef KATAGAMI_PATCH_H
#define KATAGAMI_PATCH_H

#include "katagami/curve.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { KG_PATCH_CELLS = 32 };

/* An extent is cut back where it goes farther than this fraction of the way to the edge of
 * regression, where the paper would have to fold back on itself. */
#define KG_REGRESSION_LIMIT 0.98

/* Rulings nearer to the geodesic than this (radians, 5°) are reported: such a patch is valid, but
 * small movements of its points swing the rulings wildly. */
#define KG_FLAT_RULING 0.08726646259971647

/* What a patch is made from. */
typedef struct kg_patch_input {
    kg_vec3 points[KG_CURVE_MAX_POINTS];
    size_t point_count; /* 4 or 6 */
    double extent[2];   /* u range, mm, lo < hi */
    bool has_ruling;    /* straight geodesics only: the wished direction of the rulings */
    kg_vec3 ruling;
    bool flip; /* the front is the other side */
} kg_patch_input;

/* A patch prepared for evaluation. A value: copy it freely, read its fields, never write them. */
typedef struct kg_patch {
    kg_curve geodesic;
    kg_curve_shape shape;
    double extent[2];        /* in force: the wished one cut back at the edge of regression */
    double wished_extent[2]; /* as given */
    double regression[2];    /* allowed u over all v: (negative or -inf, positive or inf) */
    double regression_v[2];  /* where these are reached; NaN where they are infinite */
    double theta[2];         /* smallest and largest θ */
    double flattest_v;       /* where the ruling is nearest to the geodesic */
    bool clamped;            /* extent differs from wished_extent */
    bool flip;
    double size; /* greatest distance between corners and control points, mm */
    kg_box3 box; /* contains every X(u,v) of the rectangle */

    /* Rulings: d = R/|R| with R a polynomial in Bernstein form on [0,1] that vanishes nowhere
     * (degree 0 for straight and planar geodesics, where D may vanish or be noise). The largest
     * coefficient is a unit vector. kg_patch_ruling is more exact where |R| gets small. */
    int ruling_degree;
    kg_vec3 rulings[KG_DARBOUX_MAX_COUNT];

    /* L at the ends of equal cells of v, to rounding. */
    double length_at[KG_PATCH_CELLS + 1];
} kg_patch;

/* Everything on one ruling. Primes are by v. */
typedef struct kg_ruling {
    double v;
    kg_vec3 p, dp, ddp; /* geodesic, p', p'' */
    kg_vec3 d, dd;      /* unit ruling, d' */
    kg_vec3 normal;     /* unit, constant along the ruling, to the front (flip respected) */
    double speed;       /* |p'| */
    double sin_theta, cos_theta;
    double dtheta; /* θ' */
} kg_ruling;

/* Prepares a patch.
 * KG_ERR_INPUT: as kg_curve_init; extent not finite or not lo < hi; an extent that lies wholly
 * beyond the edge of regression, or leaves less than a millionth of the size between the edges; a
 * ruling that runs along the geodesic (an inflection with twist that no surface goes through); a
 * ruling wish parallel to its straight geodesic. */
KG_API kg_status kg_patch_init(const kg_patch_input *input, kg_patch *out_patch,
                               kg_error *error) KG_CHECKED;

/* The ruling at v in [0,1]. */
KG_API kg_ruling kg_patch_ruling(const kg_patch *patch, double v);

/* The foot p(v) of a ruling and its direction d(v): what kg_patch_point is made of. */
KG_API kg_vec3 kg_patch_line(const kg_patch *patch, double v, kg_vec3 *out_d);

/* X(u,v) */
KG_API kg_vec3 kg_patch_point(const kg_patch *patch, double u, double v);

/* X(u,v) and its derivatives X_u, X_v. */
KG_API kg_vec3 kg_patch_derivatives(const kg_patch *patch, double u, double v, kg_vec3 *out_du,
                                    kg_vec3 *out_dv);

/* Unit normal to the front. */
KG_API kg_vec3 kg_patch_normal(const kg_patch *patch, double v);

/* L(v): arc length of the geodesic from 0, to 1e-13 of the whole. */
KG_API double kg_patch_length(const kg_patch *patch, double v);

/* Where X(u,v) lies on paper, before any scale or flip. */
KG_API kg_vec2 kg_patch_unroll(const kg_patch *patch, double u, double v);

/* Paper position and its derivatives by u and v, from θ and L alone (nothing of X): what lengths
 * and areas on paper are measured with. */
KG_API kg_vec2 kg_patch_unroll_derivatives(const kg_patch *patch, double u, double v,
                                           kg_vec2 *out_du, kg_vec2 *out_dv);

/* The interval of u around 0 in which the surface at v does not fold back, (lo, hi), either may be
 * infinite. With w ⊥ d in the tangent plane, p' = a d + b w, d' = c w: b + u c > 0. */
KG_API void kg_patch_regression(const kg_patch *patch, double v, double *out_lo, double *out_hi);

/* The point of the rectangle nearest to `point`; returns the distance. The distance to a ruling
 * has a closed form, so this is a search in v alone. */
KG_API double kg_patch_closest(const kg_patch *patch, kg_vec3 point, double *out_u, double *out_v);

#ifdef __cplusplus
}
#endif
#endif
