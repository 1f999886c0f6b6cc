/* Documents to begin with. */
#include "document/document.h"

/* The largest cells, mm, that look well, and the sheet they should fit: A4 within its margins. */
#define LARGEST_CELL 2.5
#define ROOM_WIDTH 194.0
#define ROOM_HEIGHT 281.0

double kg_document_card_cell(const int size[3]) {
    double fit = fmin(ROOM_WIDTH / size[0], ROOM_HEIGHT / ((double)size[1] + size[2]));
    return fmin(LARGEST_CELL, fmax(floor(fit * 100), 1) / 100);
}

void kg_document_card_fit(kg_oa *oa) {
    int margin =
        oa->margin_cells; /* two of them beside both sheets together, as beside the width */
    const int size[3] = {oa->width + 2 * margin, oa->depth_limit + margin, oa->height + margin};
    oa->cell_mm = fmin(oa->cell_mm, kg_document_card_cell(size));
}

kg_status kg_document_new_card(const int size[3], double cell_mm, kg_document **out_document,
                               kg_error *error) {
    kg_oa *oa;
    kg_status status = kg_oa_create(size[0], size[1], size[2], cell_mm, &oa, error);
    return status ? status : kg_document_from_oa(oa, NULL, out_document, error);
}

kg_status kg_document_new_sheet(kg_vec2 size, uint32_t front, uint32_t back,
                                kg_document **out_document, kg_error *error) {
    kg_vec2 half = kg_scale2(size, 0.5),
            corners[4] = {{-half.x, -half.y}, {half.x, -half.y}, half, {-half.x, half.y}};
    const kg_paper_sheet sheet = {4, corners, front, back, NULL};
    if (!(size.x >= KG_SHEET_LEAST && size.y >= KG_SHEET_LEAST && size.x <= KG_SHEET_MOST &&
          size.y <= KG_SHEET_MOST))
        return kg_fail(error, KG_ERR_INPUT, "a sheet is %g to %g mm wide and high, not %g x %g",
                       KG_SHEET_LEAST, KG_SHEET_MOST, size.x, size.y);
    kg_origami *origami = kg_origami_create();
    if (!origami)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    kg_status status = kg_origami_add_sheet(origami, &sheet, error);
    if (status) {
        kg_origami_destroy(origami);
        return status;
    }
    return kg_document_from_origami(origami, NULL, out_document, error);
}
