#include "tests/origami/samples.h"

#include "tests/check.h"

void add_rectangle(kg_origami *o, double x, double y, double width, double height) {
    kg_vec2 p[] = {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
    kg_paper_sheet sheet = {.count = 4, .polygon = p, .front = 0xcc3333, .back = 0xffffff};
    assert_int_equal(kg_origami_add_sheet(o, &sheet, NULL), KG_OK);
}

kg_origami *square_sheet(double side) {
    kg_origami *o = kg_origami_create();
    assert_non_null(o);
    add_rectangle(o, 0, 0, side, side);
    return o;
}

kg_fold fold_to(kg_vec3 from, kg_vec3 to, double angle_deg) {
    kg_fold f = kg_fold_default();
    f.points[0] = from, f.points[1] = to, f.angle_deg = angle_deg;
    return f;
}

kg_fold fold_axis(kg_vec3 p, kg_vec3 q, kg_vec3 vertex, double angle_deg) {
    kg_fold f = fold_to(p, q, angle_deg);
    f.by_axis = true, f.vertex = vertex;
    return f;
}

void must_fold(kg_origami *o, kg_fold fold) {
    kg_error error = {0};
    if (kg_origami_fold(o, &fold, &error))
        fail_msg("%s", error.message);
}

void must_refuse(kg_origami *o, kg_fold fold, kg_error *error) {
    size_t step = kg_origami_step(o);
    assert_int_equal(kg_origami_fold(o, &fold, error), KG_ERR_INPUT);
    assert_int_equal(kg_origami_step(o), step);
}

const kg_origami_state *last(const kg_origami *o) {
    return kg_origami_state_at(o, kg_origami_step(o));
}
