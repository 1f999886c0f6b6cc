/*
 * Words for people. English is in the source; where the program that runs the kernel has bound the
 * catalogue of texts (src/app/language.c), they come out in its user's language.
 *
 * A text is looked up when a message is put together, by the functions that do that: kg_fail,
 * kg_fail_in, kg_read_fail, kg_issues_add and kg_phrase_print take the English format and look it
 * up; whatever else is said goes through kg_phrase. So formats are whole sentences: other languages
 * put their values in another order ("%2$s", all of a format's values then have a number). Words
 * that others decide (names, numbers, keys of files, messages of libraries) stay as they are.
 */
#ifndef KG_BASE_PHRASE_H
#define KG_BASE_PHRASE_H

#include "katagami/base.h"

#include <stdarg.h>

/* Marks a text that is looked up later: in a table, or chosen among several. */
#define N_(text) text

#ifdef __cplusplus
extern "C" {
#endif

/* The text in the user's language, or as it is where there is none. Any thread may ask; what is
 * returned stays valid. */
const char *kg_phrase(const char *text)
#if defined(__GNUC__)
    __attribute__((format_arg(1)))
#endif
    ;

/* snprintf of the format in the user's language; what is too long ends with a whole character. */
void kg_phrase_print(char *out_text, size_t size, const char *format, ...) KG_PRINTF(3, 4);
void kg_phrase_vprint(char *out_text, size_t size, const char *format, va_list values)
    KG_PRINTF(3, 0);

/* What went wrong in the system, by errno. */
const char *kg_phrase_of_errno(int code);

#ifdef __cplusplus
}
#endif
#endif
