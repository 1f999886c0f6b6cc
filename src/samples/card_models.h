/* Pop-up cards: made cell by cell, and one of a mesh. */
#ifndef KG_SAMPLES_CARD_MODELS_H
#define KG_SAMPLES_CARD_MODELS_H

#include "samples/text.h"

/* A tower of three blocks on each other. */
kg_status tower_card_write(text *out, kg_error *error) KG_CHECKED;

/* A house with a stepped roof, windows and a door. */
kg_status house_card_write(text *out, kg_error *error) KG_CHECKED;

/* Two pyramids back to back and a notch, with 45° folds. */
kg_status pyramids_card_write(text *out, kg_error *error) KG_CHECKED;

/* The castle's mesh as a card. */
kg_status castle_card_write(text *out, kg_error *error) KG_CHECKED;

#endif
