#include "app/export.h"

#include <string.h>
#include <strings.h>

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

static kg_status export_net(kg_document *document, const char *path, kg_error *error) {
    kg_net_options options;
    double tab_width;
    kg_status status = kg_document_net_options(document, &options, &tab_width, error);
    return status ? status : kg_export_net(document, &options, tab_width, path, NULL, error);
}

static kg_status export_mesh(kg_document *document, const char *path, kg_error *error) {
    kg_mesh *mesh;
    kg_status status = kg_document_solve(document, KG_MESH_CHORD, error);
    if (!status)
        status = kg_document_mesh(document, NULL, &mesh, error);
    if (status)
        return status;
    status = kg_mesh_write(path, mesh, error);
    kg_mesh_destroy(mesh);
    return status;
}

kg_status kg_export_file(const kg_editor *e, const char *path, kg_error *error) {
    static const char *const nets[] = {".svg", ".pdf", ".dxf"};
    const char *dot = strrchr(path, '.');
    bool is_net = false;
    for (size_t i = 0; dot && i < sizeof nets / sizeof *nets; i++)
        is_net = is_net || strcasecmp(dot, nets[i]) == 0;
    kg_document *document;
    kg_status status = kg_document_copy(e->document, &document, error);
    if (status)
        return status;
    status = is_net ? export_net(document, path, error) : export_mesh(document, path, error);
    kg_document_destroy(document);
    return status;
}
