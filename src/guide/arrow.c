/* Arrows of folding pictures, in the notation of Yoshizawa and Randlett. */
#include "guide/diagram.h"

/* mm on the page */
#define ARROW_WIDTH 0.4
#define HEAD_LENGTH 3.2
#define HEAD_WIDTH 1.25
static const double hidden_dashes[] = {0.9, 0.8};

static void ink(cairo_t *cr) {
    cairo_set_source_rgb(cr, 0.05, 0.05, 0.06);
    cairo_set_line_width(cr, ARROW_WIDTH);
    cairo_set_line_cap(cr, CAIRO_LINE_CAP_ROUND);
    cairo_set_dash(cr, NULL, 0, 0);
}

static double length_of(const kg_vec2 *path, size_t count) {
    double sum = 0;
    for (size_t i = 1; i < count; i++)
        sum += kg_dist2(path[i - 1], path[i]);
    return sum;
}

/* A head at `tip`, coming from `from`; hollow ones have one barb, on the right of the way. */
static void paint_head(cairo_t *cr, kg_vec2 from, kg_vec2 tip, double length, bool hollow) {
    double far = kg_dist2(from, tip), width = length * HEAD_WIDTH / HEAD_LENGTH;
    if (!(far > 0))
        return;
    kg_vec2 along = kg_scale2(kg_sub2(tip, from), 1 / far), aside = kg_v2(-along.y, along.x);
    kg_vec2 base = kg_sub2(tip, kg_scale2(along, length)),
            left = kg_add2(base, kg_scale2(aside, width)),
            right = kg_sub2(base, kg_scale2(aside, width));
    cairo_move_to(cr, tip.x, tip.y);
    cairo_line_to(cr, right.x, right.y);
    if (hollow) {
        kg_vec2 neck = kg_lerp2(base, tip, 0.3);
        cairo_line_to(cr, neck.x, neck.y);
        cairo_close_path(cr);
        cairo_set_source_rgb(cr, 1, 1, 1);
        cairo_fill_preserve(cr);
        ink(cr);
        cairo_stroke(cr);
        return;
    }
    kg_vec2 neck = kg_lerp2(base, tip, 0.2);
    cairo_line_to(cr, neck.x, neck.y);
    cairo_line_to(cr, left.x, left.y);
    cairo_close_path(cr);
    cairo_fill(cr);
}

/* The point a way's length before its end, `reversed`: after its beginning. */
static kg_vec2 neck_of(const kg_vec2 *path, size_t count, double length, bool reversed) {
    for (size_t i = 1; i < count; i++) {
        size_t k = reversed ? i - 1 : count - i, next = reversed ? k + 1 : k - 1;
        double step = kg_dist2(path[k], path[next]);
        if (step >= length)
            return kg_lerp2(path[k], path[next], step > 0 ? length / step : 0);
        length -= step;
    }
    return path[reversed ? count - 1 : 0];
}

/* The way from one fraction of its points to another. */
static void stroke(cairo_t *cr, const kg_vec2 *path, size_t from, size_t to) {
    cairo_new_path(cr);
    for (size_t i = from; i <= to; i++)
        cairo_line_to(cr, path[i].x, path[i].y);
    cairo_stroke(cr);
}

void kg_arrow_paint(cairo_t *cr, kg_arrow_kind kind, bool tucked, const kg_vec2 *path,
                    size_t count) {
    if (kind == KG_ARROW_NONE || count < 2)
        return;
    double length = length_of(path, count), head = fmin(HEAD_LENGTH, 0.4 * length);
    bool hidden = kind == KG_ARROW_MOUNTAIN || tucked;
    size_t behind = hidden ? (count - 1) / 2 : count - 1;
    cairo_save(cr);
    /* white beside it keeps it apart from the lines that it crosses */
    cairo_set_line_join(cr, CAIRO_LINE_JOIN_MITER);
    ink(cr);
    cairo_set_source_rgba(cr, 1, 1, 1, 0.8);
    cairo_set_line_width(cr, 3 * ARROW_WIDTH);
    stroke(cr, path, 0, behind);
    ink(cr);
    stroke(cr, path, 0, behind);
    if (hidden) {
        cairo_set_line_cap(cr, CAIRO_LINE_CAP_BUTT);
        cairo_set_dash(cr, hidden_dashes, 2, 0);
        stroke(cr, path, behind, count - 1);
    }
    ink(cr);
    paint_head(cr, neck_of(path, count, head, false), path[count - 1], head,
               kind == KG_ARROW_MOUNTAIN);
    if (kind == KG_ARROW_UNFOLD)
        paint_head(cr, neck_of(path, count, head, true), path[0], head, true);
    cairo_restore(cr);
}

void kg_diagram_turn_symbol(cairo_t *cr, kg_vec2 at) {
    enum { COUNT = 41 };
    kg_vec2 path[COUNT];
    for (int i = 0; i < COUNT; i++) { /* a cycloid with one loop */
        double t = 2.6 * (2 * i / (double)(COUNT - 1) - 1);
        path[i] = kg_v2(at.x + 3.2 * t - 5 * sin(t), at.y + 2 * (1 - cos(t)) - 2);
    }
    kg_arrow_paint(cr, KG_ARROW_VALLEY, false, path, COUNT);
}
