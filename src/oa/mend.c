/*
 * Making cards stand. The paper's method leaves patches that do not follow from the opening of the
 * card (stability.c). Each of them is looked at with the columns beside it: what is firm at their
 * rim counts as held, and of the small changes of mend_edit.c the one is made that makes most
 * patches firm for its cost. A round makes changes that lie apart, and counts all patches anew;
 * what turns out to make it worse is taken back, so every round leaves fewer loose patches. Where
 * nothing helps, more columns beside a patch are looked at and changed, in the end all of them, and
 * a plain card is stable. At last, what turned out to be needless is put back as it was.
 */
#include "oa/mend.h"
#include "base/array.h"
#include "oa/stability.h"

#include <stdlib.h>
#include <string.h>

/* A card and what holds in it. */
typedef struct verdict {
    kg_oa_sheet *sheet;
    kg_oa_stability *stability;
    unsigned char *reached; /* the floods */
    size_t loose, missing;
} verdict;

typedef struct window {
    int x0, x1; /* columns [x0, x1) */
} window;

/* When a change was sought for a patch, and what the best one costs for each patch made firm. */
typedef struct trial {
    int round; /* 0: never */
    size_t price;
} trial;

#define NOTHING_HELPS SIZE_MAX

typedef struct mender {
    kg_oa *card;         /* with its margins */
    kg_oa *before;       /* as it was when the round began */
    const kg_oa *wanted; /* as it was given */
    kg_oa_mend_limits limits;
    verdict now;    /* of `before` */
    int round;      /* from 1 */
    bool symmetric; /* every change is made on both sides */
    int *changed;   /* per column: the last round that changed it */
    trial *trials;  /* per cell of the sheet: what was tried for the patch that begins there */
    const kg_progress *progress;
    size_t first; /* loose patches at the beginning */
    int wider;    /* columns beside a patch that are changed as well */
    size_t limit; /* what a patch made firm may cost */
    size_t next;  /* the least that one costs which costs more; NOTHING_HELPS: there is none */
    struct {
        window *items;
        size_t count, capacity;
    } edits; /* windows changed in this round, apart from each other */
} mender;

/* ---- judging ---------------------------------------------------------------------------- */

static void forget(verdict *v) {
    kg_oa_sheet_destroy(v->sheet);
    kg_oa_stability_destroy(v->stability);
    free(v->reached);
    *v = (verdict){0};
}

static kg_status judge(const kg_oa *card, verdict *out, kg_error *error) {
    verdict v = {0};
    kg_status status = kg_oa_sheet_create(card, &v.sheet, error);
    if (!status)
        status = kg_oa_stability_create(v.sheet, &v.stability, error);
    if (!status) {
        v.reached = malloc((size_t)v.sheet->width * (size_t)v.sheet->rows);
        status = v.reached ? kg_oa_flood(v.sheet, v.reached, &v.missing, error)
                           : kg_fail(error, KG_ERR_MEMORY, "out of memory");
    }
    if (status) {
        forget(&v);
        return status;
    }
    v.loose = v.stability->loose_count;
    *out = v;
    return KG_OK;
}

static bool is_better(const verdict *a, const verdict *b) {
    return a->missing < b->missing || (a->missing == b->missing && a->loose < b->loose);
}

/* Takes over what is known of column x of the card for that of a part of it. */
static void hold_column(const mender *m, const kg_oa_sheet *part, int x, int part_x,
                        const kg_oa_stability *s, unsigned char *held, unsigned char *reached) {
    for (int row = 0; row < part->rows; row++) {
        size_t cell = kg_oa_cell(m->now.sheet, x, row), at = kg_oa_cell(part, part_x, row);
        reached[at] = m->now.reached[cell];
        for (size_t side = 0; side < 2; side++)
            if (m->now.stability->patches[m->now.stability->patch_of[2 * cell + side]].stable)
                held[s->patch_of[2 * at + side]] = 1;
    }
}

/* Of a part's patches, which are held: by columns at its rim, or by being back and base. */
static void hold_rim(const mender *m, const kg_oa_sheet *part, window w, const kg_oa_stability *s,
                     unsigned char *held, unsigned char *reached) {
    if (w.x0 > 0)
        hold_column(m, part, w.x0, 0, s, held, reached);
    if (w.x1 < m->card->width)
        hold_column(m, part, w.x1 - 1, part->width - 1, s, held, reached);
    if (w.x0 == 0) {
        reached[kg_oa_cell(part, 0, 0)] |= KG_OA_FROM_BACK;
        reached[kg_oa_cell(part, 0, part->rows - 1)] |= KG_OA_FROM_BASE;
        held[s->back] = held[s->base] = 1;
    }
}

static kg_status judge_patches(const mender *m, window w, verdict *v, kg_error *error) {
    kg_oa_neighbours n = {0};
    kg_oa_stability *s = v->stability;
    kg_status status = kg_oa_patches_map(v->sheet, s, error);
    if (status)
        return status;
    unsigned char *held = calloc(s->patch_count, 1);
    status = held ? kg_oa_neighbours_create(s, false, &n, error)
                  : kg_fail(error, KG_ERR_MEMORY, "out of memory");
    if (!status) {
        hold_rim(m, v->sheet, w, s, held, v->reached);
        if (!kg_oa_close(s, &n, held))
            status = kg_fail(error, KG_ERR_MEMORY, "out of memory");
    }
    kg_oa_neighbours_clear(&n);
    free(held);
    return status;
}

/* The columns of a window as a card of their own: only counts. */
static kg_status judge_part(const mender *m, window w, verdict *out, kg_error *error) {
    size_t levels = (size_t)m->card->height, at = (size_t)w.x0;
    kg_oa part = {.width = w.x1 - w.x0,
                  .depth_limit = m->card->depth_limit,
                  .height = m->card->height,
                  .depth = m->card->depth + at * levels,
                  .window = m->card->window + at * levels,
                  .omitted = m->card->omitted + at * (levels + 1),
                  .diagonals = m->card->diagonals};
    verdict v = {.stability = calloc(1, sizeof *v.stability)};
    kg_status status = v.stability ? kg_oa_sheet_create(&part, &v.sheet, error)
                                   : kg_fail(error, KG_ERR_MEMORY, "out of memory");
    if (!status) {
        v.reached = calloc((size_t)v.sheet->width * (size_t)v.sheet->rows, 1);
        status = v.reached ? judge_patches(m, w, &v, error)
                           : kg_fail(error, KG_ERR_MEMORY, "out of memory");
    }
    if (!status) {
        out->loose = v.stability->loose_count;
        out->missing = kg_oa_flood_on(v.sheet, v.reached);
    }
    forget(&v);
    return status;
}

/* ---- symmetric cards -------------------------------------------------------------------- */

static bool is_symmetric(const kg_oa *card) {
    size_t levels = (size_t)card->height;
    for (int x = 0, y = card->width - 1; x < y; x++, y--) {
        size_t a = (size_t)x, b = (size_t)y;
        if (memcmp(card->depth + a * levels, card->depth + b * levels,
                   levels * sizeof *card->depth) != 0 ||
            memcmp(card->window + a * levels, card->window + b * levels, levels) != 0 ||
            memcmp(card->omitted + a * (levels + 1), card->omitted + b * (levels + 1),
                   levels + 1) != 0)
            return false;
    }
    return true;
}

/* The same columns, and those on the other side when the card is symmetric. */
static window on_other_side(const mender *m, window w) {
    return m->symmetric ? (window){m->card->width - w.x1, m->card->width - w.x0} : w;
}

static void copy_window(const mender *m, kg_oa *to, const kg_oa *from, window w) {
    window other = on_other_side(m, w);
    kg_oa_mend_copy(to, from, w.x0, w.x1);
    kg_oa_mend_copy(to, from, other.x0, other.x1);
}

/* Makes a change of columns of the window, and on the other side of a symmetric card. */
static void change(mender *m, const kg_oa_mend *mend, window w) {
    int last = m->card->width - 1;
    bool at_left = w.x0 + w.x1 <= m->card->width;
    kg_oa_mend_apply(m->card, &m->limits, mend);
    for (int x = w.x0; x < w.x1 && m->symmetric; x++) {
        bool from_here = at_left ? x <= last - x : x >= last - x;
        kg_oa_mend_repeat(m->card, from_here ? last - x : x, from_here ? x : last - x);
    }
}

/* ---- one patch -------------------------------------------------------------------------- */

/* The columns around [x0, x1) that decide about it: one more than are changed. In the middle of a
 * symmetric card both sides of it. */
static window window_around(const mender *m, int x0, int x1, int wider) {
    int lo = x0 - wider - 2, hi = x1 + wider + 2;
    window w = {lo < 0 ? 0 : lo, hi > m->card->width ? m->card->width : hi};
    window other = on_other_side(m, w);
    if (w.x0 < other.x1 && other.x0 < w.x1)
        return (window){w.x0 < other.x0 ? w.x0 : other.x0, w.x1 > other.x1 ? w.x1 : other.x1};
    return w;
}

/* A change, what it costs, and how many patches and cells more then hold. */
typedef struct offer {
    const kg_oa_mend *mend;
    size_t cost, gain;
} offer;

static bool is_cheaper(const offer *a, const offer *b) {
    return a->gain > 0 && (b->gain == 0 || a->gain * b->cost > b->gain * a->cost);
}

static size_t gain_of(const verdict *was, const verdict *v) {
    if (!is_better(v, was))
        return 0;
    return was->missing - v->missing + (v->loose < was->loose ? was->loose - v->loose : 0);
}

/* What a change of a window is worth. One too dear, even if it firmed everything, is not looked at
 * closer. */
static kg_status try_mend(mender *m, const kg_oa_mend *mend, window w, const verdict *was,
                          offer *out, kg_error *error) {
    kg_status status = KG_OK;
    change(m, mend, w);
    *out =
        (offer){mend, kg_oa_mend_cost(m->card, m->before, w.x0, w.x1), was->loose + was->missing};
    if (out->cost == 0) {
        out->gain = 0;
    } else if (out->cost <= m->limit * out->gain) {
        verdict v = {0};
        status = judge_part(m, w, &v, error);
        out->gain = gain_of(was, &v);
    }
    copy_window(m, m->card, m->before, w);
    return status;
}

/* Makes the change that firms most patches of the window for its cost, if one does for that of
 * m->limit each; `out_price` is what it costs each at least, NOTHING_HELPS when none does. */
static kg_status mend_patch(mender *m, const kg_oa_patch *p, window w, size_t *out_price,
                            kg_error *error) {
    kg_oa_mend mends[KG_OA_MENDS];
    size_t count = kg_oa_mends_of(m->now.sheet, p, m->wider, mends);
    verdict was = {0};
    offer best = {0}, o;
    kg_status status = judge_part(m, w, &was, error);
    for (size_t i = 0; i < count && !status; i++) {
        status = try_mend(m, &mends[i], w, &was, &o, error);
        if (!status && is_cheaper(&o, &best))
            best = o;
    }
    *out_price = best.gain > 0 ? (best.cost + best.gain - 1) / best.gain : NOTHING_HELPS;
    if (!status && *out_price <= m->limit)
        change(m, best.mend, w);
    return status;
}

/* ---- rounds ----------------------------------------------------------------------------- */

/* Tells how far the work is, by what is no longer loose. */
static kg_status report(const mender *m, kg_error *error) {
    double fraction = fmax(1 - (double)m->now.loose / (double)(m->first + 1), 0);
    bool goes_on = !m->progress || !m->progress->call ||
                   m->progress->call(m->progress->user, fraction, "mending");
    return goes_on ? KG_OK : kg_fail(error, KG_ERR_CANCELLED, "cancelled");
}

static bool has_changed(const mender *m, window w, int since) {
    for (int x = w.x0; x < w.x1; x++)
        if (m->changed[x] >= since)
            return true;
    return false;
}

static void mark_changed(mender *m, window w) {
    window other = on_other_side(m, w);
    for (int x = w.x0; x < w.x1; x++)
        m->changed[x] = m->round;
    for (int x = other.x0; x < other.x1; x++)
        m->changed[x] = m->round;
}

/* Small ones first. */
static int compare_patches(const void *a, const void *b) {
    const kg_oa_patch *const *p = a, *const *q = b;
    if ((*p)->cells != (*q)->cells)
        return (*p)->cells < (*q)->cells ? -1 : 1;
    return *p < *q ? -1 : *p > *q;
}

/* The patches that are loose or hold a cell that a flood misses. `out` has room for all. */
static size_t find_troubled(const mender *m, const kg_oa_patch **out) {
    const kg_oa_sheet *sheet = m->now.sheet;
    const kg_oa_stability *s = m->now.stability;
    size_t count = 0, cells = (size_t)sheet->width * (size_t)sheet->rows;
    for (size_t i = 0; i < s->patch_count; i++)
        out[i] = s->patches[i].stable ? NULL : &s->patches[i];
    for (size_t i = 0; i < cells && m->now.missing > 0; i++)
        if (kg_oa_must_hold(sheet, i) && m->now.reached[i] != (KG_OA_FROM_BACK | KG_OA_FROM_BASE))
            for (size_t side = 0; side < 2; side++)
                out[s->patch_of[2 * i + side]] = &s->patches[s->patch_of[2 * i + side]];
    for (size_t i = 0; i < s->patch_count; i++)
        if (out[i])
            out[count++] = out[i];
    return count;
}

static bool is_too_dear(mender *m, const trial *t) {
    bool dear = t->price > m->limit;
    if (dear && t->price < m->next)
        m->next = t->price;
    return dear;
}

static kg_status mend_troubled(mender *m, const kg_oa_patch **patches, kg_error *error) {
    kg_status status = KG_OK;
    size_t count = find_troubled(m, patches);
    if (count > 1)
        qsort(patches, count, sizeof *patches, compare_patches);
    for (size_t i = 0; i < count && !status; i++) {
        const kg_oa_patch *p = patches[i];
        window w = window_around(m, p->x0, p->x1, m->wider);
        trial *t = &m->trials[kg_oa_cell(m->now.sheet, p->x0, p->row0)];
        bool known = t->round > 0 && !has_changed(m, w, t->round);
        if (has_changed(m, w, m->round) || (known && is_too_dear(m, t)))
            continue;
        status = report(m, error);
        if (!status)
            status = mend_patch(m, p, w, &t->price, error);
        t->round = m->round;
        if (status || is_too_dear(m, t))
            continue;
        mark_changed(m, w);
        if (!kg_push(&m->edits, w))
            status = kg_fail(error, KG_ERR_MEMORY, "out of memory");
    }
    return status;
}

/* Takes the card as it is now, when it is better than before. */
static kg_status keep_if_better(mender *m, bool *out_kept, kg_error *error) {
    verdict v = {0};
    kg_status status = judge(m->card, &v, error);
    *out_kept = !status && is_better(&v, &m->now);
    if (*out_kept) {
        forget(&m->now);
        m->now = v;
        kg_oa_mend_copy(m->before, m->card, 0, m->card->width);
    } else {
        forget(&v);
    }
    return status;
}

/* Makes the changes of a round one by one, and keeps those that are for the better. `after` has
 * room for the card. */
static kg_status keep_one_by_one(mender *m, kg_oa *after, bool *out_any, kg_error *error) {
    kg_status status = KG_OK;
    kg_oa_mend_copy(after, m->card, 0, m->card->width);
    kg_oa_mend_copy(m->card, m->before, 0, m->card->width);
    for (size_t i = 0; i < m->edits.count && !status; i++) {
        window w = m->edits.items[i];
        bool kept;
        copy_window(m, m->card, after, w);
        status = keep_if_better(m, &kept, error);
        if (!kept)
            copy_window(m, m->card, m->before, w);
        *out_any = *out_any || kept;
    }
    return status;
}

static kg_status settle(mender *m, kg_oa *after, bool *out_any, kg_error *error) {
    *out_any = false;
    if (m->edits.count == 0)
        return KG_OK;
    kg_status status = keep_if_better(m, out_any, error);
    if (!status && !*out_any)
        status = keep_one_by_one(m, after, out_any, error);
    m->edits.count = 0;
    return status;
}

/* Goes on where no change was worth its cost: with dearer ones, then with more columns. False when
 * all was tried. */
static bool go_further(mender *m) {
    size_t cells = (size_t)m->now.sheet->width * (size_t)m->now.sheet->rows;
    if (m->next < NOTHING_HELPS) {
        m->limit = m->next > 2 * m->limit ? m->next : 2 * m->limit;
        return true;
    }
    m->limit = 1;
    m->wider = m->wider > 0 ? 2 * m->wider : 1;
    memset(m->trials, 0, cells * sizeof *m->trials);
    return m->wider <= 2 * m->card->width;
}

static kg_status mend_all(mender *m, kg_oa *after, kg_error *error) {
    kg_status status = KG_OK;
    m->limit = 1;
    for (bool more = true; more && m->now.loose + m->now.missing > 0 && !status;) {
        const kg_oa_patch **patches = malloc(m->now.stability->patch_count * sizeof *patches);
        bool any = false;
        m->round++;
        m->next = NOTHING_HELPS;
        status = patches ? mend_troubled(m, patches, error)
                         : kg_fail(error, KG_ERR_MEMORY, "out of memory");
        free(patches);
        if (!status)
            status = settle(m, after, &any, error);
        if (!status)
            status = report(m, error);
        if (!any)
            more = go_further(m);
    }
    return status;
}

/* ---- putting back ----------------------------------------------------------------------- */

/* Puts a column back as it was wanted, when all stays firm. */
static kg_status put_back(mender *m, int x, kg_error *error) {
    window one = {x, x + 1};
    verdict part = {0}, v = {0};
    copy_window(m, m->card, m->wanted, one);
    kg_status status = judge_part(m, window_around(m, x, x + 1, 0), &part, error);
    if (!status && part.loose + part.missing == 0)
        status = judge(m->card, &v, error);
    if (v.sheet && v.loose + v.missing == 0) {
        forget(&m->now);
        m->now = v;
        copy_window(m, m->before, m->card, one);
    } else {
        forget(&v);
        copy_window(m, m->card, m->before, one);
    }
    return status;
}

/* Columns that need not have been changed. */
static kg_status put_back_all(mender *m, kg_error *error) {
    kg_status status = KG_OK;
    for (int x = m->limits.first; x < m->limits.last && !status; x++)
        if (kg_oa_mend_cost(m->card, m->wanted, x, x + 1) > 0 && !(status = report(m, error)))
            status = put_back(m, x, error);
    return status;
}

/* ---- all -------------------------------------------------------------------------------- */

/* Hands the columns back without margins. */
static void hand_back(const mender *m, kg_oa *oa) {
    int margin = m->limits.first;
    size_t levels = (size_t)oa->height;
    for (int x = 0; x < oa->width; x++) {
        size_t to = (size_t)x * levels, from = (size_t)(x + margin) * (size_t)m->card->height;
        memcpy(oa->depth + to, m->card->depth + from, levels * sizeof *oa->depth);
        memcpy(oa->window + to, m->card->window + from, levels);
        memcpy(oa->omitted + to + (size_t)x, m->card->omitted + from + (size_t)(x + margin),
               levels + 1);
    }
}

static size_t count_changes(const kg_oa *a, const kg_oa *b) {
    size_t count = 0;
    for (int x = 0; x < a->width; x++)
        for (int z = 0; z < a->height; z++)
            count += kg_oa_depth(a, x, z) != kg_oa_depth(b, x, z) ||
                     kg_oa_window(a, x, z) != kg_oa_window(b, x, z) ||
                     kg_oa_omitted(a, x, z + 1) != kg_oa_omitted(b, x, z + 1);
    return count;
}

static kg_oa *margined(const kg_oa *oa) {
    kg_oa *card = kg_oa_with_margins(oa);
    if (card)
        card->diagonals = oa->diagonals;
    return card;
}

kg_status kg_oa_stabilize(kg_oa *oa, const kg_progress *progress, kg_oa_mended *out_mended,
                          kg_error *error) {
    mender m = {
        .card = margined(oa),
        .before = margined(oa),
        .limits = {oa->margin_cells, oa->margin_cells + oa->width, oa->height, oa->depth_limit}};
    kg_oa *wanted = margined(oa), *after = margined(oa);
    bool done = m.card && m.before && wanted && after;
    kg_status status = done ? judge(m.card, &m.now, error) : KG_OK;
    if (done && !status) {
        m.wanted = wanted;
        m.progress = progress;
        m.first = m.now.loose;
        m.symmetric = is_symmetric(wanted);
        m.changed = calloc((size_t)m.now.sheet->width, sizeof *m.changed);
        m.trials = calloc((size_t)m.now.sheet->width * (size_t)m.now.sheet->rows, sizeof *m.trials);
        done = m.changed && m.trials;
    }
    if (done && !status)
        status = mend_all(&m, after, error);
    if (done && !status && m.now.loose + m.now.missing == 0)
        status = put_back_all(&m, error);
    if (!done)
        status = kg_fail(error, KG_ERR_MEMORY, "out of memory");
    if (!status) {
        *out_mended = (kg_oa_mended){count_changes(m.before, wanted), m.now.loose, m.now.missing};
        kg_oa_mend_copy(m.card, m.before, 0, m.card->width);
        hand_back(&m, oa);
    }
    forget(&m.now);
    kg_oa_destroy(m.card);
    kg_oa_destroy(m.before);
    kg_oa_destroy(wanted);
    kg_oa_destroy(after);
    free(m.changed);
    free(m.trials);
    free(m.edits.items);
    return status;
}
