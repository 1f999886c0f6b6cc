/* Nets of documents: unrolled, with tabs and all remarks. */
#include "document/document.h"
#include "document/net_settings.h"
#include "document/pin.h"
#include "katagami/unroll.h"
#include "net/tab.h"

#include <stdlib.h>
#include <string.h>

kg_status kg_document_net_options(const kg_document *d, kg_net_options *out_options,
                                  double *out_tab_width, kg_error *error) {
    kg_status status = kg_net_settings_read(&d->model->net, out_options, error);
    if (!status)
        *out_tab_width = d->model->net.tab_width;
    return status;
}

static kg_status add_remark(kg_document_net *net, int64_t source, const char *code,
                            const char *message) {
    kg_net_warning *more = realloc(net->remarks, (net->remark_count + 1) * sizeof *more);
    if (!more)
        return KG_ERR_MEMORY;
    net->remarks = more;
    char *copy = strdup(message);
    if (!copy)
        return KG_ERR_MEMORY;
    more[net->remark_count++] = (kg_net_warning){source, code, copy};
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
        status = add_remark(net, unrolled->net->joins[r->join].sources[r->side], codes[r->trouble],
                            message);
    }
    kg_tab_report_clear(&report);
    return status;
}

kg_status kg_document_unroll(const kg_document *d, double tab_width, kg_document_net *out_net,
                             kg_error *error) {
    kg_unrolled *unrolled;
    kg_status status = kg_document_check(d, error);
    if (!status)
        status = kg_unroll(d->model, d->solution, &unrolled, error);
    if (status)
        return status;
    kg_document_net net = {0};
    for (size_t i = 0; i < kg_document_issue_count(d) && !status; i++) {
        const kg_issue *issue = kg_document_issue(d, i);
        status = add_remark(&net, issue->patch, issue->code, issue->message);
    }
    if (!status && tab_width > 0) {
        status = add_tabs(&net, unrolled, tab_width, error);
    } else {
        net.net = unrolled->net;
        unrolled->net = NULL;
    }
    kg_unrolled_destroy(unrolled);
    if (status) {
        kg_document_net_clear(&net);
        return status == KG_ERR_MEMORY ? kg_fail(error, status, "out of memory") : status;
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
