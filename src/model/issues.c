#include "model/issues.h"

#include "base/array.h"
#include "base/phrase.h"

#include <stdarg.h>
#include <stdlib.h>

kg_status kg_issues_add(kg_issues *issues, kg_severity severity, int64_t patch, const char *code,
                        const char *format, ...) {
    kg_issue issue = {.severity = severity, .patch = patch, .code = code};
    va_list args;
    va_start(args, format);
    kg_phrase_vprint(issue.message, sizeof issue.message, format, args);
    va_end(args);
    return kg_push(issues, issue) ? KG_OK : KG_ERR_MEMORY;
}

kg_status kg_issues_of_patch(kg_issues *issues, const kg_solved_patch *p) {
    const kg_patch *k = &p->patch;
    kg_status status = KG_OK;
    if (k->clamped) {
        int side = k->extent[0] != k->wished_extent[0] ? 0 : 1;
        status = kg_issues_add(
            issues, KG_WARNING, p->id, "extent-clamped",
            "its extent %g is cut back to %.4g: beyond %.4g, at v = %.3g, the paper "
            "would fold back on itself; narrow the extent, or straighten the "
            "geodesic there",
            k->wished_extent[side], k->extent[side], k->regression[side], k->regression_v[side]);
    }
    double flattest = fmin(k->theta[0], KG_PI - k->theta[1]);
    if (!status && flattest < KG_FLAT_RULING)
        status =
            kg_issues_add(issues, KG_WARNING, p->id, "flat-ruling",
                          "at v = %.3g its rulings run at %.2g degrees to the geodesic; bend the "
                          "geodesic more evenly",
                          k->flattest_v, flattest * 180 / KG_PI);
    return status;
}

kg_status kg_issues_of_notes(kg_issues *issues, const kg_solved_patch *p) {
    kg_status status = KG_OK;
    for (size_t i = 0; i < p->notes.count && !status; i++) {
        const kg_trim_note *n = &p->notes.items[i];
        long long by = n->source;
        switch (n->kind) {
        case KG_NOTE_PROLONGED:
            status =
                kg_issues_add(issues, KG_WARNING, p->id, "cut-prolonged",
                              "the cut by patch %lld ends inside it at (%.4g, %.4g, %.4g) and is "
                              "prolonged by %.3g mm; widen the extent of one of them",
                              by, n->place.x, n->place.y, n->place.z, n->length);
            break;
        case KG_NOTE_JOINED:
            status =
                kg_issues_add(issues, KG_WARNING, p->id, "cuts-joined",
                              "the cut by patch %lld ends at (%.4g, %.4g, %.4g) without meeting "
                              "another and is joined to the nearest over %.3g mm; let the cutters "
                              "cross",
                              by, n->place.x, n->place.y, n->place.z, n->length);
            break;
        case KG_NOTE_OUTSIDE:
            status =
                kg_issues_add(issues, KG_WARNING, p->id, "cut-outside",
                              "the cut by patch %lld lies wholly outside what is left of it and "
                              "changes nothing; remove that trim or put it first",
                              by);
            break;
        }
    }
    return status;
}

/* ---- order ------------------------------------------------------------------------------ */

typedef struct issue_key {
    kg_severity severity;
    size_t place, number;
} issue_key;

static int compare(const void *a, const void *b) {
    const issue_key *x = a, *y = b;
    if (x->severity != y->severity)
        return x->severity == KG_FAULT ? -1 : 1;
    if (x->place != y->place)
        return x->place < y->place ? -1 : 1;
    return x->number < y->number ? -1 : x->number > y->number;
}

kg_status kg_issues_sort(kg_issues *issues, const kg_lookup *places) {
    size_t n = issues->count;
    issue_key *keys = calloc(n + 1, sizeof *keys);
    kg_issue *sorted = calloc(n + 1, sizeof *sorted);
    if (!keys || !sorted) {
        free(keys);
        free(sorted);
        return KG_ERR_MEMORY;
    }
    for (size_t i = 0; i < n; i++)
        keys[i] = (issue_key){issues->items[i].severity,
                              kg_lookup_find(places, issues->items[i].patch)->index, i};
    qsort(keys, n, sizeof *keys, compare);
    for (size_t i = 0; i < n; i++)
        sorted[i] = issues->items[keys[i].number];
    free(keys);
    free(issues->items);
    *issues = (kg_issues){sorted, n, n + 1};
    return KG_OK;
}
