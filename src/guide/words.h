/* Every sentence of the guide, in one table to be translated. */
#ifndef KG_GUIDE_WORDS_H
#define KG_GUIDE_WORDS_H

#include "katagami/base.h"

typedef enum kg_word {
    KG_WORD_FOOTER,
    KG_WORD_UNTITLED,
    KG_WORD_GUIDE,
    KG_WORD_SIZE,
    KG_WORD_COUNTS,
    KG_WORD_WORK,
    KG_WORD_HOURS,
    KG_WORD_MINUTES,
    KG_WORD_PARTS,
    KG_WORD_PART,
    KG_WORD_PART_NAMED,
    KG_WORD_PAGE,
    KG_WORD_LEGEND,
    KG_WORD_AND,
    KG_WORD_CUT,
    KG_WORD_MOUNTAIN,
    KG_WORD_VALLEY,
    KG_WORD_MARK,
    KG_WORD_TAB,
    KG_WORD_NUMBERS,
    KG_WORD_RULINGS,
    KG_WORD_PICTURES,
    KG_WORD_GLUING,
    KG_WORD_SUBASSEMBLY,
    KG_WORD_START,
    KG_WORD_OWN,
    KG_WORD_ATTACH,
    KG_WORD_CLOSE,
    KG_WORD_PLACE,
    KG_WORD_FLAT,
    KG_WORD_ROLL_OUT,
    KG_WORD_ROLL_IN,
    KG_WORD_ROLL_BOTH,
    KG_WORD_FOLDS,
    KG_WORD_SEAM,
    KG_WORD_CONTACT,
    KG_WORD_CONTACT_INSIDE,
    KG_WORD_OWN_SEAM,
    KG_WORD_TABS_ON,
    KG_WORD_NO_TABS,
    KG_WORD_CLOSING,
    KG_WORD_SEALS,
    KG_WORD_PLACE_TEXT,
    KG_WORD_COUNT
} kg_word;

/* The sentence with its values filled in, cut off at a character within `size` bytes; returns
 * `out`. The table says which values, in which order. */
char *kg_words(char *out, size_t size, kg_word word, ...);

#endif
