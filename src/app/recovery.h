/*
 * Autosave: unsaved work goes to $XDG_STATE_HOME/katagami now and then, and is offered at the next
 * start when the app ended without removing it.
 */
#ifndef KG_APP_RECOVERY_H
#define KG_APP_RECOVERY_H

#include "app/app.h"

/* Autosaves when it is time to. */
void kg_recovery_tick(kg_app *app);
/* Seconds until then; negative: nothing to save. */
double kg_recovery_due(const kg_app *app);
/* Looks for a file left behind and offers it. */
void kg_recovery_offer(kg_app *app);
/* Opens it as unsaved work of the file it came from. */
void kg_recovery_take(kg_app *app);
/* Removes the autosaved file: the work is saved, or given up. */
void kg_recovery_forget(kg_app *app);

#endif
