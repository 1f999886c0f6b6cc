/* Commands: the net's settings, where its parts lie, and what its joins are like. */
#include "app/commands/arguments.h"
#include "app/commands/commands.h"
#include "app/text.h"
#include "base/array.h"
#include "document/pin.h"
#include "net/settings.h"

#include <stdlib.h>
#include <string.h>

/* ---- pins ------------------------------------------------------------------------------- */

static kg_status read_piece(const kg_editor *e, const json_t *a, int64_t *patch, size_t *piece,
                            kg_error *error) {
    kg_status status = kg_argument_id(a, "patch", patch, error);
    if (!status)
        status = kg_argument_index(a, "piece", piece, error);
    if (!status && *patch && !kg_model_find(kg_editor_model(e), *patch))
        status = kg_fail(error, KG_ERR_INPUT, "there is no patch %lld", (long long)*patch);
    return status;
}

static kg_status pin(kg_editor *e, const json_t *a, kg_error *error) {
    int64_t patch = 0;
    size_t piece = 0, page = 0;
    double angle_deg = 0;
    kg_vec2 at = {NAN, NAN};
    kg_status status = read_piece(e, a, &patch, &piece, error);
    if (!status)
        status = kg_argument_index(a, "page", &page, error);
    if (!status)
        status = kg_argument_number(a, "x", &at.x, error);
    if (!status)
        status = kg_argument_number(a, "y", &at.y, error);
    if (!status)
        status = kg_argument_number(a, "angle_deg", &angle_deg, error);
    if (!status && (!patch || isnan(at.x) || isnan(at.y) || page >= KG_NET_PAGES_MAX))
        status =
            kg_fail(error, KG_ERR_INPUT, "a pin needs \"patch\", \"page\", \"x\" and \"y\", in mm");
    if (!status)
        status = kg_editor_begin(e, N_("Move part"), error);
    if (status)
        return status;
    kg_editor_touch(e);
    kg_net_placement place = {(int)page, angle_deg * KG_PI / 180, at};
    return kg_editor_finish(e, kg_pin_set(kg_editor_model(e), patch, piece, place, error));
}

static bool has_pins(const kg_editor *e) {
    return json_object_get(kg_editor_model(e)->net.json, "placements") != NULL;
}

static kg_status unpin(kg_editor *e, const json_t *a, kg_error *error) {
    int64_t patch = 0;
    size_t piece = KG_PIN_ALL;
    kg_status status = KG_OK;
    if (!has_pins(e))
        return kg_fail(error, KG_ERR_INPUT, "no part is pinned");
    if (json_object_get(a, "piece"))
        piece = 0;
    status = kg_argument_id(a, "patch", &patch, error);
    if (!status && piece == 0)
        status = kg_argument_index(a, "piece", &piece, error);
    if (!status)
        status = kg_editor_begin(e, N_("Unpin part"), error);
    if (status)
        return status;
    kg_editor_touch(e);
    return kg_editor_finish(e, kg_pin_remove(kg_editor_model(e), patch, piece, error));
}

/* ---- settings --------------------------------------------------------------------------- */

/* Keys that the model holds as it finds them. */
static const char *const plain_keys[] = {"landscape", "labels", "preset", "nest",
                                         "grain",     "gap",    "merge"};

static kg_status set_plain(kg_net_settings *net, const json_t *a, kg_error *error) {
    kg_net_options ignored;
    kg_status status = KG_OK;
    for (size_t i = 0; i < sizeof plain_keys / sizeof *plain_keys && !status; i++) {
        json_t *v = json_object_get(a, plain_keys[i]);
        if (v)
            status = kg_net_settings_set(net, plain_keys[i],
                                         json_is_null(v) ? NULL : json_incref(v), error);
    }
    return status ? status : kg_net_settings_options(net, &ignored, error);
}

static kg_status set_net(kg_editor *e, const json_t *a, kg_error *error) {
    kg_net_settings *net = kg_document_net_settings(e->document);
    const char *paper = NULL;
    double margin = net->margin, scale = net->scale, tab_width = net->tab_width;
    kg_status status = kg_argument_text(a, "paper", &paper, error);
    if (!status)
        status = kg_argument_number(a, "margin", &margin, error);
    if (!status)
        status = kg_argument_number(a, "scale", &scale, error);
    if (!status)
        status = kg_argument_number(a, "tab_width", &tab_width, error);
    if (!status && !(margin >= 0 && margin <= 1e4 && scale >= 1e-6 && scale <= 1e6 &&
                     tab_width >= 0 && tab_width <= 1e3))
        status = kg_fail(error, KG_ERR_INPUT,
                         "\"margin\" has to be 0 to 10000, \"tab_width\" 0 to 1000 mm, \"scale\" "
                         "0.000001 to 1000000");
    if (!status)
        status = kg_editor_begin(e, N_("Net settings"), error);
    if (status)
        return status;
    kg_editor_touch(e);
    net->margin = margin;
    net->scale = scale;
    net->tab_width = tab_width;
    char *copy = paper ? strdup(paper) : NULL;
    if (paper && !copy)
        return kg_editor_finish(e, kg_fail(error, KG_ERR_MEMORY, "out of memory"));
    if (copy) {
        free(net->paper);
        net->paper = copy;
    }
    return kg_editor_finish(e, set_plain(net, a, error));
}

/* ---- joins ------------------------------------------------------------------------------ */

static kg_status read_word(const json_t *a, const char *name, const char *const *words, int count,
                           int *value, kg_error *error) {
    const char *text = NULL;
    kg_status status = kg_argument_text(a, name, &text, error);
    if (status || !text)
        return status;
    for (int i = 0; i < count; i++)
        if (strcmp(words[i], text) == 0) {
            *value = i;
            return KG_OK;
        }
    return kg_fail(error, KG_ERR_INPUT, "\"%s\" cannot be \"%s\"", name, text);
}

/* The wish for a pair of patches, or for their join at a place of the first, added when there is
 * none; a new one for a single join begins as what was wished for all. */
static kg_model_join *join_of(kg_model *model, const int64_t patches[2], const kg_vec2 *at) {
    const kg_model_join *all = kg_model_find_join(model, patches[0], patches[1]);
    const kg_model_join *found = at ? kg_model_find_join_at(model, patches, *at) : all;
    if (found)
        return &model->joins[found - model->joins];
    kg_model_join wish = all ? *all : (kg_model_join){0};
    if (all && all->patches[0] != patches[0])
        wish.tab = kg_net_tab_turned(wish.tab);
    wish.patches[0] = patches[0];
    wish.patches[1] = patches[1];
    wish.json = NULL;
    if (at) {
        wish.has_at = true;
        wish.at = *at;
    }
    kg_model_join *more = realloc(model->joins, (model->join_count + 1) * sizeof *more);
    if (!more)
        return NULL;
    model->joins = more;
    more[model->join_count] = wish;
    return &more[model->join_count++];
}

static kg_status change_join(kg_model *model, kg_model_join *join, const int64_t patches[2],
                             const json_t *a, kg_error *error) {
    bool turned = join->patches[0] != patches[0]; /* the model names them the other way round */
    int tab = (int)join->tab, shape = (int)join->shape;
    double width = join->width;
    bool merge = join->merge;
    kg_status status = read_word(a, "tab", kg_net_tab_side_names, 4, &tab, error);
    if (!status && turned && json_object_get(a, "tab"))
        tab = (int)kg_net_tab_turned((kg_net_tab_side)tab);
    if (!status)
        status = read_word(a, "shape", kg_net_tab_shape_names, 3, &shape, error);
    if (!status)
        status = kg_argument_number(a, "width", &width, error);
    if (!status)
        status = kg_argument_bool(a, "merge", &merge, error);
    if (!status && !(width >= 0 && width <= 1e3))
        status = kg_fail(error, KG_ERR_INPUT, "\"width\" has to be 0 to 1000 mm");
    if (status)
        return status;
    join->tab = (kg_net_tab_side)tab;
    join->shape = (kg_net_tab_shape)shape;
    join->width = width;
    join->merge = merge;
    bool plain = tab == KG_TAB_AUTO && shape == KG_TAB_SHAPE_AUTO && width == 0 && !merge;
    if (plain && !join->json &&
        !(join->has_at && kg_model_find_join(model, patches[0], patches[1])))
        *join = model->joins[--model->join_count]; /* nothing is wished for */
    return KG_OK;
}

/* What is wished for all joins of two patches also is for those that have wishes of their own. */
static kg_status change_joins(kg_model *model, const int64_t patches[2], const kg_vec2 *at,
                              const json_t *a, kg_error *error) {
    kg_status status = KG_OK;
    for (size_t i = model->join_count; i-- > 0 && !at && !status;) {
        kg_model_join *j = &model->joins[i];
        bool pair = (j->patches[0] == patches[0] && j->patches[1] == patches[1]) ||
                    (j->patches[0] == patches[1] && j->patches[1] == patches[0]);
        if (pair && j->has_at)
            status = change_join(model, j, patches, a, error);
    }
    kg_model_join *join = status ? NULL : join_of(model, patches, at);
    if (!status && !join)
        status = kg_fail(error, KG_ERR_MEMORY, "out of memory");
    return status ? status : change_join(model, join, patches, a, error);
}

static kg_status set_join(kg_editor *e, const json_t *a, kg_error *error) {
    kg_model *m = kg_editor_model(e);
    json_int_t ids[2];
    if (json_unpack((json_t *)(uintptr_t)json_object_get(a, "patches"), "[II]", &ids[0], &ids[1]))
        return kg_fail(error, KG_ERR_INPUT, "\"patches\" has to be two patches");
    const int64_t patches[2] = {ids[0], ids[1]};
    const json_t *place = json_object_get(a, "at");
    kg_vec2 at = {0, 0};
    if (place && (json_unpack((json_t *)(uintptr_t)place, "[FF]", &at.x, &at.y) ||
                  !(fabs(at.x) <= KG_MAX_COORDINATE && fabs(at.y) <= KG_MAX_COORDINATE)))
        return kg_fail(error, KG_ERR_INPUT, "\"at\" has to be [u, v] on the first patch");
    for (int i = 0; i < 2; i++)
        if (!kg_model_find(m, patches[i]))
            return kg_fail(error, KG_ERR_INPUT, "there is no patch %lld", (long long)patches[i]);
    kg_status status = kg_editor_begin(e, N_("Change join"), error);
    if (status)
        return status;
    kg_editor_touch(e);
    return kg_editor_finish(e, change_joins(m, patches, place ? &at : NULL, a, error));
}

/* ---- the view --------------------------------------------------------------------------- */

static kg_status toggle_view(kg_editor *e, const json_t *a, kg_error *error) {
    bool shown = !e->settings.net_view;
    kg_status status = kg_argument_bool(a, "shown", &shown, error);
    if (!status)
        e->settings.net_view = shown;
    return status ? status : kg_settings_write(&e->settings, error);
}

static const kg_app_command items[] = {
    {"view.net", N_("Net view"), N_("Shows or hides the pages of the net beside the model."), "F4",
     NULL, toggle_view, NULL, 0},
    {"net.set", N_("Net settings"), N_("Sets paper, tabs and labels of the net."), NULL, NULL,
     set_net, NULL, KG_COMMAND_ARGUMENTS},
};
const kg_command_table kg_net_commands = {items, sizeof items / sizeof *items, 0};

static const kg_app_command part_items[] = {
    {"net.pin", N_("Pin part"), N_("Puts a part of the net somewhere on a page."), NULL, NULL, pin,
     NULL, KG_COMMAND_ARGUMENTS},
    {"net.unpin", N_("Unpin all parts"), N_("Lets katagami place the parts of the net."), NULL,
     NULL, unpin, has_pins, KG_COMMAND_EDIT},
    {"net.join", N_("Change join"), N_("Says what tabs the joins between two patches get."), NULL,
     NULL, set_join, NULL, KG_COMMAND_ARGUMENTS},
};
const kg_command_table kg_part_commands = {part_items, sizeof part_items / sizeof *part_items,
                                           KG_FOR_KIND(KG_DOCUMENT_PATCHES)};
