#include "net/writers.h"

#include "net/text.h"

#include <libxml/xmlwriter.h>
#include <stdio.h>
#include <string.h>

#define XML(text) ((const xmlChar *)(text))

typedef struct svg {
    xmlTextWriterPtr xml;
    const kg_drawing *drawing;
    kg_bytes scratch; /* an attribute's text */
    bool failed;
} svg;

static void element(svg *s, const char *name) {
    s->failed |= xmlTextWriterStartElement(s->xml, XML(name)) < 0;
}

static void element_end(svg *s) {
    s->failed |= xmlTextWriterEndElement(s->xml) < 0;
}

static void attribute(svg *s, const char *name, const char *value) {
    s->failed |= xmlTextWriterWriteAttribute(s->xml, XML(name), XML(value)) < 0;
}

static void attribute_number(svg *s, const char *name, double value, const char *unit) {
    char text[KG_NUMBER_SIZE + 8];
    kg_number_text(value, text);
    strcat(text, unit);
    attribute(s, name, text);
}

static void attribute_integer(svg *s, const char *name, int64_t value) {
    char text[32];
    snprintf(text, sizeof text, "%lld", (long long)value);
    attribute(s, name, text);
}

static void attribute_color(svg *s, const char *name, uint32_t color) {
    char text[16];
    snprintf(text, sizeof text, "#%06x", (unsigned)(color & 0xffffff));
    attribute(s, name, text);
}

/* Writes what was gathered in the scratch as an attribute and empties it. */
static void attribute_scratch(svg *s, const char *name) {
    kg_bytes_add(&s->scratch, "", 1);
    if (s->scratch.failed)
        s->failed = true;
    else
        attribute(s, name, s->scratch.items);
    s->scratch.count = 0;
}

static void scratch_point(svg *s, kg_vec2 p) {
    kg_bytes_text(&s->scratch, " ");
    kg_bytes_number(&s->scratch, p.x);
    kg_bytes_text(&s->scratch, ",");
    kg_bytes_number(&s->scratch, p.y);
}

static void path_data(svg *s, const kg_path *path) {
    static const char *const verbs[] = {"M", "L", "C", "Z"};
    static const int points[] = {1, 1, 3, 0};
    for (size_t i = 0; i < path->count; i++) {
        const kg_path_step *step = &path->items[i];
        kg_bytes_text(&s->scratch, i > 0 ? " " : "");
        kg_bytes_text(&s->scratch, verbs[step->verb]);
        for (int k = 0; k < points[step->verb]; k++)
            scratch_point(s, step->p[k]);
    }
    attribute_scratch(s, "d");
}

static void owner(svg *s, int part, int64_t source) {
    if (part == 0)
        return;
    attribute_integer(s, "data-part", part);
    attribute_integer(s, "data-patch", source);
}

static void dashes(svg *s, kg_net_layer layer) {
    const double *lengths;
    int count = kg_layer_dashes(layer, &lengths);
    if (count == 0)
        return;
    for (int i = 0; i < count; i++) {
        kg_bytes_text(&s->scratch, i > 0 ? " " : "");
        kg_bytes_number(&s->scratch, lengths[i]);
    }
    attribute_scratch(s, "stroke-dasharray");
}

static void write_stroke(svg *s, const kg_stroke *stroke) {
    const kg_net_style *style = &s->drawing->styles[stroke->layer];
    element(s, "path");
    path_data(s, &stroke->path);
    if (stroke->filled) {
        attribute_color(s, "fill", style->color);
        attribute(s, "stroke", "none");
    } else {
        attribute(s, "fill", "none");
        attribute_color(s, "stroke", style->color);
        attribute_number(s, "stroke-width", style->width, "");
        if (stroke->dashed)
            dashes(s, stroke->layer);
    }
    owner(s, stroke->part, stroke->source);
    if (stroke->tab != 0)
        attribute_integer(s, "data-tab", stroke->tab);
    if (stroke->contact != 0)
        attribute_integer(s, "data-contact", stroke->contact);
    element_end(s);
}

static void write_caption(svg *s, const kg_caption *caption) {
    static const char *const anchors[] = {"middle", "start", "end"};
    const double degrees = 180 / KG_PI;
    kg_vec2 base = kg_caption_baseline(caption);
    element(s, "text");
    attribute_number(s, "x", base.x, "");
    attribute_number(s, "y", base.y, "");
    if (caption->angle != 0) {
        kg_bytes_text(&s->scratch, "rotate(");
        kg_bytes_number(&s->scratch, caption->angle * degrees);
        scratch_point(s, base);
        kg_bytes_text(&s->scratch, ")");
        attribute_scratch(s, "transform");
    }
    attribute(s, "font-family", KG_TEXT_FAMILIES);
    attribute_number(s, "font-size", caption->capital / KG_TEXT_CAPITAL, "");
    attribute(s, "text-anchor", anchors[caption->align]);
    attribute_color(s, "fill", s->drawing->styles[caption->layer].color);
    attribute(s, "stroke", "none");
    owner(s, caption->part, caption->source);
    s->failed |= xmlTextWriterWriteString(s->xml, XML(caption->text)) < 0;
    element_end(s);
}

static void write_layer(svg *s, const kg_page *page, kg_net_layer layer) {
    bool open = false;
    for (size_t pass = 0; pass < 2; pass++) {
        size_t count = pass == 0 ? page->strokes.count : page->captions.count;
        for (size_t i = 0; i < count; i++) {
            kg_net_layer of =
                pass == 0 ? page->strokes.items[i].layer : page->captions.items[i].layer;
            if (of != layer)
                continue;
            if (!open) {
                element(s, "g");
                attribute(s, "inkscape:groupmode", "layer");
                attribute(s, "inkscape:label", kg_layer_label(layer));
                attribute(s, "id", kg_layer_id(layer));
                open = true;
            }
            if (pass == 0)
                write_stroke(s, &page->strokes.items[i]);
            else
                write_caption(s, &page->captions.items[i]);
        }
    }
    if (open)
        element_end(s);
}

static void write_document(svg *s, size_t page, kg_layers layers) {
    kg_vec2 size = s->drawing->size;
    s->failed |= xmlTextWriterSetIndent(s->xml, 1) < 0;
    s->failed |= xmlTextWriterStartDocument(s->xml, "1.0", "UTF-8", NULL) < 0;
    element(s, "svg");
    attribute(s, "xmlns", "http://www.w3.org/2000/svg");
    attribute(s, "xmlns:inkscape", "http://www.inkscape.org/namespaces/inkscape");
    attribute_number(s, "width", size.x, "mm");
    attribute_number(s, "height", size.y, "mm");
    kg_bytes_text(&s->scratch, "0 0 ");
    kg_bytes_number(&s->scratch, size.x);
    kg_bytes_text(&s->scratch, " ");
    kg_bytes_number(&s->scratch, size.y);
    attribute_scratch(s, "viewBox");
    if (*s->drawing->title) {
        element(s, "title");
        s->failed |= xmlTextWriterWriteString(s->xml, XML(s->drawing->title)) < 0;
        element_end(s);
    }
    for (int layer = 0; layer < KG_LAYER_COUNT; layer++)
        if (layers & 1u << layer)
            write_layer(s, &s->drawing->pages[page], (kg_net_layer)layer);
    element_end(s);
    s->failed |= xmlTextWriterEndDocument(s->xml) < 0;
}

kg_status kg_svg_page(kg_drawing *drawing, size_t page, kg_layers layers, kg_bytes *out,
                      kg_error *error) {
    xmlBufferPtr buffer = xmlBufferCreate();
    svg s = {.xml = buffer ? xmlNewTextWriterMemory(buffer, 0) : NULL, .drawing = drawing};
    if (s.xml)
        write_document(&s, page, layers);
    else
        s.failed = true;
    xmlFreeTextWriter(s.xml);
    if (!s.failed)
        kg_bytes_add(out, xmlBufferContent(buffer), (size_t)xmlBufferLength(buffer));
    if (buffer)
        xmlBufferFree(buffer);
    kg_bytes_clear(&s.scratch);
    if (s.failed || out->failed)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory while writing SVG");
    return KG_OK;
}
