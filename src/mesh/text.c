#include "mesh/text.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

kg_text kg_text_of(const void *data, size_t size, bool continuations) {
    const char *begin = data;
    return (kg_text){begin, begin + size, 1, continuations};
}

static bool is_space(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

/* The length of a backslash and line end at p, or 0. */
static size_t continuation(const kg_text *t, const char *p) {
    if (!t->continuations || *p != '\\')
        return 0;
    const char *q = p + 1;
    while (q < t->end && is_space(*q))
        q++;
    return q < t->end && *q == '\n' ? (size_t)(q - p) + 1 : 0;
}

static void skip_spaces(kg_text *t) {
    while (t->at < t->end) {
        size_t n = continuation(t, t->at);
        if (n) {
            t->at += n;
            t->line++;
        } else if (is_space(*t->at)) {
            t->at++;
        } else {
            return;
        }
    }
}

bool kg_text_word(kg_text *t, kg_word *out_word) {
    skip_spaces(t);
    if (t->at == t->end || *t->at == '\n' || *t->at == '#')
        return false;
    out_word->s = t->at;
    while (t->at < t->end && *t->at != '\n' && !is_space(*t->at) && !continuation(t, t->at))
        t->at++;
    out_word->n = (size_t)(t->at - out_word->s);
    return true;
}

bool kg_text_word_anywhere(kg_text *t, kg_word *out_word) {
    while (!kg_text_word(t, out_word)) {
        if (!kg_text_next_line(t))
            return false;
    }
    return true;
}

kg_word kg_text_rest(kg_text *t) {
    skip_spaces(t);
    kg_word w = {t->at, 0};
    while (t->at < t->end && *t->at != '\n')
        t->at++;
    w.n = (size_t)(t->at - w.s);
    while (w.n && is_space(w.s[w.n - 1]))
        w.n--;
    return w;
}

bool kg_text_next_line(kg_text *t) {
    for (;;) {
        const char *p = memchr(t->at, '\n', (size_t)(t->end - t->at));
        if (!p) {
            t->at = t->end;
            return false;
        }
        const char *last = p;
        while (last > t->at && is_space(last[-1]))
            last--;
        bool joined = t->continuations && last > t->at && last[-1] == '\\';
        t->at = p + 1;
        t->line++;
        if (!joined)
            return true;
    }
}

bool kg_word_is(kg_word w, const char *s) {
    return strlen(s) == w.n && memcmp(w.s, s, w.n) == 0;
}

bool kg_word_double(kg_word w, double *out_value) {
    char copy[64]; /* longer numbers are nobody's */
    if (!w.n || w.n >= sizeof copy)
        return false;
    memcpy(copy, w.s, w.n);
    copy[w.n] = '\0';
    char *end;
    *out_value = strtod(copy, &end);
    return end == copy + w.n;
}

bool kg_word_int(kg_word w, int64_t *out_value) {
    char copy[24];
    if (!w.n || w.n >= sizeof copy)
        return false;
    memcpy(copy, w.s, w.n);
    copy[w.n] = '\0';
    char *end;
    errno = 0;
    *out_value = strtoll(copy, &end, 10);
    return end == copy + w.n && errno == 0;
}

bool kg_text_vec3(kg_text *t, kg_vec3 *out_value) {
    kg_word w[3];
    return kg_text_word(t, &w[0]) && kg_text_word(t, &w[1]) && kg_text_word(t, &w[2]) &&
           kg_word_double(w[0], &out_value->x) && kg_word_double(w[1], &out_value->y) &&
           kg_word_double(w[2], &out_value->z);
}
