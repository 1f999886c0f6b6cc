/* katagami new: an empty patch model over a reference mesh, an empty card, or a sheet to fold. */
#include "base/file.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "katagami/document.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const kg_option options[] = {
    {"output", 'o', true, "MODEL", "model file to write (.katagami); required"},
    {"reference", 0, true, "MESH", "OBJ, PLY, STL, OFF, glTF or GLB to sculpt over"},
    {"size", 0, true, "MM", "length of its longest side (its own units are mm otherwise)"},
    {"up", 0, true, "AXIS", "y or z, what points up in the mesh (z)"},
    {"card", 0, true, "WxDxH", "a pop-up card of so many cells: width, depth, height"},
    {"cell", 0, true, "MM", "side of its cells (at most 2.5, so that the card fits on A4)"},
    {"sheet", 0, true, "WxH", "a sheet to fold, mm; or A4, A3, A2, letter, legal"},
    {"title", 0, true, "TEXT", "title of the model (the mesh's name)"},
};

static kg_status write_new(const kg_arguments *a, const char *output, const char *reference,
                           double size, bool up_y, kg_error *error) {
    kg_mesh *mesh = NULL;
    kg_model *model = kg_model_create();
    const char *title = kg_arguments_get(a, "title");
    kg_status status = kg_mesh_read(reference, &mesh, error); /* a mesh that cannot be read */
    if (!status)                                              /* is told of at once */
        kg_command_say_skipped("new", mesh, reference);
    kg_mesh_destroy(mesh);
    if (!status && model) {
        free(model->title);
        model->title = title ? strdup(title) : kg_file_stem(reference);
        model->reference.file = kg_document_relative(output, reference);
        model->reference.size_mm = size;
        model->reference.up_y = up_y;
    }
    if (!status && !(model && model->title && model->reference.file))
        status = kg_fail(error, KG_ERR_IO, "%s: its folder does not exist", output);
    if (!status)
        status = kg_model_write(model, output, error);
    kg_model_destroy(model);
    return status;
}

static int new_model(const kg_arguments *a, const char *output) {
    const char *reference = kg_arguments_get(a, "reference"), *up = kg_arguments_get(a, "up");
    double size = 0;
    kg_error error;
    if (up && strcmp(up, "y") && strcmp(up, "z"))
        return kg_command_misuse("new", "--up is y or z");
    if (!kg_arguments_number(a, "size", 1e-3, 1e5, &size))
        return KG_EXIT_USAGE;
    if (write_new(a, output, reference, size, up && up[0] == 'y', &error))
        return kg_command_fail("new", &error);
    return KG_EXIT_DONE;
}

/* ---- cards and sheets ------------------------------------------------------------------- */

static kg_status set_title(kg_document *document, const char *title, kg_error *error) {
    kg_oa *oa = kg_document_oa(document);
    if (!oa)
        return kg_origami_set_title(kg_document_origami(document), title, error);
    char *copy = strdup(title);
    if (!copy)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    free(oa->title);
    oa->title = copy;
    return KG_OK;
}

/* `status` is of making the document. */
static int save(const kg_arguments *a, const char *output, kg_status status, kg_document *document,
                kg_error *error) {
    const char *title = kg_arguments_get(a, "title");
    if (status)
        return kg_command_fail("new", error);
    if (title)
        status = set_title(document, title, error);
    if (!status)
        status = kg_document_save(document, output, error);
    kg_document_destroy(document);
    return status ? kg_command_fail("new", error) : KG_EXIT_DONE;
}

static int new_card(const kg_arguments *a, const char *output) {
    const char *text = kg_arguments_get(a, "card");
    int size[3];
    char rest;
    if (sscanf(text, "%dx%dx%d%c", &size[0], &size[1], &size[2], &rest) != 3 || size[0] < 1 ||
        size[1] < 1 || size[2] < 1)
        return kg_command_misuse("new", "--card is WxDxH in cells, not %s", text);
    double cell = kg_document_card_cell(size);
    if (!kg_arguments_number(a, "cell", 1e-3, KG_OA_MAX_CELL, &cell))
        return KG_EXIT_USAGE;
    kg_error error;
    kg_document *document = NULL;
    kg_status status = kg_document_new_card(size, cell, &document, &error);
    return save(a, output, status, document, &error);
}

static int new_sheet(const kg_arguments *a, const char *output) {
    const char *text = kg_arguments_get(a, "sheet");
    kg_vec2 size;
    kg_error error;
    kg_document *document = NULL;
    if (kg_net_paper_parse(text, &size, &error) || size.x <= 0)
        return kg_command_misuse("new", "--sheet is WxH in mm, or a paper such as A4, not %s",
                                 text);
    kg_status status =
        kg_document_new_sheet(size, KG_SHEET_FRONT, KG_SHEET_BACK, &document, &error);
    return save(a, output, status, document, &error);
}

int kg_command_new(int argc, char **argv) {
    kg_arguments a;
    int code = kg_arguments_parse(
        argc, argv, "katagami new -o MODEL --reference MESH|--card WxDxH|--sheet WxH [OPTION…]",
        options, sizeof options / sizeof *options, &a);
    if (code >= 0)
        return code;
    const char *output = kg_arguments_get(&a, "output");
    bool card = kg_arguments_get(&a, "card"), sheet = kg_arguments_get(&a, "sheet"),
         mesh = kg_arguments_get(&a, "reference");
    if (a.count != 0 || !output || card + sheet + mesh != 1)
        return kg_command_misuse(
            "new", "an output (-o) and one of --reference, --card and --sheet are wanted");
    if (!mesh && (kg_arguments_get(&a, "size") || kg_arguments_get(&a, "up")))
        return kg_command_misuse("new", "--size and --up are for a --reference");
    if (!card && kg_arguments_get(&a, "cell"))
        return kg_command_misuse("new", "--cell is for a --card");
    return card ? new_card(&a, output) : sheet ? new_sheet(&a, output) : new_model(&a, output);
}
