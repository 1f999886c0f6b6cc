/*
 * katagami: guides, how a model of any kind is made: in which order and how the parts of a net are
 * glued together, sheets folded step by step, a card cut and folded.
 *
 * The order of building follows from the joins of the net alone; the guide adds pictures and is
 * written as a PDF.
 */
#ifndef KATAGAMI_GUIDE_H
#define KATAGAMI_GUIDE_H

#include "katagami/document.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- the order of building -------------------------------------------------------------- */

typedef enum kg_guide_step_kind {
    KG_STEP_START,  /* a part that a sub-assembly begins with */
    KG_STEP_OWN,    /* a part is glued to itself (a tube, a cone) before it meets others */
    KG_STEP_ATTACH, /* a new part is glued to what stands */
    KG_STEP_CLOSE,  /* the part of the step before is glued along its other edges: a ring closes */
    KG_STEP_PLACE   /* a finished sub-assembly that no join holds is put where it belongs */
} kg_guide_step_kind;

typedef struct kg_guide_step {
    kg_guide_step_kind kind;
    int part;          /* index in the net; KG_STEP_PLACE: the part its sub-assembly began with */
    int component;     /* the sub-assembly, from 0, the main one */
    size_t join_count; /* glued in this step, in this order */
    const int *joins;  /* indices in the net */
    bool closing;      /* its last join closes a ring */
    bool seals;        /* afterwards no opening is left that fingers could reach through */
} kg_guide_step;

typedef struct kg_guide_order {
    size_t step_count;
    kg_guide_step *steps;
    size_t component_count;
    int *components; /* per part of the net */
    int *joins;      /* what the steps' lists point into */
} kg_guide_order;

typedef struct kg_guide_order_options {
    const bool *inside; /* per join: a contact glued on the back of the part that bears its mark,
                           reached from inside the model only; NULL: none */
    double opening;     /* mm of edge at the net's scale around the least opening that fingers
                           reach through, >= 0 */
} kg_guide_order_options;

/* No contacts inside; 60 mm, an opening about 20 mm wide. */
KG_API kg_guide_order_options kg_guide_order_options_default(void);

/*
 * In which order the parts are glued.
 *
 * Every connected group of parts is a sub-assembly, the one with the most paper first. It begins
 * with the largest part of its largest shell (parts held together by seams and inside contacts).
 * Then the next is always, of the parts that are joined to what stands,
 *   1. one of a shell that closes no ring,
 *   2. one held by outside contacts alone (a fin), when all it sits on stands: fins go on while
 *      the inside can still be reached to press against,
 *   3. one that closes a ring: its glued edges fall apart into several runs, or go all round it,
 *   4. a fin that sits on parts still missing,
 * and among those the one that has the largest share of its joins there already, so that no small
 * gap is left for the end, then the one with the longest, then the lower number. A part is glued
 * along all it touches, beginning with its longest join and going on along its outline; where it
 * closes a ring, it is first attached along one run (or edge), and closed in a step of its own.
 * Joins of a part with itself come before it is attached.
 *
 * Every part is in one START or ATTACH step, every join between parts of the net in one step.
 * Joins with a side in no part are left out. Errors: KG_ERR_MEMORY.
 */
KG_API kg_status kg_guide_order_create(const kg_net *net, const kg_guide_order_options *options,
                                       kg_guide_order **out_order, kg_error *error) KG_CHECKED;
KG_API void kg_guide_order_destroy(kg_guide_order *order);

/* ---- the guide -------------------------------------------------------------------------- */

/*
 * Writes the guide of a solved document as a PDF. Of patches: the model, its parts, the marks and
 * lines of the net, the steps with pictures. Of sheets: a drawing of every fold in the notation of
 * Yoshizawa and Randlett, with its line, its arrow and what to do in words, and the crease pattern;
 * a fold that the next one undoes shares its drawing. Of a card: how it is cut and folded, with
 * pictures of it on its way. Pages have the net's paper where it can be held in a hand (up to
 * letter, legal and A4), else A4. Starts OpenGL off-screen, but for sheets.
 *   net      from kg_document_unroll of the same document
 *   layout   of that net: the pages on which parts are found, the written scale; NULL, for sheets
 *            only: none is needed, as where they are larger than the paper
 *   options  the net was laid out with: what its lines look like
 * Errors: KG_ERR_SYSTEM (no off-screen OpenGL, no font), KG_ERR_CANCELLED, KG_ERR_IO,
 * KG_ERR_MEMORY.
 */
KG_API kg_status kg_guide_write(const kg_document *document, const kg_document_net *net,
                                const kg_net_layout *layout, const kg_net_options *options,
                                const char *path, const kg_progress *progress,
                                kg_error *error) KG_CHECKED;

/* The same bytes in memory, to be freed with free(). */
KG_API kg_status kg_guide_write_memory(const kg_document *document, const kg_document_net *net,
                                       const kg_net_layout *layout, const kg_net_options *options,
                                       const kg_progress *progress, char **out_data,
                                       size_t *out_size, kg_error *error) KG_CHECKED;

#ifdef __cplusplus
}
#endif
#endif
