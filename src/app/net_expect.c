/* Assertions of scripts about the net view. */
#include "app/expect.h"
#include "app/net_view.h"
#include "app/script.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* PART PAGE X Y [DEGREES]: where the part's origin lies, to a thousandth of a millimetre */
static kg_status expect_place(const kg_net_view *v, const kg_net_picture *p, const char *words,
                              kg_error *error) {
    int number, page;
    double x, y, angle = NAN;
    if (sscanf(words, "%d %d %lf %lf %lf", &number, &page, &x, &y, &angle) < 4 || number < 1 ||
        (size_t)number > p->net.net->part_count)
        return kg_fail(error, KG_ERR_INPUT, "net place needs PART PAGE X Y [DEGREES]");
    kg_net_placement is = kg_net_view_placement(v, (size_t)number - 1);
    double degrees = is.angle * 180 / KG_PI;
    bool same = is.page == page && kg_dist2(is.offset, kg_v2(x, y)) < 1e-3 &&
                (isnan(angle) || fabs(remainder(degrees - angle, 360)) < 1e-3);
    return same ? KG_OK
                : kg_fail(error, KG_ERR_INPUT, "part %d lies on page %d at %.4f %.4f, %.4f degrees",
                          number, is.page, is.offset.x, is.offset.y, degrees);
}

kg_status kg_script_expect_net(const kg_net_view *v, const kg_editor *e, const char *words,
                               kg_error *error) {
    const kg_net_picture *p = kg_net_state_picture(v->state);
    char what[32] = "";
    int read = 0;
    sscanf(words, "%31s %n", what, &read);
    if (strcmp(what, "error") == 0 && strstr(kg_net_state_error(v->state), words + read) &&
        kg_net_state_error(v->state)[0])
        return KG_OK;
    if (strcmp(what, "parts") == 0 && !p)
        return kg_expect_count(what, 0, words + read, error);
    if (!p)
        return kg_fail(error, KG_ERR_INPUT, "there is no net: %s", kg_net_state_error(v->state));
    const kg_net *net = p->net.net;
    size_t pinned = 0, clashes = 0;
    for (size_t i = 0; i < net->part_count; i++) {
        pinned += net->parts[i].pinned;
        clashes += kg_net_view_clash(v, i) != 0;
    }
    if (strcmp(what, "parts") == 0)
        return kg_expect_count(what, net->part_count, words + read, error);
    if (strcmp(what, "pages") == 0)
        return kg_expect_count(what, p->layout->page_count, words + read, error);
    if (strcmp(what, "joins") == 0)
        return kg_expect_count(what, net->join_count, words + read, error);
    if (strcmp(what, "tabs") == 0)
        return kg_expect_count(what, p->net.tab_count, words + read, error);
    if (strcmp(what, "pinned") == 0)
        return kg_expect_count(what, pinned, words + read, error);
    if (strcmp(what, "clashes") == 0)
        return kg_expect_count(what, clashes, words + read, error);
    if (strcmp(what, "join") == 0) /* under the pointer, by its number; 0: none */
        return kg_expect_count(what,
                               v->hover_join < 0 ? 0 : (size_t)net->joins[v->hover_join].number,
                               words + read, error);
    if (strcmp(what, "lit") == 0) { /* the same, also when the pointer is on it in the model */
        int lit = kg_net_view_lit_join(v, e);
        return kg_expect_count(what, lit < 0 ? 0 : (size_t)net->joins[lit].number, words + read,
                               error);
    }
    if (strcmp(what, "place") == 0)
        return expect_place(v, p, words + read, error);
    return kg_fail(error, KG_ERR_INPUT, "nothing is known about the net's \"%s\"", what);
}
