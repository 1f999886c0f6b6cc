/* Commands: the mesh that is sculpted over. */
#include "app/commands/reference.h"
#include "app/commands/arguments.h"
#include "app/commands/commands.h"
#include "app/text.h"

#include <stdlib.h>
#include <string.h>

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

static kg_status change_reference(kg_editor *e, const json_t *a, const char *file,
                                  kg_error *error) {
    kg_status status = kg_editor_begin(e, N_("Set reference"), error);
    if (status)
        return status;
    status = kg_editor_finish(e, set_reference_fields(e, a, file, error));
    if (!status)
        kg_editor_load_reference(e);
    return status;
}

kg_status kg_reference_set(kg_editor *e, const char *path, kg_error *error) {
    return change_reference(e, NULL, path, error);
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
    if (file && (status = kg_mesh_read(file, &mesh, error)))
        return status; /* told of at once, nothing changed */
    kg_mesh_destroy(mesh);
    return change_reference(e, a, file, error);
}

static bool has_reference(const kg_editor *e) {
    return kg_editor_model(e)->reference.file != NULL;
}

static kg_status toggle_reference(kg_editor *e, const json_t *a, kg_error *error) {
    (void)a;
    if (!has_reference(e))
        return kg_fail(error, KG_ERR_INPUT, "there is no reference");
    kg_status status = kg_editor_begin(e, N_("Show or hide reference"), error);
    if (status)
        return status;
    kg_reference *ref = &kg_editor_model(e)->reference;
    ref->visible = !ref->visible;
    kg_editor_commit(e);
    return KG_OK;
}

static const kg_app_command items[] = {
    {"reference.set", N_("Reference…"), N_("Chooses the mesh to sculpt over."), NULL, NULL,
     set_reference, NULL, KG_COMMAND_EDIT},
    {"reference.toggle", N_("Show reference"), N_("Shows or hides the reference mesh."), "Q", NULL,
     toggle_reference, has_reference, KG_COMMAND_EDIT},
};
const kg_command_table kg_reference_commands = {items, sizeof items / sizeof *items,
                                                KG_FOR_KIND(KG_DOCUMENT_PATCHES)};
