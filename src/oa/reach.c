#include "oa/reach.h"

#include "base/array.h"

#include <stdlib.h>
#include <string.h>

enum { BITS = 64 };

/* The two floods: from_back goes down the rows, from_base up. */
enum { BACK, BASE };

struct kg_oa_reach {
    int width, rows;
    int32_t *place;  /* as kg_oa_sheet has it, but by columns, which are what changes */
    size_t words;    /* of a row of bits */
    uint64_t *right; /* bit x: joined with x + 1 */
    uint64_t *down;  /* joined with the cell below */
    uint64_t *front; /* must be reached by both floods */
    uint64_t *reached[2];
    size_t missing[2]; /* front cells that are not */
    struct {
        struct old_word {
            uint64_t *word;
            uint64_t value;
        } * items;
        size_t count, capacity;
    } bits; /* changed since the last decision */
    struct {
        struct old_place {
            size_t cell;
            int32_t place;
        } * items;
        size_t count, capacity;
    } places;
    bool failed; /* memory ran out within a try */
};

static uint64_t *row_of(const kg_oa_reach *r, uint64_t *bits, int row) {
    return bits + (size_t)row * r->words;
}

static bool bit(const uint64_t *row, int x) {
    return row[x / BITS] >> (x % BITS) & 1;
}

static void change(kg_oa_reach *r, uint64_t *word, uint64_t value) {
    if (*word == value)
        return;
    if (!kg_push(&r->bits, ((struct old_word){word, *word})))
        r->failed = true;
    *word = value;
}

static void change_bit(kg_oa_reach *r, uint64_t *row, int x, bool on) {
    uint64_t mask = (uint64_t)1 << (x % BITS), *word = &row[x / BITS];
    change(r, word, on ? *word | mask : *word & ~mask);
}

/* ---- one row of a flood ----------------------------------------------------------------- */

/* The cells a … b of a row that are joined sideways around x. */
static int stretch_begin(const uint64_t *right, int x) {
    if (x == 0)
        return 0;
    size_t w = (size_t)(x - 1) / BITS;
    uint64_t gaps = ~right[w] & (~(uint64_t)0 >> (BITS - 1 - (x - 1) % BITS));
    while (gaps == 0 && w > 0)
        gaps = ~right[--w];
    return gaps ? (int)w * BITS + (BITS - __builtin_clzll(gaps)) : 0;
}

/* The last column is never joined with one beyond, so there always is a gap. */
static int stretch_end(const uint64_t *right, int x) {
    size_t w = (size_t)x / BITS;
    uint64_t gaps = ~right[w] & (~(uint64_t)0 << (x % BITS));
    while (gaps == 0)
        gaps = ~right[++w];
    return (int)w * BITS + __builtin_ctzll(gaps);
}

/* The bits of word w that belong to the columns a … b. */
static uint64_t mask_of(size_t w, int a, int b) {
    uint64_t mask = ~(uint64_t)0;
    if (w == (size_t)a / BITS)
        mask &= ~(uint64_t)0 << (a % BITS);
    if (w == (size_t)b / BITS)
        mask &= ~(uint64_t)0 >> (BITS - 1 - b % BITS);
    return mask;
}

/* Columns of a row that something has happened to. */
typedef struct span {
    int lo, hi; /* empty when lo > hi */
} span;

/* Works out the stretches around the columns of `dirty` again; `source` and `joins` are the row
 * before in the flood (NULL: the first one) and its joins with this one. Returns what changed. */
static span renew_row(kg_oa_reach *r, int flood, int row, const uint64_t *source,
                      const uint64_t *joins, span dirty) {
    const uint64_t *right = row_of(r, r->right, row), *front = row_of(r, r->front, row);
    uint64_t *reached = row_of(r, r->reached[flood], row);
    span changed = {r->width, -1};
    for (int a = stretch_begin(right, dirty.lo), b; a <= dirty.hi; a = b + 1) {
        b = stretch_end(right, a);
        size_t from = (size_t)a / BITS, to = (size_t)b / BITS;
        uint64_t any = source ? 0 : a == 0;
        for (size_t w = from; w <= to && source && !any; w++)
            any |= source[w] & joins[w] & mask_of(w, a, b);
        for (size_t w = from; w <= to; w++) {
            uint64_t mask = mask_of(w, a, b), old = reached[w] & mask, now = any ? mask : 0;
            if (old == now)
                continue;
            uint64_t differ = old ^ now;
            int low = (int)w * BITS + __builtin_ctzll(differ);
            int high = (int)w * BITS + BITS - 1 - __builtin_clzll(differ);
            changed.lo = low < changed.lo ? low : changed.lo;
            changed.hi = high > changed.hi ? high : changed.hi;
            r->missing[flood] += (size_t)__builtin_popcountll(front[w] & mask & ~now);
            r->missing[flood] -= (size_t)__builtin_popcountll(front[w] & mask & ~old);
            change(r, &reached[w], (reached[w] & ~mask) | now);
        }
    }
    return changed;
}

static span united(span a, span b) {
    return (span){a.lo < b.lo ? a.lo : b.lo, a.hi > b.hi ? a.hi : b.hi};
}

/* Are these cells, which every stretch with changed joins holds one of, all reached, and straight
 * from the row before? Then so are the stretches, however they are joined now. Or is none, and
 * still none from there? Then neither are they. By far the most common cases. */
static bool is_settled(const uint64_t *reached, const uint64_t *source, const uint64_t *joins,
                       span cells) {
    bool all = bit(reached, cells.lo);
    for (int x = cells.lo; x <= cells.hi; x++)
        if (bit(reached, x) != all || (bit(source, x) && bit(joins, x)) != all)
            return false;
    return true;
}

/* Renews a flood after the joins around column x in the rows first … last have changed. */
static void renew(kg_oa_reach *r, int flood, int x, int first, int last) {
    int step = flood == BACK ? 1 : -1, row = flood == BACK ? first : last;
    int beyond = flood == BACK ? last + 1 : first - 1; /* the last row with another join before */
    int width = r->width;
    span here = {x > 0 ? x - 1 : 0, x + 1 < width ? x + 1 : x}, changed = {width, -1};
    for (bool near = true; row >= 0 && row < r->rows; row += step) {
        span dirty = near ? united(changed, here) : changed;
        if (dirty.lo > dirty.hi)
            break;
        bool start = row == (flood == BACK ? 0 : r->rows - 1);
        const uint64_t *source = start ? NULL : row_of(r, r->reached[flood], row - step);
        const uint64_t *joins = start ? NULL : row_of(r, r->down, flood == BACK ? row - 1 : row);
        bool alone = near && changed.lo > changed.hi && source;
        if (!alone || !is_settled(row_of(r, r->reached[flood], row), source, joins, here))
            changed = renew_row(r, flood, row, source, joins, dirty);
        near = near && row != beyond;
    }
}

/* ---- changes ---------------------------------------------------------------------------- */

static size_t cell_of(const kg_oa_reach *r, int x, int row) {
    return (size_t)x * (size_t)r->rows + (size_t)row;
}

static void join_right(kg_oa_reach *r, int x, int row) {
    const int32_t *place = &r->place[cell_of(r, x, row)];
    if (x + 1 < r->width)
        change_bit(r, row_of(r, r->right, row), x, place[0] == place[r->rows]);
}

static void join_down(kg_oa_reach *r, int x, int row) {
    const int32_t *place = &r->place[cell_of(r, x, row)];
    if (row + 1 < r->rows)
        change_bit(r, row_of(r, r->down, row), x,
                   kg_oa_place_lower(place[0]) == kg_oa_place_upper(place[1]));
}

static void take_front(kg_oa_reach *r, int x, int row) {
    uint64_t *front = row_of(r, r->front, row);
    if (!bit(front, x))
        return;
    for (int flood = 0; flood < 2; flood++)
        r->missing[flood] -= !bit(row_of(r, r->reached[flood], row), x);
    change_bit(r, front, x, false);
}

static void take_back(kg_oa_reach *r, const size_t missing[2]) {
    while (r->bits.count > 0) {
        r->bits.count--;
        *r->bits.items[r->bits.count].word = r->bits.items[r->bits.count].value;
    }
    while (r->places.count > 0) {
        r->places.count--;
        r->place[r->places.items[r->places.count].cell] = r->places.items[r->places.count].place;
    }
    memcpy(r->missing, missing, sizeof r->missing);
}

/* Places the cells, sets *out_first … *out_last to the rows that are another place now. */
static void place_cells(kg_oa_reach *r, int x, int first, int last, const int32_t *places,
                        int *out_first, int *out_last) {
    *out_first = last + 1;
    *out_last = first - 1;
    for (int row = first; row <= last; row++) {
        size_t cell = cell_of(r, x, row);
        if (r->place[cell] == places[row - first])
            continue;
        take_front(r, x, row);
        if (!kg_push(&r->places, ((struct old_place){cell, r->place[cell]})))
            r->failed = true;
        r->place[cell] = places[row - first];
        *out_first = row < *out_first ? row : *out_first;
        *out_last = row;
    }
}

kg_status kg_oa_reach_try(kg_oa_reach *r, int x, int first, int last, const int32_t *places,
                          bool *out_valid, kg_error *error) {
    size_t missing[2] = {r->missing[BACK], r->missing[BASE]};
    int from, to;
    place_cells(r, x, first, last, places, &from, &to);
    if (from <= to && !r->failed) {
        if (from > 0)
            join_down(r, x, from - 1);
        for (int row = from; row <= to; row++) {
            join_down(r, x, row);
            join_right(r, x, row);
            if (x > 0)
                join_right(r, x - 1, row);
        }
        renew(r, BACK, x, from, to);
        renew(r, BASE, x, from, to);
    }
    bool valid = !r->failed && r->missing[BACK] + r->missing[BASE] == 0;
    if (!valid)
        take_back(r, missing);
    r->bits.count = r->places.count = 0;
    if (r->failed)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    *out_valid = valid;
    return KG_OK;
}

/* ---- the whole -------------------------------------------------------------------------- */

/* Joins and fronts, then both floods, row by row. */
static void fill(kg_oa_reach *r, const unsigned char *marks) {
    span all = {0, r->width - 1};
    for (int row = 0; row < r->rows; row++)
        for (int x = 0; x < r->width; x++) {
            join_right(r, x, row);
            join_down(r, x, row);
            bool front = marks[(size_t)row * (size_t)r->width + (size_t)x] & KG_OA_FRONT;
            change_bit(r, row_of(r, r->front, row), x, front);
            r->missing[BACK] += front;
            r->missing[BASE] += front;
            r->bits.count = 0; /* nothing of this is ever taken back */
        }
    for (int row = 0; row < r->rows; row++) {
        int other = r->rows - 1 - row;
        renew_row(r, BACK, row, row > 0 ? row_of(r, r->reached[BACK], row - 1) : NULL,
                  row > 0 ? row_of(r, r->down, row - 1) : NULL, all);
        renew_row(r, BASE, other, row > 0 ? row_of(r, r->reached[BASE], other + 1) : NULL,
                  row > 0 ? row_of(r, r->down, other) : NULL, all);
        r->bits.count = 0;
    }
}

static void lay_out(const kg_oa *oa, kg_oa_sheet *s, kg_oa_reach *r) {
    kg_oa_lay_out(oa, s);
    for (int row = 0; row < r->rows; row++)
        for (int x = 0; x < r->width; x++)
            r->place[cell_of(r, x, row)] = s->place[kg_oa_cell(s, x, row)];
    fill(r, s->marks);
}

kg_status kg_oa_reach_create(const kg_oa *oa, kg_oa_reach **out_reach, kg_error *error) {
    kg_oa_reach *r = calloc(1, sizeof *r);
    if (!r)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    r->width = oa->width;
    r->rows = oa->height + oa->depth_limit;
    r->words = ((size_t)r->width + BITS - 1) / BITS;
    size_t cells = (size_t)r->width * (size_t)r->rows, words = r->words * (size_t)r->rows;
    kg_oa_sheet s = {.width = oa->width,
                     .height = oa->height,
                     .depth = oa->depth_limit,
                     .rows = r->rows,
                     .place = calloc(cells, sizeof *s.place),
                     .marks = calloc(cells, 1)};
    r->place = calloc(cells, sizeof *r->place);
    uint64_t **const rows[] = {&r->right, &r->down, &r->front, &r->reached[BACK],
                               &r->reached[BASE]};
    bool done = s.place && s.marks && r->place;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        done = (*rows[i] = calloc(words, sizeof **rows[i])) && done;
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
    free(r->right);
    free(r->down);
    free(r->front);
    free(r->reached[BACK]);
    free(r->reached[BASE]);
    free(r->bits.items);
    free(r->places.items);
    free(r);
}
