/* What all pages of a guide are made from. */
#ifndef KG_GUIDE_GUIDE_H
#define KG_GUIDE_GUIDE_H

#include "guide/book.h"
#include "guide/stage.h"
#include "guide/words.h"
#include "katagami/guide.h"

enum { KG_SENTENCE = 768 }; /* bytes, enough for every sentence with long names */

typedef struct kg_guide {
    const char *title; /* of the model, else its file's name; NULL: it has neither */
    const kg_net *net;
    const kg_net_layout *layout;
    const kg_net_options *options;
    const kg_progress *progress; /* may be NULL */
    kg_assembly *assembly;
    kg_guide_order *order;
    kg_stage *stage;
    kg_book *paper;
} kg_guide;

/* Cover, list of parts, legend. */
kg_status kg_guide_opening(kg_guide *guide, kg_error *error) KG_CHECKED;

/* All pages of a folding sequence: its pictures, the signs, the crease pattern. */
kg_status kg_guide_folds(kg_guide *guide, const kg_origami *origami, kg_error *error) KG_CHECKED;

/* The parts of the net at full width, one below the other, each at most `height` mm high. */
void kg_guide_net(kg_guide *guide, double height);
/* A line of the net and what it means, in the left half of the page. */
void kg_guide_line_sign(kg_guide *guide, kg_word word, kg_net_kind kind);

/* All pages of a pop-up card: how it is cut and folded, pictures of it, the sheet. */
kg_status kg_guide_card(kg_guide *guide, const kg_document *document, kg_error *error) KG_CHECKED;

/* A block for each step. */
kg_status kg_guide_steps(kg_guide *guide, kg_error *error) KG_CHECKED;

/* "part 4 (dorsal fin)" */
char *kg_guide_part_name(const kg_guide *guide, int part, char *out, size_t size);

/* A picture of `size` mm at (x, y), with resolution fit for print. */
kg_status kg_guide_picture(kg_guide *guide, const kg_view_of *view, kg_stage_look look,
                           const kg_camera *camera, kg_vec2 at, kg_vec2 size,
                           kg_error *error) KG_CHECKED;

/* Calls progress; KG_ERR_CANCELLED. */
kg_status kg_guide_tick(const kg_guide *guide, double fraction, kg_error *error) KG_CHECKED;

#endif
