#include "model/naming.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Words for the two sides; those of letters have to stand alone. */
static const char *const sides[][2] = {{"L", "R"},        {"l", "r"},        {"left", "right"},
                                       {"Left", "Right"}, {"LEFT", "RIGHT"}, {"左", "右"}};

enum { SIDE_WORDS = sizeof sides / sizeof *sides, KANJI = SIDE_WORDS - 1 };

static bool is_taken(const kg_model *m, const char *name, int64_t but) {
    for (size_t i = 0; i < m->patch_count; i++)
        if (m->patches[i].id != but && strcmp(m->patches[i].name, name) == 0)
            return true;
    return false;
}

/* The name with `old_size` bytes at `at` replaced; NULL: out of memory. */
static char *replaced(const char *name, size_t at, size_t old_size, const char *word) {
    size_t size = strlen(name) - old_size + strlen(word) + 1;
    char *out = malloc(size);
    if (out)
        snprintf(out, size, "%.*s%s%s", (int)at, name, word, name + at + old_size);
    return out;
}

/* Finds the side that a name tells: how many bytes of it stand where, and the other side's word. */
static bool find_side(const char *name, size_t *out_at, size_t *out_size, const char **out_other) {
    size_t length = strlen(name);
    for (int i = 0; i < 2 * SIDE_WORDS; i++) {
        const char *word = sides[i / 2][i % 2];
        size_t size = strlen(word), at = length - size;
        *out_other = sides[i / 2][1 - i % 2];
        *out_size = size;
        if (size > length)
            continue;
        if (strcmp(name + at, word) == 0 &&
            (i / 2 == KANJI || at == 0 || !isalnum((unsigned char)name[at - 1]))) {
            *out_at = at;
            return true;
        }
        if (i / 2 == KANJI && strncmp(name, word, size) == 0) {
            *out_at = 0;
            return true;
        }
    }
    return false;
}

/* "ear 2" for "ear", "ear 3" for "ear 2": the first that is free. */
static char *numbered(const kg_model *m, const char *name, int64_t id) {
    size_t digits = strlen(name);
    while (digits > 0 && isdigit((unsigned char)name[digits - 1]))
        digits--;
    bool counts =
        name[digits] && strlen(name + digits) < 9 && digits > 1 && name[digits - 1] == ' ';
    size_t stem = counts ? digits - 1 : strlen(name), size = stem + 32;
    char *out = malloc(size);
    for (long n = counts ? atol(name + digits) + 1 : 2; out; n++) {
        snprintf(out, size, "%.*s %ld", (int)stem, name, n);
        if (!is_taken(m, out, id))
            break;
    }
    return out;
}

kg_status kg_model_name_copy(kg_model *model, int64_t id, bool mirrored, kg_error *error) {
    kg_model_patch *p = kg_model_find(model, id);
    if (!p)
        return kg_fail(error, KG_ERR_INPUT, "there is no patch %lld", (long long)id);
    if (!p->name[0])
        return KG_OK;
    size_t at, size;
    const char *other;
    char *name = mirrored && find_side(p->name, &at, &size, &other)
                     ? replaced(p->name, at, size, other)
                     : strdup(p->name);
    if (name && is_taken(model, name, id)) {
        char *next = numbered(model, name, id);
        free(name);
        name = next;
    }
    if (!name)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    free(p->name);
    p->name = name;
    return KG_OK;
}
