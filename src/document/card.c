#include "document/card.h"

#include "base/array.h"
#include "base/phrase.h"
#include "document/document.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Of each kind of trouble so many places are named. */
enum { NAMED = 4 };

kg_card *kg_card_create(kg_oa *oa) {
    kg_card *card = calloc(1, sizeof *card);
    if (!card) {
        kg_oa_destroy(oa);
        return NULL;
    }
    card->oa = oa;
    card->open = KG_PI / 2;
    return card;
}

static void forget(kg_card *card) {
    kg_oa_sheet_destroy(card->sheet);
    kg_oa_stability_destroy(card->stability);
    kg_oa_remarks_destroy(card->remarks);
    card->sheet = NULL;
    card->stability = NULL;
    card->remarks = NULL;
    card->issues.count = 0;
}

void kg_card_destroy(kg_card *card) {
    if (!card)
        return;
    forget(card);
    free(card->issues.items);
    kg_oa_destroy(card->oa);
    free(card);
}

/* ---- issues ----------------------------------------------------------------------------- */

/* One issue for remarks of the same trouble: their places, the reason, what helps. */
static bool add_issue(kg_card *card, const kg_oa_remark *remarks, size_t count) {
    kg_oa_trouble trouble = remarks->trouble;
    kg_issue issue = {.severity = kg_oa_is_fault(trouble) ? KG_FAULT : KG_WARNING,
                      .code = kg_oa_trouble_code(trouble)};
    char places[NAMED * 160] = "", place[160];
    for (size_t i = 0, used = 0; i < count && i < NAMED; i++, used = strlen(places)) {
        kg_oa_remark_place(&remarks[i], place, sizeof place);
        snprintf(places + used, sizeof places - used, "%s%s", i > 0 ? kg_phrase("; ") : "", place);
    }
    size_t used = strlen(places);
    if (count > NAMED)
        kg_phrase_print(places + used, sizeof places - used, "; and %zu more places",
                        count - NAMED);
    kg_phrase_print(issue.message, sizeof issue.message, "%s: %s; %s", places,
                    kg_oa_trouble_reason(trouble), kg_oa_trouble_advice(trouble));
    return kg_push(&card->issues, issue);
}

static kg_status add_issues(kg_card *card, kg_error *error) {
    const kg_oa_remarks *r = card->remarks;
    for (size_t i = 0, end; i < r->count; i = end) {
        for (end = i; end < r->count && r->items[end].trouble == r->items[i].trouble; end++)
            ;
        if (!add_issue(card, &r->items[i], end - i))
            return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    }
    return KG_OK;
}

kg_status kg_card_solve(kg_card *card, kg_error *error) {
    forget(card);
    kg_status status = kg_oa_check(card->oa, error);
    if (!status)
        status = kg_oa_sheet_create(card->oa, &card->sheet, error);
    if (!status)
        status = kg_oa_stability_create(card->sheet, &card->stability, error);
    if (!status)
        status =
            kg_oa_remarks_create(card->oa, card->sheet, card->stability, &card->remarks, error);
    return status ? status : add_issues(card, error);
}

/* ---- net -------------------------------------------------------------------------------- */

kg_status kg_card_net(const kg_card *card, kg_document_net *out_net, kg_error *error) {
    kg_document_net net = {0};
    kg_status status = kg_oa_net(card->oa, card->sheet, &net.net, error);
    for (size_t i = 0; i < card->issues.count && !status; i++)
        status = kg_document_net_remark(&net, 0, card->issues.items[i].code,
                                        card->issues.items[i].message, error);
    if (status)
        kg_document_net_clear(&net);
    else
        *out_net = net;
    return status;
}
