/* Cards from JSON. Messages carry the file, the line and the column and level at fault. */
#include "katagami/oa.h"

#include "base/file.h"
#include "base/phrase.h"
#include "base/reader.h"
#include "net/settings.h"

#include <stdlib.h>
#include <string.h>

typedef struct reader {
    kg_reader file;
    kg_oa *oa;
    int x, z; /* column and level that are being read; -1: none */
} reader;

static void print_place(const void *owner, char *out, size_t size) {
    const reader *at = owner;
    if (at->z >= 0)
        kg_phrase_print(out, size, "column %d, level %d: ", at->x, at->z);
    else if (at->x >= 0)
        kg_phrase_print(out, size, "column %d: ", at->x);
}

/* ---- values ----------------------------------------------------------------------------- */

/* A whole number; 3.0 is one as well. */
static kg_status read_whole(reader *r, const json_t *v, int lo, int hi, int *out) {
    double x = json_is_number(v) ? json_number_value(v) : 0.5;
    if (x != floor(x))
        return kg_read_fail(&r->file, "a whole number is wanted here");
    if (!(x >= lo && x <= hi))
        return kg_read_fail(&r->file, "%.15g is not within %d and %d", x, lo, hi);
    *out = (int)x;
    return KG_OK;
}

static kg_status read_member(reader *r, const json_t *object, const char *key, double lo, double hi,
                             double *out) {
    const json_t *v = json_object_get(object, key);
    kg_status status = KG_OK;
    if (!v)
        return KG_OK;
    kg_read_enter(&r->file, key, 0);
    double x = json_number_value(v);
    if (!json_is_number(v) || !(x >= lo && x <= hi))
        status = kg_read_fail(&r->file, "\"%s\" is a number from %g to %g", key, lo, hi);
    kg_read_leave(&r->file);
    if (!status)
        *out = x;
    return status;
}

/* ---- the card --------------------------------------------------------------------------- */

static kg_status read_size(reader *r, const json_t *card, int size[3]) {
    const json_t *v = json_object_get(card, "size");
    static const char *const sides[] = {
        N_("the width is a whole number of cells from 1 to %d"),
        N_("the depth is a whole number of cells from 1 to %d"),
        N_("the height is a whole number of cells from 1 to %d"),
    };
    kg_read_enter(&r->file, "size", 0);
    kg_status status = KG_OK;
    if (!json_is_array(v) || json_array_size(v) != 3)
        status = kg_read_fail(&r->file, "a card needs \"size\": [width, depth, height] in cells");
    for (size_t i = 0; i < 3 && !status; i++) {
        const json_t *side = json_array_get(v, i);
        double x = json_number_value(side);
        kg_read_enter(&r->file, NULL, i);
        if (!json_is_number(side) || x != floor(x) || !(x >= 1 && x <= KG_OA_MAX_SIZE))
            status = kg_read_fail(&r->file, sides[i], KG_OA_MAX_SIZE);
        else
            size[i] = (int)x;
        kg_read_leave(&r->file);
    }
    kg_read_leave(&r->file);
    return status;
}

static kg_status read_level(reader *r, const json_t *v, int *column) {
    kg_status status = read_whole(r, v, 0, r->oa->depth_limit, &column[r->z]);
    if (!status && r->z > 0 && column[r->z] > column[r->z - 1])
        status = kg_read_fail(&r->file,
                              "depth %d is more than the %d below it; depths must not grow upwards",
                              column[r->z], column[r->z - 1]);
    return status;
}

static kg_status read_column(reader *r, const json_t *v) {
    kg_oa *oa = r->oa;
    kg_status status = KG_OK;
    if (!json_is_array(v) || json_array_size(v) != (size_t)oa->height)
        return kg_read_fail(&r->file, "a column has %d depths, one for each level", oa->height);
    for (r->z = 0; r->z < oa->height && !status; r->z++) {
        kg_read_enter(&r->file, NULL, (size_t)r->z);
        status = read_level(r, json_array_get(v, (size_t)r->z), oa->depth + r->x * oa->height);
        kg_read_leave(&r->file);
    }
    r->z = -1;
    return status;
}

static kg_status read_depth(reader *r, const json_t *card) {
    const json_t *v = json_object_get(card, "depth");
    kg_oa *oa = r->oa;
    kg_read_enter(&r->file, "depth", 0);
    kg_status status = KG_OK;
    if (!json_is_array(v) || json_array_size(v) != (size_t)oa->width)
        status = kg_read_fail(&r->file, "a card needs \"depth\": %d columns of %d numbers",
                              oa->width, oa->height);
    for (r->x = 0; r->x < oa->width && !status; r->x++) {
        kg_read_enter(&r->file, NULL, (size_t)r->x);
        status = read_column(r, json_array_get(v, (size_t)r->x));
        kg_read_leave(&r->file);
    }
    r->x = -1;
    kg_read_leave(&r->file);
    return status;
}

/* One [x, z] of the windows or the omitted tops. */
static kg_status read_face(reader *r, const json_t *v, bool top) {
    kg_oa *oa = r->oa;
    int x = 0, z = 0;
    const int highest[2] = {oa->width - 1, oa->height - (top ? 0 : 1)};
    static const char *const wanted[2][2] = {
        {N_("window [%g, %g]: its column is a whole number from 0 to %d"),
         N_("window [%g, %g]: its level is a whole number from 0 to %d")},
        {N_("omitted top [%g, %g]: its column is a whole number from 0 to %d"),
         N_("omitted top [%g, %g]: its height is a whole number from 0 to %d")},
    };
    if (!json_is_array(v) || json_array_size(v) != 2)
        return kg_read_fail(&r->file, "%s is [x, z]",
                            kg_phrase(top ? N_("an omitted top") : N_("a window")));
    for (size_t i = 0; i < 2; i++) {
        double at = json_number_value(json_array_get(v, i));
        if (!json_is_number(json_array_get(v, i)) || at != floor(at) || at < 0 || at > highest[i])
            return kg_read_fail(&r->file, wanted[top][i], json_number_value(json_array_get(v, 0)),
                                json_number_value(json_array_get(v, 1)), highest[i]);
        *(i == 0 ? &x : &z) = (int)at;
    }
    if (top ? kg_oa_top(oa, x, z) == 0 : kg_oa_depth(oa, x, z) == 0)
        return kg_read_fail(&r->file,
                            top ? N_("column %d has no top at height %d for leaving out")
                                : N_("column %d has no front at level %d for a window"),
                            x, z);
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
    kg_read_enter(&r->file, key, 0);
    kg_status status =
        json_is_array(v) ? KG_OK : kg_read_fail(&r->file, "\"%s\" is a list of [x, z]", key);
    for (size_t i = 0; i < json_array_size(v) && !status; i++) {
        kg_read_enter(&r->file, NULL, i);
        status = read_face(r, json_array_get(v, i), top);
        kg_read_leave(&r->file);
    }
    kg_read_leave(&r->file);
    return status;
}

static kg_status read_card(reader *r, const json_t *card) {
    int size[3];
    double margin_cells = 0;
    kg_status status = read_size(r, card, size);
    if (!status && kg_oa_create(size[0], size[1], size[2], 1, &r->oa, NULL))
        status = KG_ERR_MEMORY;
    if (!status && !json_object_get(card, "cell_mm"))
        status = kg_read_fail(&r->file, "a card needs \"cell_mm\", the side of a cell");
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
    kg_read_enter(&r->file, diagonals ? "diagonals" : "margin_cells", 0);
    if (!status && margin_cells != floor(margin_cells))
        status = kg_read_fail(&r->file, "\"margin_cells\" is a whole number");
    if (!status && diagonals && !json_is_boolean(diagonals))
        status = kg_read_fail(&r->file, "\"diagonals\" is true or false");
    kg_read_leave(&r->file);
    if (status)
        return status;
    r->oa->margin_cells = (int)margin_cells;
    r->oa->diagonals = json_is_true(diagonals);
    return KG_OK;
}

static kg_status read_root(reader *r) {
    const json_t *root = r->file.root, *card = json_object_get(root, "oa");
    kg_status status = kg_read_header(&r->file, "oa", "a pop-up card");
    if (status)
        return status;
    kg_read_enter(&r->file, "oa", 0);
    if (json_is_object(card))
        status = read_card(r, card);
    else
        status = kg_read_fail(&r->file, "a pop-up card is in \"oa\": { … }");
    kg_read_leave(&r->file);
    if (!status)
        status = kg_read_string(&r->file, root, "title", &r->oa->title);
    if (!status)
        status = kg_net_settings_parse(&r->file, root, &r->oa->net);
    if (!status)
        r->oa->json = kg_read_keep(root);
    return status;
}

kg_status kg_oa_read_memory(const char *data, size_t size, const char *name, kg_oa **out_oa,
                            kg_error *error) {
    reader r = {.x = -1, .z = -1};
    kg_status status = kg_read_begin(&r.file, data, size, name, error);
    if (status)
        return status;
    r.file.place = print_place;
    r.file.owner = &r;
    status = kg_read_end(&r.file, read_root(&r));
    if (status)
        kg_oa_destroy(r.oa);
    else
        *out_oa = r.oa;
    return status;
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
