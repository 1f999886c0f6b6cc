#include "net/space.h"

#include "base/array.h"

#include <stdlib.h>

static bool flatten(kg_space *space, const kg_stroke *stroke) {
    kg_vec2 at = {0, 0}, start = {0, 0};
    size_t count = stroke->path.count;
    bool contour = stroke->layer == KG_LAYER_CUT && count > 0 &&
                   stroke->path.items[count - 1].verb == KG_PATH_CLOSE;
    for (size_t i = 0; i < count; i++) {
        const kg_path_step *step = &stroke->path.items[i];
        kg_vec2 b[4] = {at, step->p[0], step->p[1], step->p[2]};
        int chords = step->verb == KG_PATH_CURVE ? kg_bezier2_chords(b, KG_SPACE_SAG, 200) : 1;
        for (int k = 1; k <= chords && step->verb != KG_PATH_MOVE; k++) {
            kg_vec2 q = step->verb == KG_PATH_CLOSE  ? start
                        : step->verb == KG_PATH_LINE ? step->p[0]
                                                     : kg_bezier2(b, (double)k / chords);
            kg_wall wall = {at, q, stroke->part, contour};
            if (!kg_push(&space->walls, wall))
                return false;
            at = q;
        }
        if (step->verb == KG_PATH_MOVE)
            at = start = step->p[0];
    }
    return true;
}

bool kg_space_create(const kg_page *page, kg_box2 room, kg_space *out_space) {
    kg_space space = {.room = room};
    for (size_t i = 0; i < page->strokes.count; i++) {
        if (!flatten(&space, &page->strokes.items[i])) {
            kg_space_clear(&space);
            return false;
        }
    }
    *out_space = space;
    return true;
}

void kg_space_clear(kg_space *space) {
    free(space->walls.items);
}

bool kg_space_add_wall(kg_space *space, kg_vec2 a, kg_vec2 b, int part) {
    return kg_push(&space->walls, ((kg_wall){a, b, part, false}));
}

/* Does the ray from p along x cross the wall? */
static bool crosses(const kg_wall *w, kg_vec2 p) {
    if (!w->contour || (w->a.y > p.y) == (w->b.y > p.y))
        return false;
    return p.x < w->a.x + (p.y - w->a.y) / (w->b.y - w->a.y) * (w->b.x - w->a.x);
}

bool kg_space_inside(const kg_space *space, int part, kg_vec2 p) {
    bool inside = false;
    for (size_t i = 0; i < space->walls.count; i++) {
        const kg_wall *w = &space->walls.items[i];
        if (part == 0 || w->part == part)
            inside ^= crosses(w, p);
    }
    return inside;
}

/* p in the frame of the block, its centre the origin. */
static kg_vec2 local(const kg_block *block, double c, double s, kg_vec2 p) {
    kg_vec2 d = kg_sub2(p, block->center);
    return kg_v2(c * d.x + s * d.y, c * d.y - s * d.x);
}

/* Does a segment meet the box of half size h about the origin? (Liang and Barsky's clipping.) */
static bool meets(kg_vec2 a, kg_vec2 b, kg_vec2 h) {
    double t0 = 0, t1 = 1;
    const double start[2] = {a.x, a.y}, way[2] = {b.x - a.x, b.y - a.y}, half[2] = {h.x, h.y};
    for (int i = 0; i < 2; i++) {
        if (way[i] == 0) {
            if (fabs(start[i]) > half[i])
                return false;
            continue;
        }
        double in = (-half[i] - start[i]) / way[i], out = (half[i] - start[i]) / way[i];
        t0 = fmax(t0, fmin(in, out));
        t1 = fmin(t1, fmax(in, out));
    }
    return t0 <= t1;
}

bool kg_space_blocked(const kg_space *space, int part, const kg_block *block) {
    double c = cos(block->angle), s = sin(block->angle), reach = kg_len2(block->half);
    kg_vec2 m = block->center;
    for (size_t i = 0; i < space->walls.count; i++) {
        const kg_wall *w = &space->walls.items[i];
        if ((part != 0 && w->part != part) || fmin(w->a.x, w->b.x) > m.x + reach ||
            fmax(w->a.x, w->b.x) < m.x - reach || fmin(w->a.y, w->b.y) > m.y + reach ||
            fmax(w->a.y, w->b.y) < m.y - reach)
            continue;
        if (meets(local(block, c, s, w->a), local(block, c, s, w->b), block->half))
            return true;
    }
    return false;
}

/* Half the extent of the block along x and y. */
static kg_vec2 extent(const kg_block *block) {
    double c = fabs(cos(block->angle)), s = fabs(sin(block->angle));
    return kg_v2(c * block->half.x + s * block->half.y, s * block->half.x + c * block->half.y);
}

bool kg_space_holds(const kg_space *space, const kg_block *block) {
    kg_vec2 e = extent(block), lo = kg_sub2(block->center, e), hi = kg_add2(block->center, e);
    return lo.x >= space->room.lo.x && lo.y >= space->room.lo.y && hi.x <= space->room.hi.x &&
           hi.y <= space->room.hi.y;
}

bool kg_blocks_overlap(const kg_block *a, const kg_block *b) {
    for (int i = 0; i < 2; i++) {
        /* In the frame of one, the other's bounding box must reach it. */
        const kg_block *p = i == 0 ? a : b, *q = i == 0 ? b : a;
        kg_block seen = {local(p, cos(p->angle), sin(p->angle), q->center), q->half,
                         q->angle - p->angle};
        kg_vec2 e = extent(&seen);
        if (fabs(seen.center.x) >= p->half.x + e.x || fabs(seen.center.y) >= p->half.y + e.y)
            return false;
    }
    return true;
}

/* ---- pole of inaccessibility ----------------------------------------------------------------- */

typedef struct pole {
    const kg_wall *first, *end; /* all walls of the part are among these */
    int part;
    double c, s, aspect;
} pole;

static kg_vec2 squeezed(const pole *f, kg_vec2 p) {
    return kg_v2((f->c * p.x + f->s * p.y) / f->aspect, f->c * p.y - f->s * p.x);
}

static kg_vec2 unsqueezed(const pole *f, kg_vec2 q) {
    return kg_v2(f->c * q.x * f->aspect - f->s * q.y, f->s * q.x * f->aspect + f->c * q.y);
}

/* Distance of q (squeezed) to the part's walls, negative outside of the part. */
static double clearance(const pole *f, kg_vec2 q) {
    double best = INFINITY;
    bool inside = false;
    kg_vec2 p = unsqueezed(f, q);
    for (const kg_wall *w = f->first; w < f->end; w++) {
        if (w->part != f->part)
            continue;
        kg_vec2 a = squeezed(f, w->a), ab = kg_sub2(squeezed(f, w->b), a), aq = kg_sub2(q, a);
        double l2 = kg_dot2(ab, ab), t = l2 > 0 ? kg_dot2(ab, aq) / l2 : 0;
        kg_vec2 r = kg_sub2(aq, kg_scale2(ab, t < 0 ? 0 : t > 1 ? 1 : t));
        double d = kg_dot2(r, r);
        best = d < best ? d : best;
        inside ^= crosses(w, p);
    }
    return inside ? sqrt(best) : -sqrt(best);
}

double kg_space_pole(const kg_space *space, int part, double angle, double aspect,
                     kg_vec2 *out_center) {
    enum { GRID = 12, REFINEMENTS = 12 };
    pole f = {.part = part, .c = cos(angle), .s = sin(angle), .aspect = aspect};
    kg_box2 box = kg_box2_empty();
    for (size_t i = 0; i < space->walls.count; i++) {
        const kg_wall *w = &space->walls.items[i];
        if (w->part != part)
            continue;
        f.first = f.first ? f.first : w;
        f.end = w + 1;
        kg_box2_add(&box, squeezed(&f, w->a));
    }
    if (box.lo.x > box.hi.x)
        return 0;
    kg_vec2 step = kg_scale2(kg_sub2(box.hi, box.lo), 1.0 / GRID), best_at = box.lo;
    double best = -INFINITY;
    for (int i = 0; i < GRID * GRID; i++) {
        kg_vec2 q =
            kg_v2(box.lo.x + (i % GRID + 0.5) * step.x, box.lo.y + (i / GRID + 0.5) * step.y);
        double d = clearance(&f, q);
        if (d > best) {
            best = d;
            best_at = q;
        }
    }
    for (int round = 0; round < REFINEMENTS; round++) {
        static const int dx[] = {1, -1, 0, 0}, dy[] = {0, 0, 1, -1};
        kg_vec2 from = best_at;
        for (int k = 0; k < 4; k++) {
            kg_vec2 q = kg_v2(from.x + dx[k] * step.x, from.y + dy[k] * step.y);
            double d = clearance(&f, q);
            if (d > best) {
                best = d;
                best_at = q;
            }
        }
        if (best_at.x == from.x && best_at.y == from.y)
            step = kg_scale2(step, 0.5);
    }
    *out_center = unsqueezed(&f, best_at);
    return best > 0 ? best / sqrt(2) : 0;
}
