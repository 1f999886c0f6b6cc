#include "app/export.h"

#include "app/modes/card_state.h"
#include "app/modes/sheet_state.h"
#include "base/file.h"
#include "katagami/guide.h"

kg_status kg_export_net(kg_document *document, const kg_net_options *options, double tab_width,
                        const char *path, const kg_progress *progress, kg_error *error) {
    kg_document_net net;
    kg_parts_options parts = kg_document_parts_options(document, options, tab_width);
    kg_status status = kg_document_solve(document, kg_document_net_chord(options), error);
    if (!status)
        status = kg_document_unroll_to_fit(document, &parts, &net, error);
    if (status)
        return status;
    status = kg_net_write(net.net, options, progress, path, NULL, error);
    kg_document_net_clear(&net);
    return status;
}

kg_status kg_export_guide(kg_document *document, const char *path, const kg_progress *progress,
                          kg_error *error) {
    kg_net_options options;
    kg_document_net net = {0};
    kg_net_layout *layout = NULL;
    double tab_width;
    kg_status status = kg_document_net_options(document, &options, &tab_width, error);
    if (status)
        return status;
    kg_parts_options parts = kg_document_parts_options(document, &options, tab_width);
    status = kg_document_solve(document, kg_document_net_chord(&options), error);
    if (!status)
        status = kg_document_unroll_to_fit(document, &parts, &net, error);
    if (!status && kg_document_get_kind(document) != KG_DOCUMENT_ORIGAMI)
        status = kg_net_layout_create(net.net, &options, progress, &layout, error);
    if (!status)
        status = kg_guide_write(document, &net, layout, &options, path, progress, error);
    kg_net_layout_destroy(layout);
    kg_document_net_clear(&net);
    return status;
}

kg_status kg_export_mesh(kg_document *document, const char *path, kg_error *error) {
    kg_status status = kg_document_solve(document, KG_MESH_CHORD, error);
    kg_group_color color = kg_document_model(document) ? kg_palette_linear : NULL;
    return status ? status : kg_document_export(document, path, color, error);
}

static kg_status export_net(kg_document *document, const char *path, kg_error *error) {
    kg_net_options options;
    double tab_width;
    kg_status status = kg_document_net_options(document, &options, &tab_width, error);
    return status ? status : kg_export_net(document, &options, tab_width, path, NULL, error);
}

bool kg_export_is_net(const char *path) {
    return kg_file_ends_in(path, ".svg") || kg_file_ends_in(path, ".pdf") ||
           kg_file_ends_in(path, ".dxf");
}

kg_status kg_export_copy(const kg_editor *e, const char *path, kg_document **out_copy,
                         kg_error *error) {
    const kg_card_state *card = kg_card_state_of(e);
    bool moving = kg_file_ends_in(path, ".gltf") || kg_file_ends_in(path, ".glb"),
         pattern = kg_file_ends_in(path, ".fold");
    kg_document *copy;
    kg_status status = kg_document_copy(e->document, &copy, error);
    if (status)
        return status;
    if (card && !moving && !pattern)
        kg_document_set_open(copy, card->open);
    if (kg_editor_is(e, KG_DOCUMENT_ORIGAMI) && !moving && !pattern) {
        const kg_sheets *sheets = kg_sheets_of(e);
        size_t done = kg_origami_step(kg_editor_origami(e));
        if (sheets->step < done) { /* what could be done again is not part of the copy */
            status = kg_document_set_step(copy, sheets->step, error);
            kg_document_set_fraction(copy, sheets->fraction);
        }
    }
    if (status)
        kg_document_destroy(copy);
    else
        *out_copy = copy;
    return status;
}

kg_status kg_export_file(const kg_editor *e, const char *path, kg_error *error) {
    kg_document *document;
    kg_status status = kg_export_copy(e, path, &document, error);
    if (status)
        return status;
    status = kg_export_is_net(path) ? export_net(document, path, error)
                                    : kg_export_mesh(document, path, error);
    kg_document_destroy(document);
    return status;
}
