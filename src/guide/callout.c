#include "guide/callout.h"

/* Arrows shorter than this, mm, say nothing. */
#define LEAST_ARROW 3.0

/* Places tried along a join, from its middle outwards. */
enum { PLACES = 13, MOST_BADGES = 256 };

/* What a clear place is worth; one that is seen counts 1. */
enum { CLEAR = 2 };

typedef struct callouts {
    kg_guide *guide;
    const kg_view_of *view;
    const kg_sight *sight;
    const kg_camera *camera;
    kg_vec2 at, size;
    kg_vec3 back; /* to the eye */
    size_t count;
    kg_vec2 centers[MOST_BADGES], halves[MOST_BADGES]; /* badges placed so far */
} callouts;

static kg_vec2 project(const callouts *c, kg_vec3 point) {
    kg_vec3 p = kg_v3(0, 0, 0);
    kg_camera_project(c->camera, c->size.x, c->size.y, point, &p);
    return kg_v2(c->at.x + p.x, c->at.y + p.y);
}

/* Within the picture and clear of all other badges? */
static bool is_clear(const callouts *c, kg_vec2 center, kg_vec2 half) {
    kg_vec2 in = kg_sub2(center, c->at);
    if (in.x < half.x || in.y < half.y || in.x > c->size.x - half.x || in.y > c->size.y - half.y)
        return false;
    for (size_t i = 0; i < c->count; i++)
        if (fabs(center.x - c->centers[i].x) < half.x + c->halves[i].x + 0.4 &&
            fabs(center.y - c->centers[i].y) < half.y + c->halves[i].y + 0.4)
            return false;
    return true;
}

static void take(callouts *c, kg_vec2 center, kg_vec2 half) {
    if (c->count == MOST_BADGES)
        return;
    c->centers[c->count] = center;
    c->halves[c->count++] = half;
}

/* ---- joins ------------------------------------------------------------------------------ */

static void draw_arrow(kg_book *paper, kg_vec2 from, kg_vec2 to) {
    static const double dashes[] = {1.2, 0.8};
    double length = kg_dist2(from, to);
    if (length < LEAST_ARROW)
        return;
    kg_vec2 way = kg_scale2(kg_sub2(to, from), 1 / length), side = kg_v2(-way.y, way.x);
    kg_vec2 neck = kg_sub2(to, kg_scale2(way, 2));
    kg_book_color(paper, KG_STAGE_JOIN);
    cairo_set_line_width(paper->cr, 0.3);
    cairo_set_dash(paper->cr, dashes, 2, 0);
    cairo_move_to(paper->cr, from.x, from.y);
    cairo_line_to(paper->cr, neck.x, neck.y);
    cairo_stroke(paper->cr);
    cairo_set_dash(paper->cr, NULL, 0, 0);
    cairo_move_to(paper->cr, to.x, to.y);
    cairo_line_to(paper->cr, neck.x + 0.8 * side.x, neck.y + 0.8 * side.y);
    cairo_line_to(paper->cr, neck.x - 0.8 * side.x, neck.y - 0.8 * side.y);
    cairo_close_path(paper->cr);
    cairo_fill(paper->cr);
}

/* A clear place near `centre` with a line to it; `centre` itself where there is none. */
static kg_vec2 step_aside(callouts *c, kg_vec2 center, kg_vec2 half) {
    enum { RINGS = 6, DIRECTIONS = 12 };
    for (int i = 0; i < RINGS * DIRECTIONS; i++) {
        double radius = 2 * half.y + 3.0 * (i / DIRECTIONS), angle = 2 * KG_PI * i / DIRECTIONS;
        kg_vec2 place = kg_add2(center, kg_v2(radius * cos(angle), radius * sin(angle)));
        if (!is_clear(c, place, half))
            continue;
        kg_book_color(c->guide->paper, KG_STAGE_JOIN);
        cairo_set_line_width(c->guide->paper->cr, 0.25);
        cairo_move_to(c->guide->paper->cr, center.x, center.y);
        cairo_line_to(c->guide->paper->cr, place.x, place.y);
        cairo_stroke(c->guide->paper->cr);
        return place;
    }
    return center;
}

/* The join's number stands on the way of the new part, where the join can be seen if it can. */
static void draw_join(callouts *c, int index) {
    const kg_assembly_join *join = &c->guide->assembly->joins[index];
    int number = c->guide->net->joins[index].number;
    kg_vec2 half = kg_book_badge_half(number);
    if (join->count == 0)
        return;
    kg_vec3 best = join->points[join->count / 2];
    int best_score = -1;
    for (int i = 0; i < PLACES; i++) {
        int step = (i + 1) / 2 * (i % 2 ? 1 : -1);
        size_t k = (size_t)((0.5 + step / (PLACES + 2.0)) * (double)(join->count - 1));
        kg_vec3 p = join->points[k];
        kg_vec2 center = project(c, kg_madd(p, 0.5, c->view->offset));
        int score = CLEAR * is_clear(c, center, half) + kg_sight_is_free(c->sight, p, c->back);
        if (score > best_score) {
            best_score = score;
            best = p;
        }
    }
    kg_vec2 center = project(c, kg_madd(best, 0.5, c->view->offset));
    if (kg_len(c->view->offset) > 0)
        draw_arrow(c->guide->paper, project(c, kg_add(best, c->view->offset)), project(c, best));
    if (best_score < CLEAR)
        center = step_aside(c, center, half);
    kg_book_join_badge(c->guide->paper, center.x, center.y, number);
    take(c, center, half);
}

/* ---- parts ------------------------------------------------------------------------------ */

/* Near the middle of what is seen of the part, on a free place. */
static void draw_part(callouts *c, int index) {
    const kg_assembly_part *part = &c->guide->assembly->parts[index];
    int number = c->guide->net->parts[index].number;
    bool new = c->view->roles[index] == KG_ROLE_NEW;
    kg_vec2 half = kg_book_badge_half(number), middle = kg_v2(0, 0), best = middle;
    bool seen[KG_ASSEMBLY_SAMPLES];
    size_t count = 0;
    double nearest = INFINITY;
    for (size_t i = 0; i < part->sample_count; i++) {
        kg_vec3 p = kg_view_sample(c->guide->assembly, c->view, (size_t)index, i);
        kg_vec2 at = project(c, p);
        bool within = at.x > c->at.x && at.y > c->at.y && at.x < c->at.x + c->size.x &&
                      at.y < c->at.y + c->size.y;
        seen[i] = within && kg_sight_is_free(c->sight, p, c->back);
        if (seen[i]) {
            middle = kg_add2(middle, at);
            count++;
        }
    }
    if (count == 0)
        return;
    middle = kg_scale2(middle, 1 / (double)count);
    for (size_t i = 0; i < part->sample_count; i++) {
        kg_vec2 at = project(c, kg_view_sample(c->guide->assembly, c->view, (size_t)index, i));
        double distance = kg_dist2(at, middle);
        if (seen[i] && distance < nearest && is_clear(c, at, half)) {
            nearest = distance;
            best = at;
        }
    }
    if (!isfinite(nearest))
        return;
    kg_book_part_badge(c->guide->paper, best.x, best.y, number, new ? 0xffd58a : 0xffffff);
    take(c, best, half);
}

/* Is the part in one of the view's joins? */
static bool is_joined(const callouts *c, int part) {
    for (size_t i = 0; i < c->view->join_count; i++)
        for (int side = 0; side < 2; side++)
            if (c->guide->net->joins[c->view->joins[i]].sides[side].part == part)
                return true;
    return false;
}

void kg_callouts_draw(kg_guide *guide, const kg_view_of *view, const kg_sight *sight,
                      const kg_camera *camera, kg_vec2 at, kg_vec2 size) {
    callouts c = {
        .guide = guide, .view = view, .sight = sight, .camera = camera, .at = at, .size = size};
    kg_vec3 right, up;
    kg_camera_axes(camera, &right, &up, &c.back);
    cairo_save(guide->paper->cr);
    cairo_rectangle(guide->paper->cr, at.x, at.y, size.x, size.y);
    cairo_clip(guide->paper->cr);
    for (size_t i = 0; i < view->join_count; i++)
        draw_join(&c, view->joins[i]);
    for (size_t i = 0; i < guide->net->part_count; i++)
        if (view->roles[i] == KG_ROLE_NEW || is_joined(&c, (int)i))
            draw_part(&c, (int)i);
    cairo_restore(guide->paper->cr);
}
