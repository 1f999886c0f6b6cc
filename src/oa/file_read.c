/* Cards from JSON. Messages carry the file, the line and the column and level at fault. */
#include "katagami/oa.h"

#include "base/file.h"
#include "base/json.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_DEPTH = 8 };

typedef struct reader {
    const char *name, *text;
    kg_json_step path[MAX_DEPTH];
    size_t depth;
    kg_oa *oa;
    int x, z; /* column and level that are being read; -1: none */
    kg_error *error;
} reader;

static kg_status fail_at(reader *r, const char *format, ...) KG_PRINTF(2, 3);

static kg_status fail_at(reader *r, const char *format, ...) {
    char message[KG_ERROR_SIZE / 2], where[48] = "";
    va_list args;
    va_start(args, format);
    vsnprintf(message, sizeof message, format, args);
    va_end(args);
    if (r->z >= 0)
        snprintf(where, sizeof where, "column %d, level %d: ", r->x, r->z);
    else if (r->x >= 0)
        snprintf(where, sizeof where, "column %d: ", r->x);
    return kg_fail(r->error, KG_ERR_PARSE, "%s:%d: %s%s", r->name,
                   kg_json_line(r->text, r->path, r->depth), where, message);
}

static void enter(reader *r, const char *key, size_t index) {
    r->path[r->depth++] = (kg_json_step){key, index};
}

static void leave(reader *r) {
    r->depth--;
}

/* ---- values ----------------------------------------------------------------------------- */

/* A whole number; 3.0 is one as well. */
static kg_status read_whole(reader *r, const json_t *v, int lo, int hi, int *out) {
    double x = json_is_number(v) ? json_number_value(v) : 0.5;
    if (x != floor(x))
        return fail_at(r, "a whole number is wanted here");
    if (!(x >= lo && x <= hi))
        return fail_at(r, "%.15g is not within %d and %d", x, lo, hi);
    *out = (int)x;
    return KG_OK;
}

static kg_status read_member(reader *r, const json_t *object, const char *key, double lo, double hi,
                             double *out) {
    const json_t *v = json_object_get(object, key);
    kg_status status = KG_OK;
    if (!v)
        return KG_OK;
    enter(r, key, 0);
    double x = json_number_value(v);
    if (!json_is_number(v) || !(x >= lo && x <= hi))
        status = fail_at(r, "\"%s\" is a number from %g to %g", key, lo, hi);
    leave(r);
    if (!status)
        *out = x;
    return status;
}

static kg_status read_text(reader *r, const json_t *object, const char *key, char **out) {
    const json_t *v = json_object_get(object, key);
    kg_status status = KG_OK;
    if (!v)
        return KG_OK;
    enter(r, key, 0);
    if (!json_is_string(v))
        status = fail_at(r, "\"%s\" is a text", key);
    leave(r);
    char *copy = status ? NULL : strdup(json_string_value(v));
    if (!copy)
        return status ? status : KG_ERR_MEMORY;
    free(*out);
    *out = copy;
    return KG_OK;
}

/* ---- the card --------------------------------------------------------------------------- */

static kg_status read_size(reader *r, const json_t *card, int size[3]) {
    const json_t *v = json_object_get(card, "size");
    static const char *const sides[] = {"width", "depth", "height"};
    enter(r, "size", 0);
    kg_status status = KG_OK;
    if (!json_is_array(v) || json_array_size(v) != 3)
        status = fail_at(r, "a card needs \"size\": [width, depth, height] in cells");
    for (size_t i = 0; i < 3 && !status; i++) {
        const json_t *side = json_array_get(v, i);
        double x = json_number_value(side);
        enter(r, NULL, i);
        if (!json_is_number(side) || x != floor(x) || !(x >= 1 && x <= KG_OA_MAX_SIZE))
            status = fail_at(r, "the %s is a whole number of cells from 1 to %d", sides[i],
                             KG_OA_MAX_SIZE);
        else
            size[i] = (int)x;
        leave(r);
    }
    leave(r);
    return status;
}

static kg_status read_level(reader *r, const json_t *v, int *column) {
    kg_status status = read_whole(r, v, 0, r->oa->depth_limit, &column[r->z]);
    if (!status && r->z > 0 && column[r->z] > column[r->z - 1])
        status = fail_at(r, "depth %d is more than the %d below it; depths must not grow upwards",
                         column[r->z], column[r->z - 1]);
    return status;
}

static kg_status read_column(reader *r, const json_t *v) {
    kg_oa *oa = r->oa;
    kg_status status = KG_OK;
    if (!json_is_array(v) || json_array_size(v) != (size_t)oa->height)
        return fail_at(r, "a column has %d depths, one for each level", oa->height);
    for (r->z = 0; r->z < oa->height && !status; r->z++) {
        enter(r, NULL, (size_t)r->z);
        status = read_level(r, json_array_get(v, (size_t)r->z), oa->depth + r->x * oa->height);
        leave(r);
    }
    r->z = -1;
    return status;
}

static kg_status read_depth(reader *r, const json_t *card) {
    const json_t *v = json_object_get(card, "depth");
    kg_oa *oa = r->oa;
    enter(r, "depth", 0);
    kg_status status = KG_OK;
    if (!json_is_array(v) || json_array_size(v) != (size_t)oa->width)
        status =
            fail_at(r, "a card needs \"depth\": %d columns of %d numbers", oa->width, oa->height);
    for (r->x = 0; r->x < oa->width && !status; r->x++) {
        enter(r, NULL, (size_t)r->x);
        status = read_column(r, json_array_get(v, (size_t)r->x));
        leave(r);
    }
    r->x = -1;
    leave(r);
    return status;
}

/* One [x, z] of the windows or the omitted tops. */
static kg_status read_face(reader *r, const json_t *v, bool top) {
    kg_oa *oa = r->oa;
    int x = 0, z = 0;
    const int highest[2] = {oa->width - 1, oa->height - (top ? 0 : 1)};
    if (!json_is_array(v) || json_array_size(v) != 2)
        return fail_at(r, "%s is [x, z]", top ? "an omitted top" : "a window");
    for (size_t i = 0; i < 2; i++) {
        double at = json_number_value(json_array_get(v, i));
        if (!json_is_number(json_array_get(v, i)) || at != floor(at) || at < 0 || at > highest[i])
            return fail_at(r, "%s [%g, %g]: its %s is a whole number from 0 to %d",
                           top ? "omitted top" : "window", json_number_value(json_array_get(v, 0)),
                           json_number_value(json_array_get(v, 1)),
                           i == 0 ? "column"
                           : top  ? "height"
                                  : "level",
                           highest[i]);
        *(i == 0 ? &x : &z) = (int)at;
    }
    if (top ? kg_oa_top(oa, x, z) == 0 : kg_oa_depth(oa, x, z) == 0)
        return fail_at(r, "column %d has no %s %d for %s", x,
                       top ? "top at height" : "front at level", z,
                       top ? "leaving out" : "a window");
    if (top)
        oa->omitted[x * (oa->height + 1) + z] = 1;
    else
        oa->window[x * oa->height + z] = 1;
    return KG_OK;
}

static kg_status read_faces(reader *r, const json_t *card, const char *key, bool top) {
    const json_t *v = json_object_get(card, key);
    if (!v)
        return KG_OK;
    enter(r, key, 0);
    kg_status status = json_is_array(v) ? KG_OK : fail_at(r, "\"%s\" is a list of [x, z]", key);
    for (size_t i = 0; i < json_array_size(v) && !status; i++) {
        enter(r, NULL, i);
        status = read_face(r, json_array_get(v, i), top);
        leave(r);
    }
    leave(r);
    return status;
}

static kg_status read_card(reader *r, const json_t *card) {
    int size[3];
    double margin_cells = 0;
    kg_status status = read_size(r, card, size);
    if (!status && kg_oa_create(size[0], size[1], size[2], 1, &r->oa, NULL))
        status = KG_ERR_MEMORY;
    if (!status && !json_object_get(card, "cell_mm"))
        status = fail_at(r, "a card needs \"cell_mm\", the side of a cell");
    if (!status)
        status = read_member(r, card, "cell_mm", 1e-3, KG_OA_MAX_CELL, &r->oa->cell_mm);
    if (!status)
        status = read_depth(r, card);
    if (!status)
        status = read_faces(r, card, "windows", false);
    if (!status)
        status = read_faces(r, card, "omitted", true);
    if (!status)
        status = read_member(r, card, "margin_cells", 0, KG_OA_MAX_MARGIN, &margin_cells);
    if (!status)
        status = read_member(r, card, "tiny_mm", 0, KG_OA_MAX_CELL, &r->oa->tiny_mm);
    const json_t *diagonals = json_object_get(card, "diagonals");
    enter(r, diagonals ? "diagonals" : "margin_cells", 0);
    if (!status && margin_cells != floor(margin_cells))
        status = fail_at(r, "\"margin_cells\" is a whole number");
    if (!status && diagonals && !json_is_boolean(diagonals))
        status = fail_at(r, "\"diagonals\" is true or false");
    leave(r);
    if (status)
        return status;
    r->oa->margin_cells = (int)margin_cells;
    r->oa->diagonals = json_is_true(diagonals);
    return KG_OK;
}

static kg_status read_net(reader *r, const json_t *root) {
    const json_t *v = json_object_get(root, "net");
    if (!v)
        return KG_OK;
    enter(r, "net", 0);
    kg_status status = json_is_object(v) ? KG_OK : fail_at(r, "\"net\" is an object: { … }");
    if (!status)
        status = read_text(r, v, "paper", &r->oa->paper);
    if (!status)
        status = read_member(r, v, "margin", 0, 1e4, &r->oa->margin);
    if (!status)
        status = read_member(r, v, "scale", 1e-6, 1e6, &r->oa->scale);
    leave(r);
    return status;
}

static kg_status check_header(reader *r, const json_t *root) {
    const json_t *version = json_object_get(root, "katagami");
    const char *kind = json_string_value(json_object_get(root, "kind"));
    if (!json_is_object(root) || !json_is_integer(version))
        return fail_at(r, "this is no katagami model: it must begin with {\"katagami\": 1, "
                          "\"kind\": \"oa\", …}");
    enter(r, "katagami", 0);
    if (json_integer_value(version) > KG_OA_VERSION)
        return fail_at(r,
                       "the model was written by a newer katagami (format %lld, this one reads "
                       "up to %d); update katagami",
                       (long long)json_integer_value(version), KG_OA_VERSION);
    if (json_integer_value(version) < 1)
        return fail_at(r, "there is no format %lld", (long long)json_integer_value(version));
    leave(r);
    enter(r, "kind", 0);
    if (!kind || strcmp(kind, "oa") != 0)
        return fail_at(r, "a pop-up card has \"kind\": \"oa\"");
    leave(r);
    return KG_OK;
}

static kg_status read_root(reader *r, const json_t *root) {
    const json_t *card = json_object_get(root, "oa");
    kg_status status = check_header(r, root);
    if (status)
        return status;
    enter(r, "oa", 0);
    if (json_is_object(card))
        status = read_card(r, card);
    else
        status = fail_at(r, "a pop-up card is in \"oa\": { … }");
    leave(r);
    if (!status)
        status = read_text(r, root, "title", &r->oa->title);
    if (!status)
        status = read_net(r, root);
    if (!status)
        r->oa->json = json_incref((json_t *)(uintptr_t)root);
    return status;
}

kg_status kg_oa_read_memory(const char *data, size_t size, const char *name, kg_oa **out_oa,
                            kg_error *error) {
    json_error_t where;
    kg_error local;
    if (size >= 3 && memcmp(data, "\xef\xbb\xbf", 3) == 0)
        data += 3, size -= 3; /* the mark that some editors put in front */
    json_t *root = json_loadb(data, size, JSON_REJECT_DUPLICATES, &where);
    if (!root)
        return kg_fail(error, KG_ERR_PARSE, "%s:%d: %s", name, where.line < 1 ? 1 : where.line,
                       where.text);
    char *text = malloc(size + 1); /* zero-terminated for the search of lines */
    reader r = {.name = name, .text = text, .x = -1, .z = -1, .error = error ? error : &local};
    kg_status status = KG_ERR_MEMORY;
    if (text) {
        memcpy(text, data, size);
        text[size] = '\0';
        status = read_root(&r, root);
    }
    free(text);
    json_decref(root);
    if (status) {
        kg_oa_destroy(r.oa);
        return status == KG_ERR_MEMORY ? kg_fail(error, status, "%s: out of memory", name) : status;
    }
    *out_oa = r.oa;
    return KG_OK;
}

kg_status kg_oa_read(const char *path, kg_oa **out_oa, kg_error *error) {
    char *data;
    size_t size;
    kg_status status = kg_file_read(path, &data, &size, error);
    if (status)
        return status;
    status =
        kg_oa_read_memory(data, size, strcmp(path, "-") ? path : "standard input", out_oa, error);
    free(data);
    return status;
}
