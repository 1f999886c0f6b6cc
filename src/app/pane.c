#include "app/pane.h"

#include <string.h>

/* Radians per layout unit of an orbit: half a turn across a window of 700. */
#define ORBIT_SPEED 0.0045
#define ZOOM_NOTCH 1.15
#define MOST_DISTANCE 1e7
#define LEAST_DISTANCE 1e-2

static kg_vec2 inside(const kg_pane *v, kg_vec2 px) {
    return kg_v2(px.x - v->area.x, px.y - v->area.y);
}

bool kg_pane_project(const kg_pane *v, kg_vec3 point, kg_vec2 *out_px) {
    kg_vec3 pixel;
    if (!kg_camera_project(&v->camera, v->area.width, v->area.height, point, &pixel))
        return false;
    *out_px = kg_v2(pixel.x + v->area.x, pixel.y + v->area.y);
    return true;
}

void kg_pane_ray(const kg_pane *v, kg_vec2 px, kg_vec3 *out_origin, kg_vec3 *out_direction) {
    kg_camera_ray(&v->camera, v->area.width, v->area.height, inside(v, px), out_origin,
                  out_direction);
}

bool kg_pane_on_plane(const kg_pane *v, kg_vec2 px, kg_vec3 through, kg_vec3 normal,
                      kg_vec3 *out_point) {
    kg_vec3 origin, direction;
    kg_pane_ray(v, px, &origin, &direction);
    double slope = kg_dot(direction, normal);
    if (fabs(slope) < 1e-3) /* edge-on: a pixel is a metre */
        return false;
    double t = kg_dot(kg_sub(through, origin), normal) / slope;
    if (t < 0 && !v->camera.ortho)
        return false;
    *out_point = kg_madd(origin, t, direction);
    return true;
}

kg_vec3 kg_pane_on_screen_plane(const kg_pane *v, kg_vec2 px, kg_vec3 through) {
    kg_vec3 right, up, back, point = through;
    kg_camera_axes(&v->camera, &right, &up, &back);
    kg_pane_on_plane(v, px, through, back, &point);
    return point;
}

bool kg_pane_along_axis(const kg_pane *v, kg_vec2 px, kg_vec3 through, kg_vec3 axis,
                        double *out_mm) {
    kg_vec3 o, d;
    kg_pane_ray(v, px, &o, &d);
    kg_vec3 w = kg_sub(o, through);
    double b = kg_dot(axis, d), den = 1 - b * b;
    if (den < 1e-4)
        return false;
    *out_mm = (kg_dot(w, axis) - b * kg_dot(w, d)) / den;
    return isfinite(*out_mm);
}

double kg_segment_distance(kg_vec2 p, kg_vec2 a, kg_vec2 b, double *out_fraction) {
    kg_vec2 d = kg_sub2(b, a);
    double n = kg_dot2(d, d), f = n > 0 ? fmin(fmax(kg_dot2(kg_sub2(p, a), d) / n, 0), 1) : 0;
    if (out_fraction)
        *out_fraction = f;
    return kg_dist2(p, kg_lerp2(a, b, f));
}

static double distance_of(const void *hit) {
    double distance;
    memcpy(&distance, hit, sizeof distance);
    return distance;
}

size_t kg_hits_keep(void *hits, size_t count, size_t most, const void *hit, size_t size) {
    char *items = hits;
    size_t at = count;
    while (at > 0 && distance_of(items + (at - 1) * size) > distance_of(hit))
        at--;
    if (at == most)
        return count;
    size_t kept = count < most ? count + 1 : most;
    memmove(items + (at + 1) * size, items + at * size, (kept - 1 - at) * size);
    memcpy(items + at * size, hit, size);
    return kept;
}

double kg_pane_pixel_mm(const kg_pane *v, kg_vec3 point) {
    kg_vec3 right, up, back;
    double mm = kg_camera_pixel_size(&v->camera, v->area.height);
    kg_camera_axes(&v->camera, &right, &up, &back);
    double depth = v->camera.distance - kg_dot(kg_sub(point, v->camera.center), back);
    return v->camera.ortho || depth <= 0 ? mm : mm * depth / v->camera.distance;
}

void kg_pane_fit(kg_pane *v, kg_box3 box) {
    if (box.lo.x <= box.hi.x && kg_dist(box.lo, box.hi) < LEAST_DISTANCE)
        box.hi = kg_add(box.hi, kg_v3(1, 1, 1));
    kg_camera_fit(&v->camera, box, v->area.width / fmax(v->area.height, 1));
    v->framed = box;
    v->fitted = v->camera;
    v->size = kg_v2(v->area.width, v->area.height);
}

static double fitting_distance(const kg_pane *v, double width, double height) {
    kg_camera camera = v->camera;
    kg_camera_fit(&camera, v->framed, width / fmax(height, 1));
    return camera.distance;
}

void kg_pane_keep_frame(kg_pane *v) {
    kg_vec2 before = v->size;
    double width = v->area.width, height = v->area.height;
    if (width == before.x && height == before.y)
        return;
    v->size = kg_v2(width, height);
    if (!(before.x > 1) || v->camera.distance != v->fitted.distance ||
        kg_dist(v->camera.center, v->fitted.center) > 0)
        return;
    v->camera.distance *=
        fitting_distance(v, width, height) / fitting_distance(v, before.x, before.y);
    v->fitted = v->camera;
}

/* ---- the mouse -------------------------------------------------------------------------- */

static kg_pane_drag drag_of(const kg_event *e, kg_navigation navigation) {
    bool shift = e->mods & KG_MOD_SHIFT, ctrl = e->mods & KG_MOD_CTRL;
    if (navigation == KG_NAVIGATION_BLENDER) {
        if (e->button != KG_MOUSE_MIDDLE)
            return KG_DRAG_NONE;
        return shift ? KG_DRAG_PAN : ctrl ? KG_DRAG_ZOOM : KG_DRAG_ORBIT;
    }
    if (e->button == KG_MOUSE_MIDDLE)
        return KG_DRAG_PAN;
    return e->button != KG_MOUSE_RIGHT ? KG_DRAG_NONE : shift ? KG_DRAG_PAN : KG_DRAG_ORBIT;
}

static void zoom(kg_pane *v, kg_vec2 at, double factor) {
    double distance = fmin(fmax(v->camera.distance / factor, LEAST_DISTANCE), MOST_DISTANCE);
    factor = v->camera.distance / distance;
    /* what lies under the pointer, at the depth of the center, stays there */
    kg_vec3 fixed = kg_pane_on_screen_plane(v, at, v->camera.center);
    v->camera.center = kg_lerp(fixed, v->camera.center, 1 / factor);
    v->camera.distance = distance;
}

static void move(kg_pane *v, kg_vec2 to) {
    kg_vec2 by = kg_sub2(to, v->last);
    if (v->drag == KG_DRAG_ORBIT) {
        v->camera.yaw = remainder(v->camera.yaw - by.x / v->scale * ORBIT_SPEED, 2 * KG_PI);
        v->camera.pitch += by.y / v->scale * ORBIT_SPEED;
        v->camera.pitch = fmin(fmax(v->camera.pitch, -KG_PI / 2), KG_PI / 2);
    } else if (v->drag == KG_DRAG_PAN) {
        kg_vec3 from = kg_pane_on_screen_plane(v, v->last, v->camera.center);
        kg_vec3 now = kg_pane_on_screen_plane(v, to, v->camera.center);
        v->camera.center = kg_sub(v->camera.center, kg_sub(now, from));
    } else {
        zoom(v, v->pressed, exp(-0.01 * by.y / v->scale));
    }
    v->last = to;
}

bool kg_pane_event(kg_pane *v, const kg_event *e, kg_navigation navigation) {
    switch (e->type) {
    case KG_EVENT_PRESS:
        if (v->drag != KG_DRAG_NONE || drag_of(e, navigation) == KG_DRAG_NONE)
            return v->drag != KG_DRAG_NONE;
        v->drag = drag_of(e, navigation);
        v->button = e->button;
        v->pressed = v->last = e->position;
        v->moved = false;
        return true;
    case KG_EVENT_MOVE:
        if (v->drag == KG_DRAG_NONE)
            return false;
        if (!v->moved && kg_dist2(e->position, v->pressed) < KG_CLICK_DISTANCE * v->scale)
            return true;
        v->moved = true;
        move(v, e->position);
        return true;
    case KG_EVENT_RELEASE:
        if (v->drag == KG_DRAG_NONE || e->button != v->button)
            return false;
        v->drag = KG_DRAG_NONE;
        return v->moved || e->button != KG_MOUSE_RIGHT;
    case KG_EVENT_WHEEL:
        zoom(v, e->position, pow(ZOOM_NOTCH, e->wheel));
        return true;
    default:
        return false;
    }
}
