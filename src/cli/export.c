/* katagami export: the model's surface as a mesh file, or its crease pattern. */
#include "cli/card.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "cli/paper.h"
#include "katagami/document.h"
#include "katagami/render.h"

static const kg_option options[] = {
    {"output", 'o', true, "FILE",
     "mesh to write: .obj .ply .stl .off .gltf .glb; or .fold, of sheets also .cp; required"},
    {"open", 0, true, "DEG", "how far a card is open: 0 closed, 90 standing, 180 flat (90)"},
    {"step", 0, true, "N", "sheets after so many folds (all of them)"},
    {"tolerance", 0, true, "MM", "greatest chord error of the mesh (0.02)"},
};

int kg_command_export(int argc, char **argv) {
    kg_arguments a;
    int code = kg_arguments_parse(argc, argv, "katagami export MODEL -o FILE [OPTION…]", options,
                                  sizeof options / sizeof *options, &a);
    if (code >= 0)
        return code;
    const char *path = kg_arguments_get(&a, "output");
    double tolerance = KG_MESH_CHORD, open_deg = 90, step = -1;
    if (a.count != 1 || !path)
        return kg_command_misuse("export", "a model and an output (-o) are wanted");
    if (!kg_arguments_number(&a, "tolerance", 1e-4, 100, &tolerance) ||
        !kg_arguments_number(&a, "open", 0, 180, &open_deg) ||
        !kg_arguments_number(&a, "step", 0, 1e6, &step))
        return KG_EXIT_USAGE;
    kg_error error;
    kg_document *document = NULL;
    kg_status status = kg_document_read(a.words[0], &document, &error);
    if (!status)
        status = kg_document_solve(document, tolerance, &error);
    if (!status && step >= 0)
        status = kg_document_set_step(document, (size_t)step, &error);
    if (!status) {
        kg_document_set_open(document, open_deg * KG_PI / 180);
        kg_card_warn(document, "export");
        kg_paper_warn(document, "export");
        status = kg_document_export(document, path, kg_palette_linear, &error);
    }
    kg_document_destroy(document);
    return status ? kg_command_fail("export", &error) : KG_EXIT_DONE;
}
