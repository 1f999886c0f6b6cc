/* Commands: files. */
#include "app/commands/arguments.h"
#include "app/commands/commands.h"
#include "app/export.h"
#include "app/text.h"

#include <stdlib.h>
#include <string.h>

static kg_status new_model(kg_editor *e, const json_t *a, kg_error *error) {
    if (a)
        return kg_editor_new(e, error);
    e->request = KG_REQUEST_NEW;
    return KG_OK;
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

/* ---- the reference ---------------------------------------------------------------------- */

static kg_status set_reference_fields(kg_editor *e, const json_t *a, const char *file,
                                      kg_error *error) {
    kg_reference *ref = &kg_editor_model(e)->reference;
    const char *model_path = kg_document_path(e->document);
    bool visible = true;
    double size = ref->size_mm, opacity = ref->opacity;
    const char *up = ref->up_y ? "y" : "z";
    kg_status status = kg_argument_number(a, "size_mm", &size, error);
    if (!status)
        status = kg_argument_number(a, "opacity", &opacity, error);
    if (!status)
        status = kg_argument_bool(a, "visible", &visible, error);
    if (!status)
        status = kg_argument_text(a, "up", &up, error);
    if (!status && strcmp(up, "y") != 0 && strcmp(up, "z") != 0)
        status = kg_fail(error, KG_ERR_INPUT, "\"up\" has to be \"y\" or \"z\"");
    if (!status && (size < 0 || size > 1e6 || opacity < 0 || opacity > 1))
        status =
            kg_fail(error, KG_ERR_INPUT, "\"size_mm\" has to be 0 to 1000000, \"opacity\" 0 to 1");
    if (status)
        return status;
    if (file) {
        char *name = model_path ? kg_document_relative(model_path, file) : NULL;
        char *copy = name ? name : strdup(file);
        if (!copy)
            return kg_fail(error, KG_ERR_MEMORY, "out of memory");
        free(ref->file);
        ref->file = copy;
    }
    ref->size_mm = size;
    ref->opacity = opacity;
    ref->visible = visible;
    ref->up_y = up[0] == 'y';
    return KG_OK;
}

static kg_status set_reference(kg_editor *e, const json_t *a, kg_error *error) {
    const char *file = NULL;
    kg_mesh *mesh = NULL;
    kg_status status = kg_argument_text(a, "file", &file, error);
    if (status)
        return status;
    if (!a) {
        e->request = KG_REQUEST_REFERENCE;
        return KG_OK;
    }
    if (file && (status = kg_mesh_read(file, &mesh, error))) /* told of at once, nothing changed */
        return status;
    kg_mesh_destroy(mesh);
    if ((status = kg_editor_begin(e, N_("Set reference"), error)))
        return status;
    status = kg_editor_finish(e, set_reference_fields(e, a, file, error));
    if (!status)
        kg_editor_load_reference(e);
    return status;
}

static kg_status toggle_reference(kg_editor *e, const json_t *a, kg_error *error) {
    (void)a;
    kg_status status = kg_editor_begin(e, N_("Show or hide reference"), error);
    if (status)
        return status;
    kg_reference *ref = &kg_editor_model(e)->reference;
    ref->visible = !ref->visible;
    kg_editor_commit(e);
    return KG_OK;
}

static bool has_reference(const kg_editor *e) {
    return kg_editor_model(e)->reference.file != NULL;
}
static bool has_patches(const kg_editor *e) {
    return kg_editor_model(e)->patch_count > 0;
}

static const kg_app_command items[] = {
    {"file.new", N_("New"), N_("Starts an empty model."), "Ctrl+N", NULL, new_model, NULL, 0},
    {"file.open", N_("Open…"), N_("Opens a model file."), "Ctrl+O", NULL, open_model, NULL, 0},
    {"file.save", N_("Save"), N_("Saves the model."), "Ctrl+S", NULL, save, NULL, 0},
    {"file.save_as", N_("Save as…"), N_("Saves the model under another name."), "Ctrl+Shift+S",
     NULL, save_as, NULL, 0},
    {"file.export_net", N_("Export net…"), N_("Writes the pages to cut as SVG, PDF or DXF."),
     "Ctrl+E", NULL, export_net, has_patches, 0},
    {"file.export_mesh", N_("Export mesh…"),
     N_("Writes the surface as OBJ, PLY, STL, OFF, glTF or GLB."), NULL, NULL, export_mesh,
     has_patches, 0},
    {"file.quit", N_("Quit"), N_("Ends katagami."), "Ctrl+Q", NULL, quit, NULL, 0},
    {"reference.set", N_("Reference…"), N_("Chooses the mesh to sculpt over."), NULL, NULL,
     set_reference, NULL, KG_COMMAND_EDIT},
    {"reference.toggle", N_("Show reference"), N_("Shows or hides the reference mesh."), "Q", NULL,
     toggle_reference, has_reference, KG_COMMAND_EDIT},
};
const kg_command_table kg_file_commands = {items, sizeof items / sizeof *items};
