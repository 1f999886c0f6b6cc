/* Values of JSON trees with messages that name file and line. */
#include "origami/exchange.h"

#include <stdarg.h>
#include <stdio.h>

kg_status kg_json_fail(kg_json_place *p, const char *format, ...) {
    char message[KG_ERROR_SIZE / 2];
    va_list args;
    va_start(args, format);
    vsnprintf(message, sizeof message, format, args);
    va_end(args);
    return kg_fail(p->error, KG_ERR_PARSE, "%s:%d: %s", p->name,
                   kg_json_line(p->text, p->path, p->depth), message);
}

void kg_json_enter(kg_json_place *p, const char *key, size_t index) {
    p->path[p->depth++] = (kg_json_step){key, index};
}

kg_status kg_json_read_number(kg_json_place *p, const json_t *v, double limit, double *out) {
    if (!json_is_number(v))
        return kg_json_fail(p, "a number is wanted here");
    double x = json_number_value(v);
    if (!(fabs(x) <= limit))
        return kg_json_fail(p, "%g is beyond %g", x, limit);
    *out = x;
    return KG_OK;
}

kg_status kg_json_read_point(kg_json_place *p, const json_t *v, size_t least, double out[3],
                             size_t *out_count) {
    size_t n = json_array_size(v);
    if (n < least || n > 3)
        return kg_json_fail(p, least == 3 ? "3 numbers are wanted here"
                                          : "2 or 3 numbers are wanted here");
    for (size_t i = 0; i < n; i++) {
        kg_json_enter(p, NULL, i);
        kg_status status = kg_json_read_number(p, json_array_get(v, i), 1e6, &out[i]);
        kg_json_leave(p);
        if (status)
            return status;
    }
    *out_count = n;
    return KG_OK;
}

kg_status kg_json_read_index(kg_json_place *p, const json_t *v, int64_t lo, int64_t hi,
                             int32_t *out) {
    if (!json_is_integer(v) || json_integer_value(v) < lo || json_integer_value(v) > hi)
        return kg_json_fail(p, "a whole number from %lld to %lld is wanted here", (long long)lo,
                            (long long)hi);
    *out = (int32_t)json_integer_value(v);
    return KG_OK;
}
