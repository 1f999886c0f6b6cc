/* katagami info: what is in a model, measured. */
#include "base/json.h"
#include "cli/card.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "cli/paper.h"
#include "katagami/document.h"

#include <stdio.h>
#include <stdlib.h>

static const kg_option options[] = {
    {"json", 0, false, NULL, "machine-readable: the net's report and more for each patch"},
};

static const double DEGREE = 0.017453292519943295;

/* Distance from the extent in force to the edge of regression; infinite without one. */
static double margin_of(const kg_patch *p) {
    return fmin(p->extent[0] - p->regression[0], p->regression[1] - p->extent[1]);
}

static json_t *patch_json(const kg_solved_patch *p, const char *name) {
    const kg_patch *k = &p->patch;
    double margin = margin_of(k);
    return json_pack("{s:I, s:s, s:b, s:f, s:[f,f], s:[f,f], s:o, s:I}", "id", (json_int_t)p->id,
                     "name", name, "construction", p->construction, "geodesic_mm",
                     k->length_at[KG_PATCH_CELLS], "theta_deg", k->theta[0] / DEGREE,
                     k->theta[1] / DEGREE, "extent", k->extent[0], k->extent[1],
                     "regression_margin_mm", isfinite(margin) ? json_real(margin) : json_null(),
                     "pieces", (json_int_t)p->regions.count);
}

static kg_status print_json(kg_document *d, kg_error *error) {
    kg_document_net net;
    char *report = NULL;
    kg_status status = kg_document_unroll(d, 0, &net, error);
    if (status)
        return status;
    status = kg_net_report(net.net, NULL, net.remarks, net.remark_count, 0, &report, error);
    json_t *root = status ? NULL : json_loads(report, 0, NULL), *patches = json_array();
    json_object_set_new(root, "title", json_string(kg_document_title(d)));
    if (kg_document_oa(d)) {
        json_t *card = status ? NULL : kg_card_json(d, error);
        json_object_set_new(root, "card", card);
        status = card || status ? status : error->status;
    }
    if (kg_document_origami(d))
        json_object_set_new(root, "origami", kg_paper_json(d));
    const kg_solution *s = kg_document_solution(d);
    for (size_t i = 0; s && i < kg_solution_count(s); i++)
        json_array_append_new(
            patches, patch_json(kg_solution_patch(s, i), kg_document_model(d)->patches[i].name));
    json_object_set_new(root, "patches", patches);
    char *text = root && !status ? kg_json_text(root) : NULL;
    if (text)
        fputs(text, stdout);
    else if (!status)
        status = kg_fail(error, KG_ERR_MEMORY, "out of memory");
    json_decref(root);
    free(text);
    free(report);
    kg_document_net_clear(&net);
    return status;
}

static kg_status print_text(kg_document *d, kg_error *error) {
    kg_document_net net;
    kg_status status = kg_document_unroll(d, 0, &net, error);
    if (status)
        return status;
    if (kg_document_oa(d)) {
        status = kg_card_print(d, &net, error);
        kg_document_net_clear(&net);
        return status;
    }
    if (kg_document_origami(d)) {
        kg_paper_print(d);
        kg_document_net_clear(&net);
        return KG_OK;
    }
    const kg_solution *s = kg_document_solution(d);
    printf("%s: %zu patches, %zu parts, %zu joins, %zu warnings\n", kg_document_title(d),
           kg_solution_count(s), net.net->part_count, net.net->join_count, net.remark_count);
    for (size_t i = 0; i < kg_solution_count(s); i++) {
        const kg_solved_patch *p = kg_solution_patch(s, i);
        const kg_patch *k = &p->patch;
        printf("patch %lld %s%s: geodesic %.2f mm, rulings at %.1f to %.1f degrees, extent %.4g to "
               "%.4g mm",
               (long long)p->id, kg_document_model(d)->patches[i].name,
               p->construction ? " (construction)" : "", k->length_at[KG_PATCH_CELLS],
               k->theta[0] / DEGREE, k->theta[1] / DEGREE, k->extent[0], k->extent[1]);
        if (isfinite(margin_of(k)))
            printf(", %.4g mm from folding back", margin_of(k));
        putchar('\n');
    }
    for (size_t i = 0; i < net.net->part_count; i++) {
        const kg_net_part *p = &net.net->parts[i];
        printf("part %d of patch %lld: area %.2f mm2, perimeter %.2f mm, isometry error %.1e\n",
               p->number, (long long)p->source, p->area, p->perimeter, p->isometry_error);
    }
    for (size_t i = 0; i < net.net->join_count; i++) {
        const kg_net_join *j = &net.net->joins[i];
        printf("%s %d: patches %lld and %lld, %.3f and %.3f mm\n",
               j->kind == KG_JOIN_SEAM ? "seam" : "contact", j->number, (long long)j->sources[0],
               (long long)j->sources[1], j->sides[0].length, j->sides[1].length);
    }
    for (size_t i = 0; i < net.remark_count; i++)
        printf("warning: patch %lld: %s\n", (long long)net.remarks[i].source,
               net.remarks[i].message);
    kg_document_net_clear(&net);
    return KG_OK;
}

int kg_command_info(int argc, char **argv) {
    kg_arguments a;
    int code = kg_arguments_parse(argc, argv, "katagami info MODEL [--json]", options,
                                  sizeof options / sizeof *options, &a);
    if (code >= 0)
        return code;
    if (a.count != 1)
        return kg_command_misuse("info", "one model is wanted");
    kg_error error;
    kg_document *document = NULL;
    kg_status status = kg_document_read(a.words[0], &document, &error);
    if (!status)
        status = kg_document_solve(document, KG_NET_CHORD, &error);
    if (!status)
        kg_paper_warn(document, "info");
    if (!status)
        status = kg_arguments_get(&a, "json") ? print_json(document, &error)
                                              : print_text(document, &error);
    kg_document_destroy(document);
    return status ? kg_command_fail("info", &error) : KG_EXIT_DONE;
}
