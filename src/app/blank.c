#include "app/blank.h"

/* A card of usual size: 120 mm wide, as high as it is deep, in cells of 10 mm. */
enum { CARD_CELLS = 12, CELL_MM = 10 };

/* mm from the middle of a sheet to its sides: 150 mm, as sold. */
#define HALF_SHEET 75

static kg_status no_memory(kg_error *error) {
    return kg_fail(error, KG_ERR_MEMORY, "out of memory");
}

static kg_status blank_card(kg_document **out, kg_error *error) {
    kg_oa *oa;
    kg_status status = kg_oa_create(CARD_CELLS, CARD_CELLS, CARD_CELLS, CELL_MM, &oa, error);
    return status ? status : kg_document_from_oa(oa, NULL, out, error);
}

static kg_status blank_sheet(kg_document **out, kg_error *error) {
    kg_vec2 corners[] = {{-HALF_SHEET, -HALF_SHEET},
                         {HALF_SHEET, -HALF_SHEET},
                         {HALF_SHEET, HALF_SHEET},
                         {-HALF_SHEET, HALF_SHEET}};
    kg_paper_sheet sheet = {.count = 4, .polygon = corners, .front = 0xcc3333, .back = 0xffffff};
    kg_origami *origami = kg_origami_create();
    kg_status status = origami ? kg_origami_add_sheet(origami, &sheet, error) : no_memory(error);
    if (status) {
        kg_origami_destroy(origami);
        return status;
    }
    return kg_document_from_origami(origami, NULL, out, error);
}

kg_status kg_blank_document(kg_document_kind kind, kg_document **out, kg_error *error) {
    if (kind == KG_DOCUMENT_OA)
        return blank_card(out, error);
    if (kind == KG_DOCUMENT_ORIGAMI)
        return blank_sheet(out, error);
    kg_model *model = kg_model_create();
    return model ? kg_document_from_model(model, NULL, out, error) : no_memory(error);
}
