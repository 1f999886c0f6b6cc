/* .cp files: lines `type x1 y1 x2 y2`. */
#include "origami/exchange.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_LINES = 20000 };

/* One number as JSON writes them, perhaps with a plus: a decimal point whatever the locale. */
static bool read_number(const char **at, double *out) {
    const char *from = *at;
    while (*from == ' ' || *from == '\t' || *from == ',')
        from++;
    size_t n = strspn(from, "+-0123456789.eE");
    char digits[64];
    if (n == 0 || n > sizeof digits - 3)
        return false;
    size_t plus = from[0] == '+';
    snprintf(digits, sizeof digits, "[%.*s]", (int)(n - plus), from + plus);
    json_t *list = json_loads(digits, JSON_DECODE_INT_AS_REAL, NULL);
    if (!list)
        return false;
    *out = json_number_value(json_array_get(list, 0));
    json_decref(list);
    *at = from + n;
    return isfinite(*out);
}

static kg_status read_line(const char *line, const char *name, int number, kg_pattern *out,
                           kg_error *error) {
    double v[5];
    const char *at = line;
    for (int k = 0; k < 5; k++)
        if (!read_number(&at, &v[k]) || (k > 0 && fabs(v[k]) > 1e6))
            return kg_fail(error, KG_ERR_PARSE,
                           "%s:%d: a line is `type x1 y1 x2 y2`, numbers of at most 1e6", name,
                           number);
    if (v[0] != floor(v[0]) || v[0] < 1 || v[0] > 4 || at[strspn(at, " \t\r")] != '\0')
        return kg_fail(error, KG_ERR_PARSE,
                       "%s:%d: types are 1 border, 2 mountain, 3 valley, 4 flat, with 4 numbers "
                       "behind them",
                       name, number);
    if (out->edges.count >= MAX_LINES)
        return kg_fail(error, KG_ERR_PARSE, "%s:%d: more than %d lines", name, number, MAX_LINES);
    int type = (int)v[0];
    int32_t first = (int32_t)out->vertices.count;
    kg_pattern_edge e = {{first, first + 1},
                         "BMVF"[type - 1],
                         type == 2   ? -KG_PI
                         : type == 3 ? KG_PI
                                     : 0};
    /* y points down in these files */
    return kg_push(&out->vertices, kg_v2(v[1], -v[2])) &&
                   kg_push(&out->vertices, kg_v2(v[3], -v[4])) && kg_push(&out->edges, e)
               ? KG_OK
               : KG_ERR_MEMORY;
}

kg_status kg_cp_read(const char *data, size_t size, const char *name, kg_pattern *out_pattern,
                     kg_error *error) {
    kg_pattern p = {.unit = {1, -1}};
    kg_status status = KG_OK;
    int number = 0;
    char line[256];
    for (size_t i = 0; i < size && !status;) {
        size_t n = 0;
        while (i + n < size && data[i + n] != '\n')
            n++;
        number++;
        if (n >= sizeof line)
            status = kg_fail(error, KG_ERR_PARSE, "%s:%d: the line is too long", name, number);
        else {
            memcpy(line, data + i, n);
            line[n] = '\0';
            if (line[strspn(line, " \t\r")] != '\0')
                status = read_line(line, name, number, &p, error);
        }
        i += n + 1;
    }
    if (!status && p.edges.count == 0)
        status = kg_fail(error, KG_ERR_PARSE, "%s:1: there are no lines in it", name);
    if (!status)
        status = kg_pattern_clean(&p, error);
    if (status) {
        kg_pattern_clear(&p);
        return status;
    }
    *out_pattern = p;
    return KG_OK;
}

char *kg_cp_text(const kg_origami_state *s) {
    struct {
        char *items;
        size_t count, capacity;
    } text = {0};
    size_t sheets;
    kg_vec2 *shifts;
    if (kg_sheet_shifts(s, &sheets, &shifts))
        return NULL;
    bool ok = true;
    for (size_t e = 0; e < s->edges.count && ok; e++) {
        const kg_paper_edge *edge = &s->edges.items[e];
        const kg_paper_vertex *a = &s->vertices.items[s->halves.items[2 * e].origin],
                              *b = &s->vertices.items[s->halves.items[2 * e + 1].origin];
        if (edge->kind == KG_PAPER_JOIN)
            continue;
        kg_vec2 p = kg_add2(a->paper, shifts[a->sheet]), q = kg_add2(b->paper, shifts[b->sheet]);
        double v[4] = {p.x, -p.y, q.x, -q.y};
        char line[160], digits[4][32];
        for (int k = 0; k < 4; k++)
            kg_json_number(v[k] == 0 ? 0 : v[k], digits[k]);
        int type = edge->kind == KG_PAPER_BORDER ? 1
                   : edge->angle < 0             ? 2
                   : edge->angle > 0             ? 3
                                                 : 4;
        int n = snprintf(line, sizeof line, "%d %s %s %s %s\n", type, digits[0], digits[1],
                         digits[2], digits[3]);
        for (int k = 0; k < n && ok; k++)
            ok = kg_push(&text, line[k]);
    }
    free(shifts);
    if (!ok || !kg_push(&text, '\0')) {
        free(text.items);
        return NULL;
    }
    return text.items;
}
