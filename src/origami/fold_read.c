/* FOLD 1.2 (Demaine, Ku, Lang 2016) to states. */
#include "origami/condition.h"
#include "origami/exchange.h"
#include "origami/solver.h"

#include <stdlib.h>
#include <string.h>

/* Work on patterns grows with the square of their lines. */
enum { MAX_EDGES = 20000 };

/* One frame: its own keys, then those it inherits. */
typedef struct frame {
    const json_t *own, *parent;
    size_t index; /* in file_frames from 1, 0: the file itself */
} frame;

static const json_t *find(const frame *f, const char *key) {
    const json_t *v = json_object_get(f->own, key);
    return v || !f->parent ? v : json_object_get(f->parent, key);
}

/* Points messages at a key of a frame. */
static void enter_key(kg_reader *p, const frame *f, const char *key, size_t base) {
    p->depth = base;
    if (f->index > 0 && json_object_get(f->own, key)) {
        kg_read_enter(p, "file_frames", 0);
        kg_read_enter(p, NULL, f->index - 1);
    }
    kg_read_enter(p, key, 0);
}

static bool has_class(const frame *f, const char *name) {
    const json_t *list = json_object_get(f->own, "frame_classes");
    for (size_t i = 0; i < json_array_size(list); i++) {
        const char *s = json_string_value(json_array_get(list, i));
        if (s && strcmp(s, name) == 0)
            return true;
    }
    return false;
}

static bool is_flat(const frame *f) {
    const json_t *list = find(f, "vertices_coords");
    for (size_t i = 0; i < json_array_size(list); i++)
        if (json_number_value(json_array_get(json_array_get(list, i), 2)) != 0)
            return false;
    return json_array_size(list) > 0;
}

static frame frame_at(const json_t *root, size_t index) {
    if (index == 0)
        return (frame){root, NULL, 0};
    const json_t *own = json_array_get(json_object_get(root, "file_frames"), index - 1);
    bool inherits = json_is_true(json_object_get(own, "frame_inherit")) &&
                    json_integer_value(json_object_get(own, "frame_parent")) == 0;
    return (frame){own, inherits ? root : NULL, index};
}

/* ---- the pattern ------------------------------------------------------------------------ */

static kg_status read_vertices(kg_reader *p, const json_t *list, kg_pattern *out) {
    kg_status status = KG_OK;
    for (size_t i = 0; i < json_array_size(list) && !status; i++) {
        double x[3] = {0};
        size_t n;
        kg_read_enter(p, NULL, i);
        status = kg_read_point(p, json_array_get(list, i), 2, x, &n);
        kg_read_leave(p);
        if (!status && !kg_push(&out->vertices, kg_v2(x[0], x[1])))
            status = KG_ERR_MEMORY;
    }
    return status;
}

static kg_status read_edge(kg_reader *p, const frame *f, size_t i, size_t base, kg_pattern *out) {
    kg_pattern_edge e = {.assignment = 'U', .angle = KG_PI};
    const json_t *ends = json_array_get(find(f, "edges_vertices"), i),
                 *letter = json_array_get(find(f, "edges_assignment"), i),
                 *angle = json_array_get(find(f, "edges_foldAngle"), i);
    enter_key(p, f, "edges_vertices", base);
    kg_read_enter(p, NULL, i);
    kg_status status =
        json_array_size(ends) == 2 ? KG_OK : kg_read_fail(p, "an edge has two vertices");
    for (size_t k = 0; k < 2 && !status; k++)
        status = kg_read_index(p, json_array_get(ends, k), 0, (int64_t)out->vertices.count - 1,
                               &e.ends[k]);
    if (!status && e.ends[0] == e.ends[1])
        status = kg_read_fail(p, "edge %zu begins and ends at vertex %d", i, e.ends[0]);
    if (status)
        return status;
    if (letter) {
        const char *s = json_string_value(letter);
        enter_key(p, f, "edges_assignment", base);
        kg_read_enter(p, NULL, i);
        if (!s || strlen(s) != 1 || !strchr("BMVFUCJ", s[0]))
            return kg_read_fail(p, "an assignment is one of B M V F U C J");
        e.assignment = s[0];
    }
    e.angle = e.assignment == 'M' ? -KG_PI : e.assignment == 'V' || e.assignment == 'U' ? KG_PI : 0;
    if (json_is_number(angle) && (e.assignment == 'M' || e.assignment == 'V')) {
        enter_key(p, f, "edges_foldAngle", base);
        kg_read_enter(p, NULL, i);
        status = kg_read_number(p, angle, 180, &e.angle);
        e.angle = fabs(e.angle) == 180 ? copysign(KG_PI, e.angle) : e.angle * (KG_PI / 180);
        if (!status && (e.assignment == 'M' ? e.angle > 0 : e.angle < 0))
            status = kg_read_fail(p, "mountains have angles below 0, valleys above");
    }
    if (!status && !kg_push(&out->edges, e))
        status = KG_ERR_MEMORY;
    return status;
}

static kg_status read_faces(kg_reader *p, const json_t *list, kg_pattern *out) {
    size_t most = 2 * out->edges.count; /* a face has both sides of a cut that ends in it */
    int32_t *corners = malloc((most + 1) * sizeof *corners);
    kg_status status = corners ? KG_OK : KG_ERR_MEMORY;
    for (size_t i = 0; i < json_array_size(list) && !status; i++) {
        const json_t *face = json_array_get(list, i);
        size_t n = json_array_size(face);
        double twice = 0;
        kg_read_enter(p, NULL, i);
        if (n < 3 || n > most)
            status =
                kg_read_fail(p, "a face has 3 or more vertices, and both sides of an edge at most");
        for (size_t k = 0; k < n && !status; k++)
            status = kg_read_index(p, json_array_get(face, k), 0, (int64_t)out->vertices.count - 1,
                                   &corners[k]);
        for (size_t k = 0; k < n && !status; k++)
            twice += kg_cross2(out->vertices.items[corners[k]],
                               out->vertices.items[corners[(k + 1) % n]]);
        for (size_t a = 0, b = n - 1; !status && twice < 0 && a < b; a++, b--) {
            int32_t swap = corners[a];
            corners[a] = corners[b], corners[b] = swap;
        }
        if (!status && twice == 0)
            status = kg_read_fail(p, "face %zu has no area", i);
        kg_read_leave(p);
        if (!status)
            status = kg_face_list_add(&out->faces, corners, n);
    }
    free(corners);
    return status;
}

static kg_status read_pattern(kg_reader *p, const frame *f, size_t base, kg_pattern *out) {
    const json_t *edges = find(f, "edges_vertices");
    enter_key(p, f, "vertices_coords", base);
    kg_status status = read_vertices(p, find(f, "vertices_coords"), out);
    if (!status && (json_array_size(edges) == 0 || json_array_size(edges) > MAX_EDGES))
        status = kg_read_fail(p, "a crease pattern has 1 to %d edges (edges_vertices)", MAX_EDGES);
    for (size_t i = 0; i < json_array_size(edges) && !status; i++)
        status = read_edge(p, f, i, base, out);
    enter_key(p, f, "faces_vertices", base);
    if (!status)
        status = read_faces(p, find(f, "faces_vertices"), out);
    return status;
}

/* ---- the unit --------------------------------------------------------------------------- */

/* mm; 0: the frame names none, or one without a length. */
static double unit_of(const frame *f) {
    static const struct {
        const char *name;
        double mm;
    } units[] = {{"mm", 1},         {"cm", 10},   {"m", 1000}, {"in", 25.4},
                 {"pt", 25.4 / 72}, {"um", 1e-3}, {"nm", 1e-6}};
    const char *name = json_string_value(find(f, "frame_unit"));
    for (size_t i = 0; name && i < sizeof units / sizeof *units; i++)
        if (strcmp(units[i].name, name) == 0)
            return units[i].mm;
    return 0;
}

static kg_status scale_pattern(kg_reader *p, const frame *f, kg_pattern *pattern,
                               kg_layer_report *report, double *out_scale) {
    double unit = unit_of(f), length = kg_pattern_length(pattern);
    double scale = unit > 0 ? unit : length > 0 ? KG_SHEET_SIZE / length : 1;
    for (size_t i = 0; i < pattern->vertices.count; i++) {
        kg_vec2 *v = &pattern->vertices.items[i];
        *v = kg_scale2(*v, scale);
        if (!(fabs(v->x) <= KG_MAX_COORDINATE && fabs(v->y) <= KG_MAX_COORDINATE))
            return kg_read_fail(p, "vertex %zu is more than %g mm away", i, KG_MAX_COORDINATE);
    }
    if (unit == 0)
        report->mm_per_unit = scale;
    pattern->unit = kg_v2(scale, scale);
    *out_scale = scale;
    return KG_OK;
}

/* ---- the folded form -------------------------------------------------------------------- */

/* Takes the positions of the folded form; faces must be congruent to the pattern's. */
static kg_status take_positions(kg_reader *p, const json_t *list, const kg_pattern *pattern,
                                double scale, kg_origami_state *s) {
    size_t count = pattern->vertices.count;
    if (json_array_size(list) != count)
        return kg_read_fail(p, "the folded form has %zu vertices, the crease pattern %zu",
                            json_array_size(list), count);
    for (size_t i = 0; i < count; i++) {
        double x[3] = {0};
        size_t n;
        kg_read_enter(p, NULL, i);
        kg_status status = kg_read_point(p, json_array_get(list, i), 2, x, &n);
        kg_read_leave(p);
        if (status)
            return status;
        s->vertices.items[i].position = kg_scale(kg_v3(x[0], x[1], x[2]), scale);
    }
    for (size_t i = 0; i < pattern->divided.count; i++)
        s->vertices.items[count + i].position =
            s->vertices.items[pattern->divided.items[i]].position;
    return kg_pattern_take(s, p->error);
}

/* Orders of faces to orders of the loops they were divided into. False when some overlap has none:
 * then they are solved for. */
static kg_status take_orders(kg_reader *p, const json_t *list, const kg_pattern *pattern,
                             kg_origami_state *s, bool *out_complete) {
    kg_outlines o = {0};
    int32_t faces = (int32_t)s->loops.count;
    if ((size_t)faces + 1 != pattern->faces.starts.count)
        return KG_OK; /* divided faces: let the solver find them */
    kg_status status = kg_outlines_create(s, &o);
    if (!status)
        status = kg_layers_create(s);
    for (size_t i = 0; i < json_array_size(list) && !status; i++) {
        const json_t *row = json_array_get(list, i);
        int32_t v[3];
        kg_read_enter(p, NULL, i);
        for (size_t k = 0; k < 3 && !status; k++)
            status = kg_read_index(p, json_array_get(row, k), k < 2 ? 0 : -1, k < 2 ? faces - 1 : 1,
                                   &v[k]);
        if (!status && v[0] == v[1])
            status = kg_read_fail(p, "face %d cannot lie on itself", v[0]);
        kg_read_leave(p);
        if (!status && v[2] != 0 && s->loops.items[v[0]].group == s->loops.items[v[1]].group &&
            kg_outlines_overlap(&o, v[0], v[1], s->touch)) {
            if (kg_origami_order(s, v[1], v[0]) != 0)
                status = kg_read_fail(p, "faces %d and %d are ordered twice", v[1], v[0]);
            kg_layer_put(s, &o, v[1], v[0], v[2] * o.facing[v[1]]);
        }
    }
    *out_complete = true;
    for (int32_t a = 0; a < faces && !status && *out_complete; a++)
        for (int32_t b = a + 1; b < faces && *out_complete; b++)
            *out_complete = s->loops.items[a].group != s->loops.items[b].group ||
                            !kg_outlines_overlap(&o, a, b, s->touch) || kg_origami_order(s, a, b);
    if (!status && *out_complete)
        status = kg_layers_check(s, &o, NULL, p->error);
    kg_outlines_clear(&o);
    return status;
}

/* ---- all -------------------------------------------------------------------------------- */

static kg_status read_state(kg_reader *p, const frame *flat, const frame *folded, bool in_mm,
                            kg_pattern *pattern, const kg_progress *progress,
                            kg_layer_report *report, kg_origami_state **out_state) {
    size_t base = p->depth;
    double scale = 1;
    kg_status status = read_pattern(p, flat, base, pattern);
    p->depth = base;
    if (!status && !in_mm)
        status = scale_pattern(p, flat, pattern, report, &scale);
    if (!status && pattern->faces.starts.count == 0 && !folded)
        status = kg_pattern_clean(pattern, p->error);
    if (!status && !folded)
        return kg_pattern_solve(pattern, progress, report, out_state, p->error);
    kg_origami_state *s = NULL;
    bool complete = false;
    if (!status)
        status = kg_pattern_state(pattern, &s, p->error);
    if (!status) {
        enter_key(p, folded, "vertices_coords", base);
        status = take_positions(p, find(folded, "vertices_coords"), pattern, scale, s);
    }
    if (!status) {
        enter_key(p, folded, "faceOrders", base);
        status = take_orders(p, json_object_get(folded->own, "faceOrders"), pattern, s, &complete);
    }
    p->depth = base;
    if (!status && !complete)
        status = kg_state_solve(s, progress, report, p->error);
    if (status)
        kg_state_destroy(s);
    else
        *out_state = s;
    return status;
}

kg_status kg_fold_read(kg_reader *p, const json_t *root, bool in_mm, const kg_progress *progress,
                       kg_layer_report *report, kg_origami_state **out_state) {
    size_t frames = 1 + json_array_size(json_object_get(root, "file_frames")), base = p->depth;
    frame flat = {0}, folded = {0};
    for (size_t i = 0; i < frames; i++) {
        frame f = frame_at(root, i);
        if (!flat.own && !has_class(&f, "foldedForm") && is_flat(&f))
            flat = f;
        else if (flat.own && !folded.own && has_class(&f, "foldedForm") &&
                 find(&f, "edges_vertices") == find(&flat, "edges_vertices") &&
                 find(&f, "vertices_coords") != find(&flat, "vertices_coords"))
            folded = f;
    }
    if (!flat.own)
        return kg_read_fail(p, "there is no crease pattern in it: a frame with flat "
                               "vertices_coords that is no foldedForm");
    kg_pattern pattern = {0};
    kg_status status = read_state(p, &flat, folded.own ? &folded : NULL, in_mm, &pattern, progress,
                                  report, out_state);
    p->depth = base;
    kg_pattern_clear(&pattern);
    return status;
}

kg_status kg_pattern_solve(kg_pattern *pattern, const kg_progress *progress,
                           kg_layer_report *report, kg_origami_state **out_state, kg_error *error) {
    kg_origami_state *s;
    kg_status status = kg_pattern_state(pattern, &s, error);
    if (status)
        return status;
    status = kg_pattern_fold(pattern, s, error);
    if (!status)
        status = kg_state_solve(s, progress, report, error);
    if (status) {
        kg_state_destroy(s);
        return status;
    }
    *out_state = s;
    return KG_OK;
}
