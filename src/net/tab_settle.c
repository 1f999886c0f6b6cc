#include "net/tab_settle.h"

#include "base/array.h"

#include <stdlib.h>

/* Two halves become one tab again when it keeps this share of their surface. */
static const double WORTH_JOINING = 0.95;
/* Rounds after which tabs that still meet are dropped; lowering ends long before. */
enum { ROUNDS_MAX = 400 };

static bool segments_meet(kg_vec2 a, kg_vec2 b, kg_vec2 c, kg_vec2 d) {
    kg_vec2 ab = kg_sub2(b, a), cd = kg_sub2(d, c);
    bool a_left = kg_cross2(cd, kg_sub2(a, c)) >= 0, b_left = kg_cross2(cd, kg_sub2(b, c)) >= 0;
    bool c_left = kg_cross2(ab, kg_sub2(c, a)) >= 0, d_left = kg_cross2(ab, kg_sub2(d, a)) >= 0;
    return a_left != b_left && c_left != d_left;
}

static bool paths_meet(const kg_vec2 a[4], const kg_vec2 b[4]) {
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            if (segments_meet(a[i], a[i + 1], b[j], b[j + 1]))
                return true;
    return false;
}

static kg_box2 box_of(const kg_tab *tab) {
    kg_box2 box = kg_box2_empty();
    for (int i = 0; i < 4; i++)
        kg_box2_add(&box, tab->path[i]);
    return box;
}

/* Whether two tabs meet, one of them with its clearance. */
static bool conflict(const kg_tab *a, const kg_tab *b) {
    kg_box2 x = box_of(a), y = box_of(b);
    double clear = KG_TAB_CLEARANCE;
    if (x.lo.x > y.hi.x + clear || y.lo.x > x.hi.x + clear || x.lo.y > y.hi.y + clear ||
        y.lo.y > x.hi.y + clear)
        return false;
    kg_vec2 wide_a[4], wide_b[4];
    kg_tab_guard(a, wide_a);
    kg_tab_guard(b, wide_b);
    return paths_meet(wide_a, b->path) || paths_meet(a->path, wide_b);
}

typedef enum verdict { STAYS, GIVES_WAY, GOES } verdict;

/* A tab on the way of a line that sweeps over the part from left to right. */
typedef struct sweep_item {
    double left, right;
    size_t index;
} sweep_item;

static int from_left(const void *pa, const void *pb) {
    const sweep_item *a = pa, *b = pb;
    if (a->left != b->left)
        return a->left < b->left ? -1 : 1;
    return (a->index > b->index) - (a->index < b->index);
}

/* Two tabs that meet are to give way; if neither can, the one with less surface goes. */
static void judge_pair(const kg_tab_list *tabs, const kg_tab_options *options, size_t i, size_t j,
                       verdict *verdicts) {
    size_t index[2] = {i < j ? i : j, i < j ? j : i};
    double size[2];
    bool stuck = true;
    for (int k = 0; k < 2; k++) {
        const kg_tab *tab = &tabs->items[index[k]];
        bool lower = tab->height * KG_TAB_STEP_DOWN >= kg_tab_least(tab, options);
        size[k] = tab->height * (tab->base[1] - tab->base[0]);
        if (lower && verdicts[index[k]] == STAYS)
            verdicts[index[k]] = GIVES_WAY;
        stuck = stuck && !lower;
    }
    if (stuck)
        verdicts[index[size[1] <= size[0]]] = GOES;
}

/* Judges every pair of tabs that meet; false when there is none. */
static bool judge(const kg_tab_list *tabs, const kg_tab_options *options, sweep_item *sweep,
                  verdict *verdicts) {
    bool any = false;
    size_t count = 0;
    for (size_t i = 0; i < tabs->count; i++) {
        verdicts[i] = STAYS;
        if (!(tabs->items[i].height > 0))
            continue;
        kg_box2 box = box_of(&tabs->items[i]);
        sweep[count++] = (sweep_item){box.lo.x, box.hi.x + KG_TAB_CLEARANCE, i};
    }
    qsort(sweep, count, sizeof *sweep, from_left);
    for (size_t a = 0; a < count; a++)
        for (size_t b = a + 1; b < count && sweep[b].left <= sweep[a].right; b++) {
            size_t i = sweep[a].index, j = sweep[b].index;
            if (!conflict(&tabs->items[i], &tabs->items[j]))
                continue;
            judge_pair(tabs, options, i, j, verdicts);
            any = true;
        }
    return any;
}

/* Makes one tab lower or, where it is long and gives way only in places, two of it. */
static kg_status give_way(const kg_tab_ground *ground, const kg_tab_options *options,
                          kg_tab_list *tabs, size_t index) {
    kg_tab *tab = &tabs->items[index];
    if (tab->base[1] - tab->base[0] <= 3 * tab->wanted) {
        kg_tab_fit(ground, options, tab, tab->height * KG_TAB_STEP_DOWN);
        if (tab->height > 0)
            tab->reason = KG_TAB_NEIGHBOUR;
        return KG_OK;
    }
    kg_tab halves[2];
    for (int k = 0; k < 2; k++) {
        halves[k] = kg_tab_half(tab, k, tab->wanted);
        kg_tab_fit(ground, options, &halves[k], tab->height);
    }
    *tab = halves[0];
    return kg_push(tabs, halves[1]) ? KG_OK : KG_ERR_MEMORY;
}

static double surface_of(const kg_tab *tab) {
    double bottom = kg_dist2(tab->path[0], tab->path[3]);
    return tab->height * (bottom + kg_dist2(tab->path[1], tab->path[2])) / 2;
}

static int by_base(const void *pa, const void *pb) {
    const kg_tab *a = pa, *b = pb;
    if (a->join != b->join)
        return a->join < b->join ? -1 : 1;
    if (a->piece != b->piece)
        return a->piece < b->piece ? -1 : 1;
    return (a->base[0] > b->base[0]) - (a->base[0] < b->base[0]);
}

/* Puts one tab in the left one's place for two neighbours, parts of the same base, where it holds
 * about as much. */
static bool join_halves(const kg_tab_ground *ground, const kg_tab_options *options,
                        kg_tab_list *tabs, kg_tab *left, kg_tab *right) {
    if (left->join != right->join || left->piece != right->piece || !(left->height > 0) ||
        !(right->height > 0) || left->base[1] != right->base[0])
        return false;
    kg_tab whole = *left;
    whole.base[1] = right->base[1];
    whole.wanted = fmax(left->wanted, right->wanted);
    kg_tab_fit(ground, options, &whole, fmin(left->height, right->height));
    whole.reason = left->reason;
    if (surface_of(&whole) < WORTH_JOINING * (surface_of(left) + surface_of(right)))
        return false;
    for (size_t i = 0; i < tabs->count; i++) {
        const kg_tab *other = &tabs->items[i];
        if (other != left && other != right && other->height > 0 && conflict(&whole, other))
            return false;
    }
    *left = whole;
    return true;
}

/* Undoes splits that turned out to be of no use. */
static void join_all_halves(const kg_tab_ground *ground, const kg_tab_options *options,
                            kg_tab_list *tabs) {
    bool joined = tabs->count > 1;
    while (joined) {
        joined = false;
        qsort(tabs->items, tabs->count, sizeof *tabs->items, by_base);
        size_t kept = 0;
        for (size_t i = 1; i < tabs->count; i++) {
            bool one = join_halves(ground, options, tabs, &tabs->items[kept], &tabs->items[i]);
            kg_tab tab = tabs->items[i];
            tabs->items[i].height = 0; /* what is left behind is in nobody's way */
            joined = joined || one;
            if (!one)
                tabs->items[++kept] = tab;
        }
        tabs->count = kept + 1;
    }
}

kg_status kg_tab_settle(const kg_tab_ground *ground, const kg_tab_options *options,
                        kg_tab_list *tabs) {
    kg_status status = KG_OK;
    for (int round = 0; status == KG_OK; round++) {
        size_t count = tabs->count;
        verdict *verdicts = malloc((count + 1) * sizeof *verdicts);
        sweep_item *sweep = malloc((count + 1) * sizeof *sweep);
        bool any = false;
        if (!verdicts || !sweep)
            status = KG_ERR_MEMORY;
        else
            any = judge(tabs, options, sweep, verdicts);
        for (size_t i = 0; any && i < count && status == KG_OK; i++) {
            if (verdicts[i] == GOES || (verdicts[i] == GIVES_WAY && round >= ROUNDS_MAX))
                kg_tab_drop(&tabs->items[i], KG_TAB_NEIGHBOUR);
            else if (verdicts[i] == GIVES_WAY)
                status = give_way(ground, options, tabs, i);
        }
        free(verdicts);
        free(sweep);
        if (!any)
            break;
    }
    if (status == KG_OK)
        join_all_halves(ground, options, tabs);
    return status;
}
