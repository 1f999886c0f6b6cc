#include "app/history.h"

#include "base/array.h"
#include "model/edit.h"

#include <jansson.h>
#include <stdlib.h>
#include <string.h>

static void clear_step(kg_step *step) {
    kg_model_destroy(step->model);
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
    kg_step step = {before, strdup(label), state};
    if (!step.label || !kg_push(&h->undo, step)) {
        clear_step(&step);
        return kg_fail(error, KG_ERR_MEMORY, "out of memory: this step cannot be undone");
    }
    clear_steps(&h->redo);
    if (h->undo.count > KG_HISTORY_STEPS)
        drop_oldest(&h->undo);
    return KG_OK;
}

static bool exchange(kg_steps *from, kg_steps *to, kg_model *model, uint64_t *state) {
    if (from->count == 0 || !kg_reserve(to, to->count + 1))
        return false;
    kg_step step = from->items[--from->count];
    kg_model_swap(step.model, model);
    uint64_t previous = *state;
    *state = step.state;
    step.state = previous;
    to->items[to->count++] = step;
    return true;
}

bool kg_history_undo(kg_history *h, kg_model *model, uint64_t *state) {
    return exchange(&h->undo, &h->redo, model, state);
}

bool kg_history_redo(kg_history *h, kg_model *model, uint64_t *state) {
    return exchange(&h->redo, &h->undo, model, state);
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
static json_t *write_steps(const kg_steps *steps, const kg_model *now, size_t *left) {
    json_t *list = json_array();
    const kg_model *next = now;
    for (size_t i = steps->count; i-- > 0 && list;) {
        json_t *step = write_step(steps->items[i].model, next, steps->items[i].label);
        size_t size = step ? json_dumpb(step, NULL, 0, JSON_COMPACT) : *left + 1;
        if (size > *left) {
            json_decref(step);
            break;
        }
        *left -= size;
        if (json_array_insert_new(list, 0, step))
            break;
        next = steps->items[i].model;
    }
    return list;
}

kg_status kg_history_store(const kg_history *h, kg_model *now, kg_error *error) {
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

/* Puts the patches that the step left out, being those of the next state, into their places. */
static bool complete(kg_model *state, const json_t *order, const kg_model *next) {
    size_t count = json_array_size(order);
    kg_model *rest = kg_model_copy(next);
    kg_model_patch *patches = calloc(count + 1, sizeof *patches);
    bool ok = rest && patches;
    size_t done = 0;
    for (; done < count && ok; done++) {
        int64_t id = json_integer_value(json_array_get(order, done));
        kg_model_patch *p = kg_model_find(state, id);
        if (!p)
            p = kg_model_find(rest, id);
        ok = p != NULL && p->name != NULL;
        if (ok) {
            patches[done] = *p;
            *p = (kg_model_patch){.id = id}; /* taken: an id that comes twice finds nothing */
        }
    }
    if (ok) {
        kg_model_patch *emptied = state->patches;
        state->patches = patches;
        state->patch_count = count;
        free(emptied); /* each was in the order, or belongs to no state */
    } else {
        for (size_t i = 0; i + 1 < done; i++) /* back to where their owner frees them */
            *(kg_model_find(state, patches[i].id) ? kg_model_find(state, patches[i].id)
                                                  : kg_model_find(rest, patches[i].id)) =
                patches[i];
        free(patches);
    }
    kg_model_destroy(rest);
    return ok;
}

static kg_model *read_state(const json_t *step, const kg_model *next) {
    char *text = json_dumps(json_object_get(step, "model"), JSON_COMPACT);
    kg_model *state = NULL;
    if (!text || kg_model_read_memory(text, strlen(text), "history", &state, NULL))
        state = NULL;
    free(text);
    const json_t *order = json_object_get(step, "order");
    bool listed = true;
    for (size_t i = 0; state && i < state->patch_count; i++) {
        bool found = false;
        for (size_t k = 0; k < json_array_size(order); k++)
            found = found || json_integer_value(json_array_get(order, k)) == state->patches[i].id;
        listed = listed && found;
    }
    if (state && (!listed || !complete(state, order, next))) {
        kg_model_destroy(state);
        state = NULL;
    }
    if (state) { /* keys of the whole file belong to no step */
        json_decref(state->json);
        state->json = json_incref(next->json);
    }
    return state;
}

static void read_steps(const json_t *list, const kg_model *now, uint64_t *next_state,
                       kg_steps *out) {
    size_t count = json_array_size(list);
    const kg_model *next = now;
    kg_steps newest_first = {0};
    for (size_t i = count; i-- > 0;) {
        const json_t *entry = json_array_get(list, i);
        const char *label = json_string_value(json_object_get(entry, "label"));
        kg_step step = {read_state(entry, next), strdup(label ? label : ""), (*next_state)++};
        if (!step.model || !step.label || !kg_push(&newest_first, step)) {
            clear_step(&step);
            break;
        }
        next = step.model;
    }
    for (size_t i = 0; i < newest_first.count / 2; i++) {
        kg_step held = newest_first.items[i];
        newest_first.items[i] = newest_first.items[newest_first.count - 1 - i];
        newest_first.items[newest_first.count - 1 - i] = held;
    }
    *out = newest_first;
}

void kg_history_restore(kg_model *now, uint64_t *next_state, kg_history *out_history) {
    kg_history history = {0};
    json_t *stored = json_incref(json_object_get(now->json, "history"));
    json_t *rest = stored ? json_copy(now->json) : NULL;
    if (rest) {
        json_object_del(rest, "history");
        json_decref(now->json);
        now->json = rest;
        read_steps(json_object_get(stored, "undo"), now, next_state, &history.undo);
        read_steps(json_object_get(stored, "redo"), now, next_state, &history.redo);
    }
    json_decref(stored);
    *out_history = history;
}
