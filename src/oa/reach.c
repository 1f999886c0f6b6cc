#include "oa/reach.h"

#include "base/array.h"

#include <stdlib.h>
#include <string.h>

enum { BITS = 64 };

/* The two floods: from_back goes down the rows, from_base up. */
enum { BACK, BASE };

/* What 64 columns of a row are. */
typedef struct word {
    uint64_t right; /* joined with the next column */
    uint64_t down;  /* joined with the cell below */
    uint64_t front; /* must be reached by both floods */
    uint64_t reached[2];
} word;

struct kg_oa_reach {
    int width, rows;
    int32_t *place;    /* as kg_oa_sheet has it, but by columns, which are what changes */
    word *words;       /* the rows of the first 64 columns, then of the next */
    size_t missing[2]; /* front cells that are not reached */
    struct {
        struct old_bits {
            uint64_t *bits;
            uint64_t value;
        } * items;
        size_t count, capacity;
    } changes;       /* since the last decision */
    int32_t *before; /* room for the places of a column */
    bool failed;     /* memory ran out within a try */
};

static word *word_at(const kg_oa_reach *r, int x, int row) {
    return r->words + (size_t)((unsigned)x / BITS) * (size_t)r->rows + (size_t)row;
}

static uint64_t bit_of(int x) {
    return (uint64_t)1 << ((unsigned)x % BITS);
}

static void change(kg_oa_reach *r, uint64_t *bits, uint64_t value) {
    if (*bits == value)
        return;
    if (!kg_push(&r->changes, ((struct old_bits){bits, *bits})))
        r->failed = true;
    *bits = value;
}

static void change_bits(kg_oa_reach *r, uint64_t *bits, uint64_t mask, bool on) {
    change(r, bits, on ? *bits | mask : *bits & ~mask);
}

/* ---- one row of a flood ----------------------------------------------------------------- */

/* The cells a … b of a row that are joined sideways around x. */
static int stretch_begin(const kg_oa_reach *r, int row, int x) {
    if (x == 0)
        return 0;
    int base = (x - 1) / BITS * BITS;
    uint64_t gaps = ~word_at(r, base, row)->right & (~(uint64_t)0 >> (BITS - 1 - (x - 1) % BITS));
    while (gaps == 0 && base > 0) {
        base -= BITS;
        gaps = ~word_at(r, base, row)->right;
    }
    return gaps ? base + (BITS - __builtin_clzll(gaps)) : 0;
}

/* The last column is never joined with one beyond, so there always is a gap. */
static int stretch_end(const kg_oa_reach *r, int row, int x) {
    int base = x / BITS * BITS;
    uint64_t gaps = ~word_at(r, base, row)->right & (~(uint64_t)0 << (x % BITS));
    while (gaps == 0) {
        base += BITS;
        gaps = ~word_at(r, base, row)->right;
    }
    return base + __builtin_ctzll(gaps);
}

/* The bits of the word from column `base` on that belong to the columns a … b. */
static uint64_t mask_of(int base, int a, int b) {
    uint64_t mask = ~(uint64_t)0;
    if (a > base)
        mask &= ~(uint64_t)0 << (a - base);
    if (b < base + BITS - 1)
        mask &= ~(uint64_t)0 >> (BITS - 1 - (b - base));
    return mask;
}

/* Columns of a row that something has happened to. */
typedef struct span {
    int lo, hi; /* empty when lo > hi */
} span;

static bool starts(const kg_oa_reach *r, int flood, int row) {
    return row == (flood == BACK ? 0 : r->rows - 1);
}

/* Which cells of a word are reached straight from the row before; not of the first row. */
static uint64_t straight(const word *w, int flood) {
    return flood == BACK ? w[-1].reached[BACK] & w[-1].down : w[1].reached[BASE] & w->down;
}

/* Sets the cells of a mask to be reached or not. */
static void reach_cells(kg_oa_reach *r, int flood, word *w, uint64_t mask, bool any) {
    uint64_t old = w->reached[flood], now = any ? old | mask : old & ~mask;
    uint64_t fronts = w->front & (old ^ now);
    if (fronts && any)
        r->missing[flood] -= (size_t)__builtin_popcountll(fronts);
    else if (fronts)
        r->missing[flood] += (size_t)__builtin_popcountll(fronts);
    change(r, &w->reached[flood], now);
}

/* Works out the stretches around the columns of `dirty` again. Returns what changed. */
static span renew_row(kg_oa_reach *r, int flood, int row, span dirty) {
    bool start = starts(r, flood, row);
    span changed = {r->width, -1};
    for (int a = stretch_begin(r, row, dirty.lo), b; a <= dirty.hi; a = b + 1) {
        b = stretch_end(r, row, a);
        int from = a / BITS * BITS;
        bool any = start && a == 0;
        for (int base = from; base <= b && !start && !any; base += BITS)
            any = straight(word_at(r, base, row), flood) & mask_of(base, a, b);
        for (int base = from; base <= b; base += BITS) {
            word *w = word_at(r, base, row);
            uint64_t mask = mask_of(base, a, b);
            uint64_t differ = (any ? ~w->reached[flood] : w->reached[flood]) & mask;
            if (differ == 0)
                continue;
            int low = base + __builtin_ctzll(differ);
            int high = base + BITS - 1 - __builtin_clzll(differ);
            changed.lo = low < changed.lo ? low : changed.lo;
            changed.hi = high > changed.hi ? high : changed.hi;
            reach_cells(r, flood, w, mask, any);
        }
    }
    return changed;
}

static span united(span a, span b) {
    return (span){a.lo < b.lo ? a.lo : b.lo, a.hi > b.hi ? a.hi : b.hi};
}

/* A column and those beside it, as bits of one or two words. */
typedef struct beside {
    span columns;
    int bases[2];
    uint64_t masks[2]; /* the second one is 0 when there is one word */
} beside;

static beside beside_of(const kg_oa_reach *r, int x) {
    span c = {x > 0 ? x - 1 : 0, x + 1 < r->width ? x + 1 : x};
    int low = c.lo / BITS * BITS, high = c.hi / BITS * BITS;
    return (beside){
        c, {low, high}, {mask_of(low, c.lo, c.hi), low == high ? 0 : mask_of(high, c.lo, c.hi)}};
}

/* Are these cells, which every stretch with changed joins holds one of, all reached, and straight
 * from the row before? Then so are the stretches, however they are joined now. Or is none, and
 * still none from there? Then neither are they. By far the most common cases. */
static inline bool is_settled(const kg_oa_reach *r, int flood, int row, const beside *b) {
    const word *w = word_at(r, b->bases[0], row);
    bool all = w->reached[flood] & b->masks[0];
    for (int i = 0; i < 2 && b->masks[i]; i++, w = word_at(r, b->bases[1], row)) {
        uint64_t wanted = all ? b->masks[i] : 0;
        if ((w->reached[flood] & b->masks[i]) != wanted ||
            (straight(w, flood) & b->masks[i]) != wanted)
            return false;
    }
    return true;
}

/* Renews a flood after the joins around column x in the rows first … last have changed. */
static void renew(kg_oa_reach *r, int flood, int x, int first, int last) {
    int step = flood == BACK ? 1 : -1, row = flood == BACK ? first : last;
    int beyond = flood == BACK ? last + 1 : first - 1; /* the last row with another join before */
    beside here = beside_of(r, x);
    span changed = {r->width, -1};
    for (bool near = true; row >= 0 && row < r->rows; row += step) {
        span dirty = near ? united(changed, here.columns) : changed;
        if (dirty.lo > dirty.hi)
            break;
        bool alone = near && changed.lo > changed.hi && !starts(r, flood, row);
        if (!alone || !is_settled(r, flood, row, &here))
            changed = renew_row(r, flood, row, dirty);
        near = near && row != beyond;
    }
}

/* ---- changes ---------------------------------------------------------------------------- */

static int32_t *places_of(const kg_oa_reach *r, int x) {
    return r->place + (size_t)x * (size_t)r->rows;
}

static inline void join_down(kg_oa_reach *r, int x, int row) {
    const int32_t *place = places_of(r, x) + row;
    if (row >= 0 && row + 1 < r->rows)
        change_bits(r, &word_at(r, x, row)->down, bit_of(x),
                    kg_oa_place_lower(place[0]) == kg_oa_place_upper(place[1]));
}

/* Joins cell (x, row) with those at its sides; mostly one word has both joins. */
static inline void join_sides(kg_oa_reach *r, int x, int row) {
    const int32_t *place = places_of(r, x) + row;
    word *w = word_at(r, x, row);
    uint64_t to_right = bit_of(x), to_left = to_right >> 1, bits = w->right & ~(to_right | to_left);
    bool left = x > 0 && place[-r->rows] == place[0];
    if (x + 1 < r->width && place[r->rows] == place[0])
        bits |= to_right;
    if (left)
        bits |= to_left;
    change(r, &w->right, bits);
    if (x > 0 && to_left == 0)
        change_bits(r, &word_at(r, x - 1, row)->right, bit_of(x - 1), left);
}

static inline void take_front(kg_oa_reach *r, int x, int row) {
    word *w = word_at(r, x, row);
    if (!(w->front & bit_of(x)))
        return;
    for (int flood = 0; flood < 2; flood++)
        r->missing[flood] -= !(w->reached[flood] & bit_of(x));
    change_bits(r, &w->front, bit_of(x), false);
}

static void take_back(kg_oa_reach *r, const size_t missing[2]) {
    while (r->changes.count > 0) {
        r->changes.count--;
        *r->changes.items[r->changes.count].bits = r->changes.items[r->changes.count].value;
    }
    memcpy(r->missing, missing, sizeof r->missing);
}

kg_status kg_oa_reach_try(kg_oa_reach *r, int x, int first, int last, const int32_t *places,
                          bool *out_valid, kg_error *error) {
    size_t missing[2] = {r->missing[BACK], r->missing[BASE]};
    size_t size = (size_t)(last - first + 1) * sizeof *places;
    int32_t *at = places_of(r, x) + first;
    int from = first, to = last; /* the rows that are another place now */
    while (from <= last && places[from - first] == at[from - first])
        from++;
    while (to > from && places[to - first] == at[to - first])
        to--;
    memcpy(r->before, at, size);
    memcpy(at, places, size);
    if (from <= last) {
        join_down(r, x, from - 1);
        for (int row = from; row <= to; row++) {
            take_front(r, x, row);
            join_sides(r, x, row);
            join_down(r, x, row);
        }
        renew(r, BACK, x, from, to);
        renew(r, BASE, x, from, to);
    }
    bool valid = !r->failed && r->missing[BACK] + r->missing[BASE] == 0;
    if (!valid) {
        take_back(r, missing);
        memcpy(at, r->before, size);
    }
    r->changes.count = 0;
    if (r->failed)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    *out_valid = valid;
    return KG_OK;
}

/* ---- the whole -------------------------------------------------------------------------- */

/* Joins and fronts, then both floods, row by row; nothing of this is ever taken back. */
static void fill(kg_oa_reach *r, const unsigned char *marks) {
    span all = {0, r->width - 1};
    for (int x = 0; x < r->width; x++) {
        for (int row = 0; row < r->rows; row++) {
            join_sides(r, x, row);
            join_down(r, x, row);
        }
        r->changes.count = 0;
    }
    for (int row = 0; row < r->rows; row++)
        for (int x = 0; x < r->width; x++)
            if (marks[(size_t)row * (size_t)r->width + (size_t)x] & KG_OA_FRONT) {
                word_at(r, x, row)->front |= bit_of(x);
                r->missing[BACK]++;
                r->missing[BASE]++;
            }
    for (int row = 0; row < r->rows; row++) {
        renew_row(r, BACK, row, all);
        renew_row(r, BASE, r->rows - 1 - row, all);
        r->changes.count = 0;
    }
}

static void lay_out(const kg_oa *oa, kg_oa_sheet *s, kg_oa_reach *r) {
    kg_oa_lay_out(oa, s);
    for (int row = 0; row < r->rows; row++)
        for (int x = 0; x < r->width; x++)
            places_of(r, x)[row] = s->place[kg_oa_cell(s, x, row)];
    fill(r, s->marks);
}

kg_status kg_oa_reach_create(const kg_oa *oa, kg_oa_reach **out_reach, kg_error *error) {
    kg_oa_reach *r = calloc(1, sizeof *r);
    if (!r)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    r->width = oa->width;
    r->rows = oa->height + oa->depth_limit;
    size_t rows = (size_t)r->rows, cells = (size_t)r->width * rows;
    kg_oa_sheet s = {.width = oa->width,
                     .height = oa->height,
                     .depth = oa->depth_limit,
                     .rows = r->rows,
                     .place = calloc(cells, sizeof *s.place),
                     .marks = calloc(cells, 1)};
    r->place = calloc(cells, sizeof *r->place);
    r->before = calloc(rows, sizeof *r->before);
    r->words = calloc(((size_t)r->width + BITS - 1) / BITS * rows, sizeof *r->words);
    bool done = s.place && s.marks && r->place && r->before && r->words;
    if (done)
        lay_out(oa, &s, r);
    free(s.place);
    free(s.marks);
    if (!done || r->failed) {
        kg_oa_reach_destroy(r);
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    }
    *out_reach = r;
    return KG_OK;
}

void kg_oa_reach_destroy(kg_oa_reach *r) {
    if (!r)
        return;
    free(r->place);
    free(r->before);
    free(r->words);
    free(r->changes.items);
    free(r);
}
