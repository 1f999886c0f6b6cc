/* Making a card stand: small ones at once, large ones while a dialog shows how far it is. */
#include "app/modes/card_edit.h"
#include "app/panels/panels.h"
#include "app/stand_job.h"
#include "app/text.h"

/* Cells of a sheet that is mended within a few frames, without a dialog that flashes. */
enum { SMALL_SHEET = 4096 };

static void finish(kg_app *app) {
    kg_editor *e = &app->editor;
    kg_stood stood = {0};
    kg_error error;
    kg_status status = kg_stand_job_finish(app->stand_job, &stood, &error);
    app->stand_job = NULL;
    app->redraw = true;
    const kg_oa *card = kg_editor_oa(e);
    bool same = !status && card && !e->before && kg_oa_equal(card, stood.before);
    if (same)
        status = kg_card_stand(e, stood.after, &stood.mended, &error);
    else if (!status)
        status = KG_ERR_CANCELLED; /* the work was for another card */
    if (status == KG_ERR_CANCELLED)
        kg_editor_say(e, KG_WARNING, "%s", _("The card was left as it is."));
    else if (status)
        kg_dialogs_fail(app, &error);
    kg_stood_clear(&stood);
}

void kg_stand_begin(kg_app *app) {
    const kg_oa *card = kg_editor_oa(&app->editor);
    kg_error error;
    if (!card || app->stand_job)
        return;
    kg_status status = kg_stand_job_start(card, &app->gate, &app->stand_job, &error);
    if (status)
        kg_dialogs_fail(app, &error);
    else if ((int64_t)card->width * (card->depth_limit + card->height) <= SMALL_SHEET)
        finish(app);
    else
        app->dialogs.open_stand = true;
}

void kg_stand_stop(kg_app *app) {
    kg_stood stood = {0};
    kg_error error;
    if (!app->stand_job)
        return;
    kg_stand_job_cancel(app->stand_job);
    if (!kg_stand_job_finish(app->stand_job, &stood, &error))
        kg_stood_clear(&stood);
    app->stand_job = NULL;
}

void kg_panel_stand(kg_app *app) {
    const char *title = _("Making the card stand");
    if (app->stand_job && kg_stand_job_is_done(app->stand_job))
        finish(app);
    app->busy = app->busy || app->stand_job;
    if (!kg_panel_modal(&app->dialogs.open_stand, title, 420))
        return;
    if (app->stand_job) {
        kg_ui_progress(kg_stand_job_fraction(app->stand_job), "");
        if (kg_ui_button(_("Cancel")) || kg_ui_key_pressed(KG_KEY_ESCAPE))
            kg_stand_job_cancel(app->stand_job);
    } else {
        kg_ui_popup_close();
    }
    kg_ui_popup_end();
}
