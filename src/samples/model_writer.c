#include "samples/model_writer.h"

#include <assert.h>

sample_patch *sample_add(sample_model *model, const char *name, const kg_patch_input *input) {
    assert(model->count < SAMPLE_MAX_PATCHES);
    sample_patch *p = &model->patches[model->count++];
    *p = (sample_patch){.id = (int)model->count, .name = name, .input = *input};
    return p;
}

sample_patch *sample_find(sample_model *model, int id) {
    assert(id > 0 && (size_t)id <= model->count);
    return &model->patches[id - 1];
}

static kg_vec3 mirrored(kg_vec3 p) {
    return kg_v3(p.x, -p.y, p.z);
}

/* The Darboux vector is an axial one: mirrored, it also changes its sign, and u with it. A given
 * ruling is an ordinary vector. The front stays the front either way, except that with a ruling it
 * is the axial p' x d that changes. */
sample_patch *sample_mirror(sample_model *model, const char *name, const sample_patch *of) {
    sample_patch *p = sample_add(model, name, &of->input);
    int id = p->id;
    *p = *of;
    p->id = id;
    p->name = name;
    double sign = of->input.has_ruling ? 1 : -1;
    for (size_t i = 0; i < p->input.point_count; i++)
        p->input.points[i] = mirrored(p->input.points[i]);
    p->input.ruling = mirrored(p->input.ruling);
    p->input.flip = of->input.flip != of->input.has_ruling;
    p->input.extent[0] = sign * of->input.extent[sign < 0];
    p->input.extent[1] = sign * of->input.extent[sign > 0];
    for (size_t i = 0; i < p->trim_count; i++) {
        p->trims[i].keep = mirrored(p->trims[i].keep);
        for (size_t k = 0; k < p->trims[i].count; k++)
            p->trims[i].contour[k].x *= sign;
    }
    return p;
}

static sample_trim *add_trim(sample_patch *patch, sample_trim_kind kind) {
    assert(patch->trim_count < SAMPLE_MAX_TRIMS);
    sample_trim *t = &patch->trims[patch->trim_count++];
    t->kind = kind;
    return t;
}

void sample_cut(sample_patch *patch, int by, kg_vec3 keep) {
    sample_trim *t = add_trim(patch, SAMPLE_KEEP);
    t->by[0] = by;
    t->keep = keep;
}

void sample_split(sample_patch *patch, int by) {
    add_trim(patch, SAMPLE_SPLIT)->by[0] = by;
}

void sample_enclose(sample_patch *patch, int first, int last) {
    assert(last - first < SAMPLE_MAX_BY);
    sample_trim *t = add_trim(patch, SAMPLE_ENCLOSE);
    for (int id = first; id <= last; id++)
        t->by[id - first] = id;
}

sample_trim *sample_contour(sample_patch *patch, sample_trim_kind kind) {
    return add_trim(patch, kind);
}

void sample_hole(sample_patch *patch, kg_vec2 middle, double radius, double stretch) {
    enum { STEPS = 40 };
    const double turn = 6.283185307179586;
    kg_curve curve;
    kg_status status = kg_curve_init(patch->input.points, patch->input.point_count, &curve, NULL);
    assert(status == KG_OK);
    kg_vec3 d[2];
    kg_curve_derivatives(&curve, middle.y, 1, d);
    double radius_v = status == KG_OK ? stretch * radius / kg_len(d[1]) : 0;
    sample_trim *hole = sample_contour(patch, SAMPLE_HOLE);
    for (int i = 0; i < STEPS; i++)
        hole->contour[hole->count++] = kg_v2(middle.x + radius * cos(turn * i / STEPS),
                                             middle.y + radius_v * sin(turn * i / STEPS));
}

/* ---- text ------------------------------------------------------------------------------ */

static void write_point(text *out, kg_vec3 p, int decimals) {
    text_add(out, "[");
    text_number(out, p.x, decimals);
    text_add(out, ", ");
    text_number(out, p.y, decimals);
    text_add(out, ", ");
    text_number(out, p.z, decimals);
    text_add(out, "]");
}

static void write_contour(text *out, const sample_trim *t) {
    text_add(out, "{\"contour\": [");
    for (size_t i = 0; i < t->count; i++) {
        text_add(out, i == 0 ? "[" : i % 6 == 0 ? ",\n     [" : ", [");
        text_number(out, t->contour[i].x, 3);
        text_add(out, ", ");
        text_number(out, t->contour[i].y, 5);
        text_add(out, "]");
    }
    text_add(out, "],\n     \"keep\": \"%s\"}", t->kind == SAMPLE_OUTLINE ? "inside" : "outside");
}

static void write_trim(text *out, const sample_trim *t) {
    if (t->count > 0) {
        write_contour(out, t);
        return;
    }
    text_add(out, "{\"by\": [%d", t->by[0]);
    for (int i = 1; i < SAMPLE_MAX_BY && t->by[i] != 0; i++)
        text_add(out, ", %d", t->by[i]);
    text_add(out, "]");
    if (t->kind == SAMPLE_ENCLOSE)
        text_add(out, ", \"inside\": true");
    if (t->kind == SAMPLE_KEEP) {
        text_add(out, ", \"keep\": [");
        write_point(out, t->keep, 1);
        text_add(out, "]");
    }
    text_add(out, "}");
}

static void write_patch(text *out, const sample_patch *p) {
    text_add(out, "  {\"id\": %d, \"name\": \"%s\",\n   \"points\": [", p->id, p->name);
    for (size_t i = 0; i < p->input.point_count; i++) {
        text_add(out, i == 0 ? "" : i == 3 && p->input.point_count > 4 ? ",\n    " : ", ");
        write_point(out, p->input.points[i], 6);
    }
    text_add(out, "],\n   \"extent\": [");
    text_number(out, p->input.extent[0], 3);
    text_add(out, ", ");
    text_number(out, p->input.extent[1], 3);
    text_add(out, "]");
    if (p->input.has_ruling) {
        text_add(out, ", \"ruling\": ");
        write_point(out, p->input.ruling, 4);
    }
    if (p->input.flip)
        text_add(out, ", \"flip\": true");
    if (p->construction)
        text_add(out, ", \"construction\": true");
    for (size_t i = 0; i < p->trim_count; i++) {
        text_add(out, i == 0 ? ",\n   \"trims\": [\n    " : ",\n    ");
        write_trim(out, &p->trims[i]);
    }
    text_add(out, p->trim_count > 0 ? "]}" : "}");
}

bool sample_write(const sample_model *model, text *out) {
    text_add(out, "{\"katagami\": 1, \"kind\": \"patches\", \"title\": \"%s\",\n", model->title);
    if (model->reference)
        text_add(out, " \"reference\": {\"file\": \"%s\", \"visible\": true, \"opacity\": 0.4},\n",
                 model->reference);
    text_add(out,
             " \"net\": {\"paper\": \"A4\", \"margin\": 8, \"scale\": %s, \"tab_width\": 5},\n"
             " \"patches\": [\n",
             model->scale ? model->scale : "1");
    for (size_t i = 0; i < model->count; i++) {
        write_patch(out, &model->patches[i]);
        text_add(out, i + 1 < model->count ? ",\n" : "\n");
    }
    text_add(out, " ]}\n");
    return !out->failed;
}
