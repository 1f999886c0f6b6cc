/* katagami new: an empty patch model over a reference mesh. */
#include "cli/commands.h"
#include "cli/options.h"
#include "katagami/document.h"

#include <stdlib.h>
#include <string.h>

static const kg_option options[] = {
    {"output", 'o', true, "MODEL", "model file to write (.katagami); required"},
    {"reference", 0, true, "MESH", "OBJ, PLY, STL, OFF, glTF or GLB to sculpt over; required"},
    {"size", 0, true, "MM", "length of its longest side (its own units are mm otherwise)"},
    {"title", 0, true, "TEXT", "title of the model (the mesh's name)"},
    {"up", 0, true, "AXIS", "y or z, what points up in the mesh (z)"},
};

static char *title_of(const char *path) {
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
    const char *dot = strrchr(name, '.');
    return strndup(name, dot ? (size_t)(dot - name) : strlen(name));
}

static kg_status write_new(const kg_arguments *a, const char *output, const char *reference,
                           double size, bool up_y, kg_error *error) {
    kg_mesh *mesh = NULL;
    kg_model *model = kg_model_create();
    const char *title = kg_arguments_get(a, "title");
    kg_status status = kg_mesh_read(reference, &mesh, error); /* a mesh that cannot be read */
    kg_mesh_destroy(mesh);                                    /* is told of at once */
    if (!status && model) {
        free(model->title);
        model->title = title ? strdup(title) : title_of(reference);
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

int kg_command_new(int argc, char **argv) {
    kg_arguments a;
    int code = kg_arguments_parse(argc, argv, "katagami new -o MODEL --reference MESH [--size MM]",
                                  options, sizeof options / sizeof *options, &a);
    if (code >= 0)
        return code;
    const char *output = kg_arguments_get(&a, "output"),
               *reference = kg_arguments_get(&a, "reference"), *up = kg_arguments_get(&a, "up");
    double size = 0;
    if (a.count != 0 || !output || !reference)
        return kg_command_misuse("new", "an output (-o) and a --reference are wanted");
    if (up && strcmp(up, "y") && strcmp(up, "z"))
        return kg_command_misuse("new", "--up is y or z");
    if (!kg_arguments_number(&a, "size", 1e-3, 1e5, &size))
        return KG_EXIT_USAGE;
    kg_error error;
    if (write_new(&a, output, reference, size, up && up[0] == 'y', &error))
        return kg_command_fail("new", &error);
    return KG_EXIT_DONE;
}
