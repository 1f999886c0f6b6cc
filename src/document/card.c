#include "document/card.h"

#include "base/array.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Of each kind of trouble so many are named one by one. */
enum { NAMED = 10 };

/* Paper narrower than this tears when it is folded or lifted, mm. */
#define LEAST_WIDTH 2.0

kg_card *kg_card_create(kg_oa *oa) {
    kg_card *card = calloc(1, sizeof *card);
    if (!card) {
        kg_oa_destroy(oa);
        return NULL;
    }
    card->oa = oa;
    card->open = acos(0.0);
    return card;
}

static void forget(kg_card *card) {
    kg_oa_sheet_destroy(card->sheet);
    kg_oa_stability_destroy(card->stability);
    card->sheet = NULL;
    card->stability = NULL;
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

/* An issue to be worded, or NULL when memory runs out. */
static kg_issue *add_issue(kg_card *card, kg_severity severity, const char *code) {
    kg_issue issue = {.severity = severity, .code = code};
    return kg_push(&card->issues, issue) ? &card->issues.items[card->issues.count - 1] : NULL;
}

static void say(kg_issue *issue, const char *format, ...) KG_PRINTF(2, 3);

static void say(kg_issue *issue, const char *format, ...) {
    size_t used = strlen(issue->message);
    va_list args;
    va_start(args, format);
    vsnprintf(issue->message + used, sizeof issue->message - used, format, args);
    va_end(args);
}

/* A cell of the sheet by column and level (or, where it lies, by column and depth). */
static void say_cell(kg_issue *issue, const kg_oa_sheet *s, int x, int row) {
    int32_t place = s->place[(size_t)row * (size_t)s->width + (size_t)x];
    say(issue, "[%d,%d]", x - s->margin, s->height - 1 - row + (place >> 1));
}

/* Cells that a flood misses: those that `reached` says are reached by just `by`. */
static bool add_missed(kg_card *card, const unsigned char *reached, unsigned char by,
                       const char *code, const char *what) {
    const kg_oa_sheet *s = card->sheet;
    size_t cells = (size_t)s->width * (size_t)s->rows, count = 0;
    for (size_t i = 0; i < cells; i++)
        count += kg_oa_must_hold(s, i) && reached[i] == by;
    if (count == 0)
        return true;
    kg_issue *issue = add_issue(card, KG_FAULT, code);
    if (!issue)
        return false;
    say(issue, "%zu front cell%s %s:", count, count == 1 ? "" : "s", what);
    size_t named = 0;
    for (size_t i = 0; i < cells && named < NAMED; i++)
        if (kg_oa_must_hold(s, i) && reached[i] == by) {
            say(issue, " ");
            say_cell(issue, s, (int)(i % (size_t)s->width), (int)(i / (size_t)s->width));
            named++;
        }
    if (count > named)
        say(issue, " and %zu more", count - named);
    return true;
}

static kg_status find_missed(kg_card *card, kg_error *error) {
    size_t missing, cells = (size_t)card->sheet->width * (size_t)card->sheet->rows;
    unsigned char *reached = malloc(cells);
    if (!reached)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    kg_status status = kg_oa_flood(card->sheet, reached, &missing, error);
    if (!status && missing > 0 &&
        !(add_missed(card, reached, 0, "floating", "held by nothing ([column,level])") &&
          add_missed(card, reached, KG_OA_FROM_BASE, "not-lifted",
                     "not lifted by the back sheet ([column,level])") &&
          add_missed(card, reached, KG_OA_FROM_BACK, "not-carried",
                     "not carried by the base ([column,level])")))
        status = kg_fail(error, KG_ERR_MEMORY, "out of memory");
    free(reached);
    return status;
}

/* The edge of the sheet should stay plain, or there is nothing to hold the card by. */
static bool find_bare_edges(kg_card *card) {
    const kg_oa *oa = card->oa;
    bool sides = false, top = false, front = false;
    for (int x = 0; x < oa->width; x++) {
        bool side = x == 0 || x == oa->width - 1;
        sides |= side && kg_oa_depth(oa, x, 0) > 0;
        top |= kg_oa_depth(oa, x, oa->height - 1) > 0;
        front |= kg_oa_depth(oa, x, 0) == oa->depth_limit;
    }
    if (oa->margin_cells > 0 || !(sides || top || front))
        return true;
    kg_issue *issue = add_issue(card, KG_WARNING, "edge");
    if (issue)
        say(issue, "the model reaches the sheet's %s%s%s%s%s; margin_cells 1 would keep it plain",
            sides ? "sides" : "", sides && (top || front) ? ", " : "", top ? "upper edge" : "",
            top && front ? ", " : "", front ? "front edge" : "");
    return issue != NULL;
}

/* "upright y 3, x 2-5, z 1-4" */
static void say_patch(kg_issue *issue, const kg_oa_sheet *s, const kg_oa_patch *p) {
    int x0 = p->x0 - s->margin, x1 = p->x1 - 1 - s->margin, y = p->plane_id,
        z = p->plane_id - s->depth - 1;
    if (p->plane == KG_OA_BACK)
        say(issue, "upright y %d, x %d-%d, z %d-%d", y, x0, x1, s->height - p->row1 + y,
            s->height - 1 - p->row0 + y);
    else if (p->plane == KG_OA_FLOOR)
        say(issue, "level z %d, x %d-%d, y %d-%d", z, x0, x1, z - s->height + p->row0,
            z - s->height + p->row1 - 1);
    else
        say(issue, "slanting x %d-%d", x0, x1);
}

/* One issue for all patches that are loose and flaps, or loose and none. */
static bool add_loose(kg_card *card, bool flap) {
    const kg_oa_stability *s = card->stability;
    size_t count = 0, named = 0;
    for (size_t i = 0; i < s->patch_count; i++)
        count += !s->patches[i].stable && s->patches[i].flap == flap;
    if (count == 0)
        return true;
    kg_issue *issue = add_issue(card, KG_WARNING, flap ? "flap" : "loose");
    if (!issue)
        return false;
    say(issue,
        flap ? "%zu patch%s flaps, hanging on a single patch:"
             : "%zu patch%s loose, not following from the opening of the card:",
        count, count == 1 ? " is" : "es are");
    for (size_t i = 0; i < s->patch_count && named < NAMED; i++)
        if (!s->patches[i].stable && s->patches[i].flap == flap) {
            say(issue, named++ ? "; " : " ");
            say_patch(issue, card->sheet, &s->patches[i]);
        }
    if (count > named)
        say(issue, "; and %zu more", count - named);
    return true;
}

/* Counts hinges and strips between cuts that are narrower than LEAST_WIDTH on paper. */
static kg_status find_narrow(kg_card *card, kg_error *error) {
    const kg_oa_sheet *s = card->sheet;
    double cell = card->oa->cell_mm * card->oa->scale;
    size_t hinges = 0, necks = 0, count;
    kg_oa_line *lines;
    if (cell >= LEAST_WIDTH)
        return KG_OK;
    kg_status status = kg_oa_lines(s, &lines, &count, error);
    if (status)
        return status;
    for (size_t i = 0; i < count; i++) {
        double dx = lines[i].x1 - lines[i].x0, drow = lines[i].row1 - lines[i].row0;
        hinges += lines[i].kind != KG_OA_CUT && cell * hypot(dx, drow) < LEAST_WIDTH;
    }
    free(lines);
    for (int row = 0; row < s->rows; row++)
        for (int x = 0, begin = 0; x < s->width; x++)
            if (x + 1 == s->width || kg_oa_edge_right(s, x, row) == KG_OA_CUT) {
                necks += (x + 1 - begin) * cell < LEAST_WIDTH;
                begin = x + 1;
            }
    if (hinges + necks == 0)
        return KG_OK;
    kg_issue *issue = add_issue(card, KG_WARNING, "narrow");
    if (!issue)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    say(issue,
        "%zu folds are shorter and %zu rows of cells between cuts narrower than %g mm; cells of "
        "%.3g mm are small, draw the net larger or use fewer",
        hinges, necks, LEAST_WIDTH, cell);
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
        status = find_missed(card, error);
    if (!status && !(find_bare_edges(card) && add_loose(card, false) && add_loose(card, true)))
        status = kg_fail(error, KG_ERR_MEMORY, "out of memory");
    return status ? status : find_narrow(card, error);
}

/* ---- net -------------------------------------------------------------------------------- */

static kg_status add_remark(kg_document_net *net, const kg_issue *issue, kg_error *error) {
    char *message = strdup(issue->message);
    if (!message)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    net->remarks[net->remark_count++] = (kg_net_warning){0, issue->code, message};
    return KG_OK;
}

kg_status kg_card_net(const kg_card *card, kg_document_net *out_net, kg_error *error) {
    kg_document_net net = {.remarks = calloc(card->issues.count + 1, sizeof *net.remarks)};
    kg_status status = net.remarks ? kg_oa_net(card->oa, card->sheet, &net.net, error)
                                   : kg_fail(error, KG_ERR_MEMORY, "out of memory");
    for (size_t i = 0; i < card->issues.count && !status; i++)
        status = add_remark(&net, &card->issues.items[i], error);
    if (status)
        kg_document_net_clear(&net);
    else
        *out_net = net;
    return status;
}
