/*
 * Words of a text file, line by line, from memory that need not end with a zero.
 */
#ifndef KG_MESH_TEXT_H
#define KG_MESH_TEXT_H

#include "katagami/base.h"

typedef struct kg_text {
    const char *at, *end;
    size_t line;        /* from 1 */
    bool continuations; /* a backslash at the end of a line joins it with the next (OBJ) */
} kg_text;

typedef struct kg_word {
    const char *s;
    size_t n;
} kg_word;

kg_text kg_text_of(const void *data, size_t size, bool continuations);

/* How many bytes lie behind the present place, of a text that began at `data`. */
static inline size_t kg_text_offset(const kg_text *t, const void *data) {
    return (size_t)(t->at - (const char *)data);
}

/* The next word of the current line; false at its end or at a word that starts with '#'. */
bool kg_text_word(kg_text *t, kg_word *out_word);

/* The next word, in whichever line it is. */
bool kg_text_word_anywhere(kg_text *t, kg_word *out_word);

/* What is left of the line without the spaces around it, comments included. */
kg_word kg_text_rest(kg_text *t);

/* Goes behind the end of the line; false at the end of the text. */
bool kg_text_next_line(kg_text *t);

bool kg_word_is(kg_word w, const char *s);

/* The whole word as a number ("." is the decimal point: callers hold the C locale); it may be
 * infinite or NaN. */
bool kg_word_double(kg_word w, double *out_value);
bool kg_word_int(kg_word w, int64_t *out_value);

/* Three numbers from the current line. */
bool kg_text_vec3(kg_text *t, kg_vec3 *out_value);

#endif
