/* katagami net: from a model to pages that can be cut. */
#include "base/file.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "katagami/guide.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const kg_option options[] = {
    {"output", 'o', true, "FILE", "net to write: .svg, .pdf or .dxf; required"},
    {"paper", 0, true, "SIZE", "A4, A3, A2, letter, legal, WxH in mm, or none"},
    {"landscape", 0, false, NULL, "turn the paper on its side"},
    {"margin", 0, true, "MM", "kept free at every side of the page"},
    {"gap", 0, true, "MM", "least distance between parts"},
    {"scale", 0, true, "F", "written size over the model's"},
    {"tabs", 0, true, "none|auto", "glue tabs (auto)"},
    {"tab-width", 0, true, "MM", "how far tabs reach"},
    {"labels", 0, true, "WHERE", "none, inside or outside (inside)"},
    {"preset", 0, true, "NAME", "print, laser, silhouette or cricut (print)"},
    {"perforate", 0, true, "DASH,GAP", "folds as dashes with real gaps, mm"},
    {"separate", 0, false, NULL, "print and cut lines in files of their own"},
    {"mirrored", 0, false, NULL, "for printing on the back of the paper"},
    {"tolerance", 0, true, "MM", "greatest distance of a line from the true one (0.01)"},
    {"guide", 0, true, "GUIDE.pdf", "also write an assembly guide"},
    {"json", 0, true, "FILE", "also write a report"},
};
enum { OPTION_COUNT = sizeof options / sizeof *options };

static int parse_labels(const char *text, kg_net_labels *out) {
    static const char *const names[] = {"none", "inside", "outside"};
    for (int i = 0; i < 3; i++)
        if (strcmp(text, names[i]) == 0) {
            *out = (kg_net_labels)i;
            return -1;
        }
    return kg_command_misuse("net", "--labels is none, inside or outside, not %s", text);
}

/* Fills the options from the document and the command line; -1 to go on, else an exit code. */
static int read_options(const kg_arguments *a, const kg_document *document, kg_net_options *out,
                        double *tab_width) {
    kg_error error;
    const char *text;
    if (kg_document_net_options(document, out, tab_width, &error))
        return kg_command_fail("net", &error);
    if ((text = kg_arguments_get(a, "preset"))) {
        kg_net_preset preset;
        if (kg_net_preset_parse(text, &preset, &error))
            return kg_command_misuse("net", "%s", error.message);
        kg_net_options_preset(out, preset);
    }
    if ((text = kg_arguments_get(a, "paper")) && kg_net_paper_parse(text, &out->paper, &error))
        return kg_command_misuse("net", "%s", error.message);
    if ((text = kg_arguments_get(a, "labels"))) {
        int code = parse_labels(text, &out->labels);
        if (code >= 0)
            return code;
    }
    if ((text = kg_arguments_get(a, "tabs"))) {
        if (strcmp(text, "none") == 0)
            *tab_width = 0;
        else if (strcmp(text, "auto") != 0)
            return kg_command_misuse("net", "--tabs is none or auto, not %s", text);
    }
    if ((text = kg_arguments_get(a, "perforate"))) {
        char *rest;
        out->perforate[0] = strtod(text, &rest);
        out->perforate[1] = *rest == ',' ? strtod(rest + 1, &rest) : 0;
        if (*rest || !(out->perforate[0] > 0 && out->perforate[1] > 0 && out->perforate[0] < 1e3 &&
                       out->perforate[1] < 1e3))
            return kg_command_misuse("net", "--perforate is two lengths in mm, such as 2,0.5");
    }
    out->landscape = kg_arguments_get(a, "landscape") != NULL;
    out->separate = kg_arguments_get(a, "separate") != NULL;
    out->mirrored = kg_arguments_get(a, "mirrored") != NULL;
    double wished = *tab_width > 0 ? *tab_width : 5;
    if (!kg_arguments_number(a, "margin", 0, 1e4, &out->margin) ||
        !kg_arguments_number(a, "gap", 0, 1e3, &out->gap) ||
        !kg_arguments_number(a, "scale", 1e-6, 1e6, &out->scale) ||
        !kg_arguments_number(a, "tab-width", 0.1, 1e3, &wished) ||
        !kg_arguments_number(a, "tolerance", 1e-4, 10, &out->tolerance))
        return KG_EXIT_USAGE;
    if (*tab_width > 0)
        *tab_width = wished;
    return -1;
}

/* The files to be written; those beside the net may be NULL. */
typedef struct outputs {
    const char *net, *guide, *report;
} outputs;

/* Writes the pages and, where there is to be one, the guide: both or none. */
static kg_status write_pages(const kg_document *document, const kg_document_net *net,
                             const kg_net_options *settings, const outputs *out,
                             kg_net_layout **out_layout, kg_error *error) {
    char *temporary = NULL;
    kg_status status = kg_net_layout_create(net->net, settings, NULL, out_layout, error);
    if (!status && out->guide)
        status = kg_file_temporary(out->guide, &temporary, error);
    if (!status && out->guide)
        status = kg_guide_write(document, net, *out_layout, settings, temporary, NULL, error);
    if (!status)
        status = kg_net_draw(net->net, *out_layout, settings, out->net, error);
    if (!status && out->guide)
        status = kg_file_commit(temporary, out->guide, error);
    else
        kg_file_discard(temporary);
    free(temporary);
    return status;
}

static kg_status write_net(kg_document *document, const kg_net_options *settings, double tab_width,
                           const outputs *out, kg_error *error) {
    kg_document_net net = {0};
    kg_net_layout *layout = NULL;
    char *json = NULL;
    /* chords a tenth of the tolerance at the written size, tabs of the wished width there */
    double chord = fmin(KG_NET_CHORD, 0.1 * settings->tolerance / settings->scale);
    kg_status status = kg_document_solve(document, chord, error);
    if (!status)
        status = kg_document_unroll(document, tab_width / settings->scale, &net, error);
    if (!status)
        status = write_pages(document, &net, settings, out, &layout, error);
    if (!status && out->report)
        status = kg_net_report(net.net, layout, net.remarks, net.remark_count, 0, &json, error);
    if (!status && out->report)
        status = kg_file_write(out->report, json, strlen(json), error);
    for (size_t i = 0; i < net.remark_count && !status; i++)
        fprintf(stderr, "katagami net: warning: patch %lld: %s\n", (long long)net.remarks[i].source,
                net.remarks[i].message);
    free(json);
    kg_net_layout_destroy(layout);
    kg_document_net_clear(&net);
    return status;
}

int kg_command_net(int argc, char **argv) {
    kg_arguments a;
    int code = kg_arguments_parse(argc, argv, "katagami net MODEL -o NET.svg|.pdf|.dxf [OPTION…]",
                                  options, OPTION_COUNT, &a);
    if (code >= 0)
        return code;
    const outputs out = {kg_arguments_get(&a, "output"), kg_arguments_get(&a, "guide"),
                         kg_arguments_get(&a, "json")};
    if (a.count != 1 || !out.net)
        return kg_command_misuse("net", "a model and an output (-o) are wanted");
    if (out.guide && strcmp(out.guide, "-") == 0)
        return kg_command_misuse("net", "--guide is the name of a file");
    kg_error error;
    kg_document *document;
    kg_net_options settings;
    double tab_width;
    if (kg_document_read(a.words[0], &document, &error))
        return kg_command_fail("net", &error);
    code = read_options(&a, document, &settings, &tab_width);
    if (code < 0 && write_net(document, &settings, tab_width, &out, &error))
        code = kg_command_fail("net", &error);
    kg_document_destroy(document);
    return code < 0 ? KG_EXIT_DONE : code;
}
