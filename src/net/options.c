#include "net/settings.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

static const double INCH = 25.4;

kg_net_options kg_net_options_default(void) {
    kg_net_options options = {.paper = {210, 297},
                              .margin = 8,
                              .gap = 2,
                              .scale = 1,
                              .tolerance = 0.01,
                              .labels = KG_LABELS_INSIDE};
    kg_net_options_preset(&options, KG_PRESET_PRINT);
    return options;
}

void kg_net_options_preset(kg_net_options *options, kg_net_preset preset) {
    /* Laser cutters tell operations apart by pure colours, and follow a line instead of engraving
     * its width when it is no wider than a thousandth of an inch. */
    static const kg_net_style print[KG_LAYER_COUNT] = {
        [KG_LAYER_CUT] = {0x000000, 0.2},    [KG_LAYER_MOUNTAIN] = {0xe4003a, 0.2},
        [KG_LAYER_VALLEY] = {0x0057b8, 0.2}, [KG_LAYER_MARK] = {0x808080, 0.15},
        [KG_LAYER_LABEL] = {0x404040, 0.2},  [KG_LAYER_GUIDE] = {0xa0a0a0, 0.15}};
    static const kg_net_style cutter[KG_LAYER_COUNT] = {
        [KG_LAYER_CUT] = {0xff0000, 0.025},    [KG_LAYER_MOUNTAIN] = {0x0000ff, 0.025},
        [KG_LAYER_VALLEY] = {0x00ff00, 0.025}, [KG_LAYER_MARK] = {0xff00ff, 0.025},
        [KG_LAYER_LABEL] = {0x000000, 0.025},  [KG_LAYER_GUIDE] = {0x000000, 0.025}};
    bool printed = preset == KG_PRESET_PRINT || preset == KG_PRESET_SILHOUETTE;
    memcpy(options->styles, preset == KG_PRESET_LASER ? cutter : print, sizeof print);
    if (preset == KG_PRESET_SILHOUETTE) /* its camera looks for black */
        options->styles[KG_LAYER_GUIDE].color = 0x000000;
    options->text_outlines = preset != KG_PRESET_PRINT;
    options->registration = preset == KG_PRESET_SILHOUETTE;
    options->dashes = printed;
    options->frame = preset == KG_PRESET_PRINT;
    if (preset == KG_PRESET_CRICUT) {
        /* The largest area Design Space prints and then cuts. */
        options->paper = kg_v2(6.75 * INCH, 9.25 * INCH);
        options->margin = 0;
    }
}

kg_status kg_net_preset_parse(const char *text, kg_net_preset *out_preset, kg_error *error) {
    for (int i = 0; kg_net_preset_names[i]; i++)
        if (strcmp(text, kg_net_preset_names[i]) == 0) {
            *out_preset = (kg_net_preset)i;
            return KG_OK;
        }
    return kg_fail(error, KG_ERR_INPUT,
                   "preset '%s' is unknown; there are print, laser, silhouette and cricut", text);
}

/* A plain decimal number at *text, moved behind it; negative when there is none. strtod would
 * follow the locale. */
static double decimal(const char **text) {
    const char *s = *text;
    double value = 0, unit = 1;
    int digits = 0;
    for (; *s >= '0' && *s <= '9'; s++, digits++)
        value = value * 10 + (*s - '0');
    if (*s == '.')
        for (s++; *s >= '0' && *s <= '9'; s++, digits++)
            value += (*s - '0') * (unit /= 10);
    *text = s;
    return digits > 0 ? value : -1;
}

typedef struct paper {
    const char *name;
    kg_vec2 size;
} paper;

/* Those from A4 up come first. */
static const paper papers[] = {{"A4", {210, 297}},         {"A3", {297, 420}},
                               {"A2", {420, 594}},         {"none", {0, 0}},
                               {"letter", {215.9, 279.4}}, {"legal", {215.9, 355.6}}};
enum { SERIES_COUNT = 3 };

kg_status kg_net_paper_parse(const char *text, kg_vec2 *out_paper, kg_error *error) {
    for (size_t i = 0; i < sizeof papers / sizeof *papers; i++) {
        if (strcasecmp(text, papers[i].name) == 0) {
            *out_paper = papers[i].size;
            return KG_OK;
        }
    }
    const char *s = text;
    double width = decimal(&s), height = -1;
    if (*s == 'x' || *s == 'X') {
        s++;
        height = decimal(&s);
    }
    if (!(width > 0) || !(height > 0) || *s != '\0' || width > 1e5 || height > 1e5)
        return kg_fail(error, KG_ERR_INPUT,
                       "paper '%s' is unknown; use A4, A3, A2, letter, legal, none, or a width and "
                       "height in mm like 300x200",
                       text);
    *out_paper = kg_v2(width, height);
    return KG_OK;
}

const char *kg_net_paper_for(kg_vec2 size, double margin, kg_vec2 *out_paper, bool *out_across) {
    for (size_t i = 0; i < SERIES_COUNT; i++) {
        kg_vec2 room = kg_v2(papers[i].size.x - 2 * margin, papers[i].size.y - 2 * margin);
        bool upright = size.x <= room.x && size.y <= room.y;
        if (upright || (size.x <= room.y && size.y <= room.x)) {
            *out_paper = papers[i].size;
            *out_across = !upright;
            return papers[i].name;
        }
    }
    return NULL;
}
