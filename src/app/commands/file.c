/* Commands: files. */
#include "app/commands/arguments.h"
#include "app/commands/commands.h"
#include "app/export.h"
#include "app/text.h"

static kg_status new_document(kg_editor *e, const json_t *a, kg_document_kind kind,
                              kg_error *error) {
    if (a)
        return kg_editor_new(e, kind, error);
    e->request = KG_REQUEST_NEW;
    e->new_kind = kind;
    return KG_OK;
}

static kg_status new_model(kg_editor *e, const json_t *a, kg_error *error) {
    return new_document(e, a, KG_DOCUMENT_PATCHES, error);
}

static kg_status new_card(kg_editor *e, const json_t *a, kg_error *error) {
    return new_document(e, a, KG_DOCUMENT_OA, error);
}

static kg_status new_sheet(kg_editor *e, const json_t *a, kg_error *error) {
    return new_document(e, a, KG_DOCUMENT_ORIGAMI, error);
}

static kg_status open_model(kg_editor *e, const json_t *a, kg_error *error) {
    const char *path = NULL;
    kg_status status = kg_argument_text(a, "path", &path, error);
    if (!status && path)
        status = kg_editor_open(e, path, error);
    else if (!status)
        e->request = KG_REQUEST_OPEN;
    return status;
}

static kg_status save(kg_editor *e, const json_t *a, kg_error *error) {
    const char *path = NULL;
    kg_status status = kg_argument_text(a, "path", &path, error);
    if (status)
        return status;
    if (!path && !e->path) {
        e->request = KG_REQUEST_SAVE_AS;
        return KG_OK;
    }
    status = kg_editor_save(e, path, error);
    if (!status)
        kg_editor_say(e, KG_WARNING, _("Saved %s"), e->path);
    return status;
}

static kg_status save_as(kg_editor *e, const json_t *a, kg_error *error) {
    (void)a, (void)error;
    e->request = KG_REQUEST_SAVE_AS;
    return KG_OK;
}

static kg_status export_to(kg_editor *e, const json_t *a, kg_request request, kg_error *error) {
    const char *path = NULL;
    kg_status status = kg_argument_text(a, "path", &path, error);
    if (!status && path)
        status = kg_export_file(e, path, error);
    else if (!status)
        e->request = request;
    return status;
}

static kg_status export_net(kg_editor *e, const json_t *a, kg_error *error) {
    return export_to(e, a, KG_REQUEST_EXPORT_NET, error);
}

static kg_status export_mesh(kg_editor *e, const json_t *a, kg_error *error) {
    return export_to(e, a, KG_REQUEST_EXPORT_MESH, error);
}

static kg_status quit(kg_editor *e, const json_t *a, kg_error *error) {
    (void)a, (void)error;
    e->request = KG_REQUEST_QUIT;
    return KG_OK;
}

/* There is something to write: cards and sheets always are. */
static bool has_parts(const kg_editor *e) {
    const kg_model *m = kg_editor_model(e);
    return !m || m->patch_count > 0;
}

static const kg_app_command items[] = {
    {"file.new", N_("New"), N_("Starts an empty model."), "Ctrl+N", NULL, new_model, NULL, 0},
    {"file.new_card", N_("New pop-up card"), N_("Starts an empty pop-up card."), NULL, NULL,
     new_card, NULL, 0},
    {"file.new_sheet", N_("New sheet to fold"), N_("Starts with a square sheet of paper."), NULL,
     NULL, new_sheet, NULL, 0},
    {"file.open", N_("Open…"), N_("Opens a model file."), "Ctrl+O", NULL, open_model, NULL, 0},
    {"file.save", N_("Save"), N_("Saves the model."), "Ctrl+S", NULL, save, NULL, 0},
    {"file.save_as", N_("Save as…"), N_("Saves the model under another name."), "Ctrl+Shift+S",
     NULL, save_as, NULL, 0},
    {"file.export_net", N_("Export net…"), N_("Writes the pages to cut as SVG, PDF or DXF."),
     "Ctrl+E", NULL, export_net, has_parts, 0},
    {"file.export_mesh", N_("Export mesh…"),
     N_("Writes the surface as OBJ, PLY, STL, OFF, glTF or GLB."), NULL, NULL, export_mesh,
     has_parts, 0},
    {"file.quit", N_("Quit"), N_("Ends katagami."), "Ctrl+Q", NULL, quit, NULL, 0},
};
const kg_command_table kg_file_commands = {items, sizeof items / sizeof *items, 0};
