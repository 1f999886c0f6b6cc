/* Assertions of scripts. */
#include "app/app.h"
#include "app/commands/commands.h"
#include "app/script.h"
#include "app/tools/tool.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* How far a number may be off when a script does not say, mm. */
#define SLACK 1e-6

static kg_status expect_count(const char *what, size_t is, const char *words, kg_error *error) {
    long wanted = strtol(words, NULL, 10);
    if ((long)is == wanted)
        return KG_OK;
    return kg_fail(error, KG_ERR_INPUT, "%s: %zu, not %ld", what, is, wanted);
}

static kg_status expect_yes(bool is, bool wanted, const char *what, kg_error *error) {
    if (is == wanted)
        return KG_OK;
    return kg_fail(error, KG_ERR_INPUT, "it is %s%s", wanted ? "not " : "", what);
}

/* PATCH INDEX X Y Z [TOLERANCE] */
static kg_status expect_point(const kg_editor *e, const char *words, kg_error *error) {
    long long id;
    size_t index;
    kg_vec3 p;
    double slack = SLACK;
    if (sscanf(words, "%lld %zu %lf %lf %lf %lf", &id, &index, &p.x, &p.y, &p.z, &slack) < 5)
        return kg_fail(error, KG_ERR_INPUT, "point needs PATCH INDEX X Y Z [TOLERANCE]");
    const kg_model_patch *patch = kg_model_find(kg_editor_model(e), id);
    if (!patch || index >= patch->input.point_count)
        return kg_fail(error, KG_ERR_INPUT, "patch %lld has no point %zu", id, index);
    kg_vec3 is = patch->input.points[index];
    if (fabs(is.x - p.x) <= slack && fabs(is.y - p.y) <= slack && fabs(is.z - p.z) <= slack)
        return KG_OK;
    return kg_fail(error, KG_ERR_INPUT, "point %zu of patch %lld is at %.9g %.9g %.9g", index, id,
                   is.x, is.y, is.z);
}

/* PATCH LO HI [TOLERANCE] */
static kg_status expect_extent(const kg_editor *e, const char *words, kg_error *error) {
    long long id;
    double lo, hi, slack = SLACK;
    if (sscanf(words, "%lld %lf %lf %lf", &id, &lo, &hi, &slack) < 3)
        return kg_fail(error, KG_ERR_INPUT, "extent needs PATCH LO HI [TOLERANCE]");
    const kg_model_patch *p = kg_model_find(kg_editor_model(e), id);
    if (p && fabs(p->input.extent[0] - lo) <= slack && fabs(p->input.extent[1] - hi) <= slack)
        return KG_OK;
    return kg_fail(error, KG_ERR_INPUT, "the extent of patch %lld is %.9g %.9g", id,
                   p ? p->input.extent[0] : 0, p ? p->input.extent[1] : 0);
}

static kg_status expect_selected(const kg_editor *e, const char *words, kg_error *error) {
    size_t count = 0;
    char *end;
    for (;; count++) {
        long long id = strtoll(words, &end, 10);
        if (end == words)
            break;
        words = end;
        if (count >= e->selection.patches.count || e->selection.patches.items[count] != id)
            return kg_fail(error, KG_ERR_INPUT, "patch %lld is not selected in place %zu", id,
                           count + 1);
    }
    if (count == e->selection.patches.count)
        return KG_OK;
    return kg_fail(error, KG_ERR_INPUT, "%zu patches are selected, not %zu",
                   e->selection.patches.count, count);
}

/* Pieces of a patch, or its trims. */
static kg_status expect_of_patch(const kg_editor *e, const char *words, bool trims,
                                 kg_error *error) {
    long long id, wanted;
    if (sscanf(words, "%lld %lld", &id, &wanted) != 2)
        return kg_fail(error, KG_ERR_INPUT, "PATCH and COUNT are wanted");
    const kg_model_patch *p = kg_model_find(kg_editor_model(e), id);
    const kg_solved_patch *s = kg_solution_find(kg_editor_solution(e), id);
    if (!p || !s)
        return kg_fail(error, KG_ERR_INPUT, "there is no patch %lld", id);
    size_t is = trims ? p->trim_count : s->regions.count;
    return (long long)is == wanted
               ? KG_OK
               : kg_fail(error, KG_ERR_INPUT, "patch %lld has %zu of them", id, is);
}

/* PATCH AREA TOLERANCE, mm² of all its pieces */
static kg_status expect_area(const kg_editor *e, const char *words, kg_error *error) {
    long long id;
    double wanted, slack, area = 0;
    if (sscanf(words, "%lld %lf %lf", &id, &wanted, &slack) != 3)
        return kg_fail(error, KG_ERR_INPUT, "area needs PATCH AREA TOLERANCE");
    const kg_solution *solution = kg_editor_solution(e);
    const kg_solved_patch *s = kg_solution_find(solution, id);
    for (size_t i = 0; s && i < s->regions.count; i++)
        area += kg_region_measure(&s->patch, &s->regions.items[i], kg_solution_finder(solution))
                    .paper_moment;
    return fabs(area - wanted) <= slack
               ? KG_OK
               : kg_fail(error, KG_ERR_INPUT, "patch %lld has %.6g mm²", id, area);
}

static kg_status expect_issues(const kg_editor *e, const char *words, kg_error *error) {
    const kg_solution *s = kg_editor_solution(e);
    kg_status status = expect_count("issues", kg_solution_issue_count(s), words, error);
    if (status && kg_solution_issue_count(s) > 0)
        kg_fail_in(error, status, "%s; ", kg_solution_issue(s, 0)->message);
    return status;
}

static kg_status expect_faults(const kg_editor *e, const char *words, kg_error *error) {
    const kg_solution *s = kg_editor_solution(e);
    size_t faults = 0;
    for (size_t i = 0; i < kg_solution_issue_count(s); i++)
        faults += kg_solution_issue(s, i)->severity == KG_FAULT;
    kg_status status = expect_count("faults", faults, words, error);
    if (status && faults > 0)
        kg_fail_in(error, status, "%s; ", kg_solution_issue(s, 0)->message);
    return status;
}

static kg_status expect_name(const kg_editor *e, const char *words, kg_error *error) {
    char *rest;
    long long id = strtoll(words, &rest, 10);
    const kg_model_patch *p = kg_model_find(kg_editor_model(e), id);
    if (p && strcmp(p->name, rest + strspn(rest, " ")) == 0)
        return KG_OK;
    return kg_fail(error, KG_ERR_INPUT, "patch %lld is called \"%s\"", id, p ? p->name : "");
}

/* PATCH hidden|flipped|construction, or "not" and these */
static kg_status expect_flag(const kg_editor *e, const char *words, kg_error *error) {
    long long id;
    char name[32] = "", second[32] = "";
    int n = sscanf(words, "%lld %31s %31s", &id, name, second);
    bool wanted = strcmp(name, "not") != 0;
    const char *flag = wanted ? name : second;
    const kg_model_patch *p = n >= 2 ? kg_model_find(kg_editor_model(e), id) : NULL;
    if (!p)
        return kg_fail(error, KG_ERR_INPUT, "there is no such patch");
    bool is = strcmp(flag, "hidden") == 0    ? p->hidden
              : strcmp(flag, "flipped") == 0 ? p->input.flip
                                             : p->construction;
    return expect_yes(is, wanted, flag, error);
}

static kg_status expect_text(const char *what, const char *is, const char *wanted,
                             kg_error *error) {
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

static bool begins(const char **words, const char *what) {
    size_t n = strlen(what);
    if (strncmp(*words, what, n) != 0 || ((*words)[n] && (*words)[n] != ' '))
        return false;
    *words += n;
    *words += strspn(*words, " ");
    return true;
}

kg_status kg_script_expect(const kg_app *app, const char *w, kg_error *error) {
    const kg_editor *e = &app->editor;
    char title[512];
    if (begins(&w, "net"))
        return kg_script_expect_net(&app->net_view, w, error);
    if (begins(&w, "hovered"))
        return expect_count("hovered patch", (size_t)e->hover_patch, w, error);
    if (begins(&w, "patches"))
        return expect_count("patches", kg_editor_model(e)->patch_count, w, error);
    if (begins(&w, "point"))
        return expect_point(e, w, error);
    if (begins(&w, "extent"))
        return expect_extent(e, w, error);
    if (begins(&w, "selected points"))
        return expect_count("selected points", e->selection.points.count, w, error);
    if (begins(&w, "selected"))
        return expect_selected(e, w, error);
    if (begins(&w, "issues"))
        return expect_issues(e, w, error);
    if (begins(&w, "faults"))
        return expect_faults(e, w, error);
    if (begins(&w, "pieces"))
        return expect_of_patch(e, w, false, error);
    if (begins(&w, "trims"))
        return expect_of_patch(e, w, true, error);
    if (begins(&w, "area"))
        return expect_area(e, w, error);
    if (begins(&w, "name"))
        return expect_name(e, w, error);
    if (begins(&w, "patch"))
        return expect_flag(e, w, error);
    if (begins(&w, "undo steps"))
        return expect_count("undo steps", e->history.undo.count, w, error);
    if (begins(&w, "redo steps"))
        return expect_count("redo steps", e->history.redo.count, w, error);
    if (begins(&w, "modified"))
        return expect_yes(kg_editor_is_modified(e), true, "modified", error);
    if (begins(&w, "unmodified"))
        return expect_yes(kg_editor_is_modified(e), false, "modified", error);
    if (begins(&w, "tool"))
        return expect_text("tool", e->tool->id, w, error);
    if (begins(&w, "message"))
        return expect_message(e, w, error);
    if (begins(&w, "shown"))
        return expect_shown(w, error);
    if (begins(&w, "reference"))
        return expect_yes(e->backdrop.mesh != NULL, true, "loaded", error);
    if (begins(&w, "quit"))
        return expect_yes(app->quit, true, "over", error);
    if (begins(&w, "title")) {
        kg_app_title(app, title, sizeof title);
        return expect_text("title", title, w, error);
    }
    if (begins(&w, "file")) {
        char path[KG_PATH_SIZE] = "", state[16] = "";
        sscanf(w, "%4095s %15s", path, state);
        bool wanted = strcmp(state, "missing") != 0;
        return expect_yes(access(path, R_OK) == 0, wanted, "there", error);
    }
    return kg_fail(error, KG_ERR_INPUT, "nothing is known about \"%s\"", w);
}
