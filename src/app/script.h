/*
 * Scripts: the app driven by a text file through its event queue, with assertions on what comes of
 * it. docs/app.md lists the verbs.
 */
#ifndef KG_APP_SCRIPT_H
#define KG_APP_SCRIPT_H

#include "app/app.h"

/* Makes a picture of the app as it is now. */
typedef kg_status (*kg_shot_fn)(void *user, const char *path, kg_error *error);

/* Runs a script ("-": standard input) to its end or its first failure, which names file and line.
 * Each event is a sixtieth of a second after the one before. */
kg_status kg_script_run(kg_app *app, const char *path, kg_shot_fn shot, void *user,
                        kg_error *error) KG_CHECKED;

/* An assertion about the net view, the words after "expect net". */
kg_status kg_script_expect_net(const kg_net_view *view, const kg_editor *editor, const char *words,
                               kg_error *error) KG_CHECKED;

/* One assertion, the words after "expect". */
kg_status kg_script_expect(const kg_app *app, const char *words, kg_error *error) KG_CHECKED;

#endif
