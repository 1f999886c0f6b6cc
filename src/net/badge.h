/*
 * What tells the numbers on paper apart: parts stand in boxes, joins in rings, as in the guide; and
 * a line under those that read as another number upside down, as loose parts lie.
 */
#ifndef KG_NET_BADGE_H
#define KG_NET_BADGE_H

#include "net/drawing.h"

/* A caption as it is drawn: its number and, of parts, the name beside the box, where there is one.
 */
typedef struct kg_badge {
    char number[16];
    kg_caption pieces[2];
} kg_badge;

/* Splits a boxed caption at its first blank, others not at all; returns how many pieces there are.
 * Their texts last as long as the caption and `out_badge`. */
size_t kg_badge_split(const kg_caption *caption, kg_badge *out_badge);

/* Half width and half height of a caption with its name, frame and underline, mm. */
kg_vec2 kg_badge_half(const kg_caption *caption);

/* How far the frame reaches from the caption's centre in a direction (unit length, in the caption's
 * own axes). */
double kg_badge_reach(const kg_caption *caption, kg_vec2 way);

/* Adds the caption, a boxed one as two, its frame and its underline to the page. False when memory
 * runs out. */
bool kg_badge_draw(kg_page *page, const kg_caption *caption, const kg_net_part *part) KG_CHECKED;

#endif
