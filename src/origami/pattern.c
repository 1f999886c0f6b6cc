/* Crease patterns to states. */
#include "origami/pattern.h"

#include "origami/convex.h"

#include <stdlib.h>
#include <string.h>

/* Relative to the size: ends of segments this near are one vertex. */
#define SAME_POINT 1e-6

kg_vec2 kg_pattern_in_file(const kg_pattern *p, kg_vec2 place) {
    bool same = p->unit.x == 0;
    return kg_v2(same ? place.x : place.x / p->unit.x,
                 same ? place.y : place.y / p->unit.y + 0); /* no -0 */
}

void kg_pattern_clear(kg_pattern *p) {
    free(p->vertices.items);
    free(p->edges.items);
    kg_face_list_clear(&p->faces);
    free(p->divided.items);
    *p = (kg_pattern){0};
}

double kg_pattern_length(const kg_pattern *p) {
    kg_box2 box = kg_box2_empty();
    for (size_t i = 0; i < p->vertices.count; i++)
        kg_box2_add(&box, p->vertices.items[i]);
    return p->vertices.count ? fmax(box.hi.x - box.lo.x, box.hi.y - box.lo.y) : 0;
}

/* ---- cleaning --------------------------------------------------------------------------- */

static int32_t vertex_at(kg_pattern *p, size_t old_count, kg_vec2 point, double same) {
    for (size_t i = old_count; i < p->vertices.count; i++)
        if (kg_dist2(p->vertices.items[i], point) <= same)
            return (int32_t)(i - old_count);
    return kg_push(&p->vertices, point) ? (int32_t)(p->vertices.count - 1 - old_count) : -1;
}

/* Where segment b meets segment a, as parameters of a: a crossing, or ends of b on a. */
static size_t meetings(const kg_vec2 a[2], const kg_vec2 b[2], double same, double out[3]) {
    size_t n = 0;
    kg_vec2 d = kg_sub2(a[1], a[0]), e = kg_sub2(b[1], b[0]);
    double length = kg_len2(d), area = kg_cross2(d, e);
    for (int k = 0; k < 2; k++) {
        kg_vec2 r = kg_sub2(b[k], a[0]);
        double t = kg_dot2(d, r) / (length * length);
        if (fabs(kg_cross2(d, r)) <= same * length && t * length > same && (1 - t) * length > same)
            out[n++] = t;
    }
    if (n == 0 && fabs(area) > 1e-9 * length * kg_len2(e)) {
        kg_vec2 r = kg_sub2(b[0], a[0]);
        double t = kg_cross2(r, e) / area, u = kg_cross2(r, d) / area;
        if (t * length > same && (1 - t) * length > same && u > 0 && u < 1)
            out[n++] = t;
    }
    return n;
}

static int compare_numbers(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return x < y ? -1 : x > y;
}

static int compare_edges(const void *a, const void *b) {
    const kg_pattern_edge *x = a, *y = b;
    for (int k = 0; k < 2; k++)
        if (x->ends[k] != y->ends[k])
            return x->ends[k] < y->ends[k] ? -1 : 1;
    /* of the same line drawn twice the border counts, then creases, then flat lines */
    static const char rank[] = "BCMVUFJ";
    long rx = strchr(rank, x->assignment) - rank, ry = strchr(rank, y->assignment) - rank;
    return rx < ry ? -1 : rx > ry;
}

kg_status kg_pattern_clean(kg_pattern *p, kg_error *error) {
    size_t old_vertices = p->vertices.count, count = p->edges.count;
    double size = kg_pattern_length(p), same = SAME_POINT * size;
    kg_pattern_edge *old = malloc((count + 1) * sizeof *old);
    double *cuts = malloc((3 * count + 2) * sizeof *cuts);
    kg_status status = old && cuts ? KG_OK : KG_ERR_MEMORY;
    if (old && count > 0)
        memcpy(old, p->edges.items, count * sizeof *old);
    p->edges.count = 0;
    for (size_t i = 0; i < count && !status; i++) {
        kg_vec2 a[2] = {p->vertices.items[old[i].ends[0]], p->vertices.items[old[i].ends[1]]};
        size_t n = 0;
        if (!(kg_dist2(a[0], a[1]) > same))
            continue;
        cuts[n++] = 0, cuts[n++] = 1;
        for (size_t k = 0; k < count; k++) {
            kg_vec2 b[2] = {p->vertices.items[old[k].ends[0]], p->vertices.items[old[k].ends[1]]};
            if (k != i)
                n += meetings(a, b, same, cuts + n);
        }
        qsort(cuts, n, sizeof *cuts, compare_numbers);
        int32_t last = -1;
        for (size_t k = 0; k < n && !status; k++) {
            int32_t v = vertex_at(p, old_vertices, kg_lerp2(a[0], a[1], cuts[k]), same);
            kg_pattern_edge e = old[i];
            e.ends[0] = last < v ? last : v, e.ends[1] = last < v ? v : last;
            if (v < 0 || (last >= 0 && last != v && !kg_push(&p->edges, e)))
                status = KG_ERR_MEMORY;
            last = v;
        }
    }
    free(old);
    free(cuts);
    if (status)
        return kg_fail(error, status, "out of memory");
    p->vertices.count -= old_vertices;
    if (p->vertices.count > 0)
        memmove(p->vertices.items, p->vertices.items + old_vertices,
                p->vertices.count * sizeof *p->vertices.items);
    if (p->edges.count > 0)
        qsort(p->edges.items, p->edges.count, sizeof *p->edges.items, compare_edges);
    size_t kept = 0;
    for (size_t i = 0; i < p->edges.count; i++) {
        const kg_pattern_edge *e = &p->edges.items[i];
        if (kept == 0 || memcmp(e->ends, p->edges.items[kept - 1].ends, sizeof e->ends) != 0)
            p->edges.items[kept++] = *e;
    }
    p->edges.count = kept;
    return KG_OK;
}

/* ---- faces ------------------------------------------------------------------------------ */

typedef struct spoke {
    int32_t from, half; /* half-edges as in states: 2 e and 2 e + 1 */
    double angle;
} spoke;

static int compare_spokes(const void *a, const void *b) {
    const spoke *x = a, *y = b;
    if (x->from != y->from)
        return x->from < y->from ? -1 : 1;
    if (x->angle != y->angle)
        return x->angle < y->angle ? -1 : 1;
    return x->half < y->half ? -1 : x->half > y->half;
}

static int32_t from_of(const kg_pattern *p, int32_t half) {
    return p->edges.items[half >> 1].ends[half & 1];
}

/* The half-edge that follows each around its face: at its end the next spoke clockwise. */
static kg_status find_next(const kg_pattern *p, int32_t *next) {
    size_t n = 2 * p->edges.count;
    spoke *spokes = malloc((n + 1) * sizeof *spokes);
    if (!spokes)
        return KG_ERR_MEMORY;
    for (size_t h = 0; h < n; h++) {
        int32_t a = from_of(p, (int32_t)h), b = from_of(p, (int32_t)(h ^ 1));
        kg_vec2 d = kg_sub2(p->vertices.items[b], p->vertices.items[a]);
        spokes[h] = (spoke){a, (int32_t)h, atan2(d.y, d.x)};
    }
    qsort(spokes, n, sizeof *spokes, compare_spokes);
    for (size_t first = 0, last; first < n; first = last) {
        for (last = first; last < n && spokes[last].from == spokes[first].from;)
            last++;
        for (size_t i = first; i < last; i++)
            next[spokes[i].half ^ 1] = spokes[i > first ? i - 1 : last - 1].half;
    }
    free(spokes);
    return KG_OK;
}

/* Walks one face; its corners go to `corners`. */
static size_t walk(const kg_pattern *p, const int32_t *next, int32_t start, int32_t *faces,
                   int32_t face, int32_t *corners, double *out_area) {
    size_t n = 0;
    double twice = 0;
    kg_vec2 o = p->vertices.items[from_of(p, start)];
    for (int32_t h = start; faces[h] < 0; h = next[h]) {
        faces[h] = face;
        corners[n++] = from_of(p, h);
        twice += kg_cross2(kg_sub2(p->vertices.items[from_of(p, h)], o),
                           kg_sub2(p->vertices.items[from_of(p, h ^ 1)], o));
    }
    *out_area = twice / 2;
    return n;
}

/* Paper ends at borders and cuts; what lies on the far side of borders all around is a hole. */
static bool is_hole(const kg_pattern *p, const int32_t *next, const int32_t *faces,
                    const double *areas, int32_t start) {
    int32_t h = start;
    do {
        if (p->edges.items[h >> 1].assignment != 'B' || !(areas[faces[h ^ 1]] > 0))
            return false;
    } while ((h = next[h]) != start);
    return true;
}

kg_status kg_pattern_trace(kg_pattern *p, kg_error *error) {
    size_t n = 2 * p->edges.count;
    int32_t *next = malloc((n + 1) * sizeof *next), *faces = malloc((n + 1) * sizeof *faces),
            *corners = malloc((n + 1) * sizeof *corners),
            *starts = malloc((n + 1) * sizeof *starts);
    double *areas = malloc((n + 1) * sizeof *areas);
    bool ok = next && faces && corners && starts && areas;
    kg_status status = ok ? find_next(p, next) : KG_ERR_MEMORY;
    for (size_t h = 0; h < n && ok; h++)
        faces[h] = -1;
    int32_t count = 0;
    for (size_t h = 0; h < n && !status; h++)
        if (faces[h] < 0) {
            starts[count] = (int32_t)h;
            walk(p, next, (int32_t)h, faces, count, corners, &areas[count]);
            count++;
        }
    double least = SAME_POINT * kg_pattern_length(p) * SAME_POINT * kg_pattern_length(p);
    for (int32_t f = 0; f < count && !status; f++) {
        if (!(areas[f] > least) || is_hole(p, next, faces, areas, starts[f]))
            continue;
        size_t m = 0;
        int32_t h = starts[f];
        do
            corners[m++] = from_of(p, h);
        while ((h = next[h]) != starts[f]);
        status = kg_face_list_add(&p->faces, corners, m);
    }
    free(next);
    free(faces);
    free(corners);
    free(starts);
    free(areas);
    if (!status && p->faces.starts.count == 0)
        return kg_fail(error, KG_ERR_INPUT, "the lines enclose no paper");
    return status ? kg_fail(error, status, "out of memory") : KG_OK;
}

/* ---- states ----------------------------------------------------------------------------- */

static kg_status add_edges(kg_origami_state *s, const kg_pattern *p) {
    kg_status status = KG_OK;
    for (size_t i = 0; i < p->edges.count && !status; i++) {
        const kg_pattern_edge *e = &p->edges.items[i];
        bool crease = e->assignment == 'M' || e->assignment == 'V' || e->assignment == 'F';
        kg_paper_edge_kind kind = crease                 ? KG_PAPER_CREASE
                                  : e->assignment == 'U' ? KG_PAPER_OPEN
                                  : e->assignment == 'J' ? KG_PAPER_JOIN
                                                         : KG_PAPER_BORDER;
        status = kg_state_add_edge(s, e->ends[0], e->ends[1], kind,
                                   kind == KG_PAPER_BORDER ? 0 : e->angle);
    }
    return status;
}

/* A border or cut with paper on both sides becomes two borders. */
static kg_status open_cuts(kg_origami_state *s) {
    size_t count = s->edges.count;
    for (size_t e = 0; e < count; e++) {
        int32_t h = (int32_t)(2 * e), k = h + 1;
        if (s->edges.items[e].kind != KG_PAPER_BORDER || kg_loop_of(s, h) < 0 ||
            kg_loop_of(s, k) < 0)
            continue;
        /* k moves to a new edge, whose other direction is outside the paper */
        int32_t moved = (int32_t)s->halves.count, loop = kg_loop_of(s, k), before = k;
        kg_half_edge inside = s->halves.items[k], outside = {s->halves.items[h].origin, -1, -1};
        while (kg_next(s, before) != k)
            before = kg_next(s, before);
        kg_paper_edge border = {KG_PAPER_BORDER, 0};
        if (!kg_push(&s->halves, inside) || !kg_push(&s->halves, outside) ||
            !kg_push(&s->edges, border))
            return KG_ERR_MEMORY;
        s->halves.items[before].next = moved;
        if (s->loops.items[loop].first == k)
            s->loops.items[loop].first = moved;
        s->halves.items[k].loop = -1;
    }
    return KG_OK;
}

/* Moves the corners that hang together at one vertex, clockwise and the other way from that of `h`,
 * to vertex `to`. */
static void move_corners(kg_origami_state *s, int32_t h, int32_t to, bool *seen) {
    int32_t k = h;
    do {
        seen[k] = true;
        s->halves.items[k].origin = to;
        k = kg_twin(k);
    } while (kg_loop_of(s, k) >= 0 && (k = kg_next(s, k)) != h);
    if (k == h)
        return;
    for (k = h;;) {
        int32_t before = k;
        while (kg_next(s, before) != k)
            before = kg_next(s, before);
        k = kg_twin(before);
        if (kg_loop_of(s, k) < 0)
            return;
        seen[k] = true;
        s->halves.items[k].origin = to;
    }
}

/* Gives every fan of faces around a vertex its own, the first the one they had. */
static kg_status divide_vertices(kg_origami_state *s, kg_pattern *p) {
    bool *seen = calloc(s->halves.count + 1, sizeof *seen),
         *taken = calloc(s->vertices.count + 1, sizeof *taken);
    kg_status status = seen && taken ? KG_OK : KG_ERR_MEMORY;
    for (size_t h = 0; h < s->halves.count && !status; h++) {
        int32_t v = s->halves.items[h].origin, to = v;
        if (seen[h] || kg_loop_of(s, (int32_t)h) < 0)
            continue;
        if (taken[v]) {
            kg_paper_vertex copy = s->vertices.items[v];
            to = (int32_t)s->vertices.count;
            if (!kg_push(&s->vertices, copy) || !kg_push(&p->divided, v))
                status = KG_ERR_MEMORY;
        }
        taken[v] = true;
        if (!status)
            move_corners(s, (int32_t)h, to, seen);
    }
    for (size_t h = 0; h < s->halves.count && !status; h++)
        if (kg_loop_of(s, (int32_t)h) < 0)
            s->halves.items[h].origin = s->halves.items[kg_next(s, kg_twin((int32_t)h))].origin;
    free(seen);
    free(taken);
    return status;
}

/* Numbers sheets by connected pieces. */
static kg_status find_sheets(kg_origami_state *s) {
    int32_t *todo = malloc((s->loops.count + 1) * sizeof *todo), sheet = 0;
    if (!todo)
        return KG_ERR_MEMORY;
    for (size_t i = 0; i < s->loops.count; i++)
        s->loops.items[i].sheet = -1;
    for (size_t i = 0; i < s->loops.count; i++) {
        if (s->loops.items[i].sheet >= 0)
            continue;
        size_t count = 0;
        s->loops.items[i].sheet = sheet;
        todo[count++] = (int32_t)i;
        while (count > 0) {
            int32_t loop = todo[--count], first = s->loops.items[loop].first, h = first;
            do {
                int32_t other = kg_loop_of(s, kg_twin(h));
                s->vertices.items[s->halves.items[h].origin].sheet = sheet;
                if (other >= 0 && s->loops.items[other].sheet < 0) {
                    s->loops.items[other].sheet = sheet;
                    todo[count++] = other;
                }
            } while ((h = kg_next(s, h)) != first);
        }
        sheet++;
    }
    free(todo);
    return KG_OK;
}

typedef struct face_side {
    int32_t from, to, face;
} face_side;

static int compare_sides(const void *a, const void *b) {
    const face_side *x = a, *y = b;
    if (x->from != y->from)
        return x->from < y->from ? -1 : 1;
    return x->to < y->to ? -1 : x->to > y->to;
}

/* The face left of an edge that goes between two vertices; -1 when there is none. */
static int32_t face_beside(const face_side *sides, size_t count, int32_t from, int32_t to) {
    face_side key = {from, to, -1};
    const face_side *found = bsearch(&key, sides, count, sizeof *sides, compare_sides);
    return found ? found->face : -1;
}

/* Cuts may end inside a face, which then has both sides of them; creases may not. */
static kg_status check_ends(const kg_pattern *p, kg_error *error) {
    size_t count = 0;
    face_side *sides = malloc((p->faces.corners.count + 1) * sizeof *sides);
    kg_status status = sides ? KG_OK : KG_ERR_MEMORY;
    for (size_t f = 0; f + 1 < p->faces.starts.count && !status; f++) {
        const int32_t *c = p->faces.corners.items + p->faces.starts.items[f];
        size_t n = (size_t)(p->faces.starts.items[f + 1] - p->faces.starts.items[f]);
        for (size_t i = 0; i < n; i++)
            sides[count++] = (face_side){c[i], c[(i + 1) % n], (int32_t)f};
    }
    if (count > 0)
        qsort(sides, count, sizeof *sides, compare_sides);
    for (size_t i = 0; i < p->edges.count && !status; i++) {
        const kg_pattern_edge *e = &p->edges.items[i];
        int32_t face = face_beside(sides, count, e->ends[0], e->ends[1]);
        if (face < 0 || e->assignment == 'B' || e->assignment == 'C' ||
            face_beside(sides, count, e->ends[1], e->ends[0]) != face)
            continue;
        kg_vec2 from = kg_pattern_in_file(p, p->vertices.items[e->ends[0]]),
                to = kg_pattern_in_file(p, p->vertices.items[e->ends[1]]);
        status = kg_fail(error, KG_ERR_INPUT,
                         "the line from (%g, %g) to (%g, %g) ends inside a face: creases go on "
                         "to other lines or to the border",
                         from.x, from.y, to.x, to.y);
    }
    free(sides);
    return status == KG_ERR_MEMORY ? kg_fail(error, status, "out of memory") : status;
}

kg_status kg_pattern_state(kg_pattern *p, kg_origami_state **out_state, kg_error *error) {
    kg_status status = p->faces.starts.count == 0 ? kg_pattern_trace(p, error) : KG_OK;
    if (!status)
        status = check_ends(p, error);
    if (status)
        return status;
    kg_origami_state *s = kg_state_create();
    if (!s)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    for (size_t i = 0; i < p->vertices.count && !status; i++) {
        kg_vec2 v = p->vertices.items[i];
        if (!kg_push(&s->vertices, ((kg_paper_vertex){v, kg_v3(v.x, v.y, 0), 0})))
            status = KG_ERR_MEMORY;
    }
    kg_state_measure(s);
    if (!status)
        status = add_edges(s, p);
    if (!status)
        status = kg_state_add_faces(s, 0, &p->faces, error);
    for (size_t e = 0; e < s->edges.count && !status; e++) {
        int32_t a = kg_loop_of(s, (int32_t)(2 * e)), b = kg_loop_of(s, (int32_t)(2 * e + 1));
        const kg_paper_vertex *v = s->vertices.items;
        kg_vec2 from = kg_pattern_in_file(p, v[s->halves.items[2 * e].origin].paper),
                to = kg_pattern_in_file(p, v[s->halves.items[2 * e + 1].origin].paper);
        if (a < 0 && b < 0)
            status = kg_fail(error, KG_ERR_INPUT,
                             "the line from (%g, %g) to (%g, %g) lies outside the paper: the "
                             "border has to go all around it",
                             from.x, from.y, to.x, to.y);
        if ((a < 0) != (b < 0))
            s->edges.items[e] = (kg_paper_edge){KG_PAPER_BORDER, 0};
    }
    if (!status)
        status = open_cuts(s);
    if (!status)
        status = divide_vertices(s, p);
    if (!status)
        status = find_sheets(s);
    if (!status && !kg_push(&s->groups, ((kg_face_group){kg_v3(0, 0, 1), 0})))
        status = KG_ERR_MEMORY;
    if (status) {
        kg_state_destroy(s);
        return status == KG_ERR_MEMORY ? kg_fail(error, status, "out of memory") : status;
    }
    *out_state = s;
    return KG_OK;
}
