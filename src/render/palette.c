#include "katagami/render.h"

#include "base/color.h"

#include <stdlib.h>
#include <string.h>

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

void kg_palette_linear(size_t i, float out_rgba[4]) {
    kg_color c = kg_palette(i);
    out_rgba[0] = kg_linear_of_srgb(c.r);
    out_rgba[1] = kg_linear_of_srgb(c.g);
    out_rgba[2] = kg_linear_of_srgb(c.b);
    out_rgba[3] = c.a;
}

kg_color kg_color_from_linear(const float rgba[4]) {
    kg_color c = {kg_srgb_of_linear(rgba[0]), kg_srgb_of_linear(rgba[1]),
                  kg_srgb_of_linear(rgba[2]), fminf(fmaxf(rgba[3], 0), 1)};
    return c;
}

kg_color kg_color_from_rgb(uint32_t rgb) {
    kg_color c = {(float)(rgb >> 16 & 255) / 255, (float)(rgb >> 8 & 255) / 255,
                  (float)(rgb & 255) / 255, 1};
    return c;
}

static uint32_t byte_of(float x) {
    return (uint32_t)lroundf(255 * fminf(fmaxf(x, 0), 1));
}

uint32_t kg_color_to_rgb(kg_color c) {
    return byte_of(c.r) << 16 | byte_of(c.g) << 8 | byte_of(c.b);
}

bool kg_color_parse(const char *text, kg_color *out_color) {
    if (!text || text[0] != '#' || strspn(text + 1, "0123456789abcdefABCDEF") != 6 || text[7])
        return false;
    *out_color = kg_color_from_rgb((uint32_t)strtoul(text + 1, NULL, 16));
    return true;
}
