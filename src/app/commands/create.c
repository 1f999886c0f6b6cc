/* Commands: new cards and sheets, and cards made of meshes. */
#include "app/commands/create.h"

#include "app/commands/arguments.h"
#include "app/commands/commands.h"
#include "app/convert_job.h"
#include "app/scenery.h"
#include "app/text.h"

/* A card to build by hand: as many cells as can be seen, 120 mm wide. */
#define CARD_CELLS 12
#define CARD_CELL_MM 10.0
/* As paper to fold is sold, mm. */
#define SHEET_SIDE 150.0

kg_status kg_create_take(kg_editor *e, kg_document *document, bool work, kg_error *error) {
    kg_status status = kg_editor_take(e, document, NULL, error);
    if (status)
        return status;
    if (work) /* no state of it was ever saved */
        e->saved_state = e->autosaved_state = e->next_state++;
    if (e->pane.area.width > 1)
        kg_pane_fit(&e->pane, kg_editor_box(e, false));
    return KG_OK;
}

/* ---- arguments --------------------------------------------------------------------------- */

static kg_status read_size(const json_t *a, int size[3], kg_error *error) {
    const json_t *v = json_object_get(a, "size");
    if (v && json_unpack((json_t *)(uintptr_t)v, "[iii!]", &size[0], &size[1], &size[2]))
        return kg_fail(error, KG_ERR_INPUT,
                       "\"size\" has to be [width, depth, height], whole numbers of cells");
    for (int i = 0; i < 3; i++)
        if (size[i] < 1 || size[i] > KG_OA_MAX_SIZE)
            return kg_fail(error, KG_ERR_INPUT, "\"size\" has to be 1 to %d cells a side",
                           KG_OA_MAX_SIZE);
    return KG_OK;
}

static kg_status read_sheet_size(const json_t *a, kg_vec2 *out, kg_error *error) {
    double side = SHEET_SIDE;
    const char *paper = NULL;
    const json_t *v = json_object_get(a, "size");
    kg_status status = kg_argument_number(a, "square", &side, error);
    if (!status)
        status = kg_argument_text(a, "paper", &paper, error);
    if (status)
        return status;
    *out = kg_v2(side, side);
    if (v && json_unpack((json_t *)(uintptr_t)v, "[FF!]", &out->x, &out->y))
        return kg_fail(error, KG_ERR_INPUT, "\"size\" has to be [width, height] in mm");
    return paper ? kg_net_paper_parse(paper, out, error) : KG_OK;
}

static kg_status read_axis(const json_t *a, const char *name, kg_vec3 *out, kg_error *error) {
    const char *text = NULL;
    kg_status status = kg_argument_text(a, name, &text, error);
    if (!status && text && !kg_oa_axis_parse(text, out))
        return kg_fail(error, KG_ERR_INPUT, "\"%s\" has to be x, y, z, -x, -y or -z", name);
    return status;
}

static kg_status read_count(const json_t *a, const char *name, int *value, kg_error *error) {
    size_t count = (size_t)*value;
    kg_status status = kg_argument_index(a, name, &count, error);
    if (!status && count > KG_OA_MAX_SIZE)
        status = kg_fail(error, KG_ERR_INPUT, "\"%s\" has to be at most %d", name, KG_OA_MAX_SIZE);
    if (!status)
        *value = (int)count;
    return status;
}

static kg_status read_conversion(const json_t *a, kg_oa_options *o, kg_error *error) {
    int size[3] = {o->width, o->depth, o->height};
    kg_status status = read_size(a, size, error);
    if (status)
        return status;
    o->width = size[0], o->depth = size[1], o->height = size[2];
    o->cell_mm = kg_document_card_cell(size);
    status = read_axis(a, "up", &o->up, error);
    if (o->up.z != 0)
        o->front = kg_v3(0, -1, 0);
    if (!status)
        status = read_axis(a, "front", &o->front, error);
    if (!status)
        status = kg_argument_number(a, "cell_mm", &o->cell_mm, error);
    if (!status)
        status = read_count(a, "smooth", &o->smooth, error);
    if (!status)
        status = read_count(a, "thin_top", &o->thin_top, error);
    if (!status)
        status = kg_argument_bool(a, "windows", &o->windows, error);
    if (!status)
        status = kg_argument_bool(a, "diagonals", &o->diagonals, error);
    if (!status)
        status = kg_argument_bool(a, "stable", &o->stable, error);
    if (!status)
        status = read_count(a, "margin", &o->margin, error);
    if (!status)
        status = kg_argument_bool(a, "covering", &o->covering, error);
    return status ? status : kg_argument_bool(a, "stretch", &o->stretch, error);
}

/* ---- commands ---------------------------------------------------------------------------- */

static kg_status new_card(kg_editor *e, const json_t *a, kg_error *error) {
    int size[3] = {CARD_CELLS, CARD_CELLS, CARD_CELLS};
    kg_document *document;
    if (!a) {
        e->request = KG_REQUEST_NEW_CARD;
        return KG_OK;
    }
    kg_status status = read_size(a, size, error);
    double cell = json_object_get(a, "size") ? kg_document_card_cell(size) : CARD_CELL_MM;
    if (!status)
        status = kg_argument_number(a, "cell_mm", &cell, error);
    if (!status)
        status = kg_document_new_card(size, cell, &document, error);
    return status ? status : kg_create_take(e, document, false, error);
}

static kg_status new_sheets(kg_editor *e, const json_t *a, kg_error *error) {
    kg_vec2 size;
    uint32_t front = KG_SHEET_FRONT, back = KG_SHEET_BACK;
    kg_document *document;
    if (!a) {
        e->request = KG_REQUEST_NEW_SHEETS;
        return KG_OK;
    }
    kg_status status = read_sheet_size(a, &size, error);
    if (!status)
        status = kg_argument_color(a, "front", &front, error);
    if (!status)
        status = kg_argument_color(a, "back", &back, error);
    if (!status)
        status = kg_document_new_sheet(size, front, back, &document, error);
    return status ? status : kg_create_take(e, document, false, error);
}

static kg_status card_from_mesh(kg_editor *e, const json_t *a, kg_error *error) {
    kg_oa_options options = kg_oa_options_default();
    const char *path = NULL;
    kg_document *document;
    kg_mesh *mesh;
    if (!a) {
        e->request = KG_REQUEST_CARD_FROM_MESH;
        return KG_OK;
    }
    kg_status status = kg_argument_text(a, "mesh", &path, error);
    if (!status && !path)
        status = kg_fail(error, KG_ERR_INPUT, "a card is made of a \"mesh\", a file");
    if (!status)
        status = read_conversion(a, &options, error);
    if (!status)
        status = kg_mesh_read(path, &mesh, error);
    if (status)
        return status;
    char skipped[KG_ERROR_SIZE];
    kg_mesh_say_skipped(mesh, path, skipped, sizeof skipped);
    status = kg_convert(mesh, path, &options, NULL, &document, error);
    kg_mesh_destroy(mesh);
    if (!status)
        status = kg_create_take(e, document, true, error);
    if (!status && skipped[0])
        kg_editor_say(e, KG_WARNING, "%s", skipped);
    return status;
}

static const kg_app_command items[] = {
    {"file.new_card", N_("New pop-up card…"), N_("Starts an empty card of the size you choose."),
     NULL, NULL, new_card, NULL, 0},
    {"file.new_sheets", N_("New folding…"), N_("Starts with a sheet of the size you choose."), NULL,
     NULL, new_sheets, NULL, 0},
    {"file.card_from_mesh", N_("Card from a mesh…"),
     N_("Makes a pop-up card that shows the front of a mesh."), NULL, NULL, card_from_mesh, NULL,
     0},
};
const kg_command_table kg_create_commands = {items, sizeof items / sizeof *items, 0};
