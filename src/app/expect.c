/* Assertions of scripts. */
#include "app/expect.h"

#include "app/mode.h"
#include "app/script.h"
#include "app/tools/tool.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

kg_status kg_expect_count(const char *what, size_t is, const char *words, kg_error *error) {
    char *end;
    long wanted = strtol(words, &end, 10);
    if (end == words || *end)
        return kg_fail(error, KG_ERR_INPUT, "%s: \"%s\" is no number", what, words);
    if ((long)is == wanted)
        return KG_OK;
    return kg_fail(error, KG_ERR_INPUT, "%s: %zu, not %ld", what, is, wanted);
}

kg_status kg_expect_yes(bool is, bool wanted, const char *what, kg_error *error) {
    if (is == wanted)
        return KG_OK;
    return kg_fail(error, KG_ERR_INPUT, "it is %s%s", wanted ? "not " : "", what);
}

/* Issues of the document, or its faults alone. */
static kg_status expect_issues(const kg_editor *e, const char *words, bool faults,
                               kg_error *error) {
    const kg_document *d = e->document;
    size_t count = 0;
    for (size_t i = 0; i < kg_document_issue_count(d); i++)
        count += !faults || kg_document_issue(d, i)->severity == KG_FAULT;
    kg_status status = kg_expect_count(faults ? "faults" : "issues", count, words, error);
    if (status && count > 0)
        kg_fail_in(error, status, "%s; ", kg_document_issue(d, 0)->message);
    return status;
}

/* The words are in what one of the issues says. */
static kg_status expect_issue(const kg_editor *e, const char *words, kg_error *error) {
    const kg_document *d = e->document;
    size_t count = kg_document_issue_count(d);
    for (size_t i = 0; i < count; i++)
        if (strstr(kg_document_issue(d, i)->message, words))
            return KG_OK;
    return kg_fail(error, KG_ERR_INPUT, "none of %zu issues says it: %s", count,
                   count > 0 ? kg_document_issue(d, 0)->message : "");
}

kg_status kg_expect_text(const char *what, const char *is, const char *wanted, kg_error *error) {
    if (strcmp(is, wanted) == 0)
        return KG_OK;
    return kg_fail(error, KG_ERR_INPUT, "the %s is \"%s\"", what, is);
}

/* The word is in what the status bar says. */
static kg_status expect_message(const kg_editor *e, const char *words, kg_error *error) {
    if (strstr(e->message, words) && (words[0] || !e->message[0]))
        return KG_OK;
    return kg_fail(error, KG_ERR_INPUT, "the message is \"%s\"", e->message);
}

static kg_status expect_shown(const char *words, kg_error *error) {
    kg_area area;
    if (kg_ui_find(words, &area))
        return KG_OK;
    return kg_fail(error, KG_ERR_INPUT, "no widget \"%s\" is shown", words);
}

bool kg_expect_begins(const char **words, const char *what) {
    size_t n = strlen(what);
    if (strncmp(*words, what, n) != 0 || ((*words)[n] && (*words)[n] != ' '))
        return false;
    *words += n;
    *words += strspn(*words, " ");
    return true;
}

kg_status kg_expect_unknown(const char *words, kg_error *error) {
    return kg_fail(error, KG_ERR_INPUT, "nothing is known about \"%s\"", words);
}

kg_status kg_script_expect(const kg_app *app, const char *w, kg_error *error) {
    const kg_editor *e = &app->editor;
    char title[512];
    if (kg_expect_begins(&w, "net"))
        return kg_script_expect_net(&app->net_view, &app->editor, w, error);
    if (kg_expect_begins(&w, "issues"))
        return expect_issues(e, w, false, error);
    if (kg_expect_begins(&w, "issue"))
        return expect_issue(e, w, error);
    if (kg_expect_begins(&w, "faults"))
        return expect_issues(e, w, true, error);
    if (kg_expect_begins(&w, "undo steps"))
        return kg_expect_count("undo steps", e->history.undo.count, w, error);
    if (kg_expect_begins(&w, "redo steps"))
        return kg_expect_count("redo steps", e->history.redo.count, w, error);
    if (kg_expect_begins(&w, "modified"))
        return kg_expect_yes(kg_editor_is_modified(e), true, "modified", error);
    if (kg_expect_begins(&w, "unmodified"))
        return kg_expect_yes(kg_editor_is_modified(e), false, "modified", error);
    if (kg_expect_begins(&w, "tool"))
        return kg_expect_text("tool", e->tool->id, w, error);
    if (kg_expect_begins(&w, "message"))
        return expect_message(e, w, error);
    if (kg_expect_begins(&w, "shown"))
        return expect_shown(w, error);
    if (kg_expect_begins(&w, "hidden")) {
        kg_area area;
        return kg_expect_yes(kg_ui_find(w, &area), false, "shown", error);
    }
    if (kg_expect_begins(&w, "reference"))
        return kg_expect_yes(e->backdrop.mesh != NULL, true, "loaded", error);
    if (kg_expect_begins(&w, "quit"))
        return kg_expect_yes(app->quit, true, "over", error);
    if (kg_expect_begins(&w, "title")) {
        kg_app_title(app, title, sizeof title);
        return kg_expect_text("title", title, w, error);
    }
    if (kg_expect_begins(&w, "file")) {
        char path[KG_PATH_SIZE] = "", state[16] = "";
        sscanf(w, "%4095s %15s", path, state);
        bool wanted = strcmp(state, "missing") != 0;
        return kg_expect_yes(access(path, R_OK) == 0, wanted, "there", error);
    }
    return e->mode->expect(e, w, error);
}
