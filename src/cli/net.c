/* katagami net: from a model to pages that can be cut. */
#include "app/language.h"
#include "base/file.h"
#include "base/signals.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "cli/paper.h"
#include "document/document.h"
#include "katagami/guide.h"
#include "net/clash.h"
#include "net/settings.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const kg_option options[] = {
    {"output", 'o', true, "FILE", "net to write: .svg, .pdf or .dxf; required"},
    {"paper", 0, true, "SIZE", "A4, A3, A2, letter, legal, WxH in mm, or none"},
    {"landscape", 0, false, NULL, "turn the paper on its side"},
    {"margin", 0, true, "MM", "kept free at every side of the page"},
    {"rows", 0, false, NULL, "parts in rows instead of nested by their outlines (faster)"},
    {"grain", 0, false, NULL, "turn no part by anything but half a turn: paper has a grain"},
    {"merge", 0, false, NULL, "one part of all neighbours that can be folded from one sheet"},
    {"no-split", 0, false, NULL,
     "refuse parts larger than the page instead of cutting them in two"},
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
    {"guide", 0, true, "GUIDE.pdf", "also write how it is glued or folded, step by step"},
    {"language", 0, true, "ja|en", "language of the guide (that of the environment, else English)"},
    {"json", 0, true, "FILE", "also write a report"},
};
enum { OPTION_COUNT = sizeof options / sizeof *options };

static int parse_labels(const char *text, kg_net_labels *out) {
    for (int i = 0; kg_net_label_names[i]; i++)
        if (strcmp(text, kg_net_label_names[i]) == 0) {
            *out = (kg_net_labels)i;
            return -1;
        }
    return kg_command_misuse("net", "--labels is none, inside or outside, not %s", text);
}

/* Fills the options from the document and the command line; -1 to go on, else an exit code. */
static int read_options(const kg_arguments *a, kg_document *document, kg_net_options *out,
                        double *tab_width) {
    kg_error error;
    const char *text;
    kg_status status = kg_document_net_options(document, out, tab_width, &error);
    if (status) {
        kg_fail_in(&error, status, "%s: ", a->words[0]);
        return kg_command_fail("net", &error);
    }
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
    out->landscape = out->landscape || kg_arguments_get(a, "landscape");
    out->nest = out->paper.x > 0 && !kg_arguments_get(a, "rows");
    out->grain = out->grain || kg_arguments_get(a, "grain");
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

static kg_parts_options parts_options(const kg_arguments *a, kg_document *document,
                                      const kg_net_options *settings, double tab_width) {
    kg_parts_options parts = kg_document_parts_options(document, settings, tab_width);
    if (kg_arguments_get(a, "no-split"))
        parts.room = kg_v2(0, 0);
    parts.merge = parts.merge || kg_arguments_get(a, "merge");
    return parts;
}

/* The files to be written; those beside the net may be NULL. */
typedef struct outputs {
    const char *net, *guide, *language, *report;
} outputs;

/* A file beside the net. */
typedef struct companion {
    const char *path; /* NULL: none is wanted */
    char *data;
    size_t size;
    char *temporary;
} companion;

/* Writes it to a temporary file; standard output is left for later. */
static kg_status prepare(companion *c, kg_error *error) {
    if (!c->path || strcmp(c->path, "-") == 0)
        return KG_OK;
    kg_status status = kg_file_temporary(c->path, &c->temporary, error);
    return status ? status : kg_file_write(c->temporary, c->data, c->size, error);
}

/* Puts it in its place, or (`status`) takes it away. */
static kg_status settle(companion *c, kg_status status, kg_error *error) {
    if (c->temporary && status)
        kg_file_discard(c->temporary);
    else if (c->temporary)
        status = kg_file_commit(c->temporary, c->path, error);
    else if (c->path && !status)
        status = kg_file_write(c->path, c->data, c->size, error);
    free(c->temporary);
    free(c->data);
    return status;
}

/* Adds a remark about part `i`, which is pinned where it cannot be cut out. */
static kg_status add_clash(kg_document_net *net, size_t i, unsigned clash, kg_error *error) {
    const kg_net_part *part = &net->net->parts[i];
    bool overlap = clash & KG_CLASH_OVERLAP;
    char message[KG_ERROR_SIZE];
    snprintf(message, sizeof message, "part %d%s%s is pinned %s; move it, or unpin it",
             part->number, part->name[0] ? " " : "", part->name,
             overlap ? "on another part" : "where it leaves the page's margins");
    return kg_document_net_remark(net, part->source, overlap ? "part-overlap" : "part-off-page",
                                  message, error);
}

/* Only the user's own pins put parts where they clash. */
static kg_status check_pins(kg_document_net *net, const kg_net_layout *layout,
                            const kg_net_options *settings, kg_error *error) {
    size_t count = net->net->part_count, pins = 0;
    for (size_t i = 0; i < count; i++)
        pins += net->net->parts[i].pinned;
    if (pins == 0 || settings->paper.x <= 0)
        return KG_OK;
    unsigned *clashes = calloc(count, sizeof *clashes);
    kg_status status = clashes ? kg_net_clashes(net->net, layout, settings, clashes, error)
                               : kg_fail(error, KG_ERR_MEMORY, "out of memory");
    for (size_t i = 0; i < count && !status; i++)
        for (unsigned c = KG_CLASH_PAGE; c <= KG_CLASH_OVERLAP && !status; c <<= 1)
            if (net->net->parts[i].pinned && (clashes[i] & c))
                status = add_clash(net, i, c, error);
    free(clashes);
    return status;
}

static kg_status make_report(const kg_document_net *net, const kg_net_layout *layout,
                             const kg_net_options *settings, companion *report, kg_error *error) {
    int overlaps = 0;
    kg_status status = kg_net_tab_overlaps(net->net, layout, settings, &overlaps, error);
    if (!status)
        status = kg_net_report(net->net, layout, net->remarks, net->remark_count, overlaps,
                               &report->data, error);
    if (!status)
        report->size = strlen(report->data);
    return status;
}

/* Writes the pages and what is to be beside them: all or nothing. */
static kg_status write_files(const char *path, const kg_document *document, kg_document_net *net,
                             const kg_net_options *settings, const outputs *out, kg_error *error) {
    kg_net_layout *layout = NULL;
    companion report = {.path = out->report}, guide = {.path = out->guide};
    kg_status status = kg_net_layout_create(net->net, settings, NULL, &layout, error);
    if (status)
        kg_fail_in(error, status, "%s: ", path);
    if (!status)
        status = check_pins(net, layout, settings, error);
    if (!status && out->report)
        status = make_report(net, layout, settings, &report, error);
    if (!status && out->guide) {
        kg_language_use(out->language);
        status = kg_guide_write_memory(document, net, layout, settings, NULL, &guide.data,
                                       &guide.size, error);
        kg_language_use("en"); /* all else that the command line says */
    }
    sigset_t before;
    kg_signals_hold(&before);
    if (!status)
        status = prepare(&report, error);
    if (!status)
        status = prepare(&guide, error);
    if (!status)
        status = kg_net_draw(net->net, layout, settings, out->net, error);
    status = settle(&guide, status, error);
    status = settle(&report, status, error);
    kg_signals_release(&before);
    kg_net_layout_destroy(layout);
    return status;
}

/* `path` is of the model: what it asks for may not be possible. */
static kg_status write_net(const char *path, kg_document *document, const kg_net_options *settings,
                           const kg_parts_options *parts, const outputs *out, kg_error *error) {
    kg_document_net net = {0};
    double chord = kg_document_net_chord(settings);
    if (kg_document_oa(document)) /* what is too narrow is so at the size it is drawn in */
        kg_document_oa(document)->net.scale = settings->scale;
    kg_status status = kg_document_solve(document, chord, error);
    if (!status && (status = kg_document_unroll_to_fit(document, parts, &net, error)))
        kg_fail_in(error, status, "%s: ", path);
    if (!status)
        status = write_files(path, document, &net, settings, out, error);
    for (size_t i = 0; i < net.remark_count && !status; i++)
        if (net.remarks[i].source > 0)
            fprintf(stderr, "katagami net: warning: patch %lld: %s\n",
                    (long long)net.remarks[i].source, net.remarks[i].message);
        else
            fprintf(stderr, "katagami net: warning: %s\n", net.remarks[i].message);
    kg_document_net_clear(&net);
    return status;
}

int kg_command_net(int argc, char **argv) {
    kg_arguments a;
    int code = kg_arguments_parse(argc, argv, "katagami net MODEL -o NET.svg|.pdf|.dxf [OPTION…]",
                                  options, OPTION_COUNT, &a);
    if (code >= 0)
        return code;
    const char *language = kg_arguments_get(&a, "language");
    const outputs out = {kg_arguments_get(&a, "output"), kg_arguments_get(&a, "guide"),
                         language ? language : "", kg_arguments_get(&a, "json")};
    if (a.count != 1 || !out.net)
        return kg_command_misuse("net", "a model and an output (-o) are wanted");
    if (out.guide && strcmp(out.guide, "-") == 0)
        return kg_command_misuse("net", "--guide is the name of a file");
    if (language && strcmp(language, "ja") && strcmp(language, "en"))
        return kg_command_misuse("net", "--language is ja or en, not %s", language);
    if (out.report && strcmp(out.report, "-") == 0 && strcmp(out.net, "-") == 0)
        return kg_command_misuse("net", "only one of the net and the report fits into -");
    kg_error error;
    kg_document *document;
    kg_net_options settings;
    double tab_width;
    if (kg_document_read(a.words[0], &document, &error))
        return kg_command_fail("net", &error);
    kg_paper_warn(document, "net");
    code = read_options(&a, document, &settings, &tab_width);
    if (code < 0) {
        kg_parts_options parts = parts_options(&a, document, &settings, tab_width);
        if (write_net(a.words[0], document, &settings, &parts, &out, &error))
            code = kg_command_fail("net", &error);
    }
    kg_document_destroy(document);
    return code < 0 ? KG_EXIT_DONE : code;
}
