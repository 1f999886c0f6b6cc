#include "app/history.h"

#include "base/array.h"
#include "model/edit.h"

#include <jansson.h>
#include <stdlib.h>
#include <string.h>

static void clear_step(kg_step *step) {
    kg_model_destroy(step->model);
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

kg_status kg_history_push(kg_history *h, kg_model *before, uint64_t state, const char *label,
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

/* The model as a JSON tree. */
static json_t *tree_of(const kg_model *m) {
    char *text;
    size_t size;
    if (kg_model_write_memory(m, &text, &size, NULL))
        return NULL;
    json_t *tree = json_loadb(text, size, 0, NULL);
    free(text);
    return tree;
}

/* A step as what `state` has and `next` has not. */
static json_t *write_step(const kg_model *state, const kg_model *next, const char *label) {
    kg_model part = *state;
    json_t *order = json_array(), *step = json_object();
    part.json = NULL;
    part.patch_count = 0;
    part.patches = calloc(state->patch_count + 1, sizeof *part.patches);
    bool ok = order && step && part.patches;
    for (size_t i = 0; i < state->patch_count && ok; i++) {
        const kg_model_patch *p = &state->patches[i], *q = kg_model_find(next, p->id);
        if (!q || !kg_model_patch_equal(p, q))
            part.patches[part.patch_count++] = *p;
        ok = json_array_append_new(order, json_integer(p->id)) == 0;
    }
    ok = ok && json_object_set(step, "order", order) == 0 &&
         json_object_set_new(step, "label", json_string(label)) == 0 &&
         json_object_set_new(step, "model", tree_of(&part)) == 0;
    free(part.patches);
    json_decref(order);
    if (ok)
        return step;
    json_decref(step);
    return NULL;
}

/* The newest steps that fit into `*left` bytes, oldest first. Both lists lead away from `now`. */
static json_t *write_steps(kg_steps *steps, const kg_model *now, size_t *left) {
    json_t *list = json_array();
    const kg_model *next = now;
    for (size_t i = steps->count; i-- > 0 && list;) {
        kg_step *step = &steps->items[i];
        if (!step->stored) /* so it has a model, and so has the one after it */
            step->stored = write_step(step->model, next, step->label);
        size_t size = step->stored ? json_dumpb(step->stored, NULL, 0, JSON_COMPACT) : *left + 1;
        if (size > *left || json_array_insert(list, 0, step->stored))
            break;
        *left -= size;
        next = step->model;
    }
    return list;
}

kg_status kg_history_store(kg_history *h, kg_model *now, kg_error *error) {
    size_t left = KG_HISTORY_FILE_BYTES;
    json_t *root = now->json ? json_copy(now->json) : json_object(), *history = json_object();
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
    json_decref(now->json);
    now->json = root;
    return KG_OK;
}

/* ---- from the file ---------------------------------------------------------------------- */

/* The object of a patch in a model's tree. */
static json_t *patch_in(const json_t *tree, json_int_t id) {
    const json_t *patches = json_object_get(tree, "patches");
    for (size_t i = 0; i < json_array_size(patches); i++) {
        json_t *patch = json_array_get(patches, i);
        if (json_integer_value(json_object_get(patch, "id")) == id)
            return patch;
    }
    return NULL;
}

/* The whole tree of a step: the patches that it left out are those of the next state. NULL: one is
 * in neither, or memory ran out. */
static json_t *complete(const json_t *step, const json_t *next) {
    const json_t *part = json_object_get(step, "model"), *order = json_object_get(step, "order");
    json_t *whole = json_copy((json_t *)(uintptr_t)part), *patches = json_array();
    bool ok = whole && patches;
    for (size_t i = 0; i < json_array_size(order) && ok; i++) {
        json_int_t id = json_integer_value(json_array_get(order, i));
        json_t *patch = patch_in(part, id);
        ok = json_array_append(patches, patch ? patch : patch_in(next, id)) == 0;
    }
    ok = ok && json_object_set(whole, "patches", patches) == 0;
    json_decref(patches);
    if (ok)
        return whole;
    json_decref(whole);
    return NULL;
}

static kg_model *model_of(const json_t *tree, const kg_model *now) {
    kg_model *model = NULL;
    char *text = json_dumps(tree, JSON_COMPACT);
    if (!text || kg_model_read_memory(text, strlen(text), "history", &model, NULL))
        model = NULL;
    free(text);
    if (model) { /* keys of the whole file belong to no step */
        json_decref(model->json);
        model->json = json_incref(now->json);
    }
    return model;
}

/* The model of a step that is still as it was in the file, `next` being the state it leads from. */
static bool understand(kg_step *step, const kg_model *next) {
    if (step->model)
        return true;
    json_t *now = tree_of(next), *tree = now ? complete(step->stored, now) : NULL;
    step->model = tree ? model_of(tree, next) : NULL;
    json_decref(tree);
    json_decref(now);
    return step->model != NULL;
}

static bool exchange(kg_steps *from, kg_steps *to, kg_model *model, uint64_t *state) {
    if (from->count == 0 || !kg_reserve(to, to->count + 1))
        return false;
    if (!understand(&from->items[from->count - 1], model)) {
        clear_steps(from);
        return false;
    }
    kg_step step = from->items[--from->count];
    kg_model_swap(step.model, model);
    uint64_t previous = *state;
    *state = step.state;
    step.state = previous;
    json_decref(step.stored); /* it led the other way */
    step.stored = NULL;
    to->items[to->count++] = step;
    return true;
}

bool kg_history_undo(kg_history *h, kg_model *model, uint64_t *state) {
    return exchange(&h->undo, &h->redo, model, state);
}

bool kg_history_redo(kg_history *h, kg_model *model, uint64_t *state) {
    return exchange(&h->redo, &h->undo, model, state);
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

void kg_history_restore(kg_model *now, uint64_t *next_state, kg_history *out_history) {
    kg_history history = {0};
    json_t *stored = json_incref(json_object_get(now->json, "history"));
    json_t *rest = stored ? json_copy(now->json) : NULL;
    if (rest) {
        json_object_del(rest, "history");
        json_decref(now->json);
        now->json = rest;
        read_steps(json_object_get(stored, "undo"), next_state, &history.undo);
        read_steps(json_object_get(stored, "redo"), next_state, &history.redo);
    }
    json_decref(stored);
    *out_history = history;
}
