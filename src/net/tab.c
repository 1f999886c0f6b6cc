#include "net/tab.h"

#include "net/tab_merge.h"
#include "net/tab_place.h"
#include "net/tab_settle.h"

#include "base/array.h"
#include "base/phrase.h"

#include <stdlib.h>
#include <string.h>

/* A side must hold this much more glue surface to be preferred for it, and bulge this much more
 * (radians) to be preferred for that. */
static const double CLEARLY_MORE = 1.03, CLEARLY_ROUNDER = 0.02;
/* mm of an edge that may stay without a tab at a sharp corner before a remark says so. */
static const double CORNER_LOSS = 0.1;
/* Share of a height by which a tab may be lower before a remark says so. */
static const double HEIGHT_LOSS = 0.1;
/* mm by which the bases of two joins may overlap on one edge. */
static const double SHARED = 1e-3;

enum { TROUBLES = KG_TAB_MOVED + 1, REASONS = KG_TAB_NO_EDGE + 1 };

typedef struct tabber {
    const kg_net *net;
    kg_tab_options options;
    GEOSContextHandle_t geos;
    kg_tab_ground *grounds; /* per part, like the lists and contours below */
    kg_tab_list *tabs;
    kg_tab_contour **contours; /* per part, per loop */
    int *sides;                /* per join: where its tabs are; -1: nowhere */
} tabber;

kg_tab_options kg_tab_options_default(void) {
    return (kg_tab_options){.width = 5, .least = 1.2};
}

void kg_tab_report_clear(kg_tab_report *report) {
    free(report->remarks);
    *report = (kg_tab_report){0};
}

/* ---- which side ------------------------------------------------------------------------- */

static bool is_edge(const kg_net_side *side) {
    return side->part >= 0 && side->loop >= 0;
}

static const double *bend_of(const tabber *t, size_t join, int side) {
    return t->options.bends ? t->options.bends[2 * join + (size_t)side] : NULL;
}

/* Whether two bases of one loop share more than a point. */
static bool bases_overlap(const kg_tab *a, const kg_tab *b, double loop_length) {
    for (int lap = -1; lap <= 1; lap++) {
        double shift = lap * loop_length;
        if (a->base[0] + shift < b->base[1] - SHARED && b->base[0] < a->base[1] + shift - SHARED)
            return true;
    }
    return false;
}

/* The tabs one side of a join could have beside those already given, and their glue surface. */
static kg_status propose(const tabber *t, size_t join, int side, kg_tab_list *out,
                         double *out_surface) {
    const kg_net_join *j = &t->net->joins[join];
    const kg_net_side *s = &j->sides[side];
    const kg_tab_ground *ground = &t->grounds[s->part];
    const kg_tab_list *given = &t->tabs[s->part];
    double length = kg_tab_loop_length(&ground->loops[s->loop]);
    kg_status status =
        kg_tab_place(ground, j, (int)join, side, bend_of(t, join, side), &t->options, out);
    *out_surface = 0;
    for (size_t i = 0; status == KG_OK && i < out->count; i++) {
        kg_tab *tab = &out->items[i];
        for (size_t k = 0; k < given->count; k++) {
            const kg_tab *other = &given->items[k];
            if (other->loop == tab->loop && other->height > 0 &&
                bases_overlap(tab, other, length)) {
                tab->height = 0;
                tab->reason = KG_TAB_TAKEN;
            }
        }
        *out_surface += tab->height * (tab->base[1] - tab->base[0]);
    }
    return status;
}

static double bulge_of(const tabber *t, size_t join, int side) {
    const kg_net_side *s = &t->net->joins[join].sides[side];
    kg_tab_edge edge = kg_tab_edge_of(&t->grounds[s->part].loops[s->loop], *s, NULL);
    return kg_tab_edge_bulge(&edge);
}

/* The side that is asked for or, where there is no edge, the other one; -1: none. Both for a seam
 * whose user has no wish: `*out_free`. */
static int wanted_side(const kg_net_join *join, bool *out_free) {
    int side = join->tab_side == KG_TAB_OTHER ? 1 : 0;
    *out_free = false;
    if (join->kind == KG_JOIN_CONTACT)
        return is_edge(&join->sides[0]) ? 0 : -1;
    if (!is_edge(&join->sides[side]))
        return is_edge(&join->sides[1 - side]) ? 1 - side : -1;
    *out_free = join->tab_side == KG_TAB_AUTO && is_edge(&join->sides[1 - side]);
    return side;
}

static kg_status give_tabs(tabber *t, size_t join) {
    const kg_net_join *j = &t->net->joins[join];
    kg_tab_list lists[2] = {0};
    double surface[2] = {0, 0};
    bool both = false;
    int side = j->tab_side == KG_TAB_NONE ? -1 : wanted_side(j, &both);
    kg_status status = KG_OK;
    t->sides[join] = side;
    if (side < 0)
        return KG_OK;
    for (int k = 0; k < 2 && status == KG_OK; k++)
        if (k == side || both)
            status = propose(t, join, k, &lists[k], &surface[k]);
    if (both && status == KG_OK) {
        if (surface[1] > surface[0] * CLEARLY_MORE)
            side = 1;
        else if (surface[0] <= surface[1] * CLEARLY_MORE)
            side = bulge_of(t, join, 1) > bulge_of(t, join, 0) + CLEARLY_ROUNDER;
    }
    kg_tab_list *given = &t->tabs[j->sides[side].part];
    for (size_t i = 0; i < lists[side].count && status == KG_OK; i++)
        status = kg_push(given, lists[side].items[i]) ? KG_OK : KG_ERR_MEMORY;
    t->sides[join] = side;
    free(lists[0].items);
    free(lists[1].items);
    return status;
}

/* ---- the parts -------------------------------------------------------------------------- */

static void destroy_contours(kg_tab_contour *contours, size_t count) {
    for (size_t i = 0; contours && i < count; i++)
        kg_tab_contour_destroy(&contours[i]);
    free(contours);
}

static kg_status merge_loops(const kg_tab_ground *ground, const kg_tab_list *tabs,
                             kg_tab_contour **out) {
    kg_tab_contour *contours = calloc(ground->loop_count, sizeof *contours);
    kg_status status = contours ? KG_OK : KG_ERR_MEMORY;
    for (size_t i = 0; i < ground->loop_count && status == KG_OK; i++)
        status = kg_tab_merge(&ground->loops[i], (int)i, tabs, &contours[i]);
    if (status == KG_OK)
        *out = contours;
    else
        destroy_contours(contours, ground->loop_count);
    return status;
}

static kg_status contours_valid(const tabber *t, const kg_tab_contour *contours, size_t count,
                                bool *out_valid, kg_vec2 *out_at) {
    kg_net_line *lines = calloc(count, sizeof *lines);
    if (!lines)
        return KG_ERR_MEMORY;
    for (size_t i = 0; i < count; i++)
        lines[i] = contours[i].line;
    *out_valid = kg_tab_contours_valid(t->geos, lines, count, out_at);
    free(lines);
    return KG_OK;
}

/* Takes away the tab nearest to a place where the merged contours are no simple polygon. */
static bool drop_nearest(kg_tab_list *tabs, kg_vec2 at) {
    kg_tab *nearest = NULL;
    double best = HUGE_VAL;
    for (size_t i = 0; i < tabs->count; i++)
        for (int k = 0; k < 4 && tabs->items[i].height > 0; k++) {
            double distance = kg_dist2(tabs->items[i].path[k], at);
            if (distance < best) {
                best = distance;
                nearest = &tabs->items[i];
            }
        }
    if (!nearest)
        return false;
    nearest->height = 0;
    nearest->reason = KG_TAB_NO_ROOM;
    return true;
}

/* Settles a part's tabs and merges them. Outlines that were simple stay so. */
static kg_status finish_part(tabber *t, size_t part) {
    const kg_tab_ground *ground = &t->grounds[part];
    kg_tab_list *tabs = &t->tabs[part];
    kg_status status = kg_tab_settle(ground, &t->options, tabs);
    if (status != KG_OK)
        return status;
    kg_tab_order(ground, tabs);
    bool simple = GEOSisValid_r(t->geos, ground->polygon) == 1;
    for (;;) {
        bool valid = true;
        kg_vec2 at = {0, 0};
        status = merge_loops(ground, tabs, &t->contours[part]);
        if (status == KG_OK && simple)
            status = contours_valid(t, t->contours[part], ground->loop_count, &valid, &at);
        if (status != KG_OK || valid || !drop_nearest(tabs, at))
            return status;
        destroy_contours(t->contours[part], ground->loop_count);
        t->contours[part] = NULL;
    }
}

/* ---- the new net ------------------------------------------------------------------------ */

/* Parts that meet at less than this angle (radians) lie in one plane: the sign is rounding. */
#define FLAT 1e-6

static kg_status add_folds(const tabber *t, size_t part, kg_net *out, size_t *tab_count,
                           kg_error *error) {
    const kg_tab_list *tabs = &t->tabs[part];
    int number = 0;
    for (size_t i = 0; i < tabs->count; i++) {
        const kg_tab *tab = &tabs->items[i];
        if (!(tab->height > 0))
            continue;
        double angle = t->net->joins[tab->join].fold[tab->side];
        kg_net_line line;
        kg_status status =
            kg_tab_fold(&t->grounds[part].loops[tab->loop], tab,
                        angle < -FLAT ? KG_NET_MOUNTAIN : KG_NET_VALLEY, ++number, &line);
        if (status != KG_OK)
            return kg_fail(error, status, "out of memory while adding tabs");
        status = kg_net_add_line(out, part, &line, NULL, error);
        free(line.points);
        free(line.corners);
        if (status != KG_OK)
            return status;
        ++*tab_count;
    }
    return KG_OK;
}

static kg_status add_part(const tabber *t, size_t part, kg_net *out, size_t *tab_count,
                          kg_error *error) {
    const kg_net_part *old = &t->net->parts[part];
    size_t index;
    kg_status status = kg_net_add_part(out, old->source, old->name, &index, error);
    if (status != KG_OK)
        return status;
    kg_net_part *made = &out->parts[index];
    made->number = old->number;
    made->area = old->area;
    made->surface = old->surface;
    made->perimeter = old->perimeter;
    made->isometry_error = old->isometry_error;
    for (size_t i = 0; i < old->loop_count && status == KG_OK; i++) {
        const kg_net_line *line = &t->contours[part][i].line;
        status = kg_net_add_loop(out, index, line->points, line->corners, line->count, error);
    }
    for (size_t i = 0; i < old->line_count && status == KG_OK; i++)
        status = kg_net_add_line(out, index, &old->lines[i], NULL, error);
    return status == KG_OK ? add_folds(t, part, out, tab_count, error) : status;
}

/* A side of a join, counted on the new contour. */
static kg_net_side moved_side(const tabber *t, kg_net_side side) {
    if (!is_edge(&side))
        return side;
    const kg_tab_contour *contour = &t->contours[side.part][side.loop];
    size_t old = t->grounds[side.part].loops[side.loop].line->count, count = contour->line.count;
    size_t first = contour->map[side.first];
    size_t last = contour->map[(side.first + side.count - 1) % old];
    side.count = side.count > old ? count + 1 : (last + count - first) % count + 1;
    side.count = side.count < 2 ? 2 : side.count;
    side.first = first;
    return side;
}

static kg_status build(const tabber *t, kg_net *out, size_t *tab_count, kg_error *error) {
    kg_status status = KG_OK;
    if (t->net->title) {
        size_t size = strlen(t->net->title) + 1;
        out->title = malloc(size);
        if (!out->title)
            return kg_fail(error, KG_ERR_MEMORY, "out of memory while adding tabs");
        memcpy(out->title, t->net->title, size);
    }
    for (size_t i = 0; i < t->net->part_count && status == KG_OK; i++)
        status = add_part(t, i, out, tab_count, error);
    for (size_t i = 0; i < t->net->join_count && status == KG_OK; i++) {
        kg_net_join join = t->net->joins[i];
        for (int side = 0; side < 2; side++)
            join.sides[side] = moved_side(t, join.sides[side]);
        status = kg_net_add_join(out, &join, NULL, error);
    }
    return status;
}

/* ---- the report ------------------------------------------------------------------------- */

typedef struct remark_list {
    kg_tab_remark *items;
    size_t count, capacity;
} remark_list;

typedef kg_tab_remark remark_table[TROUBLES][REASONS];

static void note(remark_table table, const kg_tab *tab, kg_vec2 at, kg_tab_trouble trouble,
                 kg_tab_reason reason, double length) {
    kg_tab_remark *r = &table[trouble][reason];
    if (r->length == 0) {
        r->height = tab->height;
        r->at = at;
    }
    r->height = fmin(r->height, tab->height);
    r->length += length;
}

static void note_tab(const tabber *t, const kg_tab *tab, remark_table table) {
    const kg_net_join *join = &t->net->joins[tab->join];
    const kg_tab_loop *loop = &t->grounds[tab->part].loops[tab->loop];
    double width = join->tab_width > 0 ? join->tab_width : t->options.width;
    double length = tab->base[1] - tab->base[0], stands = tab->foot[1] - tab->foot[0];
    kg_vec2 at = kg_tab_loop_at(loop, (tab->base[0] + tab->base[1]) / 2);
    if (!(tab->height > 0)) {
        note(table, tab, at, KG_TAB_MISSING, tab->reason, length);
        return;
    }
    if (tab->height < width * (1 - HEIGHT_LOSS)) {
        bool whole = tab->height >= tab->wanted * (1 - HEIGHT_LOSS);
        note(table, tab, at, KG_TAB_LOWERED, whole ? KG_TAB_SHORT : tab->reason, length);
    }
    if (length - stands > CORNER_LOSS)
        note(table, tab, at, KG_TAB_MISSING, KG_TAB_NO_ROOM, length - stands);
}

static bool report_join(const tabber *t, size_t index, remark_list *out) {
    const kg_net_join *join = &t->net->joins[index];
    int side = t->sides[index];
    remark_table table = {0};
    if (join->tab_side == KG_TAB_NONE)
        return true;
    if (side < 0) {
        kg_tab_remark none = {
            (int)index, 0, KG_TAB_MISSING, KG_TAB_NO_EDGE, join->sides[0].length, 0, {0, 0}};
        return kg_push(out, none);
    }
    const kg_tab_list *tabs = &t->tabs[join->sides[side].part];
    for (size_t i = 0; i < tabs->count; i++)
        if (tabs->items[i].join == (int)index)
            note_tab(t, &tabs->items[i], table);
    if ((join->tab_side == KG_TAB_OTHER && side == 0) ||
        (join->tab_side == KG_TAB_THIS && side == 1))
        table[KG_TAB_MOVED][KG_TAB_NO_EDGE].length = fmax(join->sides[side].length, SHARED);
    for (int trouble = 0; trouble < TROUBLES; trouble++)
        for (int reason = 0; reason < REASONS; reason++) {
            kg_tab_remark r = table[trouble][reason];
            if (!(r.length > 0))
                continue;
            r.join = (int)index;
            r.side = side;
            r.trouble = (kg_tab_trouble)trouble;
            r.reason = (kg_tab_reason)reason;
            if (!kg_push(out, r))
                return false;
        }
    return true;
}

void kg_tab_remark_print(const kg_net *net, const kg_tab_remark *remark, char *out, size_t size) {
    static const char *const reasons[REASONS] = {
        N_("the paper around it leaves no room"), N_("another tab is in the way"),
        N_("the edge is short or bends tightly"), N_("another join has tabs on that edge"),
        N_("its other side is no edge of this net")};
    int number = net->joins[remark->join].number;
    const char *reason = kg_phrase(reasons[remark->reason]);
    if (remark->trouble == KG_TAB_LOWERED)
        kg_phrase_print(out, size, "join %d: tabs along %.1f mm are narrower, down to %.1f mm: %s",
                        number, remark->length, remark->height, reason);
    else if (remark->trouble == KG_TAB_MISSING)
        kg_phrase_print(out, size, "join %d: %.1f mm have no tab: %s", number, remark->length,
                        reason);
    else
        kg_phrase_print(out, size, "join %d: tabs are not on the side asked for: %s", number,
                        reason);
}

/* ---- all of it -------------------------------------------------------------------------- */

static kg_status prepare(tabber *t) {
    size_t parts = t->net->part_count, joins = t->net->join_count;
    t->geos = GEOS_init_r();
    t->grounds = calloc(parts + 1, sizeof *t->grounds);
    t->tabs = calloc(parts + 1, sizeof *t->tabs);
    t->contours = calloc(parts + 1, sizeof *t->contours);
    t->sides = calloc(joins + 1, sizeof *t->sides);
    if (!t->geos || !t->grounds || !t->tabs || !t->contours || !t->sides)
        return KG_ERR_MEMORY;
    for (size_t i = 0; i < parts; i++) {
        kg_status status = kg_tab_ground_create(t->geos, &t->net->parts[i], &t->grounds[i]);
        if (status != KG_OK)
            return status;
    }
    return KG_OK;
}

static void destroy(tabber *t) {
    for (size_t i = 0; i < t->net->part_count; i++) {
        if (t->contours)
            destroy_contours(t->contours[i], t->net->parts[i].loop_count);
        if (t->tabs)
            free(t->tabs[i].items);
        if (t->grounds)
            kg_tab_ground_destroy(&t->grounds[i]);
    }
    free(t->contours);
    free(t->tabs);
    free(t->grounds);
    free(t->sides);
    if (t->geos)
        GEOS_finish_r(t->geos);
}

static kg_status check_options(const kg_net *net, const kg_tab_options *options, kg_error *error) {
    if (!(options->width >= 0.5 && options->width <= 100))
        return kg_fail(error, KG_ERR_INPUT, "tabs %g mm wide: 0.5 to 100 are possible",
                       options->width);
    if (!(options->least >= 0 && options->least <= options->width))
        return kg_fail(error, KG_ERR_INPUT, "a least tab width of %g mm is not in 0..%g",
                       options->least, options->width);
    for (size_t i = 0; i < net->join_count; i++) {
        double width = net->joins[i].tab_width;
        if (width != 0 && !(width >= 0.5 && width <= 100))
            return kg_fail(error, KG_ERR_INPUT, "join %d: tabs %g mm wide: 0.5 to 100 are possible",
                           net->joins[i].number, width);
    }
    return kg_net_check(net, error);
}

kg_status kg_net_tabs(const kg_net *net, const kg_tab_options *options, kg_net **out_net,
                      kg_tab_report *out_report, kg_error *error) {
    kg_status status = check_options(net, options, error);
    if (status != KG_OK)
        return status;
    tabber t = {.net = net, .options = *options};
    kg_net *made = kg_net_create();
    remark_list remarks = {0};
    size_t tab_count = 0;
    status = made ? prepare(&t) : KG_ERR_MEMORY;
    for (size_t i = 0; i < net->join_count && status == KG_OK && !options->none; i++)
        status = give_tabs(&t, i);
    for (size_t i = 0; i < net->part_count && status == KG_OK; i++)
        status = finish_part(&t, i);
    for (size_t i = 0; i < net->join_count && status == KG_OK && !options->none; i++)
        status = report_join(&t, i, &remarks) ? KG_OK : KG_ERR_MEMORY;
    if (status == KG_OK)
        status = build(&t, made, &tab_count, error);
    else
        kg_fail(error, status, "out of memory while adding tabs");
    if (status == KG_OK) {
        *out_net = made;
        *out_report = (kg_tab_report){tab_count, remarks.count, remarks.items};
    } else {
        kg_net_destroy(made);
        free(remarks.items);
    }
    destroy(&t);
    return status;
}
