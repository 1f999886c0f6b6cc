#include "app/history.h"

#include "app/delta.h"
#include "base/array.h"

#include <jansson.h>
#include <stdlib.h>
#include <string.h>

static void clear_step(kg_step *step) {
    kg_document_destroy(step->content);
    json_decref(step->stored);
    free(step->label);
}

static void clear_steps(kg_steps *steps) {
    for (size_t i = 0; i < steps->count; i++)
        clear_step(&steps->items[i]);
    free(steps->items);
    *steps = (kg_steps){0};
}

static void drop_oldest(kg_steps *steps) {
    clear_step(&steps->items[0]);
    steps->count--;
    memmove(steps->items, steps->items + 1, steps->count * sizeof *steps->items);
}

/* ---- working ---------------------------------------------------------------------------- */

kg_status kg_history_push(kg_history *h, kg_document *before, uint64_t state, const char *label,
                          kg_error *error) {
    kg_step step = {before, NULL, strdup(label), state};
    if (!step.label || !kg_push(&h->undo, step)) {
        clear_step(&step);
        return kg_fail(error, KG_ERR_MEMORY, "out of memory: this step cannot be undone");
    }
    clear_steps(&h->redo);
    if (h->undo.count > KG_HISTORY_STEPS)
        drop_oldest(&h->undo);
    return KG_OK;
}

void kg_history_clear(kg_history *h) {
    clear_steps(&h->undo);
    clear_steps(&h->redo);
}

/* ---- to the file ------------------------------------------------------------------------ */

/* A document's file as a JSON tree. */
static json_t *tree_of(const kg_document *d) {
    char *text;
    size_t size;
    if (kg_document_write_memory(d, &text, &size, NULL))
        return NULL;
    json_t *tree = json_loadb(text, size, 0, NULL);
    free(text);
    return tree;
}

/* The newest steps that fit into `*left` bytes, oldest first. Both lists lead away from `now`. */
static json_t *write_steps(kg_steps *steps, const kg_document *now, size_t *left) {
    json_t *list = json_array(), *next = NULL;
    const kg_document *last = now; /* `next` is its tree, when one was wanted */
    for (size_t i = steps->count; i-- > 0 && list;) {
        kg_step *step = &steps->items[i];
        if (!step->stored) { /* so it has a content, and so has the one after it */
            json_t *from = next ? next : tree_of(last), *to = tree_of(step->content);
            json_t *delta = from && to ? kg_delta_create(from, to) : NULL;
            step->stored =
                delta ? json_pack("{s:s, s:o}", "label", step->label, "delta", delta) : NULL;
            json_decref(from);
            next = to;
        } else {
            json_decref(next);
            next = NULL;
        }
        size_t size = step->stored ? json_dumpb(step->stored, NULL, 0, JSON_COMPACT) : *left + 1;
        if (size > *left || json_array_insert(list, 0, step->stored))
            break;
        *left -= size;
        last = step->content;
    }
    json_decref(next);
    return list;
}

kg_status kg_history_store(kg_history *h, kg_document *now, kg_error *error) {
    size_t left = KG_HISTORY_FILE_BYTES;
    json_t **file = kg_document_json(now);
    json_t *root = *file ? json_copy(*file) : json_object(), *history = json_object();
    bool ok = root && history;
    if (ok && h->undo.count + h->redo.count > 0)
        ok = json_object_set_new(history, "undo", write_steps(&h->undo, now, &left)) == 0 &&
             json_object_set_new(history, "redo", write_steps(&h->redo, now, &left)) == 0 &&
             json_object_set(root, "history", history) == 0;
    else if (ok)
        json_object_del(root, "history");
    json_decref(history);
    if (!ok) {
        json_decref(root);
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    }
    json_decref(*file);
    *file = root;
    return KG_OK;
}

/* ---- from the file ---------------------------------------------------------------------- */

/* The content of a step that is still as it was in the file, `next` being the state it leads from.
 */
static bool understand(kg_step *step, kg_document *next) {
    if (step->content)
        return true;
    json_t *now = tree_of(next);
    json_t *tree = now ? kg_delta_apply(now, json_object_get(step->stored, "delta")) : NULL;
    char *text = tree ? json_dumps(tree, JSON_COMPACT) : NULL;
    kg_document *content = NULL;
    if (text && !kg_document_read_memory(text, strlen(text), "history", kg_document_path(next),
                                         &content, NULL))
        step->content = content;
    if (step->content && kg_document_get_kind(content) != kg_document_get_kind(next)) {
        kg_document_destroy(content);
        step->content = NULL;
    }
    if (step->content) { /* keys of the whole file belong to no step */
        json_decref(*kg_document_json(content));
        *kg_document_json(content) = json_incref(*kg_document_json(next));
    }
    free(text);
    json_decref(tree);
    json_decref(now);
    return step->content != NULL;
}

static bool exchange(kg_steps *from, kg_steps *to, kg_document *document, uint64_t *state) {
    if (from->count == 0 || !kg_reserve(to, to->count + 1))
        return false;
    if (!understand(&from->items[from->count - 1], document)) {
        clear_steps(from);
        return false;
    }
    kg_step step = from->items[--from->count];
    kg_document_swap(step.content, document);
    uint64_t previous = *state;
    *state = step.state;
    step.state = previous;
    json_decref(step.stored); /* it led the other way */
    step.stored = NULL;
    to->items[to->count++] = step;
    return true;
}

bool kg_history_undo(kg_history *h, kg_document *document, uint64_t *state) {
    return exchange(&h->undo, &h->redo, document, state);
}

bool kg_history_redo(kg_history *h, kg_document *document, uint64_t *state) {
    return exchange(&h->redo, &h->undo, document, state);
}

static void read_steps(const json_t *list, uint64_t *next_state, kg_steps *out) {
    for (size_t i = 0; i < json_array_size(list); i++) {
        json_t *stored = json_array_get(list, i);
        const char *label = json_string_value(json_object_get(stored, "label"));
        kg_step step = {NULL, json_incref(stored), strdup(label ? label : ""), (*next_state)++};
        if (!step.label || !kg_push(out, step)) {
            clear_step(&step);
            clear_steps(out); /* older ones alone lead nowhere */
            return;
        }
    }
}

void kg_history_restore(kg_document *now, uint64_t *next_state, kg_history *out_history) {
    kg_history history = {0};
    json_t **file = kg_document_json(now);
    json_t *stored = json_incref(json_object_get(*file, "history"));
    json_t *rest = stored ? json_copy(*file) : NULL;
    if (rest) {
        json_object_del(rest, "history");
        json_decref(*file);
        *file = rest;
        read_steps(json_object_get(stored, "undo"), next_state, &history.undo);
        read_steps(json_object_get(stored, "redo"), next_state, &history.redo);
    }
    json_decref(stored);
    *out_history = history;
}
