#include "katagami/net.h"

#include <jansson.h>
#include <stdlib.h>
#include <string.h>

/* JSON has no infinities; what cannot be measured is null. */
static json_t *number(double value) {
    return isfinite(value) ? json_real(value) : json_null();
}

static json_t *part_report(const kg_net_part *part, int page) {
    return json_pack("{s:i, s:I, s:s, s:o, s:o, s:o, s:o, s:i}", "part", part->number, "patch",
                     (json_int_t)part->source, "name", part->name, "area_mm2", number(part->area),
                     "surface_mm2", number(part->surface), "perimeter_mm", number(part->perimeter),
                     "isometry_error", number(part->isometry_error), "page", page);
}

/* Of several it says which one it is. */
static json_t *seam_report(const kg_net *net, const kg_net_join *join) {
    kg_vec2 middle = join->course[0][KG_JOIN_PLACES / 2];
    json_t *at = kg_net_joins_beside(net, join) > 1
                     ? json_pack("[o,o]", number(middle.x), number(middle.y))
                     : NULL;
    return json_pack("{s:s, s:[I,I], s:[o,o], s:o*}", "kind",
                     join->kind == KG_JOIN_SEAM ? "seam" : "contact", "patches",
                     (json_int_t)join->sources[0], (json_int_t)join->sources[1], "length_mm",
                     number(join->sides[0].length), number(join->sides[1].length), "at", at);
}

static json_t *warning_report(const kg_net_warning *warning) {
    return json_pack("{s:I, s:s, s:s}", "patch", (json_int_t)warning->source, "code", warning->code,
                     "message", warning->message);
}

/* Tabs of a part are numbered from 1 without gaps; one may have several fold lines. */
static int tab_count(const kg_net *net) {
    int sum = 0;
    for (size_t i = 0; i < net->part_count; i++) {
        int highest = 0;
        for (size_t k = 0; k < net->parts[i].line_count; k++)
            if (net->parts[i].lines[k].tab > highest)
                highest = net->parts[i].lines[k].tab;
        sum += highest;
    }
    return sum;
}

static json_t *report(const kg_net *net, const kg_net_layout *layout,
                      const kg_net_warning *warnings, size_t warning_count, int tab_overlaps) {
    json_t *parts = json_array(), *seams = json_array(), *remarks = json_array();
    int failed = !parts || !seams || !remarks;
    for (size_t i = 0; !failed && i < net->part_count; i++)
        failed = json_array_append_new(
            parts, part_report(&net->parts[i], layout ? layout->placements[i].page + 1 : 0));
    for (size_t i = 0; !failed && i < net->join_count; i++)
        failed = json_array_append_new(seams, seam_report(net, &net->joins[i]));
    for (size_t i = 0; !failed && i < warning_count; i++)
        failed = json_array_append_new(remarks, warning_report(&warnings[i]));
    if (failed) {
        json_decref(parts);
        json_decref(seams);
        json_decref(remarks);
        return NULL;
    }
    return json_pack("{s:o, s:o, s:{s:i, s:i, s:o, s:i, s:i}, s:o}", "parts", parts, "seams", seams,
                     "totals", "parts", (int)net->part_count, "pages",
                     layout ? (int)layout->page_count : 0, "page_fill",
                     number(layout ? layout->fill : 0), "tabs", tab_count(net), "tab_overlaps",
                     tab_overlaps, "warnings", remarks);
}

kg_status kg_net_report(const kg_net *net, const kg_net_layout *layout,
                        const kg_net_warning *warnings, size_t warning_count, int tab_overlaps,
                        char **out_json, kg_error *error) {
    json_t *root = report(net, layout, warnings, warning_count, tab_overlaps);
    char *text = root ? json_dumps(root, JSON_INDENT(1) | JSON_REAL_PRECISION(15)) : NULL;
    json_decref(root);
    size_t size = text ? strlen(text) : 0;
    char *line = text ? realloc(text, size + 2) : NULL;
    if (!line) {
        free(text);
        return kg_fail(error, KG_ERR_MEMORY, "out of memory while writing the report");
    }
    memcpy(line + size, "\n", 2);
    *out_json = line;
    return KG_OK;
}
