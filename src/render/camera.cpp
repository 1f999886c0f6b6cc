#include "render/camera.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>

#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace {

constexpr double margin = 1.05;   // of a fitted picture
constexpr double thinnest = 1e-4; // near plane over far plane: leaves 24 bits of depth usable
constexpr double smallest = 1e-6; // mm, the closest an eye may come to its center

glm::dvec3 vec(kg_vec3 p) {
    return {p.x, p.y, p.z};
}
kg_vec3 vec(glm::dvec3 p) {
    return kg_v3(p.x, p.y, p.z);
}

struct axes {
    glm::dvec3 right, up, back;
};

axes axes_of(const kg_camera &c) {
    double cy = std::cos(c.yaw), sy = std::sin(c.yaw), cp = std::cos(c.pitch),
           sp = std::sin(c.pitch);
    return {{cy, sy, 0}, {-sy * sp, cy * sp, cp}, {sy * cp, -cy * cp, sp}};
}

glm::dmat4 view(const kg_camera &c, glm::dvec3 origin) {
    axes a = axes_of(c);
    glm::dmat4 turn(glm::transpose(glm::dmat3(a.right, a.up, a.back)));
    glm::dmat4 to_center = glm::translate(glm::dmat4(1), origin - vec(c.center));
    return glm::translate(glm::dmat4(1), glm::dvec3(0, 0, -c.distance)) * turn * to_center;
}

// Half the picture's height at distance 1.
double slope(const kg_camera &c) {
    assert(c.distance > 0 && c.field_of_view > 0 && c.field_of_view < glm::pi<double>());
    return std::tan(c.field_of_view / 2);
}

glm::dmat4 projection(const kg_camera &c, double aspect, double near, double far) {
    if (!c.ortho)
        return glm::perspective(c.field_of_view, aspect, near, far);
    double half = c.distance * slope(c);
    return glm::ortho(-half * aspect, half * aspect, -half, half, near, far);
}

void store(const glm::dmat4 &m, float out[16]) {
    glm::mat4 rounded(m);
    std::memcpy(out, glm::value_ptr(rounded), sizeof(float) * 16);
}

} // namespace

static const char *const view_names[KG_VIEW_COUNT] = {"front", "back",   "left", "right",
                                                      "top",   "bottom", "iso"};

const char *kg_view_name(kg_view view) {
    assert(view >= 0 && view < KG_VIEW_COUNT);
    return view_names[view];
}

bool kg_view_parse(const char *name, kg_view *out_view) {
    for (int i = 0; i < KG_VIEW_COUNT; i++) {
        if (std::strcmp(name, view_names[i]) == 0) {
            *out_view = static_cast<kg_view>(i);
            return true;
        }
    }
    return false;
}

kg_camera kg_camera_default(void) {
    kg_camera c = {};
    c.field_of_view = glm::radians(30.0);
    c.distance = 1;
    kg_camera_look(&c, KG_VIEW_ISO);
    kg_box3 box = {kg_v3(-100, -100, -100), kg_v3(100, 100, 100)};
    kg_camera_fit(&c, box, 1);
    return c;
}

void kg_camera_look(kg_camera *camera, kg_view view) {
    const double pi = glm::pi<double>();
    static const double turns[KG_VIEW_COUNT][2] = {
        {0, 0}, {pi, 0}, {-pi / 2, 0}, {pi / 2, 0}, {0, pi / 2}, {0, -pi / 2}, {pi / 5, pi / 7},
    };
    assert(view >= 0 && view < KG_VIEW_COUNT);
    camera->yaw = turns[view][0];
    camera->pitch = turns[view][1];
}

void kg_camera_fit(kg_camera *camera, kg_box3 box, double aspect) {
    if (!(box.lo.x <= box.hi.x))
        return;
    axes a = axes_of(*camera);
    glm::dvec3 half = (vec(box.hi) - vec(box.lo)) / 2.0;
    double t = slope(*camera) / margin, distance = 0;
    for (int i = 0; i < 8; i++) {
        glm::dvec3 corner = half * glm::dvec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
        double x = std::abs(glm::dot(corner, a.right)), y = std::abs(glm::dot(corner, a.up));
        double needed = std::max(y, x / aspect) / t;
        distance = std::max(distance, camera->ortho ? needed : needed + glm::dot(corner, a.back));
    }
    camera->center = vec((vec(box.hi) + vec(box.lo)) / 2.0);
    camera->distance = distance > smallest ? distance : 1;
}

double kg_camera_pixel_size(const kg_camera *camera, double height_px) {
    return 2 * camera->distance * slope(*camera) / height_px;
}

void kg_camera_axes(const kg_camera *camera, kg_vec3 *out_right, kg_vec3 *out_up,
                    kg_vec3 *out_back) {
    axes a = axes_of(*camera);
    *out_right = vec(a.right);
    *out_up = vec(a.up);
    *out_back = vec(a.back);
}

bool kg_camera_project(const kg_camera *camera, double width_px, double height_px, kg_vec3 point,
                       kg_vec3 *out_pixel) {
    glm::dvec4 p = view(*camera, glm::dvec3(0)) * glm::dvec4(vec(point), 1);
    double depth = -p.z, half = slope(*camera) * (camera->ortho ? camera->distance : depth);
    if (!(half > 0))
        return false;
    double px = height_px / (2 * half);
    *out_pixel = kg_v3(width_px / 2 + p.x * px, height_px / 2 - p.y * px, depth);
    return true;
}

void kg_camera_ray(const kg_camera *camera, double width_px, double height_px, kg_vec2 pixel,
                   kg_vec3 *out_origin, kg_vec3 *out_direction) {
    axes a = axes_of(*camera);
    double mm = kg_camera_pixel_size(camera, height_px);
    glm::dvec3 eye = vec(camera->center) + camera->distance * a.back;
    glm::dvec3 side =
        (pixel.x - width_px / 2) * mm * a.right + (height_px / 2 - pixel.y) * mm * a.up;
    *out_origin = vec(camera->ortho ? eye + side : eye);
    *out_direction =
        vec(camera->ortho ? -a.back : glm::normalize(side - camera->distance * a.back));
}

void kg_camera_range(const kg_camera *camera, kg_box3 box, double *out_near, double *out_far) {
    double middle = camera->distance, radius = camera->distance;
    if (box.lo.x <= box.hi.x) {
        axes a = axes_of(*camera);
        glm::dvec3 lo = vec(box.lo), hi = vec(box.hi);
        middle -= glm::dot((lo + hi) / 2.0 - vec(camera->center), a.back);
        // A tenth more for lines and points, which are drawn lifted towards the eye.
        radius = std::max(glm::length(hi - lo) / 2 * 1.1, camera->distance * 1e-3);
    }
    double near = middle - radius, far = middle + radius;
    if (!camera->ortho) {
        far = std::max(far, smallest);
        near = std::max(near, far * thinnest);
    }
    *out_near = near;
    *out_far = far;
}

void kg_camera_view(const kg_camera *camera, kg_vec3 origin, float out_matrix[16]) {
    store(view(*camera, vec(origin)), out_matrix);
}

void kg_camera_projection(const kg_camera *camera, double aspect, double near, double far,
                          float out_matrix[16]) {
    store(projection(*camera, aspect, near, far), out_matrix);
}
