#include "samples/dolphin_shape.h"

#include "samples/spline.h"

#define ROWS(a) ((int)(sizeof(a) / sizeof(a)[0]))

/* The pose: a body drawn straight is bent down towards both ends from its highest place. */
static double arch(double x) {
    const double highest = 30, bend = 0.00115; /* mm, 1/mm */
    return -bend * (x - highest) * (x - highest);
}

/* Control rows of the straight tubes: x, top, bottom, half width. */
static const double trunk[][4] = {
    {106, -6, -6, 0},       {106, 2, -12.5, 8.5},  {102, 11.5, -16.5, 12.5}, {91, 18, -20.5, 17.5},
    {69, 22.5, -25, 22},    {42, 26, -27.5, 24},   {12, 25, -26.5, 22.5},    {-18, 21, -22.5, 18},
    {-48, 15.5, -17, 12.5}, {-75, 10.5, -12, 8.2}, {-96, 6.2, -7.7, 5.2},    {-109, 2.8, -4.2, 3.6},
    {-114, 0.2, -1.5, 3},   {-114, -0.6, -0.6, 0},
};
static const double beak[][4] = {
    {125, -6, -6, 0},        {125, -5, -7, 3.4},  {119, -3.6, -8.4, 5.4},
    {109, -0.8, -11.6, 6.8}, {96, 2.4, -14.6, 8}, {91, 2.4, -14.6, 8},
};

/* Control rows of the fins: leading edge, trailing edge, greatest thickness. */
static const double dorsal[][7] = {
    {23, 0, 14, -26, 0, 12, 5},     {16, 0, 22, -25, 0, 19, 4.5},  {5, 0, 32, -22, 0, 26, 4},
    {-9, 0, 42.5, -21.5, 0, 35, 3}, {-25, 0, 49, -27, 0, 44.5, 2}, {-32, 0, 50, -32, 0, 50, 0.4},
};
static const double flipper[][7] = {
    {64, 13, -13, 36, 13, -13, 5},     {62, 20.5, -17.5, 38, 20.5, -17.5, 4.5},
    {56, 31, -25, 34, 31, -25, 4},     {44, 40, -32.5, 27, 39.5, -32, 3},
    {27, 45.5, -39, 19, 45, -38.5, 2}, {18, 47, -41, 18, 47, -41, 0.4},
};
static const double fluke[][7] = {
    {-88, 0, -0.8, -113, 0, -0.8, 5},    {-91, 6, -0.8, -121, 3, -0.8, 4.5},
    {-96, 16, -1.4, -123, 11, -1.1, 4},  {-106, 28, -2.8, -120.5, 24, -2.2, 3},
    {-119, 37, -4.4, -121.5, 35, -4, 2}, {-125, 39, -5, -125, 39, -5, 0.4},
};

dolphin_section dolphin_section_at(dolphin_tube tube, double t) {
    double row[4];
    if (tube == DOLPHIN_TRUNK)
        spline_at(trunk[0], ROWS(trunk), 4, t, row);
    else
        spline_at(beak[0], ROWS(beak), 4, t, row);
    /* the widest place lies a little under the middle */
    double middle = row[2] + 0.48 * (row[1] - row[2]);
    return (dolphin_section){.x = row[0],
                             .middle = middle + arch(row[0]),
                             .width = row[3],
                             .above = row[1] - middle,
                             .below = middle - row[2]};
}

kg_vec3 dolphin_section_point(const dolphin_section *section, double phi) {
    double s = sin(phi);
    return kg_v3(section->x, section->width * cos(phi),
                 section->middle + s * (s > 0 ? section->above : section->below));
}

/* With normals (cos psi, sin psi) the point of an ellipse is (w² cos psi, a² sin psi) / h, h being
 * the distance of its tangent from the centre. */
kg_vec3 dolphin_section_contour(const dolphin_section *section, double psi) {
    double w = section->width, a = sin(psi) > 0 ? section->above : section->below;
    double c = w * cos(psi), s = a * sin(psi), h = hypot(c, s);
    if (h <= 0)
        return kg_v3(section->x, 0, section->middle);
    return kg_v3(section->x, w * c / h, section->middle + a * s / h);
}

/* The support function h(t) + middle(t) sin psi of the sections gives the tangent along x. */
kg_vec3 dolphin_tube_normal(dolphin_tube tube, double t, double psi) {
    const double step = 1e-4;
    double t0 = fmax(0, t - step), t1 = fmin(1, t + step);
    double y = cos(psi), z = sin(psi);
    dolphin_section s0 = dolphin_section_at(tube, t0), s1 = dolphin_section_at(tube, t1);
    kg_vec3 p0 = dolphin_section_contour(&s0, psi), p1 = dolphin_section_contour(&s1, psi);
    double dx = p1.x - p0.x, dh = (p1.y - p0.y) * y + (p1.z - p0.z) * z;
    /* square to (dx, dh) in the plane of x and (0, y, z); x falls as t grows */
    return kg_unit(kg_v3(dh, -dx * y, -dx * z));
}

kg_vec3 dolphin_fin_point(dolphin_fin fin, double span, double chord, double *out_thickness) {
    double row[7];
    if (fin == DOLPHIN_DORSAL)
        spline_at(dorsal[0], ROWS(dorsal), 7, span, row);
    else if (fin == DOLPHIN_FLIPPER)
        spline_at(flipper[0], ROWS(flipper), 7, span, row);
    else
        spline_at(fluke[0], ROWS(fluke), 7, span, row);
    if (out_thickness)
        *out_thickness = row[6] * 4 * chord * (1 - chord);
    kg_vec3 p = kg_lerp(kg_v3(row[0], row[1], row[2]), kg_v3(row[3], row[4], row[5]), chord);
    /* fins keep their form and move with the place of the body where they sit */
    double place = fin == DOLPHIN_DORSAL ? 0 : fin == DOLPHIN_FLIPPER ? 50 : -101;
    p.z += arch(place);
    if (fin != DOLPHIN_DORSAL)
        p.z += (p.x - place) * DOLPHIN_FIN_RISE;
    return p;
}

/* By differences; the chord shrinks to nothing at the tip, where it is taken a little before. */
kg_vec3 dolphin_fin_normal(dolphin_fin fin, double span) {
    const double step = 1e-3, tip = 0.98;
    kg_vec3 along = kg_sub(dolphin_fin_point(fin, fmin(1, span + step), 0.5, NULL),
                           dolphin_fin_point(fin, fmax(0, span - step), 0.5, NULL));
    kg_vec3 chord = kg_sub(dolphin_fin_point(fin, fmin(span, tip), 1, NULL),
                           dolphin_fin_point(fin, fmin(span, tip), 0, NULL));
    return kg_unit(kg_cross(along, chord));
}
