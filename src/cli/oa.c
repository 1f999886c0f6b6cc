/* katagami oa: a pop-up card of a mesh. */
#include "base/file.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "katagami/document.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const kg_option options[] = {
    {"output", 'o', true, "MODEL", "model file to write (.katagami); required"},
    {"size", 0, true, "WxDxH", "cells: width, depth, height (80x40x40)"},
    {"cell", 0, true, "MM", "side of a cell (at most 2.5, so that the card fits on A4)"},
    {"up", 0, true, "AXIS", "what points up in the mesh: x, y, z, -x, -y or -z (y)"},
    {"front", 0, true, "AXIS", "what points to the reader (z; with --up z it is -y)"},
    {"stretch", 0, false, NULL, "fill the card in all directions instead of keeping proportions"},
    {"smooth", 0, true, "N", "smooth sections with N x N cells, N odd; 0 is off (3)"},
    {"windows", 0, false, NULL, "open windows where the card allows (it does)"},
    {"no-windows", 0, false, NULL, "leave the front closed"},
    {"thin-top", 0, true, "N", "leave out tops at most N cells deep where possible (0)"},
    {"diagonals", 0, false, NULL, "45-degree folds where they hold"},
    {"stable", 0, false, NULL, "change a few cells so that no patch is loose and the card stands"},
    {"margin", 0, true, "N",
     "plain cells on each side; fit: so many that the closed card covers it (0)"},
    {"tiny", 0, true, "MM", "warn of folds and strips between cuts narrower than this (2)"},
    {"title", 0, true, "TEXT", "title of the card (the mesh's name)"},
    {"progress", 0, false, NULL, "tell on standard error how far the work is"},
};

static int read_axes(const kg_arguments *a, kg_oa_options *out) {
    const char *up = kg_arguments_get(a, "up"), *front = kg_arguments_get(a, "front");
    if (up && !kg_oa_axis_parse(up, &out->up))
        return kg_command_misuse("oa", "--up is an axis such as y or -z, not %s", up);
    if (out->up.z != 0)
        out->front = kg_v3(0, -1, 0);
    if (front && !kg_oa_axis_parse(front, &out->front))
        return kg_command_misuse("oa", "--front is an axis such as z or -y, not %s", front);
    if (kg_dot(out->up, out->front) != 0)
        return kg_command_misuse("oa", "--up and --front are two different axes");
    return -1;
}

static bool is_side(int cells, int least) {
    return cells >= least && cells <= KG_OA_MAX_SIZE;
}

static int read_margin(const kg_arguments *a, kg_oa_options *out) {
    const char *margin = kg_arguments_get(a, "margin");
    double cells = 0;
    out->covering = margin && strcmp(margin, "fit") == 0;
    if (!out->covering && !kg_arguments_number(a, "margin", 0, KG_OA_MAX_MARGIN, &cells))
        return KG_EXIT_USAGE;
    if (cells != floor(cells))
        return kg_command_misuse("oa", "--margin is a whole number of cells, or fit");
    out->margin = (int)cells;
    return -1;
}

static int read_options(const kg_arguments *a, kg_oa_options *out) {
    const char *size = kg_arguments_get(a, "size");
    double smooth = 3, thin = 0;
    char rest;
    *out = kg_oa_options_default();
    if (size && sscanf(size, "%dx%dx%d%c", &out->width, &out->depth, &out->height, &rest) != 3)
        return kg_command_misuse("oa", "--size is WxDxH in cells, not %s", size);
    if (!is_side(out->width, 3) || !is_side(out->depth, 2) || !is_side(out->height, 2))
        return kg_command_misuse("oa", "--size is 3x2x2 to %dx%dx%d cells, not %s", KG_OA_MAX_SIZE,
                                 KG_OA_MAX_SIZE, KG_OA_MAX_SIZE, size);
    int code = read_axes(a, out);
    if (code >= 0)
        return code;
    if (kg_arguments_get(a, "windows") && kg_arguments_get(a, "no-windows"))
        return kg_command_misuse("oa", "--windows and --no-windows exclude each other");
    out->cell_mm = kg_document_card_cell((int[]){out->width, out->depth, out->height});
    if (!kg_arguments_number(a, "cell", 1e-3, KG_OA_MAX_CELL, &out->cell_mm) ||
        !kg_arguments_number(a, "tiny", 0, KG_OA_MAX_CELL, &out->tiny_mm) ||
        !kg_arguments_number(a, "smooth", 0, KG_OA_MAX_SIZE, &smooth) ||
        !kg_arguments_number(a, "thin-top", 0, KG_OA_MAX_SIZE, &thin))
        return KG_EXIT_USAGE;
    if (smooth != floor(smooth) || (smooth > 0 && fmod(smooth, 2) == 0))
        return kg_command_misuse("oa", "--smooth is 0 or an odd number of cells");
    if (thin != floor(thin))
        return kg_command_misuse("oa", "--thin-top is a whole number of cells");
    out->smooth = (int)smooth;
    out->thin_top = (int)thin;
    out->windows = !kg_arguments_get(a, "no-windows");
    out->stretch = kg_arguments_get(a, "stretch") != NULL;
    out->diagonals = kg_arguments_get(a, "diagonals") != NULL;
    out->stable = kg_arguments_get(a, "stable") != NULL;
    return read_margin(a, out);
}

static bool tell(void *user, double fraction, const char *what) {
    (void)user;
    fprintf(stderr, "\r%s %3.0f %%", what, 100 * fraction);
    return true;
}

/* Tells of patches that wobble: it is no failure, since the card folds all the same. */
static kg_status say_loose(const kg_oa *oa, bool mended, kg_error *error) {
    kg_oa_sheet *sheet;
    kg_oa_stability *stability;
    kg_status status = kg_oa_sheet_create(oa, &sheet, error);
    if (status)
        return status;
    status = kg_oa_stability_create(sheet, &stability, error);
    kg_oa_sheet_destroy(sheet);
    if (status)
        return status;
    if (stability->loose_count > 0)
        fprintf(stderr, "katagami oa: warning: patches that are loose: %zu; %s\n",
                stability->loose_count,
                mended ? "no small change helps, another --size may"
                       : "--stable changes a few cells so that the card stands");
    kg_oa_stability_destroy(stability);
    return KG_OK;
}

static kg_status convert(const kg_arguments *a, const kg_oa_options *wanted, const char *output,
                         kg_error *error) {
    kg_progress progress = {kg_arguments_get(a, "progress") ? tell : NULL, NULL};
    const char *title = kg_arguments_get(a, "title");
    kg_mesh *mesh;
    kg_oa *oa = NULL;
    kg_status status = kg_mesh_read(a->words[0], &mesh, error);
    if (status)
        return status;
    kg_command_say_skipped("oa", mesh, a->words[0]);
    status = kg_oa_convert(mesh, wanted, &progress, &oa, error);
    kg_mesh_destroy(mesh);
    if (progress.call)
        fputc('\n', stderr);
    if (!status && !kg_arguments_get(a, "cell"))
        kg_document_card_fit(oa);
    if (!status)
        status = say_loose(oa, wanted->stable, error);
    if (!status) {
        free(oa->title);
        oa->title = title ? strdup(title) : kg_file_stem(a->words[0]);
        status = oa->title ? kg_oa_write(oa, output, error)
                           : kg_fail(error, KG_ERR_MEMORY, "out of memory");
    }
    kg_oa_destroy(oa);
    return status;
}

int kg_command_oa(int argc, char **argv) {
    kg_arguments a;
    kg_oa_options wanted;
    int code = kg_arguments_parse(argc, argv, "katagami oa MESH -o MODEL [OPTION…]", options,
                                  sizeof options / sizeof *options, &a);
    if (code >= 0)
        return code;
    const char *output = kg_arguments_get(&a, "output");
    if (a.count != 1 || !output)
        return kg_command_misuse("oa", "a mesh and an output (-o) are wanted");
    if ((code = read_options(&a, &wanted)) >= 0)
        return code;
    kg_error error;
    return convert(&a, &wanted, output, &error) ? kg_command_fail("oa", &error) : KG_EXIT_DONE;
}
