#include "samples/simple_models.h"

void fin_model_build(sample_model *out_model) {
    *out_model = (sample_model){.title = "fin ひれ"};
    const kg_patch_input panel = {.points = {{-60, 0, 0}, {-22, 3, 17}, {20, -3, 18}, {60, 0, 2}},
                                  .point_count = 4,
                                  .extent = {-22, 22}};
    /* upright, along the panel */
    const kg_patch_input fin = {.points = {{-45, 0, 20}, {-15, 0, 20}, {15, 0, 20}, {45, 0, 20}},
                                .point_count = 4,
                                .extent = {-20, 40},
                                .has_ruling = true,
                                .ruling = {0, 0, 1}};
    sample_add(out_model, "panel", &panel);
    sample_patch *f = sample_add(out_model, "fin ひれ", &fin);
    static const kg_vec2 outline[] = {
        {-15, 0.8},  {-9, 0.79},   {-3, 0.765},  {3, 0.725},   {9, 0.67},
        {14.5, 0.6}, {19.5, 0.52}, {24, 0.43},   {27.5, 0.34}, {30, 0.25},
        {31, 0.18},  {26, 0.215},  {20, 0.245},  {14, 0.262},  {8, 0.27},
        {2, 0.272},  {-4, 0.268},  {-10, 0.258}, {-15, 0.247},
    };
    sample_trim *contour = sample_contour(f, SAMPLE_OUTLINE);
    for (size_t i = 0; i < sizeof outline / sizeof *outline; i++)
        contour->contour[contour->count++] = outline[i];
    sample_cut(f, 1, kg_v3(-20, 0, 40));
}

void lantern_model_build(sample_model *out_model) {
    enum { SIDES = 4, BOTTOM = SIDES + 1, RIM };
    *out_model = (sample_model){.title = "lantern 行灯"};
    static const char *const names[SIDES] = {"right", "back", "left", "front"};
    /* distance from the axis and height */
    static const double profile[][2] = {{18, -6}, {44, 18}, {44, 72}, {18, 96}};
    for (int k = 0; k < SIDES; k++) {
        double c = k == 0 ? 1 : k == 2 ? -1 : 0, s = k == 1 ? 1 : k == 3 ? -1 : 0;
        kg_patch_input in = {.point_count = 4, .extent = {-48, 48}};
        for (int i = 0; i < 4; i++)
            in.points[i] = kg_v3(profile[i][0] * c, profile[i][0] * s, profile[i][1]);
        sample_patch *p = sample_add(out_model, names[k], &in);
        const kg_vec3 middle = {37 * c, 37 * s, 45};
        sample_cut(p, k == 0 ? SIDES : k, middle);
        sample_cut(p, k == SIDES - 1 ? 1 : k + 2, middle);
        sample_cut(p, BOTTOM, middle);
        sample_cut(p, RIM, middle);
        sample_hole(p, kg_v2(0, 0.5), 14, 1.4);
    }
    for (int k = 0; k < 2; k++) {
        double z = k == 0 ? 4 : 86;
        kg_patch_input in = {.point_count = 4,
                             .extent = {-50, 50},
                             .has_ruling = true,
                             .ruling = {0, 1, 0},
                             .flip = k == 0};
        for (int i = 0; i < 4; i++)
            in.points[i] = kg_v3(-51 + 34.0 * i, 0, z);
        sample_patch *p = sample_add(out_model, k == 0 ? "bottom" : "rim", &in);
        p->construction = k == 1;
        if (k == 0)
            sample_enclose(p, 1, SIDES);
    }
}

void ribbon_model_build(sample_model *out_model) {
    *out_model = (sample_model){.title = "ribbon リボン"};
    const kg_patch_input ribbon = {
        .points = {{-80, -10, 0}, {-30, -4, 40}, {30, 4, 40}, {80, 10, 0}},
        .point_count = 4,
        .extent = {-14, 14},
        .flip = true};
    const kg_patch_input arch = {.points = {{-36, 0, 0}, {-40, 0, 60}, {40, 0, 60}, {36, 0, 0}},
                                 .point_count = 4,
                                 .extent = {-40, 40}};
    sample_patch *p = sample_add(out_model, "ribbon", &ribbon);
    sample_split(p, 2);
    sample_add(out_model, "arch", &arch)->construction = true;
}
