/* katagami check: everything that would not work on paper. */
#include "base/json.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "katagami/document.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const kg_option options[] = {
    {"json", 0, false, NULL, "machine-readable"},
    {"tiny", 0, true, "MM", "of a card: warn of folds and strips narrower than this (the card's)"},
};

/* What was found, of the model itself and of its net. */
typedef struct findings {
    const kg_document *document;
    kg_document_net net;      /* empty when the model has a fault */
    char page[KG_ERROR_SIZE]; /* why the net does not fit its paper, or "" */
} findings;

/* Of the net's remarks these alone say that something is missing on paper. */
static bool matters(const kg_net_warning *remark) {
    return strcmp(remark->code, "tab-missing") == 0;
}

/* Unrolls the model as `katagami net` would. */
static kg_status look_at_net(kg_document *d, findings *out, kg_error *error) {
    kg_net_options settings;
    kg_net_layout *layout = NULL;
    double tab_width;
    *out = (findings){.document = d};
    if (kg_document_check(d, NULL))
        return KG_OK;
    kg_status status = kg_document_net_options(d, &settings, &tab_width, error);
    if (!status)
        status = kg_document_unroll(d, tab_width / settings.scale, &out->net, error);
    if (!status && out->net.net->part_count > 0)
        status = kg_net_layout_create(out->net.net, &settings, NULL, &layout, error);
    kg_net_layout_destroy(layout);
    if (status != KG_ERR_INPUT)
        return status;
    memcpy(out->page, error->message, sizeof out->page);
    return KG_OK;
}

static void add_json(json_t *list, int64_t patch, const char *code, const char *message) {
    json_array_append_new(list, json_pack("{s:I, s:s, s:s}", "patch", (json_int_t)patch, "code",
                                          code, "message", message));
}

static kg_status print_json(const findings *f, kg_error *error) {
    json_t *errors = json_array(), *warnings = json_array();
    for (size_t i = 0; i < kg_document_issue_count(f->document); i++) {
        const kg_issue *issue = kg_document_issue(f->document, i);
        add_json(issue->severity == KG_FAULT ? errors : warnings, issue->patch, issue->code,
                 issue->message);
    }
    for (size_t i = 0; i < f->net.remark_count; i++)
        if (matters(&f->net.remarks[i]))
            add_json(warnings, f->net.remarks[i].source, f->net.remarks[i].code,
                     f->net.remarks[i].message);
    if (f->page[0])
        add_json(warnings, 0, "page", f->page);
    json_t *root = json_pack("{s:o, s:o}", "errors", errors, "warnings", warnings);
    char *text = root ? kg_json_text(root) : NULL;
    json_decref(root);
    if (!text)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    fputs(text, stdout);
    free(text);
    return KG_OK;
}

static void print_text(const findings *f, const char *name) {
    size_t issues = kg_document_issue_count(f->document), count = issues;
    for (size_t i = 0; i < issues; i++) {
        const kg_issue *issue = kg_document_issue(f->document, i);
        printf("%s: %s: ", name, issue->severity == KG_FAULT ? "error" : "warning");
        if (issue->patch > 0)
            printf("patch %lld: ", (long long)issue->patch);
        printf("%s [%s]\n", issue->message, issue->code);
    }
    for (size_t i = 0; i < f->net.remark_count; i++)
        if (matters(&f->net.remarks[i])) {
            printf("%s: warning: patch %lld: %s [%s]\n", name, (long long)f->net.remarks[i].source,
                   f->net.remarks[i].message, f->net.remarks[i].code);
            count++;
        }
    if (f->page[0])
        printf("%s: warning: %s [page]\n", name, f->page);
    else if (count == 0)
        printf("%s: nothing to complain of\n", name);
}

int kg_command_check(int argc, char **argv) {
    kg_arguments a;
    int code = kg_arguments_parse(argc, argv, "katagami check MODEL [--json] [--tiny MM]", options,
                                  sizeof options / sizeof *options, &a);
    if (code >= 0)
        return code;
    if (a.count != 1)
        return kg_command_misuse("check", "one model is wanted");
    kg_error error;
    kg_document *document = NULL;
    findings found = {0};
    double tiny = -1; /* as the card has it */
    if (!kg_arguments_number(&a, "tiny", 0, KG_OA_MAX_CELL, &tiny))
        return KG_EXIT_USAGE;
    kg_status status = kg_document_read(a.words[0], &document, &error);
    if (!status && tiny >= 0 && kg_document_oa(document))
        kg_document_oa(document)->tiny_mm = tiny;
    if (!status)
        status = kg_document_solve(document, KG_NET_CHORD, &error);
    if (!status)
        status = look_at_net(document, &found, &error);
    if (!status && kg_arguments_get(&a, "json"))
        status = print_json(&found, &error);
    else if (!status)
        print_text(&found, a.words[0]);
    code = status                              ? kg_command_fail("check", &error)
           : kg_document_check(document, NULL) ? KG_EXIT_FAILED
                                               : KG_EXIT_DONE;
    kg_document_net_clear(&found.net);
    kg_document_destroy(document);
    return code;
}
