#include "net/text.h"

#include <string.h>

uint32_t kg_text_character(const char **text) {
    const unsigned char *s = (const unsigned char *)*text;
    int more = *s >= 0xf0 ? 3 : *s >= 0xe0 ? 2 : *s >= 0xc0 ? 1 : 0;
    uint32_t code = more == 3 ? *s & 7u : more == 2 ? *s & 15u : more == 1 ? *s & 31u : *s;
    s++;
    for (; more > 0 && (*s & 0xc0) == 0x80; more--)
        code = code << 6 | (*s++ & 63u);
    *text = (const char *)s;
    return code;
}

bool kg_text_valid(const char *text) {
    static const uint32_t least[5] = {0, 0, 0x80, 0x800, 0x10000};
    while (*text) {
        const char *start = text;
        uint32_t c = kg_text_character(&text);
        size_t size = (size_t)(text - start);
        unsigned char head = (unsigned char)*start;
        size_t wanted = head < 0x80 ? 1 : head >= 0xf0 ? 4 : head >= 0xe0 ? 3 : 2;
        if ((head >= 0x80 && head < 0xc0) || size != wanted || c < least[size] || c > 0x10ffff ||
            (c >= 0xd800 && c < 0xe000))
            return false;
    }
    return true;
}

char *kg_text_line(const char *text) {
    char *line = strdup(text);
    for (char *s = line; line && *s;) {
        const char *next = s;
        uint32_t c = kg_text_character(&next);
        if (c < 32 || (c >= 127 && c < 160) || c == 0xfffe || c == 0xffff)
            memset(s, ' ', (size_t)(next - s));
        s += next - s;
    }
    return line;
}

double kg_text_width(const char *text) {
    double width = 0;
    while (*text) {
        uint32_t c = kg_text_character(&text);
        bool narrow = c < 128 && c != 0 && strchr(" !'()*,-./:;I[]`fijlrt|", (int)c);
        bool wide = c == 'M' || c == 'W' || c == 'm' || c == 'w' || c == '%' || c == '@';
        bool full = c >= 0x1100 && !(c >= 0x1e00 && c < 0x2e80) && !(c >= 0xff61 && c < 0xffe0);
        width += full ? 1 : wide ? 0.92 : narrow ? 0.4 : 0.66;
    }
    return width;
}

kg_vec2 kg_caption_half(const kg_caption *caption) {
    double size = caption->capital / KG_TEXT_CAPITAL;
    return kg_v2(kg_text_width(caption->text) * size / 2, caption->capital / 2);
}

double kg_caption_share(const kg_caption *caption) {
    return caption->align == KG_CAPTION_START ? 0 : caption->align == KG_CAPTION_END ? 1 : 0.5;
}

kg_vec2 kg_caption_anchor(const kg_caption *caption) {
    double along = (2 * kg_caption_share(caption) - 1) * kg_caption_half(caption).x;
    return kg_add2(caption->center,
                   kg_scale2(kg_v2(cos(caption->angle), sin(caption->angle)), along));
}

kg_vec2 kg_caption_baseline(const kg_caption *caption) {
    double down = caption->capital / 2;
    return kg_add2(kg_caption_anchor(caption),
                   kg_v2(-down * sin(caption->angle), down * cos(caption->angle)));
}
