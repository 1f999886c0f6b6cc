#include "unroll/stretch.h"

#include "base/array.h"
#include "model/border.h"

/* A point this many chord errors from an edge counts as on it: both are polylines of the same
 * curve, each off by one chord error. */
#define ON_EDGE 4.0

/* What changes along an edge changes within this many chord errors of the true place: the reach of
 * ON_EDGE at flat angles. */
#define BLUR 40.0

/* Both sides of a seam are the same curve: a corner this far from it, mm, lies beyond its end. */
#define ON_CURVE 1e-6

/* Places are looked up this often, mm: what is narrower neither holds glue nor needs it. */
#define STEP 2.0

/* Stretches shorter than this, mm, hold no glue and are left out: corners where parts touch. */
#define SHORTEST 0.05

/* Positions are multiples of this fraction of a chord, so that one turn more or less around a
 * closed edge is exact. */
#define GRAIN 0x1p-32

static double grained(double position) {
    return round(position / GRAIN) * GRAIN;
}

/* ---- where a point of an edge lies ------------------------------------------------------ */

typedef enum place_kind { FREE, CONTACT, SEAM } place_kind;

typedef struct place {
    place_kind kind;
    kg_edge_ref on; /* the edge of a seam; of a contact only the piece */
} place;

static bool same_place(place a, place b) {
    return a.kind == b.kind && kg_same_edge(a.on, b.on);
}

/* An edge to walk along, cut by patch `source`. */
typedef struct walk {
    kg_pieces *pieces;
    kg_edge_ref edge;
    int64_t source;
    double near;               /* mm */
    size_t first, end;         /* pieces of the source */
    size_t first_cut, end_cut; /* cut edges with the same source */
} walk;

static bool is_cut_by(const kg_pieces *pieces, kg_edge_ref edge, int64_t source) {
    const kg_region_edge *e = kg_piece_edge(pieces, edge);
    return e->kind == KG_EDGE_CUT && e->source == source;
}

/* On an edge of the source that the walker's patch made? */
static bool on_mutual_edge(const walk *w, const kg_cross_point *p, place *out) {
    int64_t own = w->pieces->items[w->edge.piece].patch->id;
    for (size_t i = w->first; i < w->end; i++)
        for (size_t k = 0; k < w->pieces->items[i].region->loop_count; k++) {
            const kg_region_loop *loop = &w->pieces->items[i].region->loops[k];
            for (size_t e = 0; e < loop->edge_count; e++) {
                kg_edge_ref at = {i, k, e};
                if (is_cut_by(w->pieces, at, own) &&
                    kg_edge_near(kg_piece_patch(w->pieces, i), loop, &loop->edges[e], false, p->s,
                                 p->t, w->near)) {
                    *out = (place){SEAM, at};
                    return true;
                }
            }
        }
    return false;
}

/* Inside a piece of the source, or on its border? */
static bool on_source(const walk *w, const kg_cross_point *p, place *out) {
    bool found = false;
    for (size_t i = w->first; i < w->end; i++) {
        const kg_region *region = w->pieces->items[i].region;
        bool inside = kg_region_contains(region, p->s, p->t), border = false;
        for (size_t k = 0; k < region->loop_count && !inside && !border && !found; k++)
            border =
                kg_loop_near(kg_piece_patch(w->pieces, i), &region->loops[k], p->s, p->t, w->near);
        if (inside || border) {
            *out = (place){CONTACT, {i, 0, 0}};
            found = true;
        }
        if (inside)
            break;
    }
    return found;
}

/* On another edge that the source made? */
static bool on_sibling(const walk *w, const kg_cross_point *p, place *out) {
    const kg_patch *source = &kg_solution_find(w->pieces->solution, w->source)->patch;
    for (size_t i = w->first_cut; i < w->end_cut; i++) {
        kg_edge_ref at = w->pieces->cuts[i];
        if (!kg_same_edge(at, w->edge) &&
            kg_edge_near(source, kg_piece_loop(w->pieces, at), kg_piece_edge(w->pieces, at), true,
                         p->s, p->t, w->near)) {
            *out = (place){SEAM, at};
            return true;
        }
    }
    return false;
}

static place place_at(const walk *w, double position) {
    kg_cross_point p = kg_piece_point(w->pieces, w->edge, position, NULL);
    place found = {FREE, {0}};
    if (!on_mutual_edge(w, &p, &found) && !on_source(w, &p, &found))
        on_sibling(w, &p, &found);
    return found;
}

/* ---- walking ---------------------------------------------------------------------------- */

static walk start_walk(kg_pieces *pieces, kg_edge_ref edge) {
    walk w = {.pieces = pieces,
              .edge = edge,
              .source = kg_piece_edge(pieces, edge)->source,
              .near = ON_EDGE * kg_solution_tolerance(pieces->solution)};
    size_t i = (size_t)(kg_solution_find(pieces->solution, w.source) -
                        kg_solution_patch(pieces->solution, 0));
    w.first = pieces->first_of_patch[i];
    w.end = pieces->first_of_patch[i + 1];
    size_t lo = 0, hi = pieces->cut_count;
    while (lo < hi) {
        size_t mid = lo + (hi - lo) / 2;
        if (kg_piece_edge(pieces, pieces->cuts[mid])->source < w.source)
            lo = mid + 1;
        else
            hi = mid;
    }
    w.first_cut = w.end_cut = lo;
    while (w.end_cut < pieces->cut_count &&
           kg_piece_edge(pieces, pieces->cuts[w.end_cut])->source == w.source)
        w.end_cut++;
    return w;
}

double kg_stretch_chords(const kg_pieces *all, const kg_stretch *s) {
    double sum = 0;
    kg_vec3 a = kg_piece_point(all, s->edge, s->from, NULL).x;
    for (double p = s->from; p < s->to;) {
        p = fmin(floor(p) + 1, s->to);
        kg_vec3 b = kg_piece_point(all, s->edge, p, NULL).x;
        sum += kg_dist(a, b);
        a = b;
    }
    return sum;
}

void kg_stretch_divide(const kg_pieces *all, const kg_stretch *s, int count, double *out) {
    double length = kg_stretch_chords(all, s), sum = 0;
    int next = 1;
    kg_vec3 a = kg_piece_point(all, s->edge, s->from, NULL).x;
    for (double from = s->from; from < s->to && next < count;) {
        double to = fmin(floor(from) + 1, s->to);
        kg_vec3 b = kg_piece_point(all, s->edge, to, NULL).x;
        double step = kg_dist(a, b);
        for (; next < count && step > 0 && length * next / count <= sum + step; next++)
            out[next - 1] = from + (to - from) * (length * next / count - sum) / step;
        sum += step;
        from = to;
        a = b;
    }
    for (; next < count; next++) /* rounding keeps the sum below the length */
        out[next - 1] = s->to;
}

static kg_status add_stretch(const walk *w, double from, double to, place at) {
    kg_pieces *all = w->pieces;
    kg_stretch stretch = {.edge = w->edge,
                          .from = from,
                          .to = to,
                          .partner = at.on,
                          .seam = at.kind == SEAM,
                          .mate = all->stretch_count};
    if (at.kind == FREE || kg_stretch_chords(all, &stretch) < SHORTEST)
        return KG_OK;
    if (!kg_reserve_bytes((void **)&all->stretches, &all->stretch_capacity, all->stretch_count + 1,
                          sizeof *all->stretches))
        return KG_ERR_MEMORY;
    all->stretches[all->stretch_count] = stretch;
    all->stretch_count++;
    return KG_OK;
}

/* Where the place changes between two positions, snapped to a point of the edge that is there. */
static double change_between(const walk *w, double lo, double hi, place before) {
    for (int k = 0; k < 48; k++) {
        double mid = 0.5 * (lo + hi);
        if (same_place(place_at(w, mid), before))
            lo = mid;
        else
            hi = mid;
    }
    double at = grained(0.5 * (lo + hi)), nearest = round(at);
    kg_vec3 x = kg_piece_point(w->pieces, w->edge, at, NULL).x;
    kg_vec3 y = kg_piece_point(w->pieces, w->edge, nearest, NULL).x;
    double blur = BLUR * kg_solution_tolerance(w->pieces->solution);
    return kg_dist(x, y) <= blur ? nearest : at;
}

/* One stretch runs over the start of a closed edge: joins the first of its edge to the last. */
static void join_around(kg_pieces *all, kg_edge_ref edge) {
    size_t first, end;
    kg_piece_stretches(all, edge, &first, &end);
    if (!kg_piece_closed(all, edge) || end - first < 2)
        return;
    kg_stretch *a = &all->stretches[first], *b = &all->stretches[end - 1];
    double count = (double)kg_piece_edge(all, edge)->count;
    if (a->from > 0 || b->to < count || a->seam != b->seam || !kg_same_edge(a->partner, b->partner))
        return;
    b->to = count + a->to;
    for (size_t i = first; i + 1 < end; i++) {
        all->stretches[i] = all->stretches[i + 1];
        all->stretches[i].mate = i;
    }
    all->stretch_count--;
}

static kg_status walk_edge(const walk *w) {
    size_t count = kg_piece_edge(w->pieces, w->edge)->count;
    double from = 0, before = 0;
    place current = {FREE, {0}};
    kg_status status = KG_OK;
    for (size_t i = 0; i < count; i++) {
        double length = kg_dist(kg_piece_point(w->pieces, w->edge, (double)i, NULL).x,
                                kg_piece_point(w->pieces, w->edge, (double)i + 1, NULL).x);
        double steps = ceil(length / STEP) + (count == 1);
        for (double k = 0.5; k < steps && !status; k++) {
            double position = (double)i + k / steps;
            place next = place_at(w, position);
            if (before == 0)
                current = next;
            if (!same_place(next, current)) {
                double at = change_between(w, before, position, current);
                if (at > from)
                    status = add_stretch(w, from, at, current);
                from = at;
                current = next;
            }
            before = position;
        }
    }
    if (!status)
        status = add_stretch(w, from, (double)count, current);
    if (!status)
        join_around(w->pieces, w->edge);
    return status;
}

/* The edge along a ruling where a large part was cut in two: its other side is on a piece of the
 * same patch. */
static kg_status join_halves(const walk *w) {
    const kg_pieces *all = w->pieces;
    const kg_region_edge *own = kg_piece_edge(all, w->edge);
    size_t patch = (size_t)(all->items[w->edge.piece].patch - kg_solution_patch(all->solution, 0));
    kg_vec3 start = kg_piece_point(all, w->edge, 0, NULL).x;
    for (size_t i = all->first_of_patch[patch]; i < all->first_of_patch[patch + 1]; i++)
        for (size_t k = 0; k < all->items[i].region->loop_count; k++)
            for (size_t e = 0; e < all->items[i].region->loops[k].edge_count; e++) {
                kg_edge_ref at = {i, k, e};
                const kg_region_edge *other = kg_piece_edge(all, at);
                if (other->kind == KG_EDGE_SPLIT && other->source == own->source &&
                    !kg_same_edge(at, w->edge) &&
                    kg_dist(kg_piece_point(all, at, (double)other->count, NULL).x, start) <=
                        BLUR * kg_solution_tolerance(all->solution))
                    return add_stretch(w, 0, (double)own->count, (place){SEAM, at});
            }
    return KG_OK;
}

/* ---- mating ----------------------------------------------------------------------------- */

/* Points of a stretch at fractions k / MARKS of its length; lengths of chords do here. */
enum { MARKS = 4 };

static void sample(const kg_pieces *all, const kg_stretch *s, kg_vec3 out[MARKS + 1]) {
    double length = kg_stretch_chords(all, s), sum = 0;
    int next = 0;
    kg_vec3 a = kg_piece_point(all, s->edge, s->from, NULL).x;
    for (double p = s->from; p < s->to;) {
        p = fmin(floor(p) + 1, s->to);
        kg_vec3 b = kg_piece_point(all, s->edge, p, NULL).x;
        double step = kg_dist(a, b);
        for (; next <= MARKS && next * length / MARKS <= sum + step; next++)
            out[next] = kg_lerp(a, b, step > 0 ? (next * length / MARKS - sum) / step : 0);
        sum += step;
        a = b;
    }
    for (; next <= MARKS; next++)
        out[next] = a;
}

/* Do two stretches run along the same curve, and in which direction? Quarters by length tell closed
 * curves and curves between the same ends apart. */
static bool run_together(const kg_pieces *all, const kg_stretch *a, const kg_stretch *b,
                         bool *out_reversed) {
    double near = 2 * BLUR * kg_solution_tolerance(all->solution);
    bool same = true, opposite = true;
    kg_vec3 x[MARKS + 1], y[MARKS + 1];
    sample(all, a, x);
    sample(all, b, y);
    for (int i = 0; i <= MARKS; i++) {
        same = same && kg_dist(x[i], y[i]) <= near;
        opposite = opposite && kg_dist(x[i], y[MARKS - i]) <= near;
        if (!same && !opposite)
            return false;
    }
    *out_reversed = opposite;
    return true;
}

/* The stretch of the partner's edge that runs along this one; its own index when there is none. */
static size_t find_mate(const kg_pieces *all, size_t index, bool *out_reversed) {
    const kg_stretch *s = &all->stretches[index];
    size_t first, end;
    kg_piece_stretches(all, s->partner, &first, &end);
    for (size_t i = first; i < end; i++)
        if (i != index && run_together(all, s, &all->stretches[i], out_reversed))
            return i;
    return index;
}

/* Is a position at a corner of the part? */
static bool is_vertex(const kg_pieces *all, kg_edge_ref edge, double position) {
    return !kg_piece_closed(all, edge) &&
           (position == 0 || position == (double)kg_piece_edge(all, edge)->count);
}

/* The position of an edge nearest to a point, from a position close to it. */
static double position_near(const kg_pieces *all, kg_edge_ref edge, double position, kg_vec3 x) {
    double count = (double)kg_piece_edge(all, edge)->count;
    for (int k = 0; k < 8; k++) {
        kg_cross_point slope, p = kg_piece_point(all, edge, position, &slope);
        position += kg_dot(kg_sub(x, p.x), slope.x) / kg_dot(slope.x, slope.x);
        if (!kg_piece_closed(all, edge))
            position = fmin(fmax(position, 0), count);
    }
    /* no two points of an outline where one will do */
    kg_vec3 nearest = kg_piece_point(all, edge, round(position), NULL).x;
    return kg_dist(nearest, x) <= ON_CURVE ? round(position) : grained(position);
}

/* Moves one end of a stretch, and that of the contact that touches it there; another seam ends at a
 * corner of its own. */
static void move_end(kg_pieces *all, size_t index, bool last, double position) {
    kg_stretch *s = &all->stretches[index];
    double *end = last ? &s->to : &s->from, count = (double)kg_piece_edge(all, s->edge)->count;
    bool closed = kg_piece_closed(all, s->edge);
    size_t first, behind;
    kg_piece_stretches(all, s->edge, &first, &behind);
    for (size_t i = first; i < behind; i++) {
        double *other = last ? &all->stretches[i].from : &all->stretches[i].to;
        double gap = *other - *end;
        if (i != index && !all->stretches[i].seam && (gap == 0 || (closed && fabs(gap) == count)))
            *other = position + gap;
    }
    *end = position;
}

/* Moves one end of stretch `to` to where an end of another lies on its edge; false when it does not
 * lie on it, or is no corner of its part but found to chord errors only. */
static bool follow_end(kg_pieces *all, const kg_stretch *from, bool last, size_t to, bool last_to) {
    double corner = last ? from->to : from->from;
    const kg_stretch *s = &all->stretches[to];
    if (!is_vertex(all, from->edge, corner))
        return false;
    kg_vec3 x = kg_piece_point(all, from->edge, corner, NULL).x;
    double position = position_near(all, s->edge, last_to ? s->to : s->from, x);
    if (kg_dist(kg_piece_point(all, s->edge, position, NULL).x, x) > ON_CURVE)
        return false;
    move_end(all, to, last_to, position);
    return true;
}

/* Both sides of a seam end at the same points of space: at the first corner of either part. */
static void align_ends(kg_pieces *all, size_t index) {
    const kg_stretch *a = &all->stretches[index], *b = &all->stretches[a->mate];
    for (int end = 0; end < 2; end++) {
        bool last = end, last_b = end ^ a->mate_reversed;
        if (!follow_end(all, a, last, a->mate, last_b))
            follow_end(all, b, last_b, index, last);
    }
}

/* Where more than two edges run along one curve, the third takes its ends from its mate, which has
 * a mate of its own; where it does not reach as far it is left out. */
static void take_ends(kg_pieces *all, size_t index) {
    kg_stretch *a = &all->stretches[index];
    const kg_stretch *b = &all->stretches[a->mate];
    for (int end = 0; end < 2 && !a->single; end++) {
        bool last_b = end ^ a->mate_reversed;
        kg_vec3 x = kg_piece_point(all, b->edge, last_b ? b->to : b->from, NULL).x;
        double position = position_near(all, a->edge, end ? a->to : a->from, x);
        a->single = kg_dist(kg_piece_point(all, a->edge, position, NULL).x, x) > ON_CURVE;
        if (!a->single)
            move_end(all, index, end, position);
    }
}

static void mate_stretches(kg_pieces *all) {
    for (size_t i = 0; i < all->stretch_count; i++) {
        kg_stretch *s = &all->stretches[i];
        if (!s->seam)
            continue;
        s->mate = find_mate(all, i, &s->mate_reversed);
        if (s->mate != i)
            continue;
        /* along an edge whose stretches end elsewhere: on the source still a contact */
        s->seam = false;
        s->single = all->items[s->partner.piece].patch->id != kg_piece_edge(all, s->edge)->source;
    }
    for (size_t i = 0; i < all->stretch_count; i++)
        if (all->stretches[i].mate > i && all->stretches[all->stretches[i].mate].mate == i)
            align_ends(all, i);
    for (size_t i = 0; i < all->stretch_count; i++)
        if (all->stretches[all->stretches[i].mate].mate != i)
            take_ends(all, i);
    for (size_t i = 0; i < all->stretch_count; i++) { /* nothing may be left between the ends */
        kg_stretch *s = &all->stretches[i], *mate = &all->stretches[s->mate];
        s->single = s->single || s->to <= s->from || mate->to <= mate->from;
    }
}

kg_status kg_pieces_find_stretches(kg_pieces *pieces) {
    kg_status status = KG_OK;
    for (size_t i = 0; i < pieces->count; i++)
        for (size_t k = 0; k < pieces->items[i].region->loop_count; k++)
            for (size_t e = 0; e < pieces->items[i].region->loops[k].edge_count; e++) {
                kg_edge_ref edge = {i, k, e};
                kg_edge_kind kind = kg_piece_edge(pieces, edge)->kind;
                walk w = {.pieces = pieces, .edge = edge};
                if (!status && kind == KG_EDGE_CUT) {
                    w = start_walk(pieces, edge);
                    status = walk_edge(&w);
                } else if (!status && kind == KG_EDGE_SPLIT) {
                    status = join_halves(&w);
                }
            }
    if (!status)
        mate_stretches(pieces);
    for (size_t i = 0; i < pieces->stretch_count && !status; i++) {
        kg_stretch *s = &pieces->stretches[i];
        s->measure = kg_piece_measure(pieces, s->edge, s->from, s->to);
    }
    return status;
}
