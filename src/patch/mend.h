/*
 * Edits of patches with bad rulings: too flat to the geodesic, or an edge of regression within the
 * extent. What they return is another input, or several; nothing is left of the old one.
 */
#ifndef KG_PATCH_MEND_H
#define KG_PATCH_MEND_H

#include "katagami/patch.h"

/* Whether a patch can be made of it with the whole extent, and no ruling flatter than
 * KG_FLAT_RULING. */
bool kg_patch_is_sound(const kg_patch_input *input);

/* The ends of the geodesic stay; the inner points are moved into the plane through the chord that
 * they are nearest to. KG_ERR_INPUT: it ends where it begins. */
kg_status kg_patch_flatten(const kg_patch_input *input, kg_patch_input *out,
                           kg_error *error) KG_CHECKED;

/*
 * Spreads the torsion of a cubic. At its ends
 *
 *     cot θ = E |e|³ / (2 |e × e2|³) = E / (2 |e2|³ sin³φ)     E = det(e1, e2, e3), e = e1 or e3
 *
 * so the rulings at both ends are parallel on paper where the turning angles φ of the control
 * polygon are equal. With the ends and their tangents T0, T1 kept, the arms a = |e1| and b = |e3|
 * make them so on the line
 *
 *     (a - b) (1 - T0·T1) = (T0 - T1)·(p3 - p0)
 *
 * Of it the place nearest to the arms as they are is taken that is sound; of the way there, no more
 * than it needs. Where there is none, the inner points are moved towards a plane until there is.
 * A patch that is sound already gets equal angles.
 * KG_ERR_INPUT: six points; a straight or planar geodesic; no such patch exists: the geodesic bends
 * both ways, or too sharply for its extent.
 */
kg_status kg_patch_equalize(const kg_patch_input *input, kg_patch_input *out,
                            kg_error *error) KG_CHECKED;

/* A patch divided in two with a plane in between, and what cuts the three along their common
 * rulings. */
typedef struct kg_patch_parts {
    kg_patch_input halves[2], plane;
    kg_vec2 contour[4]; /* of the plane: what stays, (u, v) */
    /* planes through the last ruling of the first half and the first of the second; each half
     * reaches a little beyond its own */
    kg_patch_input cutters[2];
    kg_vec3 keep[3]; /* places on the halves and on the plane that stay */
} kg_patch_parts;

/*
 * Divides a patch where it bends the other way or too sharply. Two developables meet smoothly along
 * a ruling of each on the two sides of a plane if both have its normal there as theirs; the plane's
 * geodesic is straight, and as long as the rulings need in order not to cross within the extent,
 * |u| |cot θ1 - cot θ2|.
 *
 * Ends and end tangents are kept, the halves are cubics. Free are the place and the tangent of the
 * plane's geodesic, the direction of its normal, and the arms at the plane; the arms at the ends
 * follow, because the osculating planes of both halves have to hold the normal. They are searched
 * (Nelder and Mead 1965, "A simplex method for function minimization") from the point in the middle
 * for the least movement of control points that leaves both halves sound.
 * KG_ERR_INPUT: a straight or planar geodesic; no such halves were found.
 */
kg_status kg_patch_divide(const kg_patch_input *input, kg_patch_parts *out,
                          kg_error *error) KG_CHECKED;

#endif
