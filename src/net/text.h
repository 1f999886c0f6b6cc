/*
 * Text of captions: how wide it is, and its outlines.
 *
 * Widths come from a small table, so that pages look the same whatever fonts a machine has and no
 * font library has to start; outlines come from Pango.
 */
#ifndef KG_NET_TEXT_H
#define KG_NET_TEXT_H

#include "net/drawing.h"

/* Font families, the Japanese one first: its Latin letters are fine too. */
#define KG_TEXT_FAMILIES "IPAexGothic, Noto Sans CJK JP, sans-serif"

/* Height of capitals over font size, as most sans fonts have it. */
#define KG_TEXT_CAPITAL 0.73

/* The character of UTF-8 at *text, which moves behind it; bytes that are none count as one each. */
uint32_t kg_text_character(const char **text);

/* True for well-formed UTF-8 (no surrogates, nothing overlong). */
bool kg_text_valid(const char *text);

/* A copy in which what may not stand in a line of XML or a page, control characters and U+FFFE and
 * U+FFFF, is a blank; the caller frees it. NULL when memory runs out. */
char *kg_text_line(const char *text);

/* Width of `text` in font sizes, on the generous side: a full-width character is 1. */
double kg_text_width(const char *text);

/* Half width and half height of a caption's box, mm. */
kg_vec2 kg_caption_half(const kg_caption *caption);

/* Start, middle or end of the text, as it is aligned: at half its height, and on its baseline. */
kg_vec2 kg_caption_anchor(const kg_caption *caption);
kg_vec2 kg_caption_baseline(const kg_caption *caption);

/* What of the text is before its anchor: 0, 0.5 or 1. */
double kg_caption_share(const kg_caption *caption);

#endif
