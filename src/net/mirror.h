/* Pages for printing on the back of the paper. */
#ifndef KG_NET_MIRROR_H
#define KG_NET_MIRROR_H

#include "net/drawing.h"

/* Mirrors every page about its vertical middle line, exchanges mountain and valley, which look the
 * other way from the back, and keeps text readable at its place. */
void kg_drawing_mirror(kg_drawing *drawing);

#endif
