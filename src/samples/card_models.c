#include "samples/card_models.h"

#include "katagami/oa.h"
#include "samples/castle_mesh.h"

#include <stdlib.h>
#include <string.h>

/* text_add takes short pieces, bytes. */
enum { CHUNK = 64 };

/* So wide a margin that nothing sticks out of the closed card. */
static kg_status cover(kg_oa *oa, kg_error *error) {
    kg_oa_sheet *sheet;
    kg_status status = kg_oa_sheet_create(oa, &sheet, error);
    if (status)
        return status;
    oa->margin_cells += kg_oa_overhang(sheet);
    kg_oa_sheet_destroy(sheet);
    return KG_OK;
}

/* Writes the card and destroys it. */
static kg_status finish(kg_oa *oa, const char *title, text *out, kg_error *error) {
    char *file;
    size_t size;
    free(oa->title);
    oa->title = strdup(title);
    kg_status status =
        oa->title ? cover(oa, error) : kg_fail(error, KG_ERR_MEMORY, "out of memory");
    if (!status)
        status = kg_oa_write_memory(oa, &file, &size, error);
    kg_oa_destroy(oa);
    if (status)
        return status;
    for (size_t i = 0; i < size; i += CHUNK)
        text_add(out, "%.*s", size - i < CHUNK ? (int)(size - i) : CHUNK, file + i);
    free(file);
    return out->failed ? kg_fail(error, KG_ERR_MEMORY, "out of memory") : KG_OK;
}

/* Fills the columns [x0, x1) to a depth and a height. */
static void add_block(kg_oa *oa, int x0, int x1, int depth, int height) {
    for (int x = x0; x < x1; x++)
        kg_oa_add(oa, x, depth - 1, height - 1);
}

static void add_window(kg_oa *oa, int x0, int x1, int z0, int z1) {
    for (int x = x0; x < x1; x++)
        for (int z = z0; z < z1; z++)
            kg_oa_set_window(oa, x, z, true);
}

kg_status tower_card_write(text *out, kg_error *error) {
    kg_oa *oa;
    kg_status status = kg_oa_create(16, 10, 16, 10, &oa, error);
    if (status)
        return status;
    add_block(oa, 2, 14, 7, 4);
    add_block(oa, 4, 12, 5, 9);
    add_block(oa, 6, 10, 3, 14);
    return finish(oa, "tower 塔", out, error);
}

kg_status house_card_write(text *out, kg_error *error) {
    kg_oa *oa;
    kg_status status = kg_oa_create(24, 14, 20, 6, &oa, error);
    if (status)
        return status;
    /* every storey is narrower than the one below, so that each hangs on back and base itself */
    add_block(oa, 3, 21, 9, 9);
    add_block(oa, 4, 20, 7, 12);
    add_block(oa, 5, 19, 5, 15);
    add_block(oa, 15, 17, 6, 18); /* chimney */
    add_block(oa, 10, 14, 11, 1); /* doorstep */
    add_window(oa, 5, 8, 3, 6);
    add_window(oa, 16, 19, 3, 6);
    add_window(oa, 11, 13, 2, 6); /* door */
    return finish(oa, "house 家", out, error);
}

kg_status pyramids_card_write(text *out, kg_error *error) {
    kg_oa *oa;
    kg_status status = kg_oa_create(24, 10, 10, 6.5, &oa, error);
    if (status)
        return status;
    for (int k = 1; k <= 5; k++) { /* up to the middle and down again */
        add_block(oa, k, k + 1, k, k);
        if (k < 5)
            add_block(oa, 11 - k - 1, 11 - k, k, k);
    }
    add_block(oa, 13, 22, 6, 6); /* with a notch at its edge */
    for (int k = 1; k <= 4; k++)
        kg_oa_remove(oa, 14 + k, 6 - k, 6 - k);
    oa->diagonals = true;
    return finish(oa, "pyramids 四角錐", out, error);
}

kg_status castle_card_write(text *out, kg_error *error) {
    text file = {0};
    kg_mesh *mesh = NULL;
    kg_oa *oa = NULL;
    kg_oa_options options = kg_oa_options_default();
    options.width = 96;
    options.depth = 36;
    options.height = 60;
    options.cell_mm = 2;
    options.stable = true;
    kg_status status =
        castle_mesh_write(&file)
            ? kg_mesh_read_memory(file.items, file.count, KG_MESH_OBJ, "castle", &mesh, error)
            : kg_fail(error, KG_ERR_MEMORY, "out of memory");
    if (!status)
        status = kg_oa_convert(mesh, &options, NULL, &oa, error);
    kg_mesh_destroy(mesh);
    text_clear(&file);
    return status ? status : finish(oa, "castle 城", out, error);
}
