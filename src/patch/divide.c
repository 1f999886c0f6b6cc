#include "patch/mend.h"
#include "patch/simplex.h"
#include "patch/strain.h"

#include <string.h>

/* Shares of the patch's size: between the rulings of both halves where they come nearest; the
 * halves beyond their cutters; the plane beyond its contour and the cutters beyond the edges. */
#define LEAST_GAP 0.02
#define BEYOND 0.02
#define PAD 0.05

/* The plane's geodesic is no longer than this share of the patch's size. */
#define LONGEST_GAP 0.3

/* Arms are between these multiples of those of the patch divided as it is. */
#define SHORTEST_ARM 0.3
#define LONGEST_ARM 3.0

/* What is searched. */
enum { PLACE, TURN_X, TURN_Y, NORMAL, ARM_0, ARM_1, ASIDE_X, ASIDE_Y, VARIABLES };
enum { NORMALS = 6, ROUNDS = 250, ROUNDS_AGAIN = 400 };

/* Against movement, which is a share of the size; of cot² θ at the plane, where slanting rulings
 * make the strip narrow. */
#define FAULT_WEIGHT 100.0
#define SLANT_WEIGHT 0.02

typedef struct chain {
    kg_vec3 halves[2][4]; /* as far as their cutters */
    kg_vec3 longer[2][4]; /* and beyond */
    double extents[2][2];
    bool turned[2]; /* u runs the other way than along the patch */
    kg_vec3 tangent, normal;
    double slant[2]; /* cot θ at the plane, across it in the sense of the first half */
    double movement, fault;
} chain;

/* ---- cubics ----------------------------------------------------------------------------- */

/* The cubic with the ends and end derivatives of a curve. */
static void to_cubic(const kg_curve *c, kg_vec3 out[4]) {
    int n = c->degree;
    out[0] = c->points[0];
    out[1] = kg_madd(out[0], n / 3.0, kg_sub(c->points[1], c->points[0]));
    out[3] = c->points[n];
    out[2] = kg_madd(out[3], n / 3.0, kg_sub(c->points[n - 1], c->points[n]));
}

/* Binormal and cot θ at an end. */
static kg_vec3 end_binormal(const kg_vec3 p[4], int end) {
    kg_vec3 e = end ? kg_sub(p[3], p[2]) : kg_sub(p[1], p[0]), middle = kg_sub(p[2], p[1]);
    return kg_unit(end ? kg_cross(middle, e) : kg_cross(e, middle));
}
static double end_slant(const kg_vec3 p[4], int end) {
    kg_vec3 e1 = kg_sub(p[1], p[0]), e2 = kg_sub(p[2], p[1]), e3 = kg_sub(p[3], p[2]);
    kg_vec3 e = end ? e3 : e1;
    double q = kg_len(e) / kg_len(kg_cross(e, e2));
    return 0.5 * kg_dot(kg_cross(e1, e2), e3) * q * q * q;
}

/* The same cubic, `by` mm farther at an end: de Casteljau beyond it. */
static void lengthen(const kg_vec3 p[4], int end, double by, kg_vec3 out[4]) {
    double v = fmin(by / (3 * kg_dist(p[2 * end], p[2 * end + 1])), 0.25);
    kg_vec3 from[4];
    for (int i = 0; i < 4; i++)
        from[i] = p[end ? i : 3 - i];
    for (int i = 0; i < 4; i++) {
        out[end ? i : 3 - i] = from[0];
        for (int k = 0; k < 3 - i; k++)
            from[k] = kg_lerp(from[k], from[k + 1], 1 + v);
    }
}

/* ---- a chain for some values of the variables --------------------------------------------- */

typedef struct task {
    const kg_patch_input *input;
    kg_curve curve;
    kg_vec3 binormal; /* at the start: which side u counts to */
    double size;
} task;

/* Any two directions across t and each other. */
static void across(kg_vec3 t, kg_vec3 *x, kg_vec3 *y) {
    *x = kg_unit(kg_cross(t, fabs(t.z) < 0.6 ? kg_v3(0, 0, 1) : kg_v3(1, 0, 0)));
    *y = kg_cross(t, *x);
}

static double excess(double x, double lo, double hi) {
    return fmax(lo - x, 0) + fmax(x - hi, 0);
}

/* Extents in the sense of each half's own rulings. The second goes on from the first, whose
 * binormal is turned round where the chain bends the other way. */
static void orient(const task *t, chain *c) {
    kg_vec3 last = end_binormal(c->halves[0], 1);
    c->turned[0] = kg_dot(end_binormal(c->halves[0], 0), t->binormal) < 0;
    c->turned[1] = c->turned[0] != (kg_dot(end_binormal(c->halves[1], 0), last) < 0);
    for (int i = 0; i < 2; i++) {
        const double *wished = t->input->extent;
        c->extents[i][0] = c->turned[i] ? -wished[1] : wished[0];
        c->extents[i][1] = c->turned[i] ? -wished[0] : wished[1];
        c->slant[i] = end_slant(c->halves[i], 1 - i);
    }
    if (c->turned[0] != c->turned[1])
        c->slant[1] = -c->slant[1];
}

/* The unit ruling of a half at the plane. */
static kg_vec3 end_ruling(const chain *c, int half) {
    kg_vec3 binormal = end_binormal(c->halves[half], 1 - half);
    return kg_unit(kg_madd(binormal, end_slant(c->halves[half], 1 - half), c->tangent));
}

/* How long the plane has to be for its rulings not to cross. */
static double gap_needed(const task *t, const chain *c) {
    double reach = fmax(fabs(t->input->extent[0]), fabs(t->input->extent[1]));
    return LEAST_GAP * t->size + reach * fabs(c->slant[0] - c->slant[1]);
}

/* False where there is no chain at all. */
static bool build(const task *t, const double *z, chain *c) {
    double v = 1 / (1 + exp(-z[PLACE])), size = t->size;
    kg_curve parts[2];
    kg_vec3 start[2][4], x, y;
    c->fault = 10 * excess(v, 0.1, 0.9) + excess(z[ARM_0], -1, 1) + excess(z[ARM_1], -1, 1);
    if (!(v > 0.01 && v < 0.99))
        return false;
    parts[0] = kg_curve_segment(&t->curve, 0, v);
    parts[1] = kg_curve_segment(&t->curve, v, 1);
    to_cubic(&parts[0], start[0]);
    to_cubic(&parts[1], start[1]);
    kg_vec3 tangent = kg_unit(kg_sub(start[0][3], start[0][2]));
    across(tangent, &x, &y);
    kg_vec3 middle = kg_madd(kg_madd(start[0][3], z[ASIDE_X] * size, x), z[ASIDE_Y] * size, y);
    c->tangent = kg_unit(kg_madd(kg_madd(tangent, z[TURN_X], x), z[TURN_Y], y));
    across(c->tangent, &x, &y);
    c->normal = kg_add(kg_scale(x, cos(z[NORMAL])), kg_scale(y, sin(z[NORMAL])));
    kg_vec3 side = kg_cross(c->tangent, c->normal);

    /* the outer arms end in the osculating planes: (p + arm t - middle)·side = 0 */
    double outer[2];
    for (int i = 0; i < 2; i++) {
        const kg_vec3 *p = start[i];
        kg_vec3 end = p[3 * i], arm = kg_sub(p[1 + i], end);
        double length = kg_len(arm);
        outer[i] = -kg_dot(kg_sub(end, middle), side) / kg_dot(arm, side);
        c->fault += excess(outer[i], SHORTEST_ARM, LONGEST_ARM);
        if (!(outer[i] * length > 1e-3 * size && outer[i] < 2 * LONGEST_ARM))
            return false;
        c->halves[i][3 * i] = end;
        c->halves[i][1 + i] = kg_madd(end, outer[i], arm);
    }
    double inner[2] = {kg_dist(start[0][2], start[0][3]) * exp(z[ARM_0]),
                       kg_dist(start[1][0], start[1][1]) * exp(z[ARM_1])};
    double gap = 2 * LEAST_GAP * size, needed = gap;
    for (int i = 0; i < 3; i++) {
        c->halves[0][3] = kg_madd(middle, -0.5 * gap, c->tangent);
        c->halves[1][0] = kg_madd(middle, 0.5 * gap, c->tangent);
        c->halves[0][2] = kg_madd(c->halves[0][3], -inner[0], c->tangent);
        c->halves[1][1] = kg_madd(c->halves[1][0], inner[1], c->tangent);
        orient(t, c);
        needed = gap_needed(t, c);
        if (!(needed > gap))
            break;
        gap = fmin(1.05 * needed, LONGEST_GAP * size);
    }
    c->fault += fmin(fmax(needed - gap, 0) / size, 5);
    c->movement = 0;
    for (int i = 0; i < 2; i++) {
        lengthen(c->halves[i], 1 - i, BEYOND * size, c->longer[i]);
        kg_strain s = kg_cubic_strain(c->longer[i], c->extents[i]);
        if (!isfinite(s.reach) || !isfinite(needed))
            return false;
        kg_vec3 at = c->halves[i][3 * (1 - i)], ruling = end_ruling(c, i);
        double back = kg_cubic_reach_back(c->longer[i], c->extents[i], at, ruling,
                                          kg_unit(kg_cross(ruling, c->normal)), 2 * BEYOND * size);
        c->fault += fmin(fmax(log(s.reach / KG_EASY_STRAIN), 0), 5) +
                    fmin(fmax(log(back / KG_EASY_STRAIN), 0), 5) +
                    5 * fmax(KG_EASY_THETA - s.theta, 0);
        for (int k = 0; k < 4; k++)
            c->movement = fmax(c->movement, kg_dist(c->halves[i][k], start[i][k]) / size);
    }
    return true;
}

static double worth(const chain *c) {
    return c->movement + SLANT_WEIGHT * (c->slant[0] * c->slant[0] + c->slant[1] * c->slant[1]);
}

static double cost(const double *z, const void *data) {
    chain c;
    if (!build(data, z, &c))
        return HUGE_VAL;
    return FAULT_WEIGHT * c.fault + worth(&c);
}

/* ---- the parts of a chain ----------------------------------------------------------------- */

static void straight(kg_patch_input *in, kg_vec3 a, kg_vec3 b, kg_vec3 ruling) {
    *in = (kg_patch_input){.point_count = 4, .has_ruling = true, .ruling = ruling};
    for (int i = 0; i < 4; i++)
        in->points[i] = kg_lerp(a, b, i / 3.0);
}

/* The plane's u runs as that of the first half does. In its (along, u) from the first half's end,
 * the rulings at its sides are lines through (0, 0) and (gap, 0). */
static void make_plane(const task *t, const chain *c, kg_patch_parts *out) {
    kg_vec3 side = end_binormal(c->halves[0], 1), a = c->halves[0][3];
    double gap = kg_dist(c->halves[1][0], a), beyond = BEYOND * t->size, pad = PAD * t->size;
    kg_vec2 corner[4]; /* low edge from the first half to the second, and the high edge back */
    for (int i = 0; i < 4; i++) {
        int half = i == 1 || i == 2, high = i >= 2;
        double u = c->extents[0][high], slant = c->slant[half], sine = 1 / sqrt(1 + slant * slant);
        corner[i] = kg_v2(u * sine * slant + half * gap, u * sine);
    }
    double lo = 0, hi = gap;
    kg_vec2 stretched[4];
    for (int i = 0; i < 4; i++) {
        kg_vec2 other = corner[i ^ 1], way = kg_sub2(corner[i], other);
        way = kg_scale2(way, beyond / kg_len2(way));
        stretched[i] = kg_add2(corner[i], way);
        lo = fmin(lo, stretched[i].x);
        hi = fmax(hi, stretched[i].x);
    }
    lo -= pad, hi += pad;
    straight(&out->plane, kg_madd(a, lo, c->tangent), kg_madd(a, hi, c->tangent), side);
    out->plane.extent[0] = c->extents[0][0] - pad;
    out->plane.extent[1] = c->extents[0][1] + pad;
    out->plane.flip = t->input->flip != c->turned[0];
    for (int i = 0; i < 4; i++)
        out->contour[i] = kg_v2(stretched[i].y, (stretched[i].x - lo) / (hi - lo));
    kg_vec2 middle =
        kg_scale2(kg_add2(kg_add2(corner[0], corner[1]), kg_add2(corner[2], corner[3])), 0.25);
    out->keep[2] = kg_madd(kg_madd(a, middle.x, c->tangent), middle.y, side);
}

static void make_parts(const task *t, const chain *c, kg_patch_parts *out) {
    double pad = PAD * t->size;
    for (int i = 0; i < 2; i++) {
        kg_patch_input *half = &out->halves[i];
        *half = (kg_patch_input){.point_count = 4, .flip = t->input->flip != c->turned[i]};
        memcpy(half->points, c->longer[i], 4 * sizeof half->points[0]);
        memcpy(half->extent, c->extents[i], sizeof half->extent);
        kg_vec3 at = c->halves[i][3 * (1 - i)], d = end_ruling(c, i);
        straight(&out->cutters[i], kg_madd(at, half->extent[0] - pad, d),
                 kg_madd(at, half->extent[1] + pad, d), c->normal);
        out->cutters[i].extent[0] = -BEYOND * t->size;
        out->cutters[i].extent[1] = BEYOND * t->size;
        double u = fmin(fmax(0, half->extent[0]), half->extent[1]);
        kg_patch patch;
        if (!kg_patch_init(half, &patch, NULL))
            out->keep[i] = kg_patch_point(&patch, u, 0.5);
    }
    make_plane(t, c, out);
}

static bool are_sound(const kg_patch_parts *parts) {
    return kg_patch_is_sound(&parts->halves[0]) && kg_patch_is_sound(&parts->halves[1]) &&
           kg_patch_is_sound(&parts->plane) && kg_patch_is_sound(&parts->cutters[0]) &&
           kg_patch_is_sound(&parts->cutters[1]);
}

kg_status kg_patch_divide(const kg_patch_input *input, kg_patch_parts *out, kg_error *error) {
    task t = {.input = input};
    kg_status status = kg_curve_init(input->points, input->point_count, &t.curve, error);
    if (status)
        return status;
    if (kg_curve_classify(&t.curve) != KG_CURVE_SPATIAL)
        return kg_fail(error, KG_ERR_INPUT, "lies in a plane: its rulings are parallel already");
    t.size = kg_curve_size(&t.curve);
    kg_vec3 d[3];
    kg_curve_derivatives(&t.curve, 0, 2, d);
    t.binormal = kg_cross(d[1], d[2]);
    double least = HUGE_VAL;
    kg_patch_parts parts;
    for (int i = 0; i < NORMALS; i++) {
        double z[VARIABLES] = {[NORMAL] = KG_PI * i / NORMALS};
        chain c;
        kg_simplex_descend(cost, &t, VARIABLES, 0.15, ROUNDS, z);
        if (!build(&t, z, &c) || c.fault > 0.1)
            continue;
        /* again from a fresh simplex: the first has shrunk beside the limits */
        kg_simplex_descend(cost, &t, VARIABLES, 0.05, ROUNDS_AGAIN, z);
        if (!build(&t, z, &c) || c.fault > 0 || worth(&c) >= least)
            continue;
        make_parts(&t, &c, &parts);
        if (!are_sound(&parts))
            continue;
        least = worth(&c);
        *out = parts;
    }
    return isfinite(least) ? KG_OK
                           : kg_fail(error, KG_ERR_INPUT,
                                     "no plane was found that leaves two sound halves; narrow the "
                                     "extent or flatten the geodesic");
}
