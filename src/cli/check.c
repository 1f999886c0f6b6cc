/* katagami check: everything that would not work on paper. */
#include "base/json.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "katagami/document.h"

#include <stdio.h>
#include <stdlib.h>

static const kg_option options[] = {
    {"json", 0, false, NULL, "machine-readable"},
};

static int print_json(const kg_document *d) {
    json_t *list[2] = {json_array(), json_array()}; /* warnings, errors */
    for (size_t i = 0; i < kg_document_issue_count(d); i++) {
        const kg_issue *issue = kg_document_issue(d, i);
        json_array_append_new(list[issue->severity == KG_FAULT],
                              json_pack("{s:I, s:s, s:s}", "patch", (json_int_t)issue->patch,
                                        "code", issue->code, "message", issue->message));
    }
    json_t *root = json_pack("{s:o, s:o}", "errors", list[1], "warnings", list[0]);
    char *text = root ? kg_json_text(root) : NULL;
    json_decref(root);
    if (!text)
        return kg_command_fail("check", &(kg_error){KG_ERR_MEMORY, "out of memory"});
    fputs(text, stdout);
    free(text);
    return KG_EXIT_DONE;
}

static void print_text(const kg_document *d, const char *name) {
    for (size_t i = 0; i < kg_document_issue_count(d); i++) {
        const kg_issue *issue = kg_document_issue(d, i);
        printf("%s: %s: patch %lld %s [%s]\n", name,
               issue->severity == KG_FAULT ? "error" : "warning", (long long)issue->patch,
               issue->message, issue->code);
    }
    if (kg_document_issue_count(d) == 0)
        printf("%s: nothing to complain of\n", name);
}

int kg_command_check(int argc, char **argv) {
    kg_arguments a;
    int code = kg_arguments_parse(argc, argv, "katagami check MODEL [--json]", options,
                                  sizeof options / sizeof *options, &a);
    if (code >= 0)
        return code;
    if (a.count != 1)
        return kg_command_misuse("check", "one model is wanted");
    kg_error error;
    kg_document *document = NULL;
    kg_status status = kg_document_read(a.words[0], &document, &error);
    if (!status)
        status = kg_document_solve(document, KG_NET_CHORD, &error);
    if (status) {
        kg_document_destroy(document);
        return kg_command_fail("check", &error);
    }
    code = KG_EXIT_DONE;
    if (kg_arguments_get(&a, "json"))
        code = print_json(document);
    else
        print_text(document, a.words[0]);
    if (kg_document_check(document, NULL))
        code = KG_EXIT_FAILED;
    kg_document_destroy(document);
    return code;
}
