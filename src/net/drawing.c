#include "net/drawing.h"

#include "base/array.h"
#include "net/fit.h"
#include "net/glyph.h"
#include "net/guide.h"
#include "net/label.h"
#include "net/layout.h"
#include "net/mirror.h"
#include "net/perforation.h"
#include "net/text.h"

#include <stdlib.h>
#include <string.h>

/* Of the tolerance, what flattening may use where a writer knows no curves. */
#define FLATTEN_SHARE 0.4

const char *kg_layer_id(kg_net_layer layer) {
    static const char *const ids[] = {"cut", "mountain", "valley", "mark", "label", "guide"};
    return ids[layer];
}

const char *kg_layer_label(kg_net_layer layer) {
    static const char *const labels[] = {"Cut", "Mountain", "Valley", "Mark", "Label", "Guide"};
    return labels[layer];
}

int kg_layer_dashes(kg_net_layer layer, const double **out_dashes) {
    static const double mountain[] = {3, 1, 0.4, 1}, valley[] = {2, 1.2};
    *out_dashes = layer == KG_LAYER_MOUNTAIN ? mountain : layer == KG_LAYER_VALLEY ? valley : NULL;
    return layer == KG_LAYER_MOUNTAIN ? 4 : layer == KG_LAYER_VALLEY ? 2 : 0;
}

kg_stroke *kg_page_stroke(kg_page *page, kg_net_layer layer, const kg_net_part *part) {
    kg_stroke stroke = {.layer = layer};
    if (part) {
        stroke.part = part->number;
        stroke.source = part->source;
    }
    if (!kg_push(&page->strokes, stroke))
        return NULL;
    return &page->strokes.items[page->strokes.count - 1];
}

bool kg_page_caption(kg_page *page, const kg_caption *caption) {
    kg_caption copy = *caption;
    copy.text = kg_text_line(caption->text);
    if (copy.text && kg_push(&page->captions, copy))
        return true;
    free(copy.text);
    return false;
}

void kg_drawing_destroy(kg_drawing *drawing) {
    if (!drawing)
        return;
    for (size_t i = 0; drawing->pages && i < drawing->page_count; i++) {
        kg_page *page = &drawing->pages[i];
        for (size_t k = 0; k < page->strokes.count; k++)
            kg_path_clear(&page->strokes.items[k].path);
        for (size_t k = 0; k < page->captions.count; k++)
            free(page->captions.items[k].text);
        free(page->strokes.items);
        free(page->captions.items);
    }
    free(drawing->pages);
    free(drawing->title);
    free(drawing);
}

/* ---- parts ---------------------------------------------------------------------------------- */

typedef struct draft {
    const kg_net *net;
    const kg_net_layout *layout;
    const kg_net_options *options;
    kg_drawing *drawing;
    double fit_tolerance;
    struct {
        kg_vec2 *items;
        size_t count, capacity;
    } placed; /* scratch: a line's points on the page */
} draft;

static kg_status out_of_memory(kg_error *error) {
    return kg_fail(error, KG_ERR_MEMORY, "out of memory while drawing the net");
}

/* One line of a part, scaled and placed before it is fitted, so that the tolerance holds on the
 * page. */
static kg_status draw_line(draft *d, size_t part, const kg_net_line *line, kg_error *error) {
    static const kg_net_layer layers[] = {KG_LAYER_CUT, KG_LAYER_MOUNTAIN, KG_LAYER_VALLEY,
                                          KG_LAYER_MARK};
    const kg_net_part *p = &d->net->parts[part];
    kg_page *page = &d->drawing->pages[d->layout->placements[part].page];
    kg_stroke *stroke = kg_page_stroke(page, layers[line->kind], p);
    if (!stroke || !kg_reserve(&d->placed, line->count))
        return out_of_memory(error);
    for (size_t i = 0; i < line->count; i++)
        d->placed.items[i] = kg_layout_apply(d->layout, part, line->points[i]);
    stroke->contact = line->contact;
    stroke->tab = line->tab;
    stroke->dashed = d->options->dashes;
    kg_status status = kg_fit(d->placed.items, line->corners, line->count, line->closed,
                              d->fit_tolerance, &stroke->path, error);
    if (status == KG_OK && stroke->path.count == 0)
        page->strokes.count--; /* a line without length */
    return status;
}

static kg_status draw_part(draft *d, size_t part, kg_error *error) {
    const kg_net_part *p = &d->net->parts[part];
    kg_status status = KG_OK;
    for (size_t i = 0; status == KG_OK && i < p->loop_count; i++)
        status = draw_line(d, part, &p->loops[i].line, error);
    for (size_t i = 0; status == KG_OK && i < p->line_count; i++)
        status = draw_line(d, part, &p->lines[i], error);
    return status;
}

static kg_status draw_all(draft *d, kg_error *error) {
    kg_status status = KG_OK;
    for (size_t i = 0; status == KG_OK && i < d->net->part_count; i++)
        status = draw_part(d, i, error);
    if (status == KG_OK)
        status = kg_guide_draw(d->drawing, d->options, error);
    if (status == KG_OK)
        status = kg_label_draw(d->net, d->layout, d->options, d->drawing, error);
    return status;
}

/* What is done to whole pages, in the order in which it may be done: mirroring exchanges folds
 * before they are perforated, and leaves text upright before it becomes outlines. */
static kg_status finish(kg_drawing *drawing, const kg_net_options *options, kg_error *error) {
    kg_status status = KG_OK;
    if (options->mirrored)
        kg_drawing_mirror(drawing);
    if (options->perforate[0] > 0)
        status = kg_perforate(drawing, options->perforate[0], options->perforate[1], error);
    if (status == KG_OK && options->text_outlines) {
        kg_glyphs *glyphs = kg_glyphs_create();
        status = glyphs ? kg_glyphs_outline(glyphs, drawing, error) : out_of_memory(error);
        kg_glyphs_destroy(glyphs);
    }
    return status;
}

kg_status kg_drawing_create(const kg_net *net, const kg_net_layout *layout,
                            const kg_net_options *options, bool curves, kg_drawing **out_drawing,
                            kg_error *error) {
    kg_drawing *drawing = calloc(1, sizeof *drawing);
    if (drawing) {
        drawing->page_count = layout->page_count;
        drawing->pages = calloc(drawing->page_count, sizeof *drawing->pages);
        drawing->title = kg_text_line(net->title ? net->title : "");
    }
    if (!drawing || !drawing->pages || !drawing->title) {
        kg_drawing_destroy(drawing);
        return out_of_memory(error);
    }
    drawing->size = layout->page_size;
    memcpy(drawing->styles, options->styles, sizeof drawing->styles);
    double share = curves ? 1 : 1 - FLATTEN_SHARE;
    drawing->flatten_tolerance = FLATTEN_SHARE * options->tolerance;
    draft d = {.net = net,
               .layout = layout,
               .options = options,
               .drawing = drawing,
               .fit_tolerance = share * options->tolerance};
    kg_status status = draw_all(&d, error);
    if (status == KG_OK)
        status = finish(drawing, options, error);
    free(d.placed.items);
    if (status)
        kg_drawing_destroy(drawing);
    else
        *out_drawing = drawing;
    return status;
}
