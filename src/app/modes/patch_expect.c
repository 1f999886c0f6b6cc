/* Assertions of scripts about patch models. */
#include "app/modes/patch_expect.h"
#include "app/expect.h"
#include "app/tools/seam.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* PATCH INDEX X Y Z [TOLERANCE] */
static kg_status expect_point(const kg_editor *e, const char *words, kg_error *error) {
    long long id;
    size_t index;
    kg_vec3 p;
    double slack = KG_EXPECT_SLACK;
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
    double lo, hi, slack = KG_EXPECT_SLACK;
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
    return kg_expect_yes(is, wanted, flag, error);
}

/* The two patches whose seam is lit, in any order; 0 0: none is. */
static kg_status expect_seam(const kg_editor *e, const char *words, kg_error *error) {
    long long a, b;
    if (sscanf(words, "%lld %lld", &a, &b) != 2)
        return kg_fail(error, KG_ERR_INPUT, "expect seam PATCH PATCH");
    const int64_t *seam = e->hover_seam;
    bool lit = kg_seam_is_hovered(e, seam[0], seam[1]);
    if (lit ? kg_seam_is_hovered(e, a, b) : a == 0 && b == 0)
        return KG_OK;
    return kg_fail(error, KG_ERR_INPUT, "seam: %lld %lld", lit ? (long long)seam[0] : 0,
                   lit ? (long long)seam[1] : 0);
}

kg_status kg_patch_expect(const kg_editor *e, const char *w, kg_error *error) {
    if (kg_expect_begins(&w, "patches"))
        return kg_expect_count("patches", kg_editor_model(e)->patch_count, w, error);
    if (kg_expect_begins(&w, "point"))
        return expect_point(e, w, error);
    if (kg_expect_begins(&w, "extent"))
        return expect_extent(e, w, error);
    if (kg_expect_begins(&w, "selected points"))
        return kg_expect_count("selected points", e->selection.points.count, w, error);
    if (kg_expect_begins(&w, "selected"))
        return expect_selected(e, w, error);
    if (kg_expect_begins(&w, "pieces"))
        return expect_of_patch(e, w, false, error);
    if (kg_expect_begins(&w, "trims"))
        return expect_of_patch(e, w, true, error);
    if (kg_expect_begins(&w, "area"))
        return expect_area(e, w, error);
    if (kg_expect_begins(&w, "name"))
        return expect_name(e, w, error);
    if (kg_expect_begins(&w, "patch"))
        return expect_flag(e, w, error);
    if (kg_expect_begins(&w, "hovered"))
        return kg_expect_count("hovered patch", (size_t)e->hover_patch, w, error);
    if (kg_expect_begins(&w, "seam"))
        return expect_seam(e, w, error);
    return kg_expect_unknown(w, error);
}
