/* Pop-up cards as documents: what follows from a card, and what is wrong with it. */
#ifndef KG_DOCUMENT_CARD_H
#define KG_DOCUMENT_CARD_H

#include "katagami/document.h"

typedef struct kg_card {
    kg_oa *oa;
    double open;        /* angle between the sheets in meshes */
    kg_oa_sheet *sheet; /* NULL until solved, and all that follows */
    kg_oa_stability *stability;
    kg_oa_remarks *remarks;
    struct {
        kg_issue *items;
        size_t count, capacity;
    } issues;
} kg_card;

/* Takes the card over. NULL, with the card destroyed, when memory runs out. */
kg_card *kg_card_create(kg_oa *oa);
void kg_card_destroy(kg_card *card);

/* Lays out the sheet and says what is wrong. KG_ERR_MEMORY; KG_ERR_INPUT for a card that
 * kg_oa_check refuses. */
kg_status kg_card_solve(kg_card *card, kg_error *error) KG_CHECKED;

/* The net with all issues as remarks. A net of a card with faults is a net all the same. */
kg_status kg_card_net(const kg_card *card, kg_document_net *out_net, kg_error *error) KG_CHECKED;

#endif
