/*
 * The dolphin's shape as smooth functions: what its reference mesh is drawn from and its paper
 * model is fitted to. 250 mm long, head towards +x, left side towards +y, z up.
 *
 * Trunk and beak are tubes of half-elliptic cross-sections square to x (upper and lower halves meet
 * at the middle height); fins are thin lenses between a leading and a trailing edge.
 */
#ifndef KG_SAMPLES_DOLPHIN_SHAPE_H
#define KG_SAMPLES_DOLPHIN_SHAPE_H

#include "katagami/base.h"

typedef enum dolphin_tube { DOLPHIN_TRUNK, DOLPHIN_BEAK } dolphin_tube;

/* All of these are of the left side; right ones are mirrored in y. */
typedef enum dolphin_fin { DOLPHIN_DORSAL, DOLPHIN_FLIPPER, DOLPHIN_FLUKE } dolphin_fin;

/* Flukes and flippers rise towards the front, as the tail does there: 16.26°, a slope whose sine
 * and cosine have few decimals. */
#define DOLPHIN_FIN_RISE (0.28 / 0.96)

/* Half an ellipse above the middle height, half below. */
typedef struct dolphin_section {
    double x, middle;           /* centre of the ellipses */
    double width, above, below; /* radii */
} dolphin_section;

/* t in [0,1] from the front end to the rear end. */
dolphin_section dolphin_section_at(dolphin_tube tube, double t);

/* The point of the section at the angle phi, 0 on the left, pi/2 on top. */
kg_vec3 dolphin_section_point(const dolphin_section *section, double phi);

/* Where the section's outward normal is (0, cos psi, sin psi): the contour of the tube as seen
 * square to that direction. */
kg_vec3 dolphin_section_contour(const dolphin_section *section, double psi);

/* Unit outward normal of the tube where the section's own is (0, cos psi, sin psi). */
kg_vec3 dolphin_tube_normal(dolphin_tube tube, double t, double psi);

/* The fin's middle surface: span in [0,1] from root to tip, chord in [0,1] from leading to trailing
 * edge; out_thickness may be NULL. */
kg_vec3 dolphin_fin_point(dolphin_fin fin, double span, double chord, double *out_thickness);

/* Unit normal of the middle surface at mid-chord, upwards (of the dorsal fin: to the left). */
kg_vec3 dolphin_fin_normal(dolphin_fin fin, double span);

#endif
