#include "katagami/render.h"

static kg_color mix(kg_color a, float white, float t) {
    kg_color c = {a.r + (white - a.r) * t, a.g + (white - a.g) * t, a.b + (white - a.b) * t, a.a};
    return c;
}

kg_color kg_palette(size_t i) {
    static const uint8_t okabe_ito[8][3] = {
        {86, 180, 233}, {230, 159, 0}, {0, 158, 115}, {204, 121, 167},
        {240, 228, 66}, {213, 94, 0},  {0, 114, 178}, {130, 130, 130},
    };
    const uint8_t *c = okabe_ito[i % 8];
    kg_color color = {(float)c[0] / 255, (float)c[1] / 255, (float)c[2] / 255, 1};
    switch (i / 8 % 3) {
    case 1:
        return mix(color, 1, 0.45f);
    case 2:
        return mix(color, 0, 0.35f);
    default:
        return color;
    }
}

/* The transfer function of sRGB (IEC 61966-2-1). */
static float srgb(float linear) {
    if (!(linear > 0.0031308f)) /* also catches NaN */
        return linear > 0 ? 12.92f * linear : 0;
    return linear < 1 ? 1.055f * powf(linear, 1 / 2.4f) - 0.055f : 1;
}

kg_color kg_color_from_linear(const float rgba[4]) {
    kg_color c = {srgb(rgba[0]), srgb(rgba[1]), srgb(rgba[2]), fminf(fmaxf(rgba[3], 0), 1)};
    return c;
}
