#include "cli/paper.h"

#include <stdio.h>

typedef struct figures {
    size_t sheets, folds, faces, pairs;
    double mountain, valley; /* lengths of folded creases, mm */
} figures;

static figures measure(kg_document *d) {
    const kg_origami *o = kg_document_origami(d);
    const kg_origami_state *s = kg_origami_state_at(o, kg_origami_step(o));
    figures f = {
        .folds = kg_origami_step(o), .faces = s->loops.count, .pairs = kg_origami_pair_count(s)};
    for (size_t i = 0; i < s->loops.count; i++)
        f.sheets = (size_t)s->loops.items[i].sheet >= f.sheets ? (size_t)s->loops.items[i].sheet + 1
                                                               : f.sheets;
    for (size_t e = 0; e < s->edges.count; e++) {
        double length = kg_dist(s->vertices.items[s->halves.items[2 * e].origin].position,
                                s->vertices.items[s->halves.items[2 * e + 1].origin].position);
        *(s->edges.items[e].angle > 0 ? &f.valley : &f.mountain) +=
            s->edges.items[e].angle == 0 ? 0 : length;
    }
    return f;
}

/* What is known of the layers of a pattern; files that hold their order are counted now. False:
 * nothing. */
static bool find_layers(kg_document *d, kg_layer_report *out) {
    if (!kg_document_layers(d))
        return false;
    *out = *kg_document_layers(d);
    return out->states > 0 ||
           kg_origami_count_orders(kg_document_origami(d), NULL, out, NULL) == KG_OK;
}

void kg_paper_warn(const kg_document *d, const char *command) {
    const kg_layer_report *r = kg_document_layers(d);
    if (r && r->mm_per_unit > 0)
        fprintf(stderr,
                "katagami %s: warning: %s: it names no unit (frame_unit), so that it was "
                "made %g mm long: 1 became %.6g mm\n",
                command, kg_document_path(d), KG_SHEET_SIZE, r->mm_per_unit);
}

void kg_paper_print(kg_document *d) {
    figures f = measure(d);
    kg_layer_report r;
    const char *title = kg_document_title(d); /* patterns seldom have one */
    printf("%s%s%zu sheet%s, %zu folds, %zu faces, %zu pairs of layers on each other\n", title,
           *title ? ": " : "", f.sheets, f.sheets == 1 ? "" : "s", f.folds, f.faces, f.pairs);
    printf("mountain folds %.1f mm, valley folds %.1f mm\n", f.mountain, f.valley);
    if (find_layers(d, &r))
        printf("the layers of the crease pattern can lie in %s%g way%s: %zu independent choice%s\n",
               r.exact ? "" : "at least ", r.states, r.states == 1 ? "" : "s", r.components,
               r.components == 1 ? "" : "s");
}

json_t *kg_paper_json(kg_document *d) {
    figures f = measure(d);
    kg_layer_report r;
    json_t *o = json_pack("{s:I, s:I, s:I, s:I, s:f, s:f}", "sheets", (json_int_t)f.sheets, "folds",
                          (json_int_t)f.folds, "faces", (json_int_t)f.faces, "overlaps",
                          (json_int_t)f.pairs, "mountain_mm", f.mountain, "valley_mm", f.valley);
    if (find_layers(d, &r)) {
        json_object_set_new(o, "states", json_real(r.states));
        json_object_set_new(o, "states_exact", json_boolean(r.exact));
        json_object_set_new(o, "components", json_integer((json_int_t)r.components));
    }
    return o;
}
