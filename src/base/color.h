/* The transfer function of sRGB (IEC 61966-2-1), for one channel in [0,1]. */
#ifndef KG_BASE_COLOR_H
#define KG_BASE_COLOR_H

#include <math.h>

/* Linear light, as meshes and glTF hold it, of what a screen shows. */
static inline float kg_linear_of_srgb(float x) {
    return x <= 0.04045f ? x / 12.92f : powf((x + 0.055f) / 1.055f, 2.4f);
}

/* The other way; what is out of range, or not a number, becomes the nearest end. */
static inline float kg_srgb_of_linear(float x) {
    if (!(x > 0.0031308f)) /* also catches NaN */
        return x > 0 ? 12.92f * x : 0;
    return x < 1 ? 1.055f * powf(x, 1 / 2.4f) - 0.055f : 1;
}

#endif
