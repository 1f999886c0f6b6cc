#include "oa/reach.h"

#include "base/array.h"

#include <stdlib.h>
#include <string.h>

enum { BITS = 64 };

/* The two floods: from_back goes down the rows, from_base up. */
enum { BACK, BASE };

/* Rows of bits: word w of row r, which are the columns from 64 w on, is [w * rows + r], so that
 * what happens to one column runs along memory. */
typedef uint64_t *bit_rows;

/* What a try has changed: all but `place` go back to what they were when it fails. */
typedef struct kept_row {
    uint64_t *bits;
    uint64_t value;
} kept_row;

struct kg_oa_reach {
    int width, rows;
    int32_t *place;    /* as kg_oa_sheet has it, but by columns, which are what changes */
    bit_rows memory;   /* of all bits */
    bit_rows right;    /* joined with the next column */
    bit_rows down;     /* joined with the cell below */
    bit_rows front;    /* must be reached by both floods */
    bit_rows flood[2]; /* reached by it */
    size_t missing[2]; /* front cells that are not reached */
    int32_t *before;   /* room for the places of a column */
    uint64_t *joints;  /* room for the bits of a column's joins and fronts */
    struct {
        kept_row *items;
        size_t count, capacity;
    } changes;   /* of the floods, since the last decision */
    bool failed; /* memory ran out within a try */
};

static size_t word_at(const kg_oa_reach *r, int x, int row) {
    return (size_t)((unsigned)x / BITS) * (size_t)r->rows + (size_t)row;
}

static uint64_t bit_of(int x) {
    return (uint64_t)1 << ((unsigned)x % BITS);
}

/* ---- one row of a flood ----------------------------------------------------------------- */

/* The cells a … b of a row that are joined sideways around x. */
static int stretch_begin(const kg_oa_reach *r, int row, int x) {
    if (x == 0)
        return 0;
    int base = (x - 1) / BITS * BITS;
    const uint64_t *right = r->right + word_at(r, base, row);
    uint64_t gaps = ~*right & (~(uint64_t)0 >> (BITS - 1 - (x - 1) % BITS));
    while (gaps == 0 && base > 0) {
        base -= BITS;
        gaps = ~*(right -= r->rows);
    }
    return gaps ? base + (BITS - __builtin_clzll(gaps)) : 0;
}

/* The last column is never joined with one beyond, so there always is a gap. */
static int stretch_end(const kg_oa_reach *r, int row, int x) {
    int base = x / BITS * BITS;
    const uint64_t *right = r->right + word_at(r, base, row);
    uint64_t gaps = ~*right & (~(uint64_t)0 << (x % BITS));
    while (gaps == 0) {
        base += BITS;
        gaps = ~*(right += r->rows);
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
static uint64_t straight(const kg_oa_reach *r, int flood, size_t word) {
    return flood == BACK ? r->flood[BACK][word - 1] & r->down[word - 1]
                         : r->flood[BASE][word + 1] & r->down[word];
}

/* Turns cells of a word that are reached into such that are not, or the other way round. */
static void turn_cells(kg_oa_reach *r, int flood, size_t word, uint64_t cells, bool reached) {
    uint64_t *bits = &r->flood[flood][word], fronts = r->front[word] & cells;
    if (fronts && reached)
        r->missing[flood] -= (size_t)__builtin_popcountll(fronts);
    else if (fronts)
        r->missing[flood] += (size_t)__builtin_popcountll(fronts);
    if (!kg_push(&r->changes, ((kept_row){bits, *bits})))
        r->failed = true;
    *bits ^= cells;
}

/* The columns of these bits of the word from `base` on. */
static span span_of(int base, uint64_t bits) {
    return (span){base + __builtin_ctzll(bits), base + BITS - 1 - __builtin_clzll(bits)};
}

static span united(span a, span b) {
    return (span){a.lo < b.lo ? a.lo : b.lo, a.hi > b.hi ? a.hi : b.hi};
}

/* All cells of the stretches that hold a seed, where none goes on in the next word. A stretch's
 * joins are all its cells but the last one, so seeds added to them carry over into that; from there
 * they spread back over twice as many joins at a time. */
static uint64_t spread(uint64_t seeds, uint64_t right) {
    uint64_t cells = (((seeds & right) + right) | seeds) & ~right;
    for (unsigned n = 1; n < BITS; n *= 2) {
        cells |= right & (cells >> n);
        right &= right >> n;
    }
    return cells;
}

/* Works out the stretches of the columns a … b again, which lie within one word. */
static span renew_word(kg_oa_reach *r, int flood, int row, int a, int b) {
    size_t word = word_at(r, a, row);
    int base = a / BITS * BITS;
    uint64_t area = mask_of(base, a, b);
    uint64_t now = spread(straight(r, flood, word) & area, r->right[word]) & area;
    uint64_t lost = r->flood[flood][word] & area & ~now, won = now & ~r->flood[flood][word];
    if (lost)
        turn_cells(r, flood, word, lost, false);
    if (won)
        turn_cells(r, flood, word, won, true);
    return lost | won ? span_of(base, lost | won) : (span){r->width, -1};
}

/* Works out a single stretch again, the columns a … b. */
static span renew_stretch(kg_oa_reach *r, int flood, int row, int a, int b) {
    span changed = {r->width, -1};
    int from = a / BITS * BITS;
    bool start = starts(r, flood, row), any = start && a == 0;
    for (int base = from; base <= b && !start && !any; base += BITS)
        any = straight(r, flood, word_at(r, base, row)) & mask_of(base, a, b);
    for (int base = from; base <= b; base += BITS) {
        size_t word = word_at(r, base, row);
        uint64_t now = r->flood[flood][word];
        uint64_t differ = (any ? ~now : now) & mask_of(base, a, b);
        if (differ) {
            turn_cells(r, flood, word, differ, any);
            changed = united(changed, span_of(base, differ));
        }
    }
    return changed;
}

/* Works out the stretches around the columns of `dirty` again. Returns what changed. */
static span renew_row(kg_oa_reach *r, int flood, int row, span dirty) {
    int a = stretch_begin(r, row, dirty.lo), b = stretch_end(r, row, dirty.hi);
    if (a / BITS == b / BITS && !starts(r, flood, row))
        return renew_word(r, flood, row, a, b);
    span changed = {r->width, -1};
    for (int end; a <= b; a = end + 1) {
        end = stretch_end(r, row, a);
        changed = united(changed, renew_stretch(r, flood, row, a, end));
    }
    return changed;
}

/* ---- many rows of a flood --------------------------------------------------------------- */

/* A column and those beside it, as bits of one or two words. */
typedef struct beside {
    span columns;
    size_t words[2];   /* of row 0 */
    uint64_t masks[2]; /* the second one is 0 when there is one word */
} beside;

static beside beside_of(const kg_oa_reach *r, int x) {
    span c = {x > 0 ? x - 1 : 0, x + 1 < r->width ? x + 1 : x};
    int low = c.lo / BITS * BITS, high = c.hi / BITS * BITS;
    return (beside){c,
                    {word_at(r, low, 0), word_at(r, high, 0)},
                    {mask_of(low, c.lo, c.hi), low == high ? 0 : mask_of(high, c.lo, c.hi)}};
}

/* Are these cells, which every stretch with changed joins holds one of, all reached, and straight
 * from the row before? Then so are the stretches, however they are joined now. Or is none, and
 * still none from there? Then neither are they. By far the most common cases. */
static bool is_settled(const kg_oa_reach *r, int flood, int row, const beside *b) {
    bool all = r->flood[flood][b->words[0] + (size_t)row] & b->masks[0];
    for (int i = 0; i < 2 && b->masks[i]; i++) {
        size_t word = b->words[i] + (size_t)row;
        uint64_t wanted = all ? b->masks[i] : 0;
        if ((r->flood[flood][word] & b->masks[i]) != wanted ||
            (straight(r, flood, word) & b->masks[i]) != wanted)
            return false;
    }
    return true;
}

/* Of `count` rows from `row` upwards or downwards: are they all reached as above? */
static bool are_reached(const kg_oa_reach *r, int flood, int row, int count, const beside *b) {
    uint64_t missing = 0;
    for (int i = 0; i < 2 && b->masks[i]; i++) {
        const uint64_t *now = r->flood[flood] + b->words[i] + row;
        const uint64_t *down = r->down + b->words[i] + row - (flood == BACK);
        const uint64_t *before = flood == BACK ? now - 1 : now + 1;
        uint64_t all = ~(uint64_t)0;
        for (int k = 0; k < count; k++)
            all &= now[k] & before[k] & down[k];
        missing |= ~all & b->masks[i];
    }
    return missing == 0;
}

/* From `row` on in the direction of the flood, but not beyond `last`: the first row that is not
 * settled. */
static int skip_settled(const kg_oa_reach *r, int flood, int row, int last, const beside *b) {
    enum { AT_ONCE = 16 };
    int step = flood == BACK ? 1 : -1;
    while ((last - row) * step >= 0 && !starts(r, flood, row)) {
        int count = (last - row) * step + 1;
        count = count < AT_ONCE ? count : AT_ONCE;
        if (are_reached(r, flood, flood == BACK ? row : row - count + 1, count, b)) {
            row += step * count;
            continue;
        }
        for (; count > 0 && is_settled(r, flood, row, b); count--)
            row += step;
        if (count > 0)
            break;
    }
    return row;
}

/* Renews a flood after the joins around column x in the rows first … last have changed. Where all
 * fronts were reached before, a row that misses one settles the matter: false. */
static bool renew(kg_oa_reach *r, int flood, int x, int first, int last, bool complete) {
    int step = flood == BACK ? 1 : -1, row = flood == BACK ? first : last;
    int end = flood == BACK ? last + 1 : first - 1; /* the last row with another join before */
    end = end < 0 ? 0 : end < r->rows ? end : r->rows - 1;
    beside here = beside_of(r, x);
    span changed = {r->width, -1};
    for (; row >= 0 && row < r->rows; row += step) {
        if (changed.lo > changed.hi)
            row = skip_settled(r, flood, row, end, &here);
        bool near = (end - row) * step >= 0;
        if (!near && changed.lo > changed.hi)
            break;
        changed = renew_row(r, flood, row, near ? united(changed, here.columns) : changed);
        if (complete && r->missing[flood] > 0)
            return false;
    }
    return r->missing[flood] == 0;
}

/* ---- changes ---------------------------------------------------------------------------- */

static int32_t *places_of(const kg_oa_reach *r, int x) {
    return r->place + (size_t)x * (size_t)r->rows;
}

/* Joins the cells of rows [from, to] of column x with those on their right. */
static void join_right(kg_oa_reach *r, int x, int from, int to) {
    if (x < 0 || x + 1 >= r->width)
        return;
    const int32_t *place = places_of(r, x) + from, *next = place + r->rows;
    uint64_t *right = r->right + word_at(r, x, from);
    unsigned shift = (unsigned)x % BITS;
    for (int i = 0; i <= to - from; i++)
        right[i] = (right[i] & ~((uint64_t)1 << shift)) | (uint64_t)(place[i] == next[i]) << shift;
}

/* Joins them with those below; the last row has none. */
static void join_down(kg_oa_reach *r, int x, int from, int to) {
    const int32_t *place = places_of(r, x) + from;
    uint64_t *down = r->down + word_at(r, x, from);
    unsigned shift = (unsigned)x % BITS;
    to = to + 1 < r->rows ? to : r->rows - 2;
    for (int i = 0; i <= to - from; i++) {
        bool joined = kg_oa_place_lower(place[i]) == kg_oa_place_upper(place[i + 1]);
        down[i] = (down[i] & ~((uint64_t)1 << shift)) | (uint64_t)joined << shift;
    }
}

/* The cells of rows [from, to] of column x are fronts no more. */
static void take_fronts(kg_oa_reach *r, int x, int from, int to) {
    size_t word = word_at(r, x, from);
    uint64_t *front = r->front + word, bit = bit_of(x), any = 0;
    for (int i = 0; i <= to - from; i++)
        any |= front[i];
    for (int i = 0; i <= to - from && (any & bit); i++) {
        if (!(front[i] & bit))
            continue;
        front[i] &= ~bit;
        for (int k = 0; k < 2; k++)
            r->missing[k] -= !(r->flood[k][word + (size_t)i] & bit);
    }
}

/* The bits that a change of rows [from, to] of column x touches: fronts and joins of it, and the
 * joins of the column before, which may be in another word. */
typedef struct touched {
    uint64_t *bits[4];
    size_t rows;
} touched;

static touched touched_by(const kg_oa_reach *r, int x, int from, int to) {
    size_t here = word_at(r, x, from), left = word_at(r, x > 0 ? x - 1 : 0, from);
    return (touched){{r->right + left, r->right + here, r->down + here, r->front + here},
                     (size_t)(to - from + 1)};
}

static void keep(kg_oa_reach *r, const touched *t) {
    for (size_t i = 0; i < 4; i++)
        memcpy(r->joints + i * t->rows, t->bits[i], t->rows * sizeof *r->joints);
}

static void take_back(kg_oa_reach *r, const touched *t, const size_t missing[2]) {
    while (r->changes.count > 0) {
        r->changes.count--;
        *r->changes.items[r->changes.count].bits = r->changes.items[r->changes.count].value;
    }
    for (size_t i = 0; i < 4; i++)
        memcpy(t->bits[i], r->joints + i * t->rows, t->rows * sizeof *r->joints);
    memcpy(r->missing, missing, sizeof r->missing);
}

/* Places rows [from, to] of column x anew, which are others than before. */
static bool try_places(kg_oa_reach *r, int x, int from, int to, const int32_t *places) {
    size_t missing[2] = {r->missing[BACK], r->missing[BASE]};
    size_t size = (size_t)(to - from + 1) * sizeof *places;
    int above = from > 0 ? from - 1 : 0;
    touched t = touched_by(r, x, above, to);
    keep(r, &t);
    memcpy(r->before, places_of(r, x) + from, size);
    memcpy(places_of(r, x) + from, places, size);
    take_fronts(r, x, from, to);
    join_right(r, x - 1, from, to);
    join_right(r, x, from, to);
    join_down(r, x, above, to);
    bool complete = missing[BACK] + missing[BASE] == 0;
    bool valid = renew(r, BACK, x, from, to, complete) && renew(r, BASE, x, from, to, complete);
    if (!valid || r->failed) {
        take_back(r, &t, missing);
        memcpy(places_of(r, x) + from, r->before, size);
    }
    r->changes.count = 0;
    return valid;
}

kg_status kg_oa_reach_try(kg_oa_reach *r, int x, int first, int last, const int32_t *places,
                          bool *out_valid, kg_error *error) {
    const int32_t *at = places_of(r, x);
    int from = first, to = last; /* the rows that are another place now */
    while (from <= last && places[from - first] == at[from])
        from++;
    while (to > from && places[to - first] == at[to])
        to--;
    bool valid = from <= last ? try_places(r, x, from, to, places + (from - first))
                              : r->missing[BACK] + r->missing[BASE] == 0;
    if (r->failed)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    *out_valid = valid;
    return KG_OK;
}

/* ---- the whole -------------------------------------------------------------------------- */

/* Joins, then both floods, row by row; nothing of this is ever taken back. */
static void fill(kg_oa_reach *r) {
    span all = {0, r->width - 1};
    for (int x = 0; x < r->width; x++) {
        join_right(r, x, 0, r->rows - 1);
        join_down(r, x, 0, r->rows - 1);
    }
    for (int row = 0; row < r->rows; row++) {
        renew_row(r, BACK, row, all);
        renew_row(r, BASE, r->rows - 1 - row, all);
        r->changes.count = 0;
    }
}

/* `marks` has room for a column. */
static void lay_out(const kg_oa *oa, unsigned char *marks, kg_oa_reach *r) {
    for (int x = 0; x < r->width; x++) {
        kg_oa_lay_column(oa, x, places_of(r, x), marks);
        for (int row = 0; row < r->rows; row++)
            if (marks[row] & KG_OA_FRONT) {
                r->front[word_at(r, x, row)] |= bit_of(x);
                r->missing[BACK]++;
                r->missing[BASE]++;
            }
    }
    fill(r);
}

kg_status kg_oa_reach_create(const kg_oa *oa, kg_oa_reach **out_reach, kg_error *error) {
    kg_oa_reach *r = calloc(1, sizeof *r);
    if (!r)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    r->width = oa->width;
    r->rows = oa->height + oa->depth_limit;
    size_t rows = (size_t)r->rows, words = ((size_t)r->width + BITS - 1) / BITS * rows;
    unsigned char *marks = calloc(rows, 1);
    r->place = calloc((size_t)r->width * rows, sizeof *r->place);
    r->before = calloc(rows, sizeof *r->before);
    r->joints = calloc(4 * rows, sizeof *r->joints);
    r->memory = calloc(5 * words, sizeof *r->memory);
    bool done = marks && r->place && r->before && r->joints && r->memory;
    if (done) {
        bit_rows *const parts[5] = {&r->right, &r->down, &r->front, &r->flood[BACK],
                                    &r->flood[BASE]};
        for (size_t i = 0; i < 5; i++)
            *parts[i] = r->memory + i * words;
        lay_out(oa, marks, r);
    }
    free(marks);
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
    free(r->joints);
    free(r->memory);
    free(r->changes.items);
    free(r);
}
