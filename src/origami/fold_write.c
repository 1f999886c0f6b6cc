/* States to FOLD 1.2. */
#include "origami/exchange.h"

#include <stdio.h>
#include <stdlib.h>

kg_status kg_sheet_shifts(const kg_origami_state *s, size_t *out_count, kg_vec2 **out_shifts) {
    size_t n = 0;
    for (size_t i = 0; i < s->vertices.count; i++)
        n = (size_t)s->vertices.items[i].sheet + 1 > n ? (size_t)s->vertices.items[i].sheet + 1 : n;
    kg_vec2 *shifts = calloc(n + 1, sizeof *shifts);
    kg_box2 *boxes = malloc((n + 1) * sizeof *boxes);
    if (!shifts || !boxes) {
        free(shifts);
        free(boxes);
        return KG_ERR_MEMORY;
    }
    for (size_t k = 0; k < n; k++)
        boxes[k] = kg_box2_empty();
    for (size_t i = 0; i < s->vertices.count; i++)
        kg_box2_add(&boxes[s->vertices.items[i].sheet], s->vertices.items[i].paper);
    double right = n > 0 ? boxes[0].hi.x : 0, gap = ceil(s->size / 10);
    for (size_t k = 1; k < n; k++) {
        bool meets = false; /* whole steps, so that most coordinates stay exact */
        for (size_t j = 0; j < k; j++)
            meets |= boxes[k].lo.x <= boxes[j].hi.x + shifts[j].x &&
                     boxes[j].lo.x + shifts[j].x <= boxes[k].hi.x &&
                     boxes[k].lo.y <= boxes[j].hi.y && boxes[j].lo.y <= boxes[k].hi.y;
        if (meets)
            shifts[k].x = ceil(right - boxes[k].lo.x) + gap;
        right = fmax(right, boxes[k].hi.x + shifts[k].x);
    }
    free(boxes);
    *out_count = n;
    *out_shifts = shifts;
    return KG_OK;
}

static json_t *number(double x) {
    return x == floor(x) && fabs(x) < 1e15 ? json_integer((json_int_t)x) : json_real(x);
}

static json_t *numbers(const double *x, size_t n) {
    json_t *row = json_array();
    for (size_t i = 0; i < n; i++)
        json_array_append_new(row, number(x[i]));
    return row;
}

static const char *letter(const kg_paper_edge *e) {
    return e->kind == KG_PAPER_BORDER ? "B"
           : e->kind == KG_PAPER_JOIN ? "J"
           : e->kind == KG_PAPER_OPEN ? "U"
           : e->angle == 0            ? "F"
           : e->angle > 0             ? "V"
                                      : "M";
}

static void write_topology(const kg_origami_state *s, json_t *frame) {
    json_t *ends = json_array(), *letters = json_array(), *angles = json_array(),
           *faces = json_array();
    for (size_t e = 0; e < s->edges.count; e++) {
        const kg_paper_edge *edge = &s->edges.items[e];
        double degrees =
            fabs(edge->angle) == KG_PI ? copysign(180, edge->angle) : edge->angle * (180 / KG_PI);
        json_array_append_new(ends, json_pack("[i,i]", s->halves.items[2 * e].origin,
                                              s->halves.items[2 * e + 1].origin));
        json_array_append_new(letters, json_string(letter(edge)));
        json_array_append_new(angles, edge->kind == KG_PAPER_OPEN ? json_null() : number(degrees));
    }
    for (size_t i = 0; i < s->loops.count; i++) {
        json_t *face = json_array();
        int32_t first = s->loops.items[i].first, h = first;
        do
            json_array_append_new(face, json_integer(s->halves.items[h].origin));
        while ((h = kg_next(s, h)) != first);
        json_array_append_new(faces, face);
    }
    json_object_set_new(frame, "edges_vertices", ends);
    json_object_set_new(frame, "edges_assignment", letters);
    json_object_set_new(frame, "edges_foldAngle", angles);
    json_object_set_new(frame, "faces_vertices", faces);
}

static void write_positions(const kg_origami_state *s, json_t *frame) {
    json_t *points = json_array(), *orders = json_array();
    for (size_t i = 0; i < s->vertices.count; i++)
        json_array_append_new(points, numbers(&s->vertices.items[i].position.x, 3));
    /* [f, g, s]: f on the side s of g's front */
    kg_layer_order o = {0};
    while (kg_origami_next_order(s, &o))
        json_array_append_new(orders, json_pack("[i,i,i]", o.b, o.a, o.side));
    json_object_set_new(frame, "vertices_coords", points);
    json_object_set_new(frame, "faceOrders", orders);
}

static json_t *folded_frame(const kg_origami_state *s, bool inherits, size_t step) {
    json_t *f =
        json_pack("{s:[s], s:[s]}", "frame_classes", "foldedForm", "frame_attributes", "3D");
    if (inherits) {
        json_object_set_new(f, "frame_parent", json_integer(0));
        json_object_set_new(f, "frame_inherit", json_true());
    } else {
        char title[32];
        snprintf(title, sizeof title, "step %zu", step);
        json_object_set_new(f, "frame_title", json_string(title));
        write_topology(s, f);
    }
    write_positions(s, f);
    return f;
}

json_t *kg_fold_json(const kg_origami_state *s, kg_origami_state *const *states, size_t count,
                     const char *title) {
    size_t sheets;
    kg_vec2 *shifts;
    json_t *root = json_pack(
        "{s:f, s:s, s:[s], s:s, s:[s], s:[s], s:s}", "file_spec", 1.2, "file_creator", "katagami",
        "file_classes", count > 0 ? "diagrams" : "singleModel", "file_title", title,
        "frame_classes", "creasePattern", "frame_attributes", "2D", "frame_unit", "mm");
    if (!root || kg_sheet_shifts(s, &sheets, &shifts)) {
        json_decref(root);
        return NULL;
    }
    json_t *points = json_array(), *frames = json_array();
    for (size_t i = 0; i < s->vertices.count; i++) {
        const kg_paper_vertex *v = &s->vertices.items[i];
        kg_vec2 p = kg_add2(v->paper, shifts[v->sheet]);
        json_array_append_new(points, numbers(&p.x, 2));
    }
    free(shifts);
    json_object_set_new(root, "vertices_coords", points);
    write_topology(s, root);
    json_array_append_new(frames, folded_frame(s, true, 0));
    for (size_t i = 0; i < count; i++)
        json_array_append_new(frames, folded_frame(states[i], false, i));
    json_object_set_new(root, "file_frames", frames);
    return root;
}
