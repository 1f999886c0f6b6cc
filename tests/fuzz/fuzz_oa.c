#include "katagami/oa.h"

#include "tests/fuzz/fuzz.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

/* More cells are read as well, but not laid out: the fuzzer should spend its time elsewhere. */
enum { MAX_CELLS = 1 << 14 };

/* Whatever can be read can be laid out: its net is a net, its pose a mesh. */
static void use(const kg_oa *oa) {
    kg_oa_sheet *sheet;
    kg_oa_stability *stability;
    kg_net *net;
    kg_mesh *mesh;
    size_t missing;
    kg_status status = kg_oa_sheet_create(oa, &sheet, NULL);
    assert(!status);
    unsigned char *reached = malloc((size_t)sheet->width * (size_t)sheet->rows);
    status = kg_oa_flood(sheet, reached, &missing, NULL);
    assert(!status);
    status = kg_oa_stability_create(sheet, &stability, NULL);
    assert(!status && stability->loose_count <= stability->patch_count);
    status = kg_oa_net(oa, sheet, &net, NULL);
    assert(!status && kg_net_check(net, NULL) == KG_OK);
    status = kg_oa_pose(oa, sheet, stability, 1, &mesh, NULL);
    assert(!status && kg_mesh_check(mesh, NULL) == KG_OK);
    free(reached);
    kg_mesh_destroy(mesh);
    kg_net_destroy(net);
    kg_oa_stability_destroy(stability);
    kg_oa_sheet_destroy(sheet);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    kg_oa *oa, *again;
    kg_error error = {0};
    kg_status status = kg_oa_read_memory((const char *)data, size, "fuzz", &oa, &error);
    if (status) {
        assert(error.status == status && strstr(error.message, "fuzz"));
        return 0;
    }
    assert(kg_oa_check(oa, NULL) == KG_OK);
    char *text, *text2;
    size_t text_size, text_size2;
    status = kg_oa_write_memory(oa, &text, &text_size, &error);
    assert(!status);
    status = kg_oa_read_memory(text, text_size, "fuzz", &again, &error);
    assert(!status);
    status = kg_oa_write_memory(again, &text2, &text_size2, &error);
    assert(!status && strcmp(text, text2) == 0);
    free(text);
    free(text2);
    kg_oa_destroy(again);
    int64_t m = 2 * oa->margin_cells;
    if ((oa->width + m) * (oa->height + oa->depth_limit + m) <= MAX_CELLS)
        use(oa);
    kg_oa_destroy(oa);
    return 0;
}
