/* Breaking text into lines, of Japanese too. */
#ifndef KG_APP_UI_WRAP_H
#define KG_APP_UI_WRAP_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/*
 * Puts line feeds into a text so that no line is wider than `width`: in place of spaces, and
 * between Japanese characters, but not before marks that may not begin a line nor behind ones that
 * may not end one. A word that is too wide for a line stays whole. `measure` is the width from one
 * byte to another. What `out` has no room for is cut off.
 */
void kg_ui_wrap(const char *text, double width, double (*measure)(const char *, const char *),
                char *out, size_t size);

#ifdef __cplusplus
}
#endif
#endif
