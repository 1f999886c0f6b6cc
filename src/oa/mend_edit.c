#include "oa/mend.h"

#include <stdlib.h>
#include <string.h>

/* ---- cards ------------------------------------------------------------------------------ */

static int *column_of(const kg_oa *card, int x) {
    return card->depth + (size_t)x * (size_t)card->height;
}

void kg_oa_mend_copy(kg_oa *to, const kg_oa *from, int x0, int x1) {
    size_t levels = (size_t)from->height, at = (size_t)x0 * levels, tops = at + (size_t)x0;
    size_t columns = (size_t)(x1 - x0);
    memcpy(to->depth + at, from->depth + at, columns * levels * sizeof *to->depth);
    memcpy(to->window + at, from->window + at, columns * levels);
    memcpy(to->omitted + tops, from->omitted + tops, columns * (levels + 1));
}

void kg_oa_mend_repeat(kg_oa *card, int to, int from) {
    size_t levels = (size_t)card->height, a = (size_t)to, b = (size_t)from;
    memcpy(column_of(card, to), column_of(card, from), levels * sizeof *card->depth);
    memcpy(card->window + a * levels, card->window + b * levels, levels);
    memcpy(card->omitted + a * (levels + 1), card->omitted + b * (levels + 1), levels + 1);
}

/* Voxels that differ; what appears or vanishes before the back sheet is seen most. */
static size_t depth_cost(int a, int b) {
    enum { SILHOUETTE = 4 };
    return (size_t)abs(a - b) + ((a == 0) != (b == 0) ? SILHOUETTE : 0);
}

/* Steps between this level of a column and of the next one. */
static size_t is_step(const kg_oa *card, int x, int z) {
    return x + 1 < card->width && kg_oa_depth(card, x, z) != kg_oa_depth(card, x + 1, z);
}

size_t kg_oa_mend_cost(const kg_oa *a, const kg_oa *b, int x0, int x1) {
    size_t cost = 0, steps[2] = {0, 0};
    for (int x = x0; x < x1; x++) {
        for (int z = 0; z < a->height; z++) {
            cost += depth_cost(kg_oa_depth(a, x, z), kg_oa_depth(b, x, z));
            cost += kg_oa_window(a, x, z) != kg_oa_window(b, x, z);
            steps[0] += is_step(a, x, z);
            steps[1] += is_step(b, x, z);
        }
        for (int z = 0; z <= a->height; z++)
            cost += kg_oa_omitted(a, x, z) != kg_oa_omitted(b, x, z);
    }
    return cost + (steps[0] > steps[1] ? steps[0] - steps[1] : 0);
}

/* ---- windows and tops ------------------------------------------------------------------- */

static void close_run(kg_oa *card, int x, int z) {
    int z0, z1, first, last;
    kg_oa_window_run(card, x, z, &z0, &z1, &first, &last);
    for (z = z0; z <= z1; z++)
        kg_oa_set_window(card, x, z, false);
}

static void close_windows(kg_oa *card, int x, const kg_oa_mend *m) {
    for (int z = 0; z < card->height; z++) {
        int row = kg_oa_front_row(card, x, z);
        if (!kg_oa_window(card, x, z) || row < m->row0 || row >= m->row1)
            continue;
        if (m->kind == KG_OA_CLOSE_RUNS)
            close_run(card, x, z);
        else
            kg_oa_set_window(card, x, z, false);
    }
}

static void put_back_tops(kg_oa *card, int x, const kg_oa_mend *m) {
    for (int z = 1; z <= card->height; z++) {
        int first = card->height - z + (z < card->height ? kg_oa_depth(card, x, z) : 0);
        if (first < m->row1 && first + kg_oa_top(card, x, z) > m->row0)
            kg_oa_set_omitted(card, x, z, false);
    }
}

/* ---- fronts ----------------------------------------------------------------------------- */

static int clamped(int value, int lo, int hi) {
    return value < lo ? lo : value > hi ? hi : value;
}

/* Moves the fronts at depth m->at of a column between those below and above them. */
static void move_front(kg_oa *card, const kg_oa_mend_limits *limits, int x, const kg_oa_mend *m) {
    int *depth = column_of(card, x), z0 = 0, z1;
    while (z0 < limits->height && depth[z0] > m->at)
        z0++;
    for (z1 = z0; z1 < limits->height && depth[z1] == m->at; z1++)
        ;
    if (m->at == 0 || z0 == z1)
        return;
    int most = z0 > 0 ? depth[z0 - 1] : limits->depth;
    int least = z1 < card->height ? depth[z1] : 0;
    const int *beside =
        m->kind == KG_OA_FRONT_AS_LEFT ? depth - card->height : depth + card->height;
    for (int z = z0; z < z1; z++) {
        int to = m->kind == KG_OA_MOVE_FRONT       ? m->at + m->by
                 : m->kind == KG_OA_FRONT_TO_LOWER ? (z0 > 0 ? most : m->at)
                 : m->kind == KG_OA_FRONT_TO_UPPER ? least
                                                   : beside[z];
        depth[z] = clamped(to, least, most);
    }
}

/* Moves the top at height m->at of a column up or down. */
static void move_top(kg_oa *card, const kg_oa_mend_limits *limits, int x, const kg_oa_mend *m) {
    int *depth = column_of(card, x), z = m->at;
    if (kg_oa_top(card, x, z) == 0)
        return;
    int below = depth[z - 1], above = z < card->height ? depth[z] : 0, to = z + m->by;
    if (m->kind == KG_OA_TOP_TO_UPPER)
        for (to = z; above > 0 && to < limits->height && depth[to] == above; to++)
            ;
    else if (m->kind == KG_OA_TOP_TO_LOWER)
        for (to = z; to > 0 && depth[to - 1] == below; to--)
            ;
    to = clamped(to, 0, limits->height);
    for (int level = z; level < to; level++)
        depth[level] = below;
    for (int level = to; level < z; level++)
        depth[level] = above;
}

/* ---- columns ---------------------------------------------------------------------------- */

static void change_column(kg_oa *card, const kg_oa_mend_limits *limits, int x,
                          const kg_oa_mend *m) {
    switch (m->kind) {
    case KG_OA_CLOSE_WINDOWS:
    case KG_OA_CLOSE_RUNS:
        close_windows(card, x, m);
        break;
    case KG_OA_PUT_BACK_TOPS:
        put_back_tops(card, x, m);
        break;
    case KG_OA_MOVE_FRONT:
    case KG_OA_FRONT_TO_LOWER:
    case KG_OA_FRONT_TO_UPPER:
    case KG_OA_FRONT_AS_LEFT:
    case KG_OA_FRONT_AS_RIGHT:
        move_front(card, limits, x, m);
        break;
    case KG_OA_MOVE_TOP:
    case KG_OA_TOP_TO_UPPER:
    case KG_OA_TOP_TO_LOWER:
        move_top(card, limits, x, m);
        break;
    case KG_OA_AS_LEFT:
    case KG_OA_AS_RIGHT:
        kg_oa_mend_repeat(card, x, m->kind == KG_OA_AS_LEFT ? x - 1 : x + 1);
        break;
    case KG_OA_FLATTEN:
        memset(column_of(card, x), 0, (size_t)card->height * sizeof *card->depth);
        break;
    }
    kg_oa_clear_faceless(card, x);
}

void kg_oa_mend_apply(kg_oa *card, const kg_oa_mend_limits *limits, const kg_oa_mend *m) {
    bool from_left = m->kind == KG_OA_AS_LEFT || m->kind == KG_OA_FRONT_AS_LEFT;
    bool from_right = m->kind == KG_OA_AS_RIGHT || m->kind == KG_OA_FRONT_AS_RIGHT;
    int x0 = m->x0 < limits->first ? limits->first : m->x0;
    int x1 = m->x1 > limits->last ? limits->last : m->x1;
    if (from_left && x0 == 0)
        x0 = 1;
    if (from_right && x1 == card->width)
        x1--;
    if (from_right)
        for (int x = x1 - 1; x >= x0; x--)
            change_column(card, limits, x, m);
    else
        for (int x = x0; x < x1; x++)
            change_column(card, limits, x, m);
}

/* ---- choices ---------------------------------------------------------------------------- */

typedef struct choices {
    kg_oa_mend *items;
    size_t count;
    const kg_oa_patch *patch;
    int at;
} choices;

static void add(choices *c, kg_oa_mend_kind kind, int by, int wider) {
    const kg_oa_patch *p = c->patch;
    c->items[c->count++] = (kg_oa_mend){
        kind, p->x0 - wider, p->x1 + wider, p->row0 - wider, p->row1 + wider, c->at, by};
}

size_t kg_oa_mends_of(const kg_oa_sheet *sheet, const kg_oa_patch *p, int wider,
                      kg_oa_mend out_mends[KG_OA_MENDS]) {
    enum { FARTHEST = 3, NARROW = 4 };
    choices c = {out_mends, 0, p, 0};
    bool upright = p->plane == KG_OA_BACK, level = p->plane == KG_OA_FLOOR;
    add(&c, KG_OA_CLOSE_WINDOWS, 0, 0);
    add(&c, KG_OA_CLOSE_RUNS, 0, 0);
    add(&c, KG_OA_PUT_BACK_TOPS, 0, 1);
    add(&c, KG_OA_CLOSE_WINDOWS, 0, 1);
    add(&c, KG_OA_CLOSE_RUNS, 0, 1);
    c.at = upright ? p->plane_id : p->plane_id - sheet->depth - 1;
    for (int by = 1; by <= FARTHEST && (upright || level); by++) {
        add(&c, upright ? KG_OA_MOVE_FRONT : KG_OA_MOVE_TOP, by, 0);
        add(&c, upright ? KG_OA_MOVE_FRONT : KG_OA_MOVE_TOP, -by, 0);
    }
    if (upright || level) {
        add(&c, upright ? KG_OA_FRONT_TO_LOWER : KG_OA_TOP_TO_UPPER, 0, 0);
        add(&c, upright ? KG_OA_FRONT_TO_UPPER : KG_OA_TOP_TO_LOWER, 0, 0);
    }
    if (upright) {
        add(&c, KG_OA_FRONT_AS_LEFT, 0, 0);
        add(&c, KG_OA_FRONT_AS_RIGHT, 0, 0);
    }
    if (wider > 0 || p->x1 - p->x0 <= NARROW) {
        add(&c, KG_OA_AS_LEFT, 0, wider);
        add(&c, KG_OA_AS_RIGHT, 0, wider);
    }
    if (wider > 0) {
        add(&c, KG_OA_CLOSE_RUNS, 0, wider);
        add(&c, KG_OA_PUT_BACK_TOPS, 0, wider);
        add(&c, KG_OA_FLATTEN, 0, wider);
    }
    return c.count;
}
