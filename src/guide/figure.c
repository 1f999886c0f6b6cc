#include "guide/figure.h"

#include "origami/convex.h"

#include <stdlib.h>
#include <string.h>

/* Of the facet's own size squared: what has less area is seen from its edge. */
#define EDGE_ON 1e-6
/* Overlaps narrower than this, of the whole figure, are facets that touch. */
#define TOUCH 1e-6

/* Lines, mm on the page. */
#define OUTLINE_WIDTH 0.3
#define CREASE_WIDTH 0.12
#define FOLD_WIDTH 0.3
/* How far beside a line its facet has to be seen. */
#define BESIDE 0.8
/* Parts of a line that are seen or not, each on its own; at most so many of one line. */
#define PIECE 1.5
#define MOST_PIECES 64
static const double valley_dashes[] = {2.2, 1.3}, mountain_dashes[] = {3, 1, 0.25, 1, 0.25, 1};

static kg_vec2 flat(kg_vec3 p) {
    return kg_v2(p.x, p.y);
}

/* ---- building --------------------------------------------------------------------------- */

/* Newell's normal; its z is twice the area as seen. */
static kg_vec3 normal_of(const kg_vec3 *p, size_t n, kg_vec3 *out_middle) {
    kg_vec3 sum = kg_v3(0, 0, 0), middle = kg_v3(0, 0, 0);
    for (size_t i = 0; i < n; i++) {
        sum = kg_add(sum, kg_cross(kg_sub(p[i], p[0]), kg_sub(p[(i + 1) % n], p[0])));
        middle = kg_madd(middle, 1 / (double)n, p[i]);
    }
    *out_middle = middle;
    return sum;
}

kg_status kg_figure_add(kg_figure *f, const kg_vec3 *points, const unsigned char *looks,
                        size_t count, uint32_t color, int32_t id) {
    kg_vec3 middle, normal = normal_of(points, count, &middle);
    kg_facet facet = {.first = f->points.count, .count = count, .color = color, .id = id};
    facet.box = kg_box2_empty();
    for (size_t i = 0; i < count; i++)
        kg_box2_add(&facet.box, flat(points[i]));
    kg_vec2 span = kg_sub2(facet.box.hi, facet.box.lo);
    if (!(fabs(normal.z) > EDGE_ON * (kg_dot2(span, span) + kg_len(normal))))
        return KG_OK;
    bool reversed = normal.z < 0;
    for (size_t i = 0; i < count; i++) {
        size_t point = reversed ? count - 1 - i : i,
               side = reversed ? (2 * count - 2 - i) % count : i;
        if (!kg_push(&f->points, points[point]) || !kg_push(&f->looks, looks[side]))
            return KG_ERR_MEMORY;
    }
    facet.plane[0] = -normal.x / normal.z;
    facet.plane[1] = -normal.y / normal.z;
    facet.plane[2] = middle.z - facet.plane[0] * middle.x - facet.plane[1] * middle.y;
    return kg_push(&f->facets, facet) ? KG_OK : KG_ERR_MEMORY;
}

void kg_figure_clear(kg_figure *f) {
    free(f->facets.items);
    free(f->points.items);
    free(f->looks.items);
    free(f->corners.items);
    free(f->pieces.items);
    free(f->order);
    *f = (kg_figure){0};
}

/* ---- what covers what ------------------------------------------------------------------- */

typedef struct sorting {
    kg_figure *figure;
    double touch;
    kg_vec2 *scratch;    /* three polygons of the common part of two facets */
    size_t room;         /* of each */
    signed char *covers; /* count × count: 1 the first is nearer than the second, -1 farther */
} sorting;

static void outline(const kg_figure *f, const kg_facet *a, kg_vec2 *out) {
    for (size_t i = 0; i < a->count; i++)
        out[i] = flat(f->points.items[a->first + i]);
}

static double depth(const kg_facet *a, kg_vec2 p) {
    return a->plane[0] * p.x + a->plane[1] * p.y + a->plane[2];
}

static int compare(sorting *s, const kg_facet *a, const kg_facet *b, kg_figure_order order,
                   const void *user) {
    kg_vec2 *p = s->scratch, *q = p + s->room, *common = q + s->room, *more = common + s->room;
    if (a->box.lo.x > b->box.hi.x || b->box.lo.x > a->box.hi.x || a->box.lo.y > b->box.hi.y ||
        b->box.lo.y > a->box.hi.y)
        return 0;
    outline(s->figure, a, p);
    outline(s->figure, b, q);
    if (!kg_convex_overlap(p, a->count, q, b->count, s->touch))
        return 0;
    int known = order(user, a->id, b->id);
    if (known)
        return known;
    size_t n = kg_convex_common(p, a->count, q, b->count, common, more);
    double most = 0;
    for (size_t i = 0; i < n; i++) {
        double d = depth(a, common[i]) - depth(b, common[i]);
        most = fabs(d) > fabs(most) ? d : most;
    }
    return most > s->touch ? 1 : most < -s->touch ? -1 : 0;
}

/* Room for polygons of `count` corners in the scratch, whose contents go. */
static bool make_room(sorting *s, size_t count) {
    if (count <= s->room)
        return true;
    if (count > SIZE_MAX / (8 * sizeof *s->scratch))
        return false;
    free(s->scratch);
    s->room = 2 * count;
    s->scratch = malloc(4 * s->room * sizeof *s->scratch);
    return s->scratch;
}

/* What is seen of a facet: its outline less all that covers it, as convex pieces. */
static kg_status find_pieces(sorting *s, size_t index) {
    kg_figure *f = s->figure;
    kg_facet *a = &f->facets.items[index];
    a->clipped = true;
    a->first_piece = f->pieces.count;
    for (size_t i = 0; i < a->count; i++)
        if (!kg_push(&f->corners, flat(f->points.items[a->first + i])))
            return KG_ERR_MEMORY;
    if (!kg_push(&f->pieces, f->corners.count))
        return KG_ERR_MEMORY;
    for (size_t k = 0; k < f->facets.count; k++) {
        const kg_facet *b = &f->facets.items[k];
        if (s->covers[k * f->facets.count + index] <= 0)
            continue;
        size_t old_first = a->first_piece, old_end = f->pieces.count;
        a->first_piece = old_end;
        for (size_t piece = old_first; piece < old_end; piece++) {
            size_t start = piece == 0 ? 0 : f->pieces.items[piece - 1],
                   n = f->pieces.items[piece] - start;
            if (!make_room(s, n + b->count + 4)) /* pieces gain a corner with every cut */
                return KG_ERR_MEMORY;
            kg_vec2 *p = s->scratch, *next = p + s->room, *outside = next + s->room;
            memcpy(p, f->corners.items + start, n * sizeof *p);
            for (size_t e = 0; e < b->count && n > 0; e++) {
                kg_vec2 from = flat(f->points.items[b->first + e]),
                        to = flat(f->points.items[b->first + (e + 1) % b->count]);
                kg_vec2 out = kg_v2(to.y - from.y, from.x - to.x);
                size_t m = kg_convex_clip(p, n, out, kg_dot2(out, from), outside);
                for (size_t i = 0; i < m; i++)
                    if (!kg_push(&f->corners, outside[i]))
                        return KG_ERR_MEMORY;
                if (m > 0 && !kg_push(&f->pieces, f->corners.count))
                    return KG_ERR_MEMORY;
                out = kg_scale2(out, -1);
                n = kg_convex_clip(p, n, out, kg_dot2(out, from), next);
                memcpy(p, next, n * sizeof *p);
            }
        }
    }
    a->piece_count = f->pieces.count - a->first_piece;
    return KG_OK;
}

/* Kahn (1962); rings and what covers them come last, clipped. */
static kg_status sort(sorting *s) {
    kg_figure *f = s->figure;
    size_t n = f->facets.count, done = 0;
    size_t *below = calloc(n + 1, sizeof *below); /* facets not yet painted that it covers */
    kg_status status = below ? KG_OK : KG_ERR_MEMORY;
    for (size_t i = 0; i < n && below; i++) {
        for (size_t k = 0; k < n; k++)
            below[i] += s->covers[i * n + k] > 0;
        if (below[i] == 0)
            f->order[done++] = (int32_t)i;
    }
    for (size_t at = 0; at < done && below; at++)
        for (size_t i = 0; i < n; i++)
            if (s->covers[i * n + (size_t)f->order[at]] > 0 && --below[i] == 0)
                f->order[done++] = (int32_t)i;
    for (size_t i = 0; i < n && !status; i++)
        if (below[i] > 0) {
            status = find_pieces(s, i);
            f->order[done++] = (int32_t)i;
        }
    free(below);
    return status;
}

kg_status kg_figure_sort(kg_figure *f, kg_figure_order order, const void *user) {
    size_t n = f->facets.count, most = 0;
    kg_box2 box = kg_box2_empty();
    for (size_t i = 0; i < n; i++) {
        most = f->facets.items[i].count > most ? f->facets.items[i].count : most;
        kg_box2_add(&box, f->facets.items[i].box.lo);
        kg_box2_add(&box, f->facets.items[i].box.hi);
    }
    sorting s = {.figure = f, .touch = n ? TOUCH * kg_dist2(box.lo, box.hi) : 0};
    s.covers = calloc(n * n + 1, 1);
    free(f->order);
    f->order = malloc((n + 1) * sizeof *f->order);
    kg_status status = make_room(&s, 2 * most + 2) && s.covers && f->order ? KG_OK : KG_ERR_MEMORY;
    for (size_t i = 0; i < n && !status; i++)
        for (size_t k = i + 1; k < n; k++) {
            int c = compare(&s, &f->facets.items[i], &f->facets.items[k], order, user);
            s.covers[i * n + k] = (signed char)c;
            s.covers[k * n + i] = (signed char)-c;
        }
    if (!status)
        status = sort(&s);
    free(s.scratch);
    free(s.covers);
    return status;
}

/* ---- painting --------------------------------------------------------------------------- */

void kg_figure_fold_line(cairo_t *cr, bool mountain, double phase) {
    cairo_set_line_width(cr, FOLD_WIDTH);
    cairo_set_line_cap(cr, CAIRO_LINE_CAP_BUTT);
    if (mountain)
        cairo_set_dash(cr, mountain_dashes, 6, phase);
    else
        cairo_set_dash(cr, valley_dashes, 2, phase);
}

static void set_color(cairo_t *cr, uint32_t color) {
    cairo_set_source_rgb(cr, (color >> 16 & 255) / 255.0, (color >> 8 & 255) / 255.0,
                         (color & 255) / 255.0);
}

static void stroke_side(cairo_t *cr, kg_side_look look, kg_vec2 a, kg_vec2 b, kg_vec2 origin) {
    cairo_set_dash(cr, NULL, 0, 0);
    cairo_set_line_cap(cr, CAIRO_LINE_CAP_ROUND);
    cairo_set_source_rgb(cr, 0.1, 0.11, 0.13);
    cairo_set_line_width(cr, OUTLINE_WIDTH);
    if (look == KG_SIDE_CREASE) { /* stops short of the edges of the paper, as books draw it */
        double inset = fmin(0.8 / fmax(kg_dist2(a, b), 1e-9), 0.2);
        kg_vec2 from = kg_lerp2(a, b, inset);
        b = kg_lerp2(b, a, inset);
        a = from;
        cairo_set_line_width(cr, CREASE_WIDTH);
    } else if (look == KG_SIDE_VALLEY || look == KG_SIDE_MOUNTAIN) {
        /* both facets draw it: in the same direction, so that their dashes agree */
        if (a.x > b.x || (a.x == b.x && a.y > b.y)) {
            kg_vec2 swap = a;
            a = b, b = swap;
        }
        kg_vec2 along = kg_scale2(kg_sub2(b, a), 1 / fmax(kg_dist2(a, b), 1e-9));
        kg_figure_fold_line(cr, look == KG_SIDE_MOUNTAIN, kg_dot2(kg_sub2(a, origin), along));
    }
    cairo_move_to(cr, a.x, a.y);
    cairo_line_to(cr, b.x, b.y);
    cairo_stroke(cr);
}

static bool holds(const kg_figure *f, const kg_facet *a, kg_vec2 p) {
    for (size_t i = 0; i < a->count; i++) {
        kg_vec2 from = flat(f->points.items[a->first + i]),
                to = flat(f->points.items[a->first + (i + 1) % a->count]);
        if (!(kg_cross2(kg_sub2(to, from), kg_sub2(p, from)) > 0))
            return false;
    }
    return true;
}

/* The facet seen at a point of those painted from `place` on; -1: none. */
static int32_t seen_at(const kg_figure *f, size_t place, kg_vec2 p) {
    for (size_t i = f->facets.count; i-- > place;)
        if (holds(f, &f->facets.items[f->order[i]], p))
            return f->order[i];
    return -1;
}

/* A line to fold along that lies just under the edge of a higher layer would vanish there, although
 * the facet beside it is seen. Where it does, it is painted again, at the height of that edge, on a
 * strip of the facet's colour. */
static void repeat_fold(const kg_figure *f, cairo_t *cr, size_t place, size_t k, double scale,
                        kg_vec2 offset, kg_vec2 origin) {
    const kg_facet *a = &f->facets.items[f->order[place]];
    kg_side_look look = (kg_side_look)f->looks.items[a->first + k];
    kg_vec2 start = flat(f->points.items[a->first + k]),
            end = flat(f->points.items[a->first + (k + 1) % a->count]);
    kg_vec2 side = kg_sub2(end, start);
    double length = kg_len2(side);
    if ((look != KG_SIDE_VALLEY && look != KG_SIDE_MOUNTAIN) || !(length > 0))
        return;
    kg_vec2 in = kg_v2(-side.y / length, side.x / length);
    int pieces = (int)fmin(fmax(length * scale / PIECE, 1), MOST_PIECES);
    for (int i = 0; i < pieces; i++) {
        kg_vec2 p = kg_lerp2(start, end, (double)i / pieces),
                q = kg_lerp2(start, end, (i + 1.0) / pieces), middle = kg_lerp2(p, q, 0.5);
        int32_t top = seen_at(f, place, middle);
        double lift = top < 0 ? 0 : depth(&f->facets.items[top], middle) - depth(a, middle);
        kg_vec2 shift = kg_scale2(f->shear, fmax(lift, 0));
        if (top == f->order[place] ||
            seen_at(f, place, kg_add2(middle, kg_scale2(in, BESIDE / scale + kg_len2(shift)))) !=
                f->order[place])
            continue;
        p = kg_add2(p, shift), q = kg_add2(q, shift);
        p = kg_v2(offset.x + scale * p.x, offset.y - scale * p.y);
        q = kg_v2(offset.x + scale * q.x, offset.y - scale * q.y);
        set_color(cr, a->color);
        cairo_set_dash(cr, NULL, 0, 0);
        cairo_set_line_cap(cr, CAIRO_LINE_CAP_BUTT);
        cairo_set_line_width(cr, 2.5 * OUTLINE_WIDTH);
        cairo_move_to(cr, p.x, p.y);
        cairo_line_to(cr, q.x, q.y);
        cairo_stroke(cr);
        stroke_side(cr, look, p, q, origin);
    }
}

void kg_figure_paint(const kg_figure *f, cairo_t *cr, double scale, kg_vec2 offset,
                     kg_vec2 origin) {
#define PLACED(p) kg_v2(offset.x + scale * (p).x, offset.y - scale * (p).y)
    kg_vec2 start = PLACED(origin);
    for (size_t i = 0; i < f->facets.count; i++) {
        const kg_facet *a = &f->facets.items[f->order[i]];
        cairo_save(cr);
        cairo_new_path(cr);
        for (size_t k = 0; k < a->piece_count; k++) {
            size_t piece = a->first_piece + k, c = piece ? f->pieces.items[piece - 1] : 0;
            for (; c < f->pieces.items[piece]; c++) {
                kg_vec2 p = PLACED(f->corners.items[c]);
                cairo_line_to(cr, p.x, p.y);
            }
            cairo_close_path(cr);
        }
        if (a->clipped)
            cairo_clip(cr);
        for (size_t k = 0; k < a->count; k++) {
            kg_vec2 p = PLACED(f->points.items[a->first + k]);
            cairo_line_to(cr, p.x, p.y);
        }
        cairo_close_path(cr);
        set_color(cr, a->color);
        cairo_fill(cr);
        for (size_t k = 0; k < a->count; k++) {
            kg_side_look look = (kg_side_look)f->looks.items[a->first + k];
            if (look != KG_SIDE_NONE)
                stroke_side(cr, look, PLACED(f->points.items[a->first + k]),
                            PLACED(f->points.items[a->first + (k + 1) % a->count]), start);
        }
        cairo_restore(cr);
    }
    for (size_t i = 0; i < f->facets.count; i++)
        for (size_t k = 0; k < f->facets.items[f->order[i]].count; k++)
            repeat_fold(f, cr, i, k, scale, offset, start);
    cairo_set_dash(cr, NULL, 0, 0);
#undef PLACED
}
