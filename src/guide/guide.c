#include "guide/guide.h"

#include "base/file.h"
#include "net/text.h"

#include <stdlib.h>
#include <string.h>

/* Of the pictures: fine lines stay smooth at this, and files small. */
#define DOTS_PER_MM (170 / 25.4)

/* Paper that can lie beside the work, mm; nets on larger sheets have guides on A4. */
#define HANDY_WIDTH 220
#define HANDY_HEIGHT 360
#define LEAST_WIDTH 180
#define LEAST_HEIGHT 250

/* Copies a name, cut off where it would fill more than about a line. */
static void shorten(char *out, size_t size, const char *name) {
    static const char ellipsis[] = "…";
    const double most = 24; /* full-width characters */
    size_t used = 0;
    for (const char *next = name; *next; used = (size_t)(next - name)) {
        kg_text_character(&next);
        size_t length = (size_t)(next - name);
        bool fits = length + sizeof ellipsis < size;
        if (fits) {
            memcpy(out + used, name + used, length - used);
            out[length] = 0;
        }
        if (!fits || kg_text_width(out) > most) {
            memcpy(out + used, ellipsis, sizeof ellipsis);
            return;
        }
    }
    out[used] = 0;
}

char *kg_guide_part_name(const kg_guide *guide, int part, char *out, size_t size) {
    const kg_net_part *p = &guide->net->parts[part];
    char name[KG_SENTENCE / 4];
    shorten(name, sizeof name, p->name ? p->name : "");
    return name[0] ? kg_words(out, size, KG_WORD_PART_NAMED, p->number, name)
                   : kg_words(out, size, KG_WORD_PART, p->number);
}

kg_status kg_guide_picture(kg_guide *guide, const kg_view_of *view, kg_stage_look look,
                           const kg_camera *camera, kg_vec2 at, kg_vec2 size, kg_error *error) {
    kg_image image = {0};
    kg_status status =
        kg_stage_picture(guide->stage, view, look, camera, (int)lround(size.x * DOTS_PER_MM),
                         (int)lround(size.y * DOTS_PER_MM), &image, error);
    if (!status)
        status = kg_book_image(guide->paper, &image, at.x, at.y, size.x, error);
    kg_image_destroy(&image);
    return status;
}

kg_status kg_guide_tick(const kg_guide *guide, double fraction, kg_error *error) {
    const kg_progress *p = guide->progress;
    return !p || !p->call || p->call(p->user, fraction, "guide")
               ? KG_OK
               : kg_fail(error, KG_ERR_CANCELLED, "cancelled");
}

static kg_vec2 paper_size(const kg_guide *guide) {
    kg_vec2 size = guide->layout ? guide->layout->page_size : guide->options->paper;
    double width = fmin(size.x, size.y), height = fmax(size.x, size.y);
    bool handy = width >= LEAST_WIDTH && width <= HANDY_WIDTH && height >= LEAST_HEIGHT &&
                 height <= HANDY_HEIGHT;
    return handy ? kg_v2(width, height) : kg_v2(210, 297);
}

static kg_status order_parts(kg_guide *guide, kg_error *error) {
    kg_guide_order_options options = kg_guide_order_options_default();
    bool *inside = calloc(guide->net->join_count + 1, sizeof *inside);
    if (!inside)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    for (size_t i = 0; i < guide->net->join_count; i++)
        inside[i] = guide->assembly->joins[i].inside;
    options.inside = inside;
    options.opening /= guide->layout->scale;
    kg_status status = kg_guide_order_create(guide->net, &options, &guide->order, error);
    free(inside);
    return status;
}

static kg_status open_paper(kg_guide *guide, kg_word footing, kg_error *error) {
    char title[KG_SENTENCE], footer[KG_SENTENCE];
    kg_words(title, sizeof title, KG_WORD_UNTITLED);
    kg_words(footer, sizeof footer, footing, guide->title ? guide->title : title);
    return kg_book_create(paper_size(guide), footer, footer, &guide->paper, error);
}

static kg_status write_assembly(kg_guide *guide, const kg_document *document,
                                const kg_document_net *net, kg_error *error) {
    kg_status status = kg_assembly_create(document, guide->net, net->room, &guide->assembly, error);
    if (!status)
        status = order_parts(guide, error);
    if (!status)
        status = kg_stage_create(guide->assembly, &guide->stage, error);
    if (!status)
        status = open_paper(guide, KG_WORD_FOOTER, error);
    if (!status)
        status = kg_guide_opening(guide, error);
    return status ? status : kg_guide_steps(guide, error);
}

static kg_status write_folds(kg_guide *guide, const kg_origami *origami, kg_error *error) {
    kg_status status = open_paper(guide, KG_WORD_SHEETS_FOOTER, error);
    return status ? status : kg_guide_folds(guide, origami, error);
}

kg_status kg_guide_write_memory(const kg_document *document, const kg_document_net *net,
                                const kg_net_layout *layout, const kg_net_options *options,
                                const kg_progress *progress, char **out_data, size_t *out_size,
                                kg_error *error) {
    kg_guide guide = {.net = net->net, .layout = layout, .options = options, .progress = progress};
    const char *title = kg_document_title(document), *path = kg_document_path(document);
    bool named = path && strcmp(path, "-") != 0;
    char *name = title[0] || !named ? NULL : kg_file_stem(path);
    guide.title = title[0] ? title : name && name[0] ? name : NULL;
    kg_status status = KG_OK;
    switch (kg_document_get_kind(document)) {
    case KG_DOCUMENT_PATCHES:
        status = write_assembly(&guide, document, net, error);
        break;
    case KG_DOCUMENT_ORIGAMI:
        status = write_folds(&guide, kg_document_origami(document), error);
        break;
    case KG_DOCUMENT_OA:
        status = open_paper(&guide, KG_WORD_CARD_FOOTER, error);
        if (!status)
            status = kg_guide_card(&guide, document, error);
        break;
    }
    if (!status)
        status = kg_book_finish(guide.paper, error);
    if (!status) {
        *out_data = guide.paper->bytes.items;
        *out_size = guide.paper->bytes.count;
        guide.paper->bytes = (kg_bytes){0};
    }
    kg_book_destroy(guide.paper);
    kg_stage_destroy(guide.stage);
    kg_guide_order_destroy(guide.order);
    kg_assembly_destroy(guide.assembly);
    free(name);
    return status;
}

kg_status kg_guide_write(const kg_document *document, const kg_document_net *net,
                         const kg_net_layout *layout, const kg_net_options *options,
                         const char *path, const kg_progress *progress, kg_error *error) {
    char *data;
    size_t size;
    kg_status status =
        kg_guide_write_memory(document, net, layout, options, progress, &data, &size, error);
    if (status)
        return status;
    status = kg_file_write(path, data, size, error);
    free(data);
    return status;
}
