#include "net/path.h"

#include "base/array.h"

#include <stdlib.h>

void kg_path_clear(kg_path *path) {
    free(path->items);
    *path = (kg_path){0};
}

bool kg_path_move(kg_path *path, kg_vec2 p) {
    return kg_push(path, ((kg_path_step){KG_PATH_MOVE, {p}}));
}

bool kg_path_line(kg_path *path, kg_vec2 p) {
    return kg_push(path, ((kg_path_step){KG_PATH_LINE, {p}}));
}

bool kg_path_curve(kg_path *path, kg_vec2 p1, kg_vec2 p2, kg_vec2 p3) {
    return kg_push(path, ((kg_path_step){KG_PATH_CURVE, {p1, p2, p3}}));
}

bool kg_path_close(kg_path *path) {
    return kg_push(path, ((kg_path_step){.verb = KG_PATH_CLOSE}));
}

kg_vec2 kg_path_end(const kg_path_step *step) {
    return step->p[step->verb == KG_PATH_CURVE ? 2 : 0];
}

kg_vec2 kg_bezier2(const kg_vec2 p[4], double t) {
    double s = 1 - t, a = s * s * s, b = 3 * s * s * t, c = 3 * s * t * t, d = t * t * t;
    return kg_v2(a * p[0].x + b * p[1].x + c * p[2].x + d * p[3].x,
                 a * p[0].y + b * p[1].y + c * p[2].y + d * p[3].y);
}

int kg_bezier2_chords(const kg_vec2 p[4], double tolerance, int limit) {
    double bend = 0;
    for (int i = 0; i < 2; i++)
        bend = fmax(bend, kg_len2(kg_add2(kg_sub2(p[i], kg_scale2(p[i + 1], 2)), p[i + 2])));
    double chords = ceil(sqrt(0.75 * bend / tolerance));
    return chords < 1 ? 1 : chords > limit ? limit : (int)chords;
}
