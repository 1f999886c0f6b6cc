/* What a document holds, apart from its place and from what follows from it: copied, compared,
 * exchanged, written to memory. Undo is made of these. */
#include "document/document.h"
#include "model/edit.h"
#include "origami/origami.h"

#include <assert.h>

kg_status kg_document_copy(const kg_document *d, kg_document **out_copy, kg_error *error) {
    kg_model *model = d->model ? kg_model_copy(d->model) : NULL;
    kg_oa *oa = d->card ? kg_oa_copy(d->card->oa) : NULL;
    kg_origami *origami = d->folded ? kg_origami_copy(d->folded->origami) : NULL;
    if (model)
        return kg_document_from_model(model, d->path, out_copy, error);
    if (oa) {
        kg_status status = kg_document_from_oa(oa, d->path, out_copy, error);
        if (!status)
            kg_document_set_open(*out_copy, d->card->open);
        return status;
    }
    if (origami)
        return kg_document_from_origami(origami, d->path, out_copy, error);
    return kg_fail(error, KG_ERR_MEMORY, "out of memory");
}

bool kg_document_equal(const kg_document *a, const kg_document *b) {
    if (a->kind != b->kind)
        return false;
    return a->model  ? kg_model_equal(a->model, b->model)
           : a->card ? kg_oa_equal(a->card->oa, b->card->oa)
                     : kg_origami_equal(a->folded->origami, b->folded->origami);
}

void kg_document_swap(kg_document *a, kg_document *b) {
    assert(a->kind == b->kind);
    if (a->model) {
        kg_model_swap(a->model, b->model);
    } else if (a->card) {
        kg_oa *oa = a->card->oa;
        a->card->oa = b->card->oa;
        b->card->oa = oa;
    } else {
        kg_origami *origami = a->folded->origami;
        a->folded->origami = b->folded->origami;
        b->folded->origami = origami;
        a->folded->step = kg_origami_step(a->folded->origami);
        b->folded->step = kg_origami_step(b->folded->origami);
    }
}

struct json_t **kg_document_json(kg_document *d) {
    return d->model ? &d->model->json : d->card ? &d->card->oa->json : &d->folded->origami->json;
}

kg_status kg_document_write_memory(const kg_document *d, char **out_text, size_t *out_size,
                                   kg_error *error) {
    return d->model  ? kg_model_write_memory(d->model, out_text, out_size, error)
           : d->card ? kg_oa_write_memory(d->card->oa, out_text, out_size, error)
                     : kg_origami_write_memory(d->folded->origami, out_text, out_size, error);
}
