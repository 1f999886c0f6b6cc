/* Commands: files. */
#include "app/commands/arguments.h"
#include "app/commands/commands.h"
#include "app/export.h"
#include "app/export_job.h"
#include "app/text.h"

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

/* Its pictures are drawn by a thread of their own: a thread has one OpenGL context, and this one's
 * is the window's. */
static kg_status export_guide(kg_editor *e, const json_t *a, kg_error *error) {
    const char *path = NULL;
    kg_export_job *job;
    kg_status status = kg_argument_text(a, "path", &path, error);
    if (!status && !path)
        e->request = KG_REQUEST_EXPORT_GUIDE;
    if (status || !path)
        return status;
    status = kg_export_job_start(e, path, true, NULL, &job, error);
    return status ? status : kg_export_job_finish(job, error);
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
    {"file.new", N_("New patch model"), N_("Starts an empty patch model."), "Ctrl+N", NULL,
     new_model, NULL, 0},
    {"file.open", N_("Open…"), N_("Opens a model file."), "Ctrl+O", NULL, open_model, NULL, 0},
    {"file.save", N_("Save"), N_("Saves the model."), "Ctrl+S", NULL, save, NULL, 0},
    {"file.save_as", N_("Save as…"), N_("Saves the model under another name."), "Ctrl+Shift+S",
     NULL, save_as, NULL, 0},
    {"file.export_net", N_("Export net…"), N_("Writes the pages to cut as SVG, PDF or DXF."),
     "Ctrl+E", NULL, export_net, has_parts, 0},
    {"file.export_mesh", N_("Export mesh…"),
     N_("Writes the surface as a mesh, or the crease pattern as FOLD."), NULL, NULL, export_mesh,
     has_parts, 0},
    {"file.export_guide", N_("Export instructions…"),
     N_("Writes how it is built or folded, step by step, as a PDF."), NULL, NULL, export_guide,
     has_parts, 0},
    {"file.quit", N_("Quit"), N_("Ends katagami."), "Ctrl+Q", NULL, quit, NULL, 0},
};
const kg_command_table kg_file_commands = {items, sizeof items / sizeof *items, 0};
