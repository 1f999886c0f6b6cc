/*
 * Fits a patch to a line on a surface: least squares over the control points (Levenberg-Marquardt,
 * MINPACK).
 *
 * A developable that touches a surface along a curve is the envelope of the tangent planes there.
 * So what is asked is that the geodesic keeps to the line and that the patch's normals are the
 * surface's; the rulings follow from that.
 */
#ifndef KG_SAMPLES_SHEET_FIT_H
#define KG_SAMPLES_SHEET_FIT_H

#include "katagami/patch.h"

/* The line: point and unit surface normal at s in [0,1]. */
typedef void (*sheet_line_fn)(const void *user, double s, kg_vec3 *out_point, kg_vec3 *out_normal);

typedef struct sheet_wish {
    sheet_line_fn line;
    const void *user;
    size_t point_count;   /* 4 or 6 */
    double front, behind; /* mm: straight leads along the line's tangents before 0 and after 1 */
    /* A planar geodesic keeps to the plane through `origin` along two unit directions, and its
     * patch is a cylinder; its line is taken as seen square to that plane. Directions with few
     * decimals keep rounded control points in the plane. */
    bool planar;
    kg_vec3 origin, along, across;
} sheet_wish;

/* Sets points and point_count of `out_input`, rounded to four decimals. KG_ERR_INPUT when the fit
 * does not come to rest or no patch can be made of its result. */
kg_status sheet_fit(const sheet_wish *wish, kg_patch_input *out_input, kg_error *error) KG_CHECKED;

#endif
