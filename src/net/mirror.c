#include "net/mirror.h"

static void stroke_mirror(kg_stroke *stroke, double width) {
    if (stroke->layer == KG_LAYER_MOUNTAIN)
        stroke->layer = KG_LAYER_VALLEY;
    else if (stroke->layer == KG_LAYER_VALLEY)
        stroke->layer = KG_LAYER_MOUNTAIN;
    for (size_t i = 0; i < stroke->path.count; i++)
        for (int k = 0; k < 3; k++)
            stroke->path.items[i].p[k].x = width - stroke->path.items[i].p[k].x;
}

void kg_drawing_mirror(kg_drawing *drawing) {
    for (size_t i = 0; i < drawing->page_count; i++) {
        kg_page *page = &drawing->pages[i];
        for (size_t k = 0; k < page->strokes.count; k++)
            /* The machine looks for its registration marks where they always are. */
            if (page->strokes.items[k].layer != KG_LAYER_GUIDE)
                stroke_mirror(&page->strokes.items[k], drawing->size.x);
        for (size_t k = 0; k < page->captions.count; k++) {
            kg_caption *caption = &page->captions.items[k];
            if (caption->layer == KG_LAYER_GUIDE)
                continue;
            caption->center.x = drawing->size.x - caption->center.x;
            caption->angle = -caption->angle;
            /* A name stays beside its number. */
            if (caption->align != KG_CAPTION_MIDDLE)
                caption->align =
                    caption->align == KG_CAPTION_START ? KG_CAPTION_END : KG_CAPTION_START;
        }
    }
}
