#include "net/writers.h"

#include "base/file.h"
#include "base/phrase.h"
#include "base/signals.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

typedef struct output {
    char *path;
    char *temporary;
    kg_bytes bytes;
} output;

typedef struct outputs {
    output *items;
    size_t count;
} outputs;

static void outputs_clear(outputs *all) {
    for (size_t i = 0; all->items && i < all->count; i++) {
        free(all->items[i].path);
        free(all->items[i].temporary);
        kg_bytes_clear(&all->items[i].bytes);
    }
    free(all->items);
}

static kg_status output_prepare(output *o, kg_error *error) {
    kg_status status = kg_file_temporary(o->path, &o->temporary, error);
    if (status)
        return status;
    FILE *f = fopen(o->temporary, "wb");
    bool done = f && fwrite(o->bytes.items, 1, o->bytes.count, f) == o->bytes.count;
    if (f && fclose(f) != 0)
        done = false;
    return done ? KG_OK
                : kg_fail(error, KG_ERR_IO, "%s: cannot write: %s", o->path,
                          kg_phrase_of_errno(errno));
}

/* Writes every file beside its place, then moves them all there; when one cannot be written, none
 * stays. */
static kg_status outputs_write(outputs *all, kg_error *error) {
    if (all->count == 1)
        return kg_file_write(all->items[0].path, all->items[0].bytes.items,
                             all->items[0].bytes.count, error);
    kg_status status = KG_OK;
    sigset_t before;
    kg_signals_hold(&before);
    for (size_t i = 0; status == KG_OK && i < all->count; i++)
        status = output_prepare(&all->items[i], error);
    size_t moved = 0;
    while (status == KG_OK && moved < all->count) {
        status = kg_file_commit(all->items[moved].temporary, all->items[moved].path, error);
        moved += status == KG_OK;
    }
    for (size_t i = 0; status != KG_OK && i < all->count; i++)
        kg_file_discard(i < moved ? all->items[i].path : all->items[i].temporary);
    kg_signals_release(&before);
    return status;
}

/* The ending of a path's last name with its dot, or the empty end. */
static const char *ending_of(const char *path) {
    const char *slash = strrchr(path, '/'), *dot = strrchr(path, '.');
    return dot && (!slash || dot > slash) ? dot : path + strlen(path);
}

/* "dir/NAME.svg" -> "dir/NAME-2.svg", with `word` before the number when there is one. */
static char *numbered(const char *path, const char *ending, const char *word, size_t number) {
    size_t size = strlen(path) + strlen(word) + 32;
    char *out = malloc(size);
    if (!out)
        return NULL;
    int n = snprintf(out, size, "%.*s%s", (int)(ending - path), path, word);
    if (number > 0)
        n += snprintf(out + n, size - (size_t)n, "-%zu", number);
    snprintf(out + n, size - (size_t)n, "%s", ending);
    return out;
}

typedef struct file_format {
    const char *ending;
    kg_status (*write)(kg_drawing *, size_t, kg_layers, kg_bytes *, kg_error *);
    bool all_pages; /* in one file */
    bool curves;
} file_format;

static const file_format formats[] = {{".svg", kg_svg_page, false, true},
                                      {".pdf", kg_pdf_pages, true, true},
                                      {".dxf", kg_dxf_page, false, false}};

static kg_status draw_files(kg_drawing *drawing, const kg_net_options *options, const char *path,
                            const file_format *format, outputs *all, kg_error *error) {
    const kg_layers cut = 1u << KG_LAYER_CUT;
    static const char *const words[] = {"-print", "-cut"};
    size_t sets = options->separate ? 2 : 1;
    size_t pages = format->all_pages ? 1 : drawing->page_count;
    const char *ending = ending_of(path);
    all->items = calloc(sets * pages, sizeof *all->items);
    if (!all->items)
        return kg_fail(error, KG_ERR_MEMORY, "%s: out of memory", path);
    if (strcmp(path, "-") == 0 && sets * pages > 1)
        return kg_fail(error, KG_ERR_INPUT,
                       "the net has %zu files, standard output takes one; give a name, or paper "
                       "'none'",
                       sets * pages);
    for (size_t set = 0; set < sets; set++) {
        kg_layers layers = sets == 1 ? KG_LAYERS_ALL : set == 0 ? KG_LAYERS_ALL & ~cut : cut;
        for (size_t page = 0; page < pages; page++) {
            output *o = &all->items[all->count++];
            o->path = numbered(path, ending, sets == 1 ? "" : words[set], pages > 1 ? page + 1 : 0);
            if (!o->path)
                return kg_fail(error, KG_ERR_MEMORY, "%s: out of memory", path);
            kg_status status = format->write(drawing, page, layers, &o->bytes, error);
            if (status)
                return status;
        }
    }
    return outputs_write(all, error);
}

/* Standard output takes SVG. */
static kg_status format_of(const char *path, const file_format **out_format, kg_error *error) {
    const char *ending = strcmp(path, "-") == 0 ? ".svg" : ending_of(path);
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++) {
        if (strcasecmp(ending, formats[i].ending) == 0) {
            *out_format = &formats[i];
            return KG_OK;
        }
    }
    return kg_fail(error, KG_ERR_INPUT, "%s: a net is written as .svg, .pdf or .dxf", path);
}

kg_status kg_net_draw(const kg_net *net, const kg_net_layout *layout, const kg_net_options *options,
                      const char *path, kg_error *error) {
    const file_format *format = NULL;
    kg_drawing *drawing;
    kg_status status = format_of(path, &format, error);
    if (status)
        return status;
    status = kg_drawing_create(net, layout, options, format->curves, &drawing, error);
    if (status)
        return status;
    outputs all = {0};
    status = draw_files(drawing, options, path, format, &all, error);
    outputs_clear(&all);
    kg_drawing_destroy(drawing);
    return status;
}

kg_status kg_net_write(const kg_net *net, const kg_net_options *options,
                       const kg_progress *progress, const char *path, kg_net_layout **out_layout,
                       kg_error *error) {
    kg_net_layout *layout;
    kg_status status = kg_net_layout_create(net, options, progress, &layout, error);
    if (status)
        return status;
    status = kg_net_draw(net, layout, options, path, error);
    if (status == KG_OK && out_layout)
        *out_layout = layout;
    else
        kg_net_layout_destroy(layout);
    return status;
}
