/* From models to nets: true sizes, every join once, and both sides of a join at the same place in
 * space. Paper is mapped back to space by an inverse of its own. */
#include "katagami/unroll.h"
#include "tests/model/random_model.h"

/* A model with everything made of it. */
typedef struct made {
    kg_model *model;
    kg_solution *solution;
    kg_unrolled *unrolled;
    kg_net *net;
} made;

static made make_at(kg_model *model, double tolerance) {
    made m = {.model = model};
    kg_error error;
    if (kg_solution_create(model, tolerance, NULL, &m.solution, &error))
        fail_msg("%s", error.message);
    if (kg_unroll(model, m.solution, &m.unrolled, &error))
        fail_msg("%s", error.message);
    m.net = m.unrolled->net;
    if (m.net->part_count > 0 && kg_net_check(m.net, &error))
        fail_msg("%s", error.message);
    return m;
}

static made make(kg_model *model) {
    made m = make_at(model, 0.001);
    kg_error error;
    if (kg_solution_check(m.solution, &error))
        fail_msg("%s", error.message);
    return m;
}

static void unmake(made *m) {
    kg_unrolled_destroy(m->unrolled);
    kg_solution_destroy(m->solution);
    kg_model_destroy(m->model);
}

static const kg_patch *patch_of_part(const made *m, int part) {
    return &kg_solution_find(m->solution, m->net->parts[part].source)->patch;
}

/* ---- from paper to space ---------------------------------------------------------------- */

/* How far right of the ruling at v a point lies, and where along it. */
static double off_ruling(const kg_patch *p, kg_vec2 q, double v, double *out_u) {
    kg_vec2 du, dv, o = kg_patch_unroll_derivatives(p, 0, v, &du, &dv);
    kg_vec2 d = kg_sub2(q, o);
    *out_u = kg_dot2(d, du);
    return kg_cross2(du, d);
}

/* The (u,v) of a point of the printed side, the nearest to `hint` where several rulings run through
 * it. */
static kg_vec2 fold_back(const kg_patch *p, kg_vec2 q, kg_vec3 hint) {
    enum { STEPS = 120 };
    if (p->flip)
        q.x = -q.x;
    kg_vec2 best = kg_v2(0, -1);
    double nearest = INFINITY;
    for (int i = -4; i < STEPS + 4; i++) { /* rounding may put the ends a hair outside */
        double lo = (double)i / STEPS, hi = (double)(i + 1) / STEPS, u;
        double flo = off_ruling(p, q, lo, &u), fhi = off_ruling(p, q, hi, &u);
        if ((flo > 0) == (fhi > 0))
            continue;
        for (int k = 0; k < 60; k++) {
            double mid = 0.5 * (lo + hi);
            if ((off_ruling(p, q, mid, &u) > 0) == (flo > 0))
                lo = mid;
            else
                hi = mid;
        }
        off_ruling(p, q, lo, &u);
        double d = kg_dist(kg_patch_point(p, u, lo), hint);
        if (d < nearest)
            nearest = d, best = kg_v2(u, lo);
    }
    assert_true(best.y > -1);
    return best;
}

static size_t side_count(const kg_net *net, const kg_net_side *side) {
    return side->loop >= 0 ? side->count : net->parts[side->part].lines[side->line].count;
}

/* Point i of a side of a join, in the order of side 0, on paper. */
static kg_vec2 side_point(const kg_net *net, const kg_net_side *side, size_t i) {
    size_t n = side_count(net, side);
    if (side->reversed)
        i = n - 1 - i;
    const kg_net_part *part = &net->parts[side->part];
    if (side->loop < 0)
        return part->lines[side->line].points[i];
    const kg_net_line *line = &part->loops[side->loop].line;
    return line->points[(side->first + i) % line->count];
}

static kg_vec3 side_space(const made *m, const kg_net_side *side, size_t i, kg_vec3 hint) {
    const kg_patch *p = patch_of_part(m, side->part);
    kg_vec2 uv = fold_back(p, side_point(m->net, side, i), hint);
    return kg_patch_point(p, uv.x, uv.y);
}

/* Both sides of a join are the same curve in space, point by point, and equally long. */
static void assert_sides_meet(const made *m, const kg_net_join *j) {
    size_t n = side_count(m->net, &j->sides[0]);
    assert_int_equal(n, side_count(m->net, &j->sides[1]));
    assert_true(n >= 2);
    assert_false(j->sides[0].reversed);
    assert_near(j->sides[0].length, j->sides[1].length, 1e-6 * j->sides[0].length);
    const kg_patch *a = patch_of_part(m, j->sides[0].part);
    for (size_t i = 0; i < n; i++) {
        kg_vec2 uv = {0};
        kg_vec3 x, y = kg_v3(0, 0, 0);
        /* each hints where the other is, so that neither can choose a wrong ruling alone */
        for (int k = 0; k < 3; k++) {
            uv = fold_back(a, side_point(m->net, &j->sides[0], i), y);
            x = kg_patch_point(a, uv.x, uv.y);
            y = side_space(m, &j->sides[1], i, x);
        }
        assert_near(kg_dist(x, y), 0, 4e-6);
    }
}

/* `blur`: mm by which cuts that nearly touch may stray from the exact curve where it is no longer
 * defined. */
static void assert_true_sizes_to(const made *m, double blur) {
    for (size_t i = 0; i < m->net->part_count; i++) {
        const kg_net_part *p = &m->net->parts[i];
        double shoelace = 0;
        for (size_t k = 0; k < p->loop_count; k++) {
            const kg_net_line *l = &p->loops[k].line;
            for (size_t q = 0; q < l->count; q++)
                shoelace += 0.5 * kg_cross2(l->points[q], l->points[(q + 1) % l->count]);
        }
        assert_true(shoelace > 0);
        assert_true(p->isometry_error < 1e-6);
        assert_near(p->area, p->surface, 1e-6 * p->surface + blur * p->perimeter);
        double slack = kg_solution_tolerance(m->solution) * p->perimeter;
        assert_near(shoelace, p->area, slack);
    }
}

static void assert_true_sizes(const made *m) {
    assert_true_sizes_to(m, 0);
}

static size_t count_joins(const made *m, kg_net_join_kind kind, int64_t a, int64_t b) {
    size_t n = 0;
    for (size_t i = 0; i < m->net->join_count; i++) {
        const kg_net_join *j = &m->net->joins[i];
        bool pair = (j->sources[0] == a && j->sources[1] == b) ||
                    (kind == KG_JOIN_SEAM && j->sources[0] == b && j->sources[1] == a);
        n += j->kind == kind && pair;
    }
    return n;
}

/* ---- folding a tab ---------------------------------------------------------------------- */

/* Folds a short tab on a side of a join in space and looks where it comes to lie. */
static void assert_tab_lies_on_the_other_part(const made *m, const kg_net_join *j, int side) {
    const kg_net_side *s = &j->sides[side];
    const kg_patch *p = patch_of_part(m, s->part);
    const kg_solved_patch *other = kg_solution_find(m->solution, j->sources[1 - side]);
    const kg_net_line *line = &m->net->parts[s->part].loops[s->loop].line;
    kg_vec2 a = line->points[s->first], b = line->points[(s->first + 1) % line->count];
    kg_vec2 d = kg_sub2(b, a), middle = kg_lerp2(a, b, 0.5);
    kg_vec2 out = kg_scale2(kg_v2(d.y, -d.x), 1 / kg_len2(d)); /* the paper is on the left */
    kg_vec2 uv = fold_back(p, middle, kg_v3(0, 0, 0)), du, dv;
    kg_vec3 xu, xv, x = kg_patch_derivatives(p, uv.x, uv.y, &xu, &xv);
    kg_patch_unroll_derivatives(p, uv.x, uv.y, &du, &dv);
    if (p->flip)
        out.x = -out.x;
    double det = kg_cross2(du, dv);
    kg_vec3 away =
        kg_add(kg_scale(xu, kg_cross2(out, dv) / det), kg_scale(xv, kg_cross2(du, out) / det));
    kg_vec3 front = kg_patch_normal(p, uv.y);
    kg_vec3 tab = kg_add(kg_scale(away, cos(j->fold[side])), kg_scale(front, sin(j->fold[side])));
    const double reach = 0.02;
    kg_vec3 tip = kg_madd(x, reach, tab);
    double u, v;
    /* the fold is the largest along the edge, and curved parts bend away from their tangents */
    bool flat = p->shape == KG_CURVE_STRAIGHT && other->patch.shape == KG_CURVE_STRAIGHT;
    assert_near(kg_patch_closest(&other->patch, tip, &u, &v), 0, reach * (flat ? 1e-9 : 0.3));
    bool on_paper = false;
    for (size_t i = 0; i < other->regions.count; i++)
        on_paper = on_paper || kg_region_contains(&other->regions.items[i], u, v);
    assert_true(on_paper);
}

/* Two planes through the y axis; patch 1 goes up from it to the left, patch 2 to the right. */
static kg_model *gable(double angle1, double angle2, bool flip1, bool flip2) {
    kg_model *m = checked(kg_model_create());
    const double angle[2] = {angle1, angle2};
    for (int i = 0; i < 2; i++) {
        kg_vec3 d = kg_v3(cos(angle[i]), 0, sin(angle[i]));
        kg_patch_input in =
            flat_input(kg_scale(d, -20), kg_scale(d, 40), kg_v3(0, i ? 1 : -1, 0), -30, 30);
        in.flip = i ? flip2 : flip1;
        kg_model_patch *p = add_patch(m, i + 1, in);
        insert_trim(p, 0, trim_by(2 - i));
        keep_near(&p->trims[0], kg_scale(d, 30));
    }
    return m;
}

static void folds_lay_tabs_on_the_other_part(void **state) {
    (void)state;
    for (int flips = 0; flips < 4; flips++)
        for (double angle = 0.3; angle < 6.1; angle += 0.45) {
            if (fabs(angle - 3.14) < 0.2)
                continue;
            made m = make(gable(0.2, 0.2 + angle, flips & 1, flips & 2));
            assert_int_equal(m.net->join_count, 1);
            const kg_net_join *j = &m.net->joins[0];
            assert_int_equal(j->kind, KG_JOIN_SEAM);
            assert_sides_meet(&m, j);
            assert_tab_lies_on_the_other_part(&m, j, 0);
            assert_tab_lies_on_the_other_part(&m, j, 1);
            unmake(&m);
        }
}

static void the_tab_of_a_contact_takes_the_flatter_side(void **state) {
    (void)state;
    for (int flips = 0; flips < 4; flips++)
        for (double angle = 0.3; angle < 3; angle += 0.4) {
            kg_model *model = gable(0.2, 0.2 + angle, flips & 1, flips & 2);
            model->patches[1].trims[0].off = true;
            made m = make(model);
            assert_int_equal(m.net->join_count, 1);
            const kg_net_join *j = &m.net->joins[0];
            assert_int_equal(j->kind, KG_JOIN_CONTACT);
            assert_sides_meet(&m, j);
            assert_tab_lies_on_the_other_part(&m, j, 0);
            assert_true(fabs(j->fold[0]) <= KG_PI / 2 + 1e-9);
            unmake(&m);
        }
}

/* ---- joins ------------------------------------------------------------------------------ */

static void random_models_unroll_truly(void **state) {
    (void)state;
    kg_random r = {11};
    size_t seams = 0, contacts = 0;
    for (int round = 0; round < 90; round++) {
        kg_model *model = random_model(&r, 6);
        /* let some cut each other both ways */
        for (size_t i = 0; i + 1 < model->patch_count; i++) {
            kg_model_patch *p = &model->patches[i], *q = &model->patches[i + 1];
            if (p->trim_count != 1 || p->trims[0].kind != KG_TRIM_BY || p->trims[0].by[0] != q->id)
                continue;
            insert_trim(q, 0, trim_by(p->id));
        }
        made m = make_at(model, 0.005);
        assert_true_sizes_to(&m, 1e-4);
        for (size_t i = 0; i < m.net->join_count; i++) {
            assert_sides_meet(&m, &m.net->joins[i]);
            *(m.net->joins[i].kind == KG_JOIN_SEAM ? &seams : &contacts) += 1;
        }
        unmake(&m);
    }
    print_message("%zu seams, %zu contacts\n", seams, contacts);
    assert_true(seams > 10 && contacts > 30);
}

/* z = 10 - x²/40 along y, and z = y²/40 along x: they cross in the circle x² + y² = 400. */
static kg_model *pillow(kg_vec3 keep_upper, kg_vec3 keep_lower, bool flip) {
    kg_model *m = checked(kg_model_create());
    for (int i = 0; i < 2; i++) {
        const double s = 30, h = s * s / 40;
        const double at[4] = {-s, -s / 3, s / 3, s}, z[4] = {h, -h / 3, -h / 3, h};
        kg_patch_input in = {.point_count = 4, .extent = {-30, 30}, .flip = flip};
        for (int k = 0; k < 4; k++)
            in.points[k] = i ? kg_v3(0, at[k], z[k]) : kg_v3(at[k], 0, 10 - z[k]);
        kg_model_patch *p = add_patch(m, i + 1, in);
        insert_trim(p, 0, trim_by(2 - i));
        keep_near(&p->trims[0], i ? keep_lower : keep_upper);
    }
    return m;
}

static void a_closed_curve_is_one_seam(void **state) {
    (void)state;
    const kg_vec3 middle = kg_v3(0, 0, 5), corner = kg_v3(30, 30, 0);
    for (int kind = 0; kind < 8; kind++) {
        made m = make(pillow(kind & 1 ? corner : middle, kind & 2 ? corner : middle, kind & 4));
        assert_int_equal(m.net->join_count, 1);
        const kg_net_join *j = &m.net->joins[0];
        assert_int_equal(j->kind, KG_JOIN_SEAM);
        for (int side = 0; side < 2; side++) {
            const kg_net_line *l =
                &m.net->parts[j->sides[side].part].loops[j->sides[side].loop].line;
            assert_int_equal(j->sides[side].count, l->count + 1);
            for (size_t i = 0; i < l->count; i++)
                assert_false(l->corners[i]); /* smooth all around, its start included */
            assert_tab_lies_on_the_other_part(&m, j, side);
        }
        assert_sides_meet(&m, j);
        assert_true_sizes(&m);
        unmake(&m);
    }
}

static void a_closed_contact_is_one_mark(void **state) {
    (void)state;
    kg_model *model = pillow(kg_v3(0, 0, 5), kg_v3(0, 0, 5), true);
    model->patches[0].trims[0].off = true;
    made m = make(model);
    assert_int_equal(m.net->join_count, 1);
    assert_int_equal(count_joins(&m, KG_JOIN_CONTACT, 2, 1), 1);
    assert_sides_meet(&m, &m.net->joins[0]);
    unmake(&m);
}

static void the_parts_of_a_split_patch_are_joined(void **state) {
    (void)state;
    kg_model *model = pillow(kg_v3(0, 0, 5), kg_v3(0, 0, 5), false);
    kg_patch_input in = flat_input(kg_v3(3, 0, -30), kg_v3(3, 0, 30), kg_v3(0.1, 1, 0), -50, 50);
    add_patch(model, 3, in)->construction = true;
    insert_trim(&model->patches[0], 1, trim_by(3));
    made m = make(model);
    assert_int_equal(m.net->part_count, 3);
    assert_int_equal(count_joins(&m, KG_JOIN_SEAM, 1, 1), 1);
    assert_int_equal(count_joins(&m, KG_JOIN_SEAM, 1, 2), 2);
    assert_int_equal(m.net->join_count, 3);
    for (size_t i = 0; i < m.net->join_count; i++)
        assert_sides_meet(&m, &m.net->joins[i]);
    assert_true_sizes(&m);
    unmake(&m);
}

static void patches_that_meet_on_a_construction_plane_are_joined(void **state) {
    (void)state;
    kg_model *model = gable(0.4, 2.5, false, true);
    add_patch(model, 3, flat_input(kg_v3(0, 0, -20), kg_v3(0, 0, 20), kg_v3(0, 1, 0), -40, 40))
        ->construction = true;
    model->patches[0].trims[0].by[0] = model->patches[1].trims[0].by[0] = 3;
    made m = make(model);
    assert_int_equal(m.net->part_count, 2);
    assert_int_equal(m.net->join_count, 1);
    assert_int_equal(count_joins(&m, KG_JOIN_SEAM, 1, 2), 1);
    assert_sides_meet(&m, &m.net->joins[0]);
    assert_tab_lies_on_the_other_part(&m, &m.net->joins[0], 0);
    assert_tab_lies_on_the_other_part(&m, &m.net->joins[0], 1);
    unmake(&m);
}

static void a_third_patch_on_a_seam_is_joined_once(void **state) {
    (void)state;
    kg_model *model = gable(0.4, 2.5, false, true);
    kg_model_patch *p =
        add_patch(model, 3, flat_input(kg_v3(0, 0, 20), kg_v3(0, 0, -40), kg_v3(0, 1, 0), -20, 20));
    insert_trim(p, 0, trim_by(1));
    keep_near(&p->trims[0], kg_v3(0, 0, -30));
    made m = make(model);
    assert_int_equal(m.net->join_count, 2);
    assert_int_equal(count_joins(&m, KG_JOIN_SEAM, 1, 2), 1);
    assert_int_equal(count_joins(&m, KG_JOIN_CONTACT, 3, 1), 1);
    for (size_t i = 0; i < 2; i++)
        assert_sides_meet(&m, &m.net->joins[i]);
    unmake(&m);
}

/* The ground, split in two by a construction plane, with a wall across the split; the wall is wider
 * than the ground. */
static kg_model *wall_across_a_seam(bool flip) {
    kg_model *m = checked(kg_model_create());
    add_patch(m, 1, flat_input(kg_v3(0, 0, 0), kg_v3(100, 0, 0), kg_v3(0, 1, 0), -50, 50));
    kg_patch_input in = flat_input(kg_v3(50, 0, -20), kg_v3(50, 0, 60), kg_v3(0, 1, 0), -70, 30);
    in.flip = flip;
    add_patch(m, 2, in);
    add_patch(m, 3, flat_input(kg_v3(-10, 0, -5), kg_v3(110, 20, -5), kg_v3(0, 0, 1), -9, 9))
        ->construction = true;
    insert_trim(&m->patches[0], 0, trim_by(3));
    insert_trim(&m->patches[1], 0, trim_by(1));
    keep_near(&m->patches[1].trims[0], kg_v3(50, 0, 40));
    return m;
}

static void a_contact_across_a_seam_is_two(void **state) {
    (void)state;
    for (int flip = 0; flip < 2; flip++) {
        made m = make_at(wall_across_a_seam(flip), 0.001);
        assert_int_equal(m.net->part_count, 3);
        assert_int_equal(count_joins(&m, KG_JOIN_CONTACT, 2, 1), 2);
        assert_int_equal(count_joins(&m, KG_JOIN_SEAM, 1, 1), 1);
        assert_int_equal(m.net->join_count, 3);
        double contact = 0;
        for (size_t i = 0; i < 3; i++) {
            assert_sides_meet(&m, &m.net->joins[i]);
            if (m.net->joins[i].kind == KG_JOIN_CONTACT)
                contact += m.net->joins[i].sides[0].length;
        }
        assert_near(contact, 80, 0.01); /* from the ground's edge at -50 to the wall's at 30 */
        unmake(&m);
    }
}

static void wishes_for_joins_follow_the_patches_they_name(void **state) {
    (void)state;
    for (int order = 0; order < 2; order++) {
        kg_model *model = gable(0.4, 2.5, false, true);
        model->joins = checked(calloc(1, sizeof *model->joins));
        model->join_count = 1;
        model->joins[0] = (kg_model_join){.patches = {order ? 2 : 1, order ? 1 : 2},
                                          .tab = KG_TAB_THIS,
                                          .width = 3,
                                          .shape = KG_TAB_TEETH};
        made m = make(model);
        const kg_net_join *j = &m.net->joins[0];
        assert_int_equal(j->sources[0], 1);
        assert_int_equal(j->tab_side, order ? KG_TAB_OTHER : KG_TAB_THIS);
        assert_int_equal(j->tab_shape, KG_TAB_TEETH);
        assert_near(j->tab_width, 3, 0);
        unmake(&m);
    }
}

/* ---- outlines --------------------------------------------------------------------------- */

static void contours_keep_their_corners_and_smooth_joints_have_none(void **state) {
    (void)state;
    kg_model *m = checked(kg_model_create());
    kg_model_patch *p =
        add_patch(m, 1, flat_input(kg_v3(0, 0, 0), kg_v3(100, 0, 0), kg_v3(0, 1, 0), -50, 50));
    kg_trim_op op = {.kind = KG_TRIM_CONTOUR,
                     .contour_count = 5,
                     .contour = checked(malloc(5 * sizeof *op.contour))};
    const kg_vec2 house[5] = {{-20, 0.2}, {20, 0.2}, {20, 0.5}, {0, 0.8}, {-20, 0.5}};
    memcpy(op.contour, house, sizeof house);
    insert_trim(p, 0, op);
    made made_ = make(m);
    assert_int_equal(made_.net->parts[0].loop_count, 1);
    const kg_net_line *l = &made_.net->parts[0].loops[0].line;
    int corners = 0;
    for (size_t i = 0; i < l->count; i++)
        corners += l->corners[i];
    assert_int_equal(corners, 5);
    unmake(&made_);
}

/* ---- ticks ------------------------------------------------------------------------------ */

static size_t ticks_of(const made *m, int part, int join, kg_vec2 *out, size_t room) {
    size_t n = 0;
    const kg_net_part *p = &m->net->parts[part];
    for (size_t i = 0; i < p->line_count; i++) {
        const kg_net_line *l = &p->lines[i];
        bool is_mark = m->net->joins[join].sides[1].loop < 0 &&
                       m->net->joins[join].sides[1].part == part &&
                       m->net->joins[join].sides[1].line == (int)i;
        if (l->join != join || is_mark)
            continue;
        assert_int_equal(l->kind, KG_NET_MARK);
        assert_int_equal(l->count, 2);
        assert_near(kg_dist2(l->points[0], l->points[1]), 2, 1e-9);
        assert_true(n < room);
        out[n++] = l->contact || m->net->joins[join].sides[1].loop >= 0 ||
                           m->net->joins[join].sides[0].part == part
                       ? l->points[0]
                       : kg_lerp2(l->points[0], l->points[1], 0.5);
    }
    return n;
}

static void ticks_of_both_sides_meet_in_space(void **state) {
    (void)state;
    for (int kind = 0; kind < 4; kind++) {
        kg_model *model = pillow(kg_v3(0, 0, 5), kg_v3(0, 0, 5), kind & 1);
        model->patches[0].trims[0].off = kind & 2;
        made m = make(model);
        const kg_net_join *j = &m.net->joins[0];
        kg_vec2 a[16], b[16];
        size_t n = ticks_of(&m, j->sides[0].part, 0, a, 16);
        assert_int_equal(n, 4); /* 136 mm: five pieces of 27 */
        assert_int_equal(ticks_of(&m, j->sides[1].part, 0, b, 16), n);
        for (size_t i = 0; i < n; i++) {
            const kg_patch *p = patch_of_part(&m, j->sides[0].part),
                           *q = patch_of_part(&m, j->sides[1].part);
            kg_vec2 uv = fold_back(p, a[i], kg_v3(0, 0, 0));
            kg_vec3 x = kg_patch_point(p, uv.x, uv.y);
            uv = fold_back(q, b[i], x);
            assert_near(kg_dist(x, kg_patch_point(q, uv.x, uv.y)), 0, 1e-6);
        }
        unmake(&m);
    }
}

static void short_joins_have_no_ticks(void **state) {
    (void)state;
    made m = make(gable(0.2, 1.2, false, false)); /* 60 mm */
    assert_int_equal(m.net->parts[0].line_count, 0);
    assert_int_equal(m.net->parts[1].line_count, 0);
    unmake(&m);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(folds_lay_tabs_on_the_other_part),
        cmocka_unit_test(the_tab_of_a_contact_takes_the_flatter_side),
        cmocka_unit_test(random_models_unroll_truly),
        cmocka_unit_test(a_closed_curve_is_one_seam),
        cmocka_unit_test(a_closed_contact_is_one_mark),
        cmocka_unit_test(the_parts_of_a_split_patch_are_joined),
        cmocka_unit_test(patches_that_meet_on_a_construction_plane_are_joined),
        cmocka_unit_test(a_third_patch_on_a_seam_is_joined_once),
        cmocka_unit_test(wishes_for_joins_follow_the_patches_they_name),
        cmocka_unit_test(a_contact_across_a_seam_is_two),
        cmocka_unit_test(contours_keep_their_corners_and_smooth_joints_have_none),
        cmocka_unit_test(ticks_of_both_sides_meet_in_space),
        cmocka_unit_test(short_joins_have_no_ticks),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
