/*
 * DXF of AutoCAD 2000 (AC1015), the oldest that knows units and LWPOLYLINE and the newest that
 * every cutter's software reads. Structure after Autodesk's DXF reference for that release:
 * sections, the nine tables with their owners' handles, the two block records and their blocks,
 * and a root dictionary are what readers insist on. y points up in DXF: it is the page's height
 * less y, so that nothing is mirrored.
 */
#include "net/writers.h"

#include "net/text.h"

#include <stdio.h>
#include <string.h>

/* Handles of what is always there; entities are numbered from FIRST_ENTITY. */
enum {
    H_VPORT = 1,
    H_LTYPE,
    H_LAYER,
    H_STYLE,
    H_VIEW,
    H_UCS,
    H_APPID,
    H_DIMSTYLE,
    H_BLOCK_RECORD,
    H_DICTIONARY,
    H_GROUPS,
    H_MODEL,
    H_PAPER,
    H_FIRST_RECORD, /* linetypes, layers, style, application, blocks */
    FIRST_ENTITY = 0x100
};

typedef struct dxf {
    kg_bytes *out;
    const kg_drawing *drawing;
    double tolerance; /* of flattened curves, mm */
    int record, entity;
} dxf;

static void text(dxf *d, int code, const char *value) {
    char head[16];
    snprintf(head, sizeof head, "%3d\n", code);
    kg_bytes_text(d->out, head);
    kg_bytes_text(d->out, value);
    kg_bytes_text(d->out, "\n");
}

static void integer(dxf *d, int code, int value) {
    char digits[16];
    snprintf(digits, sizeof digits, "%d", value);
    text(d, code, digits);
}

static void handle(dxf *d, int code, int value) {
    char digits[16];
    snprintf(digits, sizeof digits, "%X", (unsigned)value);
    text(d, code, digits);
}

static void real(dxf *d, int code, double value) {
    char digits[KG_NUMBER_SIZE];
    kg_number_text(value, digits);
    if (!strchr(digits, '.'))
        strcat(digits, ".0");
    text(d, code, digits);
}

static void point(dxf *d, int code, double x, double y) {
    real(d, code, x);
    real(d, code + 10, y);
}

/* ---- header and tables
 * --------------------------------------------------------------------------- */

static void header(dxf *d, int entities) {
    kg_vec2 size = d->drawing->size;
    text(d, 0, "SECTION");
    text(d, 2, "HEADER");
    text(d, 9, "$ACADVER");
    text(d, 1, "AC1015");
    text(d, 9, "$DWGCODEPAGE");
    text(d, 3, "ANSI_1252");
    text(d, 9, "$HANDSEED");
    handle(d, 5, FIRST_ENTITY + entities);
    text(d, 9, "$INSUNITS");
    integer(d, 70, 4); /* millimetres */
    text(d, 9, "$MEASUREMENT");
    integer(d, 70, 1); /* metric */
    text(d, 9, "$EXTMIN");
    point(d, 10, 0, 0);
    real(d, 30, 0);
    text(d, 9, "$EXTMAX");
    point(d, 10, size.x, size.y);
    real(d, 30, 0);
    text(d, 0, "ENDSEC");
    text(d, 0, "SECTION");
    text(d, 2, "CLASSES");
    text(d, 0, "ENDSEC");
}

static void table(dxf *d, const char *name, int own, int count) {
    text(d, 0, "TABLE");
    text(d, 2, name);
    handle(d, 5, own);
    handle(d, 330, 0);
    text(d, 100, "AcDbSymbolTable");
    integer(d, 70, count);
    if (own == H_DIMSTYLE)
        text(d, 100, "AcDbDimStyleTable");
}

static void record(dxf *d, const char *type, int own, int owner, const char *class,
                   const char *name) {
    text(d, 0, type);
    handle(d, 5, own);
    handle(d, 330, owner);
    text(d, 100, "AcDbSymbolTableRecord");
    text(d, 100, class);
    text(d, 2, name);
}

static void empty_table(dxf *d, const char *name, int own) {
    table(d, name, own, 0);
    text(d, 0, "ENDTAB");
}

static const char *linetype(kg_net_layer layer) {
    return layer == KG_LAYER_MOUNTAIN ? "DASHDOT"
           : layer == KG_LAYER_VALLEY ? "DASHED"
                                      : "Continuous";
}

static void linetype_record(dxf *d, const char *name, const char *words, const double *dashes,
                            int count) {
    double length = 0;
    for (int i = 0; i < count; i++)
        length += dashes[i];
    record(d, "LTYPE", d->record++, H_LTYPE, "AcDbLinetypeTableRecord", name);
    integer(d, 70, 0);
    text(d, 3, words);
    integer(d, 72, 65);
    integer(d, 73, count);
    real(d, 40, length);
    for (int i = 0; i < count; i++) {
        real(d, 49, i % 2 == 0 ? dashes[i] : -dashes[i]); /* gaps are negative */
        integer(d, 74, 0);
    }
}

/* The nearest of AutoCAD's first nine colours; black paper's white stands for black. */
static int color_index(uint32_t color) {
    static const uint32_t colors[] = {0xff0000, 0xffff00, 0x00ff00, 0x00ffff, 0x0000ff,
                                      0xff00ff, 0x000000, 0x808080, 0xc0c0c0};
    int best = 0, least = 3 * 256 * 256;
    for (int i = 0; i < 9; i++) {
        int sum = 0;
        for (int shift = 0; shift < 24; shift += 8) {
            int step = (int)(color >> shift & 255) - (int)(colors[i] >> shift & 255);
            sum += step * step;
        }
        if (sum < least) {
            least = sum;
            best = i;
        }
    }
    return best + 1;
}

static void tables(dxf *d) {
    const double *dashes;
    int count;
    text(d, 0, "SECTION");
    text(d, 2, "TABLES");
    empty_table(d, "VPORT", H_VPORT);
    table(d, "LTYPE", H_LTYPE, 5);
    linetype_record(d, "ByBlock", "", NULL, 0);
    linetype_record(d, "ByLayer", "", NULL, 0);
    linetype_record(d, "Continuous", "Solid line", NULL, 0);
    count = kg_layer_dashes(KG_LAYER_MOUNTAIN, &dashes);
    linetype_record(d, linetype(KG_LAYER_MOUNTAIN), "Mountain fold", dashes, count);
    count = kg_layer_dashes(KG_LAYER_VALLEY, &dashes);
    linetype_record(d, linetype(KG_LAYER_VALLEY), "Valley fold", dashes, count);
    text(d, 0, "ENDTAB");
    table(d, "LAYER", H_LAYER, 1 + KG_LAYER_COUNT);
    for (int i = -1; i < KG_LAYER_COUNT; i++) {
        kg_net_layer layer = (kg_net_layer)i;
        record(d, "LAYER", d->record++, H_LAYER, "AcDbLayerTableRecord",
               i < 0 ? "0" : kg_layer_label(layer));
        integer(d, 70, 0);
        integer(d, 62, i < 0 ? 7 : color_index(d->drawing->styles[i].color));
        text(d, 6, i < 0 ? "Continuous" : linetype(layer));
    }
    text(d, 0, "ENDTAB");
    table(d, "STYLE", H_STYLE, 1);
    record(d, "STYLE", d->record++, H_STYLE, "AcDbTextStyleTableRecord", "Standard");
    integer(d, 70, 0);
    real(d, 40, 0);
    real(d, 41, 1);
    real(d, 50, 0);
    integer(d, 71, 0);
    real(d, 42, 2.5);
    text(d, 3, "txt");
    text(d, 4, "");
    text(d, 0, "ENDTAB");
    empty_table(d, "VIEW", H_VIEW);
    empty_table(d, "UCS", H_UCS);
    table(d, "APPID", H_APPID, 1);
    record(d, "APPID", d->record++, H_APPID, "AcDbRegAppTableRecord", "ACAD");
    integer(d, 70, 0);
    text(d, 0, "ENDTAB");
    empty_table(d, "DIMSTYLE", H_DIMSTYLE);
    table(d, "BLOCK_RECORD", H_BLOCK_RECORD, 2);
    record(d, "BLOCK_RECORD", H_MODEL, H_BLOCK_RECORD, "AcDbBlockTableRecord", "*Model_Space");
    record(d, "BLOCK_RECORD", H_PAPER, H_BLOCK_RECORD, "AcDbBlockTableRecord", "*Paper_Space");
    text(d, 0, "ENDTAB");
    text(d, 0, "ENDSEC");
}

static void block(dxf *d, int owner, const char *name) {
    text(d, 0, "BLOCK");
    handle(d, 5, d->record++);
    handle(d, 330, owner);
    text(d, 100, "AcDbEntity");
    if (owner == H_PAPER)
        integer(d, 67, 1);
    text(d, 8, "0");
    text(d, 100, "AcDbBlockBegin");
    text(d, 2, name);
    integer(d, 70, 0);
    point(d, 10, 0, 0);
    real(d, 30, 0);
    text(d, 3, name);
    text(d, 1, "");
    text(d, 0, "ENDBLK");
    handle(d, 5, d->record++);
    handle(d, 330, owner);
    text(d, 100, "AcDbEntity");
    if (owner == H_PAPER)
        integer(d, 67, 1);
    text(d, 8, "0");
    text(d, 100, "AcDbBlockEnd");
}

static void blocks(dxf *d) {
    text(d, 0, "SECTION");
    text(d, 2, "BLOCKS");
    block(d, H_MODEL, "*Model_Space");
    block(d, H_PAPER, "*Paper_Space");
    text(d, 0, "ENDSEC");
}

static void objects(dxf *d) {
    text(d, 0, "SECTION");
    text(d, 2, "OBJECTS");
    text(d, 0, "DICTIONARY");
    handle(d, 5, H_DICTIONARY);
    handle(d, 330, 0);
    text(d, 100, "AcDbDictionary");
    integer(d, 281, 1);
    text(d, 3, "ACAD_GROUP");
    handle(d, 350, H_GROUPS);
    text(d, 0, "DICTIONARY");
    handle(d, 5, H_GROUPS);
    handle(d, 330, H_DICTIONARY);
    text(d, 100, "AcDbDictionary");
    integer(d, 281, 1);
    text(d, 0, "ENDSEC");
}

/* ---- entities
 * ------------------------------------------------------------------------------------ */

static void entity(dxf *d, const char *type, kg_net_layer layer) {
    text(d, 0, type);
    handle(d, 5, FIRST_ENTITY + d->entity++);
    handle(d, 330, H_MODEL);
    text(d, 100, "AcDbEntity");
    text(d, 8, kg_layer_label(layer));
}

static int step_chords(const dxf *d, const kg_path_step *step, kg_vec2 b[4]) {
    if (step->verb != KG_PATH_CURVE)
        return 1;
    b[0] = kg_path_end(step - 1);
    for (int i = 0; i < 3; i++)
        b[i + 1] = step->p[i];
    return kg_bezier2_chords(b, d->tolerance, 100000);
}

static bool same(kg_vec2 a, kg_vec2 b) {
    return a.x == b.x && a.y == b.y;
}

/* One polyline from the move at `first` to before the next move, which is returned. */
static size_t polyline(dxf *d, const kg_stroke *stroke, size_t first) {
    const kg_path_step *steps = stroke->path.items;
    size_t end = first + 1;
    int vertices = 1;
    kg_vec2 b[4];
    bool closed = false;
    for (; end < stroke->path.count && steps[end].verb != KG_PATH_MOVE; end++) {
        closed |= steps[end].verb == KG_PATH_CLOSE;
        vertices += steps[end].verb == KG_PATH_CLOSE ? 0 : step_chords(d, &steps[end], b);
    }
    /* A closed polyline does not repeat its first vertex. */
    bool repeats =
        closed && end - first > 2 && same(kg_path_end(&steps[end - 2]), steps[first].p[0]);
    vertices -= repeats;
    if (vertices < 2)
        return end;
    entity(d, "LWPOLYLINE", stroke->layer);
    text(d, 100, "AcDbPolyline");
    integer(d, 90, vertices);
    integer(d, 70, closed ? 1 : 0);
    real(d, 43, 0);
    double height = d->drawing->size.y;
    for (size_t i = first; i < end && steps[i].verb != KG_PATH_CLOSE; i++) {
        int chords = step_chords(d, &steps[i], b);
        for (int k = 1; k <= chords && vertices > 0; k++, vertices--) {
            kg_vec2 p = chords > 1 ? kg_bezier2(b, (double)k / chords) : kg_path_end(&steps[i]);
            point(d, 10, p.x, height - p.y);
        }
    }
    return end;
}

/* UTF-8 as DXF 2000 has it: ASCII, and \U+XXXX for the rest. */
static void caption_text(dxf *d, const char *utf8) {
    kg_bytes_text(d->out, "  1\n");
    const char *s = utf8;
    while (*s) {
        uint32_t c = kg_text_character(&s);
        char code[16];
        if (c < 32 || c > 0xffff)
            snprintf(code, sizeof code, "?");
        else if (c < 127)
            snprintf(code, sizeof code, "%c", (char)c);
        else
            snprintf(code, sizeof code, "\\U+%04X", (unsigned)c);
        kg_bytes_text(d->out, code);
    }
    kg_bytes_text(d->out, "\n");
}

static void caption_entity(dxf *d, const kg_caption *caption) {
    static const int adjustments[] = {
        [KG_CAPTION_MIDDLE] = 1, [KG_CAPTION_START] = 0, [KG_CAPTION_END] = 2};
    kg_vec2 base = kg_caption_baseline(caption);
    double height = d->drawing->size.y;
    entity(d, "TEXT", caption->layer);
    text(d, 100, "AcDbText");
    point(d, 10, base.x, height - base.y);
    real(d, 30, 0);
    real(d, 40, caption->capital);
    caption_text(d, caption->text);
    real(d, 50, -caption->angle * 180 / KG_PI);
    integer(d, 72, adjustments[caption->align]); /* of the second point */
    point(d, 11, base.x, height - base.y);
    real(d, 31, 0);
    text(d, 100, "AcDbText");
}

static void entities(dxf *d, const kg_page *page, kg_layers layers) {
    text(d, 0, "SECTION");
    text(d, 2, "ENTITIES");
    for (size_t i = 0; i < page->strokes.count; i++) {
        const kg_stroke *stroke = &page->strokes.items[i];
        for (size_t k = 0; layers & 1u << stroke->layer && k < stroke->path.count;)
            k = polyline(d, stroke, k);
    }
    for (size_t i = 0; i < page->captions.count; i++)
        if (layers & 1u << page->captions.items[i].layer)
            caption_entity(d, &page->captions.items[i]);
    text(d, 0, "ENDSEC");
}

kg_status kg_dxf_page(kg_drawing *drawing, size_t page, kg_layers layers, kg_bytes *out,
                      kg_error *error) {
    kg_bytes body = {0};
    dxf d = {.out = &body,
             .drawing = drawing,
             .tolerance = drawing->flatten_tolerance,
             .record = H_FIRST_RECORD};
    tables(&d);
    blocks(&d);
    entities(&d, &drawing->pages[page], layers);
    objects(&d);
    text(&d, 0, "EOF");
    /* The header names the first free handle, so it is written last and put in front. */
    d.out = out;
    header(&d, d.entity);
    kg_bytes_add(out, body.items, body.count);
    bool failed = body.failed || out->failed;
    kg_bytes_clear(&body);
    return failed ? kg_fail(error, KG_ERR_MEMORY, "out of memory while writing DXF") : KG_OK;
}
