/* Making a card of a mesh: its options beside a picture of what comes of them. */
#include "app/commands/commands.h"
#include "app/commands/create.h"
#include "app/convert_job.h"
#include "app/panels/panels.h"
#include "app/text.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Layout units. */
enum { FIELD_WIDTH = 110, LEFT_WIDTH = 300, PICTURE_WIDTH = 400, PICTURE_HEIGHT = 330 };

/* Edges bent by more than 20 degrees are folds. */
#define CREASE 0.35

struct kg_conversion {
    char path[KG_PATH_SIZE];
    kg_mesh *mesh;       /* NULL: not read yet, or with the job */
    kg_convert_job *job; /* NULL: nothing is being made */
    kg_converted made;
    uint32_t picture; /* of it; 0: none */
    kg_area drawn;    /* its size, pixels */
    bool stale;       /* the options are others than the job's or those of what was made */
    bool wanted;      /* is to be taken as soon as it is there */
    char error[KG_ERROR_SIZE];
};

/* ---- the work ---------------------------------------------------------------------------- */

static void drop_picture(kg_conversion *c) {
    kg_ui_picture_destroy(c->picture);
    c->picture = 0;
}

void kg_conversion_stop(kg_app *app) {
    kg_conversion *c = app->conversion;
    kg_converted made = {0};
    kg_error error;
    if (!c)
        return;
    if (c->job) {
        kg_convert_job_cancel(c->job);
        if (!kg_convert_job_finish(c->job, &c->mesh, &made, &error))
            kg_converted_clear(&made);
    }
    drop_picture(c);
    kg_converted_clear(&c->made);
    kg_mesh_destroy(c->mesh);
    free(c);
    app->conversion = NULL;
}

/* Takes what a job that has ended made, unless other options are wanted by now. */
static void collect(kg_conversion *c) {
    kg_converted made = {0};
    kg_error error;
    if (!c->job || !kg_convert_job_is_done(c->job))
        return;
    kg_status status = kg_convert_job_finish(c->job, &c->mesh, &made, &error);
    c->job = NULL;
    if (c->stale) {
        kg_converted_clear(&made);
        return;
    }
    drop_picture(c);
    kg_converted_clear(&c->made);
    c->made = made;
    c->wanted = c->wanted && !status;
    snprintf(c->error, sizeof c->error, "%s", status ? error.message : "");
}

static void start(kg_conversion *c, const kg_oa_options *options, kg_gate *gate) {
    kg_error error;
    if (!c->stale)
        return;
    if (c->job) {
        kg_convert_job_cancel(c->job);
        return;
    }
    kg_mesh *mesh = c->mesh;
    c->mesh = NULL;
    c->stale = false;
    if (kg_convert_job_start(c->path, mesh, options, gate, &c->job, &error))
        snprintf(c->error, sizeof c->error, "%s", error.message);
}

/* ---- the picture ------------------------------------------------------------------------- */

static kg_status draw(kg_app *app, const kg_mesh *mesh, const kg_area *area, kg_image *out,
                      kg_error *error) {
    static const kg_color paper = {0.93F, 0.92F, 0.88F, 1}, ink = {0.2F, 0.2F, 0.22F, 1};
    kg_overlay overlay = {0};
    kg_surface surface;
    kg_shape *edges = NULL;
    kg_camera camera = kg_camera_default();
    kg_camera_fit(&camera, kg_mesh_bounds(mesh), area->width / area->height);
    kg_status status =
        kg_surface_from_mesh(mesh, 0, mesh->face_count, CREASE, NULL, &surface, error);
    if (status)
        return status;
    kg_overlay_surface(&overlay, &surface, kg_style_default(paper));
    status = kg_shape_from_edges(&surface, CREASE, &edges, error);
    kg_surface_destroy(&surface);
    if (!status) {
        kg_overlay_item(&overlay, edges, kg_line_style(ink, 1));
        status = kg_scenery_thumbnail(app->stage, &overlay, &camera, (int)area->width,
                                      (int)area->height, out, error);
    }
    kg_overlay_clear(&overlay);
    kg_shape_destroy(edges);
    return status;
}

static void show_picture(kg_app *app, kg_conversion *c) {
    kg_area area = kg_ui_canvas_area("##card", PICTURE_WIDTH, PICTURE_HEIGHT);
    kg_image image;
    kg_error error;
    kg_color ink = kg_ui_text_ink();
    if (c->picture && (c->drawn.width != area.width || c->drawn.height != area.height))
        drop_picture(c);
    if (!c->picture && c->made.standing && !draw(app, c->made.standing, &area, &image, &error)) {
        c->picture = kg_ui_picture_create(&image);
        c->drawn = area;
        kg_image_destroy(&image);
    }
    kg_ui_canvas(KG_CANVAS_WINDOW);
    if (c->picture)
        kg_ui_canvas_picture(area, c->picture, c->job || c->stale ? 0.5 : 1);
    ink.a *= 0.3F;
    kg_ui_canvas_frame(area, ink, 1, 0);
}

/* ---- the options ------------------------------------------------------------------------- */

static const char *const axis_names[] = {"x", "-x", "y", "-y", "z", "-z"};
enum { AXIS_COUNT = 6 };

static int index_of(kg_vec3 axis) {
    for (int i = 0; i < AXIS_COUNT; i++) {
        kg_vec3 a;
        if (kg_oa_axis_parse(axis_names[i], &a) && kg_dot(a, axis) > 0.5)
            return i;
    }
    return 0;
}

static bool axis_choice(const char *label, kg_vec3 *axis, const kg_vec3 *across) {
    const char *names[AXIS_COUNT];
    kg_vec3 axes[AXIS_COUNT], a;
    int count = 0, chosen = 0;
    for (int i = 0; i < AXIS_COUNT; i++) {
        kg_oa_axis_parse(axis_names[i], &a);
        if (across && kg_dot(a, *across) != 0)
            continue;
        if (i == index_of(*axis))
            chosen = count;
        names[count] = axis_names[i];
        axes[count++] = a;
    }
    kg_ui_width(FIELD_WIDTH);
    if (!kg_ui_choice(label, names, count, &chosen))
        return false;
    *axis = axes[chosen];
    return true;
}

/* What points up cannot be the front. */
static bool axes(kg_oa_options *o) {
    bool changed = axis_choice(_("up##mesh"), &o->up, NULL);
    if (kg_dot(o->up, o->front) != 0)
        o->front = o->up.z != 0 ? kg_v3(0, -1, 0) : kg_v3(0, 0, 1);
    return axis_choice(_("front##mesh"), &o->front, &o->up) || changed;
}

static bool whole(const char *label, int *value, int lo, int hi, double speed) {
    double shown = *value;
    kg_ui_width(FIELD_WIDTH);
    unsigned result = kg_ui_number(label, &shown, speed, lo, hi, "%.0f");
    *value = (int)fmin(fmax(floor(shown + 0.5), lo), hi);
    return result & KG_FIELD_CHANGED;
}

static bool flag(const char *label, bool *value, const char *tip) {
    bool changed = kg_ui_check(label, value);
    kg_ui_tooltip(tip);
    return changed;
}

static bool size_fields(kg_oa_options *o) {
    bool changed = whole(_("width, cells"), &o->width, 3, KG_OA_MAX_SIZE, 0.25);
    changed = whole(_("depth, cells"), &o->depth, 2, KG_OA_MAX_SIZE, 0.25) || changed;
    changed = whole(_("height, cells"), &o->height, 2, KG_OA_MAX_SIZE, 0.25) || changed;
    if (changed) /* so that the sheet fits an A4 */
        o->cell_mm = kg_document_card_cell((int[]){o->width, o->depth, o->height});
    kg_ui_width(FIELD_WIDTH);
    changed = kg_ui_number(_("cell##mm"), &o->cell_mm, 0.01, 0.01, KG_OA_MAX_CELL, "%.2f mm") &
                  KG_FIELD_CHANGED ||
              changed;
    o->cell_mm = fmin(fmax(o->cell_mm, 0.01), KG_OA_MAX_CELL);
    return changed;
}

static bool fields(kg_oa_options *o) {
    static const int sides[] = {0, 3, 5, 7};
    const char *const smooth[] = {_("off"), "3", "5", "7"};
    int side = 0;
    bool proportions = !o->stretch, changed = axes(o);
    for (int i = 0; i < 4; i++)
        if (sides[i] == o->smooth)
            side = i;
    changed = size_fields(o) || changed;
    changed = flag(_("keep proportions"), &proportions,
                   _("Else the mesh is stretched to fill the card.")) ||
              changed;
    o->stretch = !proportions;
    kg_ui_width(FIELD_WIDTH);
    changed = kg_ui_choice(_("smoothing"), smooth, 4, &side) || changed;
    o->smooth = sides[side];
    kg_ui_tooltip(_("Takes out what is thinner than so many cells."));
    changed =
        flag(_("windows"), &o->windows, _("Opens the front where nothing would fall apart.")) ||
        changed;
    changed = whole(_("thin tops, cells"), &o->thin_top, 0, 20, 0.05) || changed;
    kg_ui_tooltip(_("Leaves out tops that are at most so deep; 0: none."));
    changed =
        flag(_("45° folds"), &o->diagonals, _("Pyramids instead of steps where they fold.")) ||
        changed;
    changed =
        flag(_("make it stand"), &o->stable, _("Changes a few cells so that no patch is loose.")) ||
        changed;
    return flag(_("cover it when closed"), &o->covering,
                _("As wide a margin as it takes that nothing sticks out of the closed card.")) ||
           changed;
}

static void tell(const kg_conversion *c, const kg_oa_options *o) {
    char text[128];
    const kg_oa *made = c->made.document ? kg_document_oa(c->made.document) : NULL;
    double cell = made ? made->cell_mm : o->cell_mm;
    int margin = made ? made->margin_cells : o->margin;
    snprintf(text, sizeof text, _("Sheet: %.4g × %.4g mm"), (o->width + 2 * margin) * cell,
             (o->depth + o->height + 2 * margin) * cell);
    kg_ui_text_dim(text);
    const kg_oa_stability *stability =
        c->made.document ? kg_document_stability(c->made.document) : NULL;
    size_t loose = 0; /* flaps follow their own weight, as in the card's panel */
    for (size_t i = 0; stability && i < stability->patch_count; i++)
        loose += !stability->patches[i].stable && !stability->patches[i].flap;
    /* one bar for all, so that nothing moves under the pointer */
    if (c->error[0] && !c->job)
        kg_ui_text_wrapped(c->error);
    else if (c->job || !stability)
        kg_ui_progress(c->job ? kg_convert_job_fraction(c->job) : 0, "");
    else if (loose > 0) {
        snprintf(text, sizeof text, _("Works, but %zu patches are loose"), loose);
        kg_ui_progress(0, text);
    } else {
        kg_ui_progress(0, _("Works: one sheet that pops up"));
    }
}

/* ---- the dialog -------------------------------------------------------------------------- */

void kg_conversion_ask(kg_app *app, const char *path) {
    kg_conversion_stop(app);
    app->conversion = calloc(1, sizeof *app->conversion);
    if (!app->conversion)
        return;
    snprintf(app->conversion->path, sizeof app->conversion->path, "%s", path);
    app->conversion->stale = true;
    app->dialogs.open_conversion = true;
}

/* Shows what was made as a document of its own. */
static void take(kg_app *app) {
    kg_conversion *c = app->conversion;
    kg_document *document = c->made.document;
    char skipped[KG_ERROR_SIZE];
    kg_error error;
    kg_mesh_say_skipped(c->mesh, c->path, skipped, sizeof skipped);
    c->made.document = NULL;
    kg_conversion_stop(app);
    if (kg_create_take(&app->editor, document, true, &error))
        kg_dialogs_fail(app, &error);
    else if (skipped[0])
        kg_editor_say(&app->editor, KG_WARNING, "%s", skipped);
}

void kg_panel_convert(kg_app *app) {
    static const double widths[] = {LEFT_WIDTH, 0};
    kg_dialogs *d = &app->dialogs;
    kg_oa_options *o = &d->creation.conversion;
    kg_conversion *c = app->conversion;
    bool other = false, cancel = false;
    if (!c)
        return;
    collect(c);
    if (!kg_panel_modal(&d->open_conversion, _("Card from a mesh"),
                        LEFT_WIDTH + PICTURE_WIDTH + 40))
        return;
    const char *slash = strrchr(c->path, '/');
    kg_ui_text(slash ? slash + 1 : c->path);
    kg_ui_same_line();
    other = kg_ui_small_button(_("Another mesh…"));
    if (kg_ui_table_begin("conversion", 2, widths)) {
        kg_ui_table_row();
        kg_ui_table_next();
        c->stale = fields(o) || c->stale;
        kg_ui_table_next();
        show_picture(app, c);
        tell(c, o);
        kg_ui_table_end();
    }
    start(c, o, &app->gate);
    kg_ui_space();
    bool ready = !c->job && !c->stale && c->made.document;
    kg_ui_disabled_begin(c->error[0] && !c->job);
    c->wanted = kg_ui_primary_button(_("Make card")) || c->wanted;
    kg_ui_disabled_end();
    kg_ui_same_line();
    cancel = kg_ui_button(_("Cancel")) || kg_ui_key_pressed(KG_KEY_ESCAPE);
    bool done = c->wanted && ready;
    if (done || cancel || other)
        kg_ui_popup_close();
    kg_ui_popup_end();
    app->busy = app->busy || c->job;
    if (done)
        take(app);
    else if (cancel || other)
        kg_conversion_stop(app);
    if (other)
        kg_dialogs_browse(app, KG_FOR_CARD_OF_MESH);
}
