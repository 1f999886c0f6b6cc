/* The windows of the app. Each function shows one and does what the user does in it. */
#ifndef KG_APP_PANELS_PANELS_H
#define KG_APP_PANELS_PANELS_H

#include "app/app.h"

/* All of them; sets the area that is left for the 3D view. */
void kg_panels_show(kg_app *app);

/* A dialog, opened in this frame when `open` says so, which is unset; kg_ui_popup_end ends it when
 * true. */
bool kg_panel_modal(bool *open, const char *title, double width);

double kg_panel_menu(kg_app *app); /* height in pixels */
void kg_panel_toolbar(kg_app *app, kg_area area);
/* A command as a button of the tool bar. */
void kg_panel_tool_button(kg_editor *editor, const char *id, kg_icon icon, bool on);
void kg_panel_outliner(kg_app *app, kg_area area);
void kg_panel_properties(kg_app *app, kg_area area);
void kg_panel_status(kg_app *app, kg_area area);
/* Of text that tells something, to be read on the panels of the theme. */
kg_color kg_panel_severity_color(const kg_editor *editor, kg_severity severity);
void kg_panel_net(kg_app *app);                         /* takes its place from the 3D view */
void kg_panel_net_settings(kg_app *app);                /* a popup of the net view's header */
void kg_panel_axes(kg_app *app);                        /* the ball that turns the view */
bool kg_axes_event(kg_app *app, const kg_event *event); /* true: it was for the ball */

/* The fold being made: buttons of the tool bar, its properties, a label beside the pointer. */
void kg_panel_fold_buttons(kg_editor *editor);
void kg_panel_fold(kg_app *app, kg_area area);
void kg_panel_fold_label(kg_app *app);

void kg_panel_handles(kg_app *app); /* what the mode draws over the 3D view */
void kg_panel_context_menu(kg_app *app);
void kg_panel_start(kg_app *app); /* over the empty view */

void kg_panel_sheets(kg_app *app); /* in the window that is open */
void kg_panel_steps(kg_app *app);
void kg_panel_steps_bar(kg_app *app); /* takes its place from the 3D view */

/* Dialogs: opened by flags of app->dialogs. */
void kg_panel_palette(kg_app *app);
void kg_panel_help(kg_app *app);
void kg_panel_settings(kg_app *app);
void kg_panel_browser(kg_app *app);
void kg_panel_prompts(kg_app *app);
void kg_panel_export(kg_app *app);
void kg_panel_create(kg_app *app);
void kg_panel_convert(kg_app *app);
void kg_panel_loading(kg_app *app);
void kg_panel_stand(kg_app *app);

/* Asks what to export as, starting from the last choice where it is for such a purpose: KG_FOR_NET,
 * KG_FOR_MESH, KG_FOR_GUIDE. */
void kg_export_ask(kg_app *app, kg_purpose purpose);
/* Writes what the purpose and the name's ending say, in the background. */
void kg_export_to(kg_app *app, kg_purpose purpose, const char *path);
/* Gives up what is being written. */
void kg_export_stop(kg_app *app);

/* Opens a document in the place of the one there is; makes a mesh the reference. What goes wrong is
 * shown. Large files are read in the background. */
void kg_loading_open(kg_app *app, const char *path);
void kg_loading_reference(kg_app *app, const char *path);
/* Gives up what is being read. */
void kg_loading_stop(kg_app *app);

/* Asks how a card is to be made of a mesh; gives that up. */
void kg_conversion_ask(kg_app *app, const char *path);
void kg_conversion_stop(kg_app *app);

/* Makes the card stand, large ones in the background; gives that up. */
void kg_stand_begin(kg_app *app);
void kg_stand_stop(kg_app *app);

/* Asks what to do about unsaved changes, if there are any, then goes on with `purpose`. */
void kg_dialogs_go_on(kg_app *app, kg_purpose purpose);
/* Opens the browser. */
void kg_dialogs_browse(kg_app *app, kg_purpose purpose);
/* Whether a file is a mesh, by its name. */
bool kg_dialogs_is_mesh(const char *path);
/* Does what a file was chosen for. */
void kg_dialogs_use_file(kg_app *app, kg_purpose purpose, const char *path);
/* Puts the document's file first in the list of recent ones. */
void kg_dialogs_remember(kg_app *app);
void kg_dialogs_fail(kg_app *app, const kg_error *error);
void kg_dialogs_clear(kg_dialogs *dialogs);

#endif
