#include "model/mirror.h"

#include "base/writer.h"

#include <string.h>

static const kg_mirror_plane usual = {1, 0};
static const char *const axes[] = {"x", "y", "z"};

bool kg_mirror_plane_equal(kg_mirror_plane a, kg_mirror_plane b) {
    return a.axis == b.axis && a.at == b.at;
}

kg_mirror_plane kg_mirror_plane_read(const json_t *root) {
    const json_t *mirror = json_object_get(root, "mirror");
    const char *across = json_string_value(json_object_get(mirror, "across"));
    double at = json_number_value(json_object_get(mirror, "at"));
    for (int i = 0; across && i < 3; i++)
        if (strcmp(across, axes[i]) == 0 && fabs(at) <= KG_MAX_COORDINATE)
            return (kg_mirror_plane){i, at};
    return usual;
}

bool kg_mirror_plane_write(kg_mirror_plane plane, json_t *root) {
    bool is_usual = kg_mirror_plane_equal(plane, usual);
    if (is_usual && kg_mirror_plane_equal(kg_mirror_plane_read(root), usual))
        return true;
    return kg_write_if(
        root, "mirror", !is_usual,
        json_pack("{s:s,s:o}", "across", axes[plane.axis], "at", kg_write_number(plane.at)));
}

kg_vec3 kg_mirror_plane_normal(kg_mirror_plane plane) {
    return kg_v3(plane.axis == 0, plane.axis == 1, plane.axis == 2);
}
