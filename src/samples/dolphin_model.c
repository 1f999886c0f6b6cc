#include "samples/dolphin_model.h"

#include "samples/dolphin_shape.h"
#include "samples/sheet_fit.h"

/*
 * Eight long strips make the body, each touching the shape where its section's normal has one
 * direction; where two strips meet they cut each other. The upper strips bend one way only, so they
 * are spatial cubics whose rulings fan out; the others wind back and forth (belly, flanks) or bend
 * sharply over the melon (back), and are cylinders over planar curves. The beak is half a tube
 * closed by a jaw; each fin is one sheet, cut by the strip that it stands on.
 */
enum {
    BACK = 1,
    BELLY,
    FLANK_LEFT,
    FLANK_RIGHT,
    UPPER_LEFT,
    UPPER_RIGHT,
    LOWER_LEFT,
    LOWER_RIGHT,
    BEAK,
    JAW,
    DORSAL,
    FLIPPER_LEFT,
    FLIPPER_RIGHT,
    FLUKE_LEFT,
    FLUKE_RIGHT
};

static const kg_vec3 X = {1, 0, 0}, Y = {0, 1, 0}, Z = {0, 0, 1};

/* ---- lines that sheets are fitted to --------------------------------------------------- */

/* A stretch of a tube's contour as seen square to the section normals at psi. */
typedef struct contour_line {
    dolphin_tube tube;
    double psi0, psi1; /* at t0 and t1, even between */
    double t0, t1;
    double flare; /* mm that it stands off at t1; from three quarters of the way */
} contour_line;

static void contour_at(const void *user, double s, kg_vec3 *out_point, kg_vec3 *out_normal) {
    const contour_line *l = user;
    double t = l->t0 + (l->t1 - l->t0) * s, psi = l->psi0 + (l->psi1 - l->psi0) * s;
    dolphin_section section = dolphin_section_at(l->tube, t);
    *out_point = dolphin_section_contour(&section, psi);
    *out_normal = dolphin_tube_normal(l->tube, t, psi);
    double rear = fmax(0, 4 * s - 3);
    *out_point = kg_madd(*out_point, l->flare * rear * rear, *out_normal);
}

/* Over the upper half of a section, from left to right. */
static void arch_at(const void *user, double s, kg_vec3 *out_point, kg_vec3 *out_normal) {
    const dolphin_section *section = user;
    *out_point = dolphin_section_contour(section, KG_PI * s);
    *out_normal = kg_v3(0, cos(KG_PI * s), sin(KG_PI * s));
}

/* The middle of a fin from its root to near its tip, where all edges run together. */
static void fin_at(const void *user, double s, kg_vec3 *out_point, kg_vec3 *out_normal) {
    const double end = 0.75; /* of the span */
    const dolphin_fin *fin = user;
    *out_point = dolphin_fin_point(*fin, end * s, 0.5, NULL);
    *out_normal = dolphin_fin_normal(*fin, end * s);
}

/* The t of a tube's section at this x. */
static double t_at(dolphin_tube tube, double x) {
    double lo = 0, hi = 1;
    for (int i = 0; i < 60; i++) {
        double middle = 0.5 * (lo + hi);
        if (dolphin_section_at(tube, middle).x > x)
            lo = middle;
        else
            hi = middle;
    }
    return 0.5 * (lo + hi);
}

/* ---- sheets ---------------------------------------------------------------------------- */

typedef struct sheet {
    const char *name;
    sheet_wish wish;
    kg_vec3 towards;      /* at the middle of the patch: the extent reaches `forth` mm this way */
    double back, forth;   /* and `back` mm the other */
    kg_vec3 outward;      /* the side that the front is on */
    const char *mirrored; /* name of its mirror image, or NULL */
} sheet;

static kg_status orient(kg_patch_input *in, const sheet *s, kg_error *error) {
    kg_patch patch;
    in->extent[0] = -1;
    in->extent[1] = 1;
    kg_status status = kg_patch_init(in, &patch, error);
    if (status != KG_OK)
        return status;
    kg_ruling r = kg_patch_ruling(&patch, 0.5);
    bool along = kg_dot(r.d, s->towards) > 0;
    in->extent[0] = along ? -s->back : -s->forth;
    in->extent[1] = along ? s->forth : s->back;
    in->flip = kg_dot(r.normal, s->outward) < 0;
    return KG_OK;
}

static kg_status add_sheet(sample_model *model, const sheet *s, kg_error *error) {
    kg_patch_input in = {0};
    kg_status status = sheet_fit(&s->wish, &in, error);
    if (status == KG_OK)
        status = orient(&in, s, error);
    if (status != KG_OK)
        return kg_fail_in(error, status, "%s: ", s->name);
    sample_patch *p = sample_add(model, s->name, &in);
    if (s->mirrored)
        sample_mirror(model, s->mirrored, p);
    return KG_OK;
}

static contour_line trunk(double psi0, double psi1, double t0, double x1) {
    return (contour_line){DOLPHIN_TRUNK, psi0, psi1, t0, t_at(DOLPHIN_TRUNK, x1), 0};
}

/* The leads make neighbours cut each other all the way: back and belly run past each other at both
 * ends, the lower strips past both, flanks and upper strips out of the body. */
static kg_status add_body(sample_model *model, kg_error *error) {
    const kg_vec3 out = {0, 0.6, -0.8}; /* normal of the lower strips: 3 to 4 has few decimals */
    const double low = atan2(out.z, out.y);
    contour_line back = trunk(KG_PI / 2, KG_PI / 2, 0.006, -108);
    contour_line belly = trunk(-KG_PI / 2, -KG_PI / 2, t_at(DOLPHIN_TRUNK, 97), -108);
    contour_line flank = trunk(0, 0, t_at(DOLPHIN_TRUNK, 102), -108);
    contour_line upper = trunk(0.22 * KG_PI, 0.30 * KG_PI, t_at(DOLPHIN_TRUNK, 92), -95);
    contour_line lower = trunk(low, low, t_at(DOLPHIN_TRUNK, 94), -100);
    lower.flare = 1; /* so that it ends in a point before the tail does, like the upper one */
    const sheet sheets[] = {
        {"back 背中",
         {.line = contour_at,
          .user = &back,
          .point_count = 6,
          .front = 22,
          .behind = 24,
          .planar = true,
          .along = X,
          .across = Z},
         Y,
         34,
         34,
         Z,
         NULL},
        {"belly 腹",
         {.line = contour_at,
          .user = &belly,
          .point_count = 6,
          .front = 14,
          .behind = 12,
          .planar = true,
          .along = X,
          .across = Z},
         Y,
         34,
         34,
         kg_neg(Z),
         NULL},
        {"flank left",
         {.line = contour_at,
          .user = &flank,
          .point_count = 6,
          .front = 9,
          .behind = 11,
          .planar = true,
          .along = X,
          .across = Y},
         Z,
         70,
         50,
         Y,
         "flank right"},
        {"upper side left",
         {.line = contour_at, .user = &upper, .point_count = 4, .front = 21, .behind = 27},
         Z,
         22,
         18,
         kg_v3(0, 1, 1),
         "upper side right"},
        {"lower side left",
         {.line = contour_at,
          .user = &lower,
          .point_count = 6,
          .front = 24,
          .behind = 24,
          .planar = true,
          .along = X,
          .across = out},
         Z,
         22,
         22,
         out,
         "lower side right"},
    };
    for (size_t i = 0; i < sizeof sheets / sizeof *sheets; i++) {
        kg_status status = add_sheet(model, &sheets[i], error);
        if (status != KG_OK)
            return status;
    }
    return KG_OK;
}

static kg_status add_beak(sample_model *model, kg_error *error) {
    dolphin_section root = dolphin_section_at(DOLPHIN_BEAK, t_at(DOLPHIN_BEAK, 109));
    contour_line bottom = {DOLPHIN_BEAK,           -KG_PI / 2, -KG_PI / 2, t_at(DOLPHIN_BEAK, 119),
                           t_at(DOLPHIN_BEAK, 97), 0};
    const sheet sheets[] = {
        /* square to rulings that fall by 20.6° towards the tip */
        {"beak くちばし",
         {.line = arch_at,
          .user = &root,
          .point_count = 6,
          .front = 12,
          .behind = 12,
          .planar = true,
          .origin = kg_v3(112, 0, -16),
          .along = Y,
          .across = kg_v3(0.352, 0, 0.936)},
         X,
         12,
         20,
         Z,
         NULL},
        {"jaw",
         {.line = contour_at,
          .user = &bottom,
          .point_count = 6,
          .front = 14,
          .behind = 8,
          .planar = true,
          .along = X,
          .across = Z},
         Y,
         14,
         14,
         kg_neg(Z),
         NULL},
    };
    kg_status status = add_sheet(model, &sheets[0], error);
    return status == KG_OK ? add_sheet(model, &sheets[1], error) : status;
}

/* The sheet's point nearest to `point`, which is meant to lie on it. */
static kg_status find_on(const kg_patch *patch, kg_vec3 point, kg_vec2 *out_uv, kg_error *error) {
    const double near_enough = 1.5; /* mm */
    kg_vec2 uv;
    double distance = kg_patch_closest(patch, point, &uv.x, &uv.y);
    if (distance > near_enough)
        return kg_fail(error, KG_ERR_INPUT, "(%.1f, %.1f, %.1f) is %.1f mm off the sheet", point.x,
                       point.y, point.z, distance);
    *out_uv = uv;
    return KG_OK;
}

/* The fin's outline, found on its sheet. */
static kg_status add_outline(sample_patch *p, dolphin_fin fin, kg_error *error) {
    enum { STEPS = 20 };
    kg_patch patch;
    kg_status status = kg_patch_init(&p->input, &patch, error);
    if (status != KG_OK)
        return status;
    sample_trim *outline = sample_contour(p, SAMPLE_OUTLINE);
    for (int i = 0; i < 2 * STEPS && status == KG_OK; i++) {
        bool leading = i <= STEPS;
        double span = (double)(leading ? i : 2 * STEPS - i) / STEPS;
        if (i == 2 * STEPS - 1)
            span = 0; /* the root's other end */
        status = find_on(&patch, dolphin_fin_point(fin, span, leading ? 0 : 1, NULL),
                         &outline->contour[outline->count++], error);
    }
    return status;
}

static kg_status add_dorsal(sample_model *model, kg_error *error) {
    kg_patch_input in = {.point_count = 4, .extent = {-8, 44}, .has_ruling = true, .ruling = Z};
    for (int i = 0; i < 4; i++)
        in.points[i] = kg_v3(36 - 28.0 * i, 0, 16);
    sample_patch *p = sample_add(model, "dorsal fin 背びれ", &in);
    kg_status status = add_outline(p, DOLPHIN_DORSAL, error);
    sample_cut(p, BACK, kg_v3(-10, 0, 40));
    return status;
}

static kg_status add_paired_fin(sample_model *model, const sheet *s, int by, kg_vec3 keep,
                                kg_error *error) {
    sheet single = *s;
    single.mirrored = NULL;
    kg_status status = add_sheet(model, &single, error);
    if (status != KG_OK)
        return status;
    sample_patch *p = &model->patches[model->count - 1];
    status = add_outline(p, *(const dolphin_fin *)s->wish.user, error);
    sample_cut(p, by, keep);
    sample_patch *q = sample_mirror(model, s->mirrored, p);
    q->trims[q->trim_count - 1].by[0] = by + 1;
    return status;
}

static kg_status add_fins(sample_model *model, kg_error *error) {
    const kg_vec3 level = {-0.28, 0, 0.96}; /* square to rulings that rise as the fins do */
    const dolphin_fin flipper = DOLPHIN_FLIPPER, fluke = DOLPHIN_FLUKE;
    const sheet flippers = {"flipper left 胸びれ",
                            {.line = fin_at,
                             .user = &flipper,
                             .point_count = 4,
                             .front = 3,
                             .behind = 24,
                             .planar = true,
                             .origin = kg_v3(42, 0, -20),
                             .along = Y,
                             .across = level},
                            X,
                            36,
                            28,
                            Z,
                            "flipper right 胸びれ"};
    const sheet flukes = {"fluke left 尾びれ",
                          {.line = fin_at,
                           .user = &fluke,
                           .point_count = 4,
                           .front = 4,
                           .behind = 16,
                           .planar = true,
                           .origin = kg_v3(-104, 0, -21),
                           .along = Y,
                           .across = level},
                          X,
                          28,
                          22,
                          Z,
                          "fluke right 尾びれ"};
    kg_status status = add_dorsal(model, error);
    if (status == KG_OK)
        status = add_paired_fin(model, &flippers, LOWER_LEFT, kg_v3(34, 40, -33), error);
    if (status == KG_OK)
        status = add_paired_fin(model, &flukes, FLANK_LEFT, kg_v3(-112, 24, -25), error);
    return status;
}

/* ---- cuts ------------------------------------------------------------------------------ */

/* Every strip by those it meets; the points kept lie around the middle of the body. */
static void cut_body(sample_model *model) {
    const kg_vec3 top = {20, 0, 25}, bottom = {20, 0, -28};
    sample_cut(sample_find(model, BACK), BELLY, top);
    sample_cut(sample_find(model, BELLY), BACK, bottom);
    for (int side = 0; side < 2; side++) {
        double y = side == 0 ? 1 : -1;
        int flank = FLANK_LEFT + side, upper = UPPER_LEFT + side, lower = LOWER_LEFT + side;
        const kg_vec3 middle = {20, 23 * y, -1}, above = {20, 17 * y, 17},
                      below = {20, 15 * y, -20};
        sample_cut(sample_find(model, BACK), flank, top);
        sample_cut(sample_find(model, BACK), upper, top);
        sample_cut(sample_find(model, BACK), lower, top);
        sample_cut(sample_find(model, BELLY), flank, bottom);
        sample_cut(sample_find(model, BELLY), lower, bottom);
        sample_cut(sample_find(model, flank), BELLY, middle);
        sample_cut(sample_find(model, flank), BACK, middle);
        sample_cut(sample_find(model, flank), upper, middle);
        sample_cut(sample_find(model, flank), lower, middle);
        sample_cut(sample_find(model, upper), BACK, above);
        sample_cut(sample_find(model, upper), flank, above);
        sample_cut(sample_find(model, lower), BACK, below);
        sample_cut(sample_find(model, lower), BELLY, below);
        sample_cut(sample_find(model, lower), flank, below);
    }
}

static void cut_beak(sample_model *model) {
    const kg_vec3 above = {114, 0, -11}, below = {114, 0, -20};
    sample_cut(sample_find(model, BEAK), JAW, above);
    sample_cut(sample_find(model, BEAK), BACK, above);
    sample_cut(sample_find(model, JAW), BACK, below);
    sample_cut(sample_find(model, JAW), BEAK, below);
}

/* Small round holes in the flanks. */
static kg_status open_eye(sample_patch *flank, double side, kg_error *error) {
    kg_patch patch;
    kg_vec2 middle;
    kg_status status = kg_patch_init(&flank->input, &patch, error);
    if (status == KG_OK)
        status = find_on(&patch, kg_v3(87, 17 * side, -7.5), &middle, error);
    if (status == KG_OK)
        sample_hole(flank, middle, 1.7, 1);
    return status;
}

kg_status dolphin_model_build(sample_model *out_model, kg_error *error) {
    /* at this scale, 215 mm long, all parts fit one sheet of A4 */
    sample_model model = {.title = "dolphin イルカ", .reference = "dolphin.obj", .scale = "0.86"};
    kg_status status = add_body(&model, error);
    if (status == KG_OK)
        status = add_beak(&model, error);
    if (status == KG_OK)
        status = add_fins(&model, error);
    if (status != KG_OK)
        return status;
    cut_body(&model);
    cut_beak(&model);
    /* for a finger or a lamp */
    sample_hole(sample_find(&model, BELLY), kg_v2(0, 0.4), 5.5, 4);
    status = open_eye(sample_find(&model, FLANK_LEFT), 1, error);
    if (status == KG_OK)
        status = open_eye(sample_find(&model, FLANK_RIGHT), -1, error);
    if (status == KG_OK)
        *out_model = model;
    return status;
}
