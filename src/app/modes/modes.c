#include "app/modes/modes.h"

const kg_mode *kg_mode_of(kg_document_kind kind) {
    switch (kind) {
    case KG_DOCUMENT_OA:
        return &kg_card_mode;
    case KG_DOCUMENT_ORIGAMI:
        return &kg_sheet_mode;
    case KG_DOCUMENT_PATCHES:
        break;
    }
    return &kg_patch_mode;
}
