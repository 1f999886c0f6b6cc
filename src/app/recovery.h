/*
 * Autosave: unsaved work goes to $XDG_STATE_HOME/katagami/autosave-PID.katagami now and then. The
 * file is removed when the work is saved or given up; one whose process is gone was left by a
 * crash, and is offered at the next start.
 */
#ifndef KG_APP_RECOVERY_H
#define KG_APP_RECOVERY_H

#include "app/app.h"

/* Autosaves when it is time to. */
void kg_recovery_tick(kg_app *app);
/* Seconds until then; negative: nothing to save. */
double kg_recovery_due(const kg_app *app);
/* Offers the newest file left behind in a dialog; removes those that were never written to their
 * end. */
void kg_recovery_offer(kg_app *app);
/* Opens the file offered as unsaved work of the file it came from; it becomes this process's own
 * autosave. */
void kg_recovery_take(kg_app *app);
/* Removes the file offered and offers the next. */
void kg_recovery_drop(kg_app *app);
/* Removes this process's autosave: the work is saved, or given up. */
void kg_recovery_forget(kg_app *app);

#endif
