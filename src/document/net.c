/* Nets of documents: unrolled, with tabs and all remarks. */
#include "document/document.h"

#include "base/phrase.h"
#include "document/pin.h"
#include "katagami/unroll.h"
#include "net/merge.h"
#include "net/tab.h"

#include <jansson.h>

#include <stdlib.h>
#include <string.h>

kg_net_settings *kg_document_net_settings(kg_document *d) {
    return d->model  ? &d->model->net
           : d->card ? &d->card->oa->net
                     : kg_origami_net_settings(d->folded->origami);
}

/* Sheets bring their own size: paper that holds each of them flat. Larger ones stay on A4, where
 * they are refused with what would help. */
static void hold_sheets(const kg_origami *o, kg_net_options *options) {
    const kg_origami_state *s = kg_origami_state_at(o, 0);
    kg_vec2 most = {0, 0};
    bool across;
    for (int32_t sheet = 0, any = 1; any; sheet++) {
        kg_box2 box = kg_box2_empty();
        any = 0;
        for (size_t i = 0; i < s->vertices.count; i++)
            if (s->vertices.items[i].sheet == sheet)
                kg_box2_add(&box, s->vertices.items[i].paper), any = 1;
        kg_vec2 span = any ? kg_scale2(kg_sub2(box.hi, box.lo), options->scale) : kg_v2(0, 0);
        most = kg_v2(fmax(most.x, fmin(span.x, span.y)), fmax(most.y, fmax(span.x, span.y)));
    }
    kg_net_paper_for(most, options->margin, &options->paper, &across);
}

kg_status kg_document_net_options(kg_document *d, kg_net_options *out_options,
                                  double *out_tab_width, kg_error *error) {
    const kg_net_settings *settings = kg_document_net_settings(d);
    kg_status status = kg_net_settings_options(settings, out_options, error);
    if (status)
        return status;
    if (!d->model && !json_object_get(settings->json, "labels"))
        out_options->labels = KG_LABELS_NONE;
    if (d->folded && !settings->paper && out_options->paper.x > 0)
        hold_sheets(d->folded->origami, out_options);
    *out_tab_width = d->model ? settings->tab_width : 0;
    return KG_OK;
}

kg_parts_options kg_document_parts_options(kg_document *d, const kg_net_options *options,
                                           double tab_width) {
    double rims = 2 * options->margin;
    kg_parts_options parts = {.tab_width = tab_width / options->scale};
    if (options->paper.x > 0)
        parts.room = kg_v2((options->paper.x - rims) / options->scale,
                           (options->paper.y - rims) / options->scale);
    parts.merge = json_is_true(json_object_get(kg_document_net_settings(d)->json, "merge"));
    return parts;
}

double kg_document_net_chord(const kg_net_options *options) {
    return fmin(KG_NET_CHORD, 0.2 * options->tolerance / options->scale);
}

kg_status kg_document_net_remark(kg_document_net *net, int64_t source, const char *code,
                                 const char *message, kg_error *error) {
    char *copy = strdup(message);
    kg_net_warning *more =
        copy ? realloc(net->remarks, (net->remark_count + 1) * sizeof *more) : NULL;
    if (!more) {
        free(copy);
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    }
    more[net->remark_count++] = (kg_net_warning){source, code, copy};
    net->remarks = more;
    return KG_OK;
}

static kg_status add_tabs(kg_document_net *net, const kg_unrolled *unrolled, double tab_width,
                          kg_error *error) {
    static const char *const codes[] = {"tab-lowered", "tab-missing", "tab-moved"};
    kg_tab_options options = kg_tab_options_default();
    options.width = tab_width;
    options.least = fmin(options.least, tab_width);
    options.bends = (const double *const *)unrolled->bends;
    kg_tab_report report = {0};
    kg_status status = kg_net_tabs(unrolled->net, &options, &net->net, &report, error);
    net->tab_count = report.tab_count;
    for (size_t i = 0; i < report.remark_count && !status; i++) {
        const kg_tab_remark *r = &report.remarks[i];
        char message[KG_ERROR_SIZE / 2];
        kg_tab_remark_print(unrolled->net, r, message, sizeof message);
        status = kg_document_net_remark(net, unrolled->net->joins[r->join].sources[r->side],
                                        codes[r->trouble], message, error);
    }
    kg_tab_report_clear(&report);
    return status;
}

/* ---- merging ---------------------------------------------------------------------------- */

/* Which joins the model wants to be folds. */
static bool *merge_wishes(const kg_model *model, const kg_unrolled *unrolled) {
    bool *wanted = calloc(unrolled->net->join_count + 1, sizeof *wanted);
    for (size_t i = 0; i < unrolled->net->join_count && wanted; i++)
        wanted[i] =
            unrolled->wishes[i] < model->join_count && model->joins[unrolled->wishes[i]].merge;
    return wanted;
}

static kg_status merge_parts(kg_document_net *net, const kg_model *model, kg_unrolled *unrolled,
                             const kg_parts_options *options, kg_error *error) {
    static const char *const reasons[] = {
        N_("it is no straight line on both parts"),
        N_("one part is seen from its front, the other from its back (flip one of them)"),
        N_("the parts would lie on each other"), N_("the whole would not fit the page"),
        N_("both of its sides belong to one part already")};
    bool *wanted = merge_wishes(model, unrolled);
    if (!wanted)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    kg_merge_options merging = {options->merge, wanted, options->room, unrolled->bends};
    kg_merge_report report = {0};
    kg_status status = kg_net_merge(unrolled->net, &merging, &report, error);
    for (size_t i = 0; i < report.remark_count && !status; i++) {
        const kg_merge_remark *r = &report.remarks[i];
        char message[KG_ERROR_SIZE / 2];
        kg_phrase_print(message, sizeof message, "seam %d with patch %lld cannot be a fold: %s",
                        r->number, (long long)r->sources[1], kg_phrase(reasons[r->refusal]));
        status = kg_document_net_remark(net, r->sources[0], "not-merged", message, error);
    }
    free(report.remarks);
    free(wanted);
    return status;
}

/* ---- wishes ----------------------------------------------------------------------------- */

/* Whether a wish for one join holds for any. */
static bool is_met(const kg_unrolled *unrolled, size_t wish) {
    for (size_t i = 0; i < unrolled->net->join_count; i++)
        if (unrolled->wishes[i] == wish)
            return true;
    return false;
}

/* Names wishes for single joins that are for none: patches that were drawn apart, or are gone. They
 * stay in the model. */
static kg_status name_idle_wishes(kg_document_net *net, const kg_model *model,
                                  const kg_unrolled *unrolled, kg_error *error) {
    for (size_t i = 0; i < model->join_count; i++) {
        const kg_model_join *j = &model->joins[i];
        char message[KG_ERROR_SIZE / 2];
        if (!j->has_at || is_met(unrolled, i))
            continue;
        kg_phrase_print(message, sizeof message,
                        "no join with patch %lld is left for the wish at %g mm, %g",
                        (long long)j->patches[1], j->at.x, j->at.y);
        kg_status status = kg_document_net_remark(net, j->patches[0], "join-wish", message, error);
        if (status)
            return status;
    }
    return KG_OK;
}

/* ---- the whole -------------------------------------------------------------------------- */

kg_status kg_document_unroll(const kg_document *document, double tab_width,
                             kg_document_net *out_net, kg_error *error) {
    kg_parts_options options = {.tab_width = tab_width};
    return kg_document_unroll_to_fit(document, &options, out_net, error);
}

kg_status kg_document_unroll_to_fit(const kg_document *d, const kg_parts_options *options,
                                    kg_document_net *out_net, kg_error *error) {
    if (d->card)
        return kg_card_net(d->card, out_net, error);
    if (d->folded)
        return kg_folded_net(d->folded, out_net, error);
    /* tabs stand out on every side */
    kg_vec2 tabs = kg_v2(2 * options->tab_width, 2 * options->tab_width), room = options->room;
    if (room.x > 0)
        room = kg_v2(fmax(room.x - tabs.x, tabs.x), fmax(room.y - tabs.y, tabs.y));
    kg_unrolled *unrolled;
    kg_status status = kg_document_check(d, error);
    if (!status)
        status = kg_unroll_to_fit(d->model, d->solution, room, &unrolled, error);
    if (status)
        return status;
    kg_document_net net = {.room = room};
    kg_parts_options inner = *options;
    inner.room = room;
    for (size_t i = 0; i < kg_document_issue_count(d) && !status; i++) {
        const kg_issue *issue = kg_document_issue(d, i);
        status = kg_document_net_remark(&net, issue->patch, issue->code, issue->message, error);
    }
    if (!status)
        status = name_idle_wishes(&net, d->model, unrolled, error);
    if (!status)
        status = merge_parts(&net, d->model, unrolled, &inner, error);
    if (!status && options->tab_width > 0) {
        status = add_tabs(&net, unrolled, options->tab_width, error);
    } else if (!status) {
        net.net = unrolled->net;
        unrolled->net = NULL;
    }
    kg_unrolled_destroy(unrolled);
    if (status) {
        kg_document_net_clear(&net);
        return status;
    }
    kg_pin_parts(d->model, net.net);
    *out_net = net;
    return KG_OK;
}

void kg_document_net_clear(kg_document_net *net) {
    kg_net_destroy(net->net);
    for (size_t i = 0; i < net->remark_count; i++)
        free((void *)(uintptr_t)net->remarks[i].message);
    free(net->remarks);
    *net = (kg_document_net){0};
}
