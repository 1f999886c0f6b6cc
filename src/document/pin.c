#include "document/pin.h"

#include "net/settings.h"

#include <jansson.h>

typedef struct pin {
    int64_t patch;
    size_t piece;
    kg_net_placement place;
} pin;

/* Farther off than any page. */
#define FARTHEST 1e5

static bool is_place(kg_net_placement p) {
    return p.page >= 0 && p.page < KG_NET_PAGES_MAX && fabs(p.offset.x) <= FARTHEST &&
           fabs(p.offset.y) <= FARTHEST && fabs(p.angle) <= 1e4;
}

static bool read_pin(const json_t *v, pin *out) {
    json_int_t patch, piece = 0;
    int page;
    double x, y, angle = 0;
    if (json_unpack((json_t *)(uintptr_t)v, "{s:I, s?I, s:i, s:F, s:F, s?F}", "patch", &patch,
                    "piece", &piece, "page", &page, "x", &x, "y", &y, "angle_deg", &angle) ||
        piece < 0)
        return false;
    *out = (pin){patch, (size_t)piece, {page, remainder(angle, 360) * KG_PI / 180, kg_v2(x, y)}};
    return is_place(out->place);
}

size_t kg_pin_piece(const kg_net *net, size_t part) {
    size_t piece = 0;
    for (size_t i = 0; i < part; i++)
        piece += net->parts[i].source == net->parts[part].source;
    return piece;
}

int kg_pin_part(const kg_net *net, int64_t patch, size_t piece) {
    for (size_t i = 0; i < net->part_count; i++)
        if (net->parts[i].source == patch && piece-- == 0)
            return (int)i;
    return -1;
}

void kg_pin_parts(const kg_model *model, kg_net *net) {
    const json_t *list = json_object_get(model->net.json, "placements");
    for (size_t i = 0; i < json_array_size(list); i++) {
        pin p;
        int part = read_pin(json_array_get(list, i), &p) ? kg_pin_part(net, p.patch, p.piece) : -1;
        if (part >= 0 && (size_t)p.place.page <= net->part_count) {
            net->parts[part].pinned = true;
            net->parts[part].pin = p.place;
        }
    }
}

/* The list without the pins that are asked for; NULL when memory runs out. */
static json_t *list_without(const kg_model *model, int64_t patch, size_t piece) {
    const json_t *list = json_object_get(model->net.json, "placements");
    json_t *kept = json_array();
    for (size_t i = 0; kept && i < json_array_size(list); i++) {
        json_t *v = json_array_get(list, i);
        pin p;
        bool gone = patch == 0 || (read_pin(v, &p) && p.patch == patch &&
                                   (piece == KG_PIN_ALL || p.piece == piece));
        if (!gone && json_array_append(kept, v)) {
            json_decref(kept);
            return NULL;
        }
    }
    return kept;
}

kg_status kg_pin_set(kg_model *model, int64_t patch, size_t piece, kg_net_placement place,
                     kg_error *error) {
    if (!is_place(place))
        return kg_fail(error, KG_ERR_INPUT, "page %d, %g, %g mm is no place for a part",
                       place.page + 1, place.offset.x, place.offset.y);
    json_t *list = list_without(model, patch, piece);
    json_t *v = json_pack("{s:I, s:I, s:i, s:f, s:f, s:f}", "patch", (json_int_t)patch, "piece",
                          (json_int_t)piece, "page", place.page, "x", place.offset.x, "y",
                          place.offset.y, "angle_deg", place.angle * 180 / KG_PI);
    if (!list || !v || json_array_append(list, v)) {
        json_decref(v);
        json_decref(list);
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    }
    json_decref(v);
    return kg_net_settings_set(&model->net, "placements", list, error);
}

kg_status kg_pin_remove(kg_model *model, int64_t patch, size_t piece, kg_error *error) {
    json_t *list = list_without(model, patch, piece);
    if (!list)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    if (json_array_size(list) > 0)
        return kg_net_settings_set(&model->net, "placements", list, error);
    json_decref(list);
    return kg_net_settings_set(&model->net, "placements", NULL, error);
}

kg_status kg_pin_forget_patch(kg_model *model, int64_t patch, kg_error *error) {
    kg_status status = kg_pin_remove(model, patch, KG_PIN_ALL, error);
    if (status)
        return status;
    size_t kept = 0;
    for (size_t i = 0; i < model->join_count; i++) {
        kg_model_join *join = &model->joins[i];
        if (join->patches[0] == patch || join->patches[1] == patch)
            json_decref(join->json);
        else
            model->joins[kept++] = *join;
    }
    model->join_count = kept;
    return KG_OK;
}
