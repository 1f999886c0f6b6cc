#include "app/net_view.h"

#include "app/tools/seam.h"
#include "document/pin.h"
#include "katagami/unroll.h"

#include <stdlib.h>
#include <string.h>

/* Layout units: how near the pointer has to be to an edge, and where the handle is. */
enum { NEAR = 6, HANDLE_DISTANCE = 22, FIT_MARGIN = 16 };

static const kg_net_picture *picture_of(const kg_net_view *v) {
    return kg_net_state_picture(v->state);
}

/* ---- life ------------------------------------------------------------------------------- */

static void forget(kg_net_view *v) {
    v->hover_part = v->hover_join = v->active_part = v->moved_part = -1;
    v->menu_part = v->menu_join = -1;
    free(v->clashes);
    v->clashes = NULL;
    if (v->gesture == KG_NET_MOVING || v->gesture == KG_NET_TURNING)
        v->gesture = KG_NET_IDLE;
}

kg_status kg_net_view_init(kg_net_view *v, kg_gate *gate, kg_error *error) {
    *v = (kg_net_view){
        .state = kg_net_state_create(gate), .zoom = 1, .scale = 1, .columns = 1, .fitted = true};
    if (!v->state)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    forget(v);
    return KG_OK;
}

void kg_net_view_clear(kg_net_view *v) {
    kg_net_state_destroy(v->state);
    free(v->clashes);
    *v = (kg_net_view){0};
}

bool kg_net_view_follow(kg_net_view *v, const kg_editor *e, kg_area area, double scale) {
    const kg_net_picture *p = picture_of(v);
    int64_t source = 0;
    size_t piece = 0;
    if (p && v->active_part >= 0) {
        source = p->net.net->parts[v->active_part].source;
        piece = kg_pin_piece(p->net.net, (size_t)v->active_part);
    }
    bool is_new = kg_net_state_follow(v->state, e);
    bool area_changed = memcmp(&v->area, &area, sizeof area) != 0;
    v->area = area;
    v->scale = scale;
    if (is_new || v->revision != kg_net_state_revision(v->state)) {
        forget(v);
        v->revision = kg_net_state_revision(v->state);
        p = picture_of(v);
        if (p && source)
            v->active_part = kg_pin_part(p->net.net, source, piece);
    }
    p = picture_of(v);
    bool other = area_changed || (p && (v->fitted_pages != p->layout->page_count ||
                                        kg_dist2(v->fitted_size, p->layout->page_size) > 0));
    bool still = v->gesture == KG_NET_IDLE || v->gesture == KG_NET_DIVIDING;
    if (v->fitted && p && other && still)
        kg_net_view_fit(v);
    return is_new;
}

/* ---- places ----------------------------------------------------------------------------- */

kg_vec2 kg_net_view_to_px(const kg_net_view *v, kg_vec2 board) {
    return kg_add2(v->pan, kg_scale2(board, v->zoom));
}

kg_vec2 kg_net_view_to_board(const kg_net_view *v, kg_vec2 px) {
    return kg_scale2(kg_sub2(px, v->pan), 1 / v->zoom);
}

size_t kg_net_view_page_count(const kg_net_view *v) {
    const kg_net_picture *p = picture_of(v);
    if (!p)
        return 0;
    size_t count = p->layout->page_count;
    bool more = v->gesture == KG_NET_MOVING && count < p->net.net->part_count;
    if (v->moved_part >= 0 && (size_t)v->moved.page >= count)
        more = true;
    return count + more;
}

kg_vec2 kg_net_view_page_origin(const kg_net_view *v, int page) {
    const kg_net_picture *p = picture_of(v);
    kg_vec2 size = p ? p->layout->page_size : kg_v2(0, 0);
    return kg_v2(page % v->columns * (size.x + KG_BOARD_GAP),
                 page / v->columns * (size.y + KG_BOARD_GAP));
}

kg_net_placement kg_net_view_placement(const kg_net_view *v, size_t part) {
    return (int)part == v->moved_part ? v->moved : picture_of(v)->layout->placements[part];
}

static kg_vec2 turned(kg_vec2 p, double angle) {
    double c = cos(angle), s = sin(angle);
    return kg_v2(c * p.x - s * p.y, s * p.x + c * p.y);
}

/* The part's point at a point of the board. */
static kg_vec2 from_board(const kg_net_view *v, const kg_net_placement *at, kg_vec2 p) {
    kg_vec2 q = kg_sub2(kg_sub2(p, kg_net_view_page_origin(v, at->page)), at->offset);
    return kg_scale2(turned(q, -at->angle), 1 / picture_of(v)->layout->scale);
}

kg_net_map kg_net_view_map(const kg_net_view *v, size_t part) {
    kg_net_placement at = kg_net_view_placement(v, part);
    double scale = v->zoom * picture_of(v)->layout->scale;
    return (kg_net_map){
        scale * cos(at.angle), scale * sin(at.angle),
        kg_net_view_to_px(v, kg_add2(kg_net_view_page_origin(v, at.page), at.offset))};
}

kg_vec2 kg_net_view_part_point(const kg_net_view *v, size_t part, kg_vec2 px) {
    kg_net_placement at = kg_net_view_placement(v, part);
    return from_board(v, &at, kg_net_view_to_board(v, px));
}

kg_box2 kg_net_view_part_box(const kg_net_view *v, size_t part) {
    const kg_net_line *line = &picture_of(v)->net.net->parts[part].loops[0].line;
    kg_net_map map = kg_net_view_map(v, part);
    kg_box2 box = kg_box2_empty();
    for (size_t i = 0; i < line->count; i++)
        kg_box2_add(&box, kg_net_map_apply(&map, line->points[i]));
    return box;
}

/* The middle of a part's box in its own coordinates: it turns about this. */
static kg_vec2 middle_of(const kg_net_part *part) {
    kg_box2 box = kg_box2_empty();
    for (size_t i = 0; i < part->loops[0].line.count; i++)
        kg_box2_add(&box, part->loops[0].line.points[i]);
    return kg_lerp2(box.lo, box.hi, 0.5);
}

kg_net_placement kg_net_view_turned(const kg_net_view *v, size_t part, double angle) {
    const kg_net_picture *p = picture_of(v);
    kg_net_placement at = kg_net_view_placement(v, part);
    kg_vec2 middle = kg_scale2(middle_of(&p->net.net->parts[part]), p->layout->scale);
    kg_vec2 stays = kg_add2(at.offset, turned(middle, at.angle));
    at.angle = remainder(at.angle + angle, 2 * KG_PI);
    at.offset = kg_sub2(stays, turned(middle, at.angle));
    return at;
}

bool kg_net_view_handle(const kg_net_view *v, kg_vec2 *out_center, kg_vec2 *out_handle) {
    const kg_net_picture *p = picture_of(v);
    if (!p || v->active_part < 0 || p->options.paper.x == 0)
        return false;
    const kg_net_part *part = &p->net.net->parts[v->active_part];
    kg_net_map map = kg_net_view_map(v, (size_t)v->active_part);
    kg_vec2 center = kg_net_map_apply(&map, middle_of(part));
    if (v->gesture == KG_NET_TURNING) {
        *out_handle = v->last;
    } else {
        kg_box2 box = kg_net_view_part_box(v, (size_t)v->active_part);
        double top = v->area.y + HANDLE_DISTANCE / 2.0 * v->scale; /* never out of sight */
        *out_handle = kg_v2(center.x, fmax(box.lo.y - HANDLE_DISTANCE * v->scale, top));
    }
    *out_center = center;
    return true;
}

unsigned kg_net_view_clash(const kg_net_view *v, size_t part) {
    return v->clashes ? v->clashes[part] : picture_of(v)->clashes[part];
}

/* ---- looking ---------------------------------------------------------------------------- */

void kg_net_view_fit(kg_net_view *v) {
    const kg_net_picture *p = picture_of(v);
    if (!p)
        return;
    int pages = (int)p->layout->page_count;
    v->fitted = true;
    v->fitted_pages = p->layout->page_count;
    kg_vec2 size = v->fitted_size = p->layout->page_size;
    double margin = FIT_MARGIN * v->scale, best = 0;
    for (int columns = 1; columns <= pages; columns++) {
        int rows = (pages + columns - 1) / columns;
        double width = columns * (size.x + KG_BOARD_GAP) - KG_BOARD_GAP;
        double height = rows * (size.y + KG_BOARD_GAP) - KG_BOARD_GAP;
        double zoom =
            fmin((v->area.width - 2 * margin) / width, (v->area.height - 2 * margin) / height);
        if (zoom <= best)
            continue;
        best = zoom;
        v->columns = columns;
        v->zoom = zoom;
        v->pan = kg_v2(v->area.x + (v->area.width - zoom * width) / 2,
                       v->area.y + (v->area.height - zoom * height) / 2);
    }
}

/* How far [lo, hi] has to be moved to lie between `from` and `to`; its beginning comes first. */
static double shift_into(double lo, double hi, double from, double to) {
    double by = hi > to ? to - hi : 0;
    return lo + by < from ? from - lo : by;
}

void kg_net_view_show_part(kg_net_view *v, size_t part) {
    kg_box2 box = kg_net_view_part_box(v, part);
    double margin = FIT_MARGIN * v->scale;
    kg_vec2 by = kg_v2(
        shift_into(box.lo.x, box.hi.x, v->area.x + margin, v->area.x + v->area.width - margin),
        shift_into(box.lo.y, box.hi.y, v->area.y + margin, v->area.y + v->area.height - margin));
    v->active_part = (int)part;
    v->fitted = v->fitted && by.x == 0 && by.y == 0;
    v->pan = kg_add2(v->pan, by);
}

/* ---- what lies under a pixel ------------------------------------------------------------ */

static bool inside(const kg_net_part *part, kg_vec2 p) {
    bool in = false;
    for (size_t i = 0; i < part->loop_count; i++) {
        const kg_net_line *line = &part->loops[i].line;
        for (size_t k = 0, j = line->count - 1; k < line->count; j = k++) {
            kg_vec2 a = line->points[j], b = line->points[k];
            if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x))
                in = !in;
        }
    }
    return in;
}

int kg_net_view_part_at(const kg_net_view *v, kg_vec2 px) {
    const kg_net_picture *p = picture_of(v);
    kg_vec2 board = kg_net_view_to_board(v, px);
    for (size_t i = p ? p->net.net->part_count : 0; i-- > 0;) {
        kg_net_placement at = kg_net_view_placement(v, i);
        if (inside(&p->net.net->parts[i], from_board(v, &at, board)))
            return (int)i;
    }
    return -1;
}

bool kg_net_side_points(const kg_net *net, const kg_net_side *side, size_t index, kg_vec2 *out) {
    if (side->part < 0)
        return false;
    const kg_net_part *part = &net->parts[side->part];
    if (side->loop < 0) {
        const kg_net_line *line = &part->lines[side->line];
        if (index >= line->count)
            return false;
        *out = line->points[index];
        return true;
    }
    const kg_net_line *line = &part->loops[side->loop].line;
    if (index >= side->count)
        return false;
    *out = line->points[(side->first + index) % line->count];
    return true;
}

/* Pixels from a side of a join. */
static double side_distance(const kg_net_view *v, const kg_net_side *side, kg_vec2 px) {
    const kg_net *net = picture_of(v)->net.net;
    double best = INFINITY;
    kg_vec2 p, before = px;
    if (side->part < 0)
        return best;
    kg_net_map map = kg_net_view_map(v, (size_t)side->part);
    for (size_t i = 0; kg_net_side_points(net, side, i, &p); i++) {
        kg_vec2 at = kg_net_map_apply(&map, p);
        if (i > 0)
            best = fmin(best, kg_segment_distance(px, before, at, NULL));
        before = at;
    }
    return best;
}

/* Whether the pixel is on a number printed for this join on one of its parts. */
static bool on_number(const kg_net_view *v, const kg_net_join *join, kg_vec2 px) {
    const kg_net_picture *p = picture_of(v);
    for (size_t i = 0; i < p->drawing->page_count; i++)
        for (size_t k = 0; k < p->drawing->pages[i].captions.count; k++) {
            const kg_caption *c = &p->drawing->pages[i].captions.items[k];
            char *end;
            long number = strtol(c->text, &end, 10);
            bool is_side = false;
            for (int s = 0; s < 2; s++)
                is_side = is_side || (join->sides[s].part >= 0 &&
                                      p->net.net->parts[join->sides[s].part].number == c->part);
            kg_vec2 at =
                kg_net_view_to_px(v, kg_add2(c->center, kg_net_view_page_origin(v, (int)i)));
            if (c->frame == KG_FRAME_RING && is_side && *end == '\0' && number == join->number &&
                kg_dist2(px, at) < fmax(c->capital * v->zoom, NEAR * v->scale))
                return true;
        }
    return false;
}

int kg_net_view_join_at(const kg_net_view *v, kg_vec2 px) {
    const kg_net_picture *p = picture_of(v);
    double nearest = NEAR * v->scale;
    int best = -1;
    for (size_t i = 0; p && i < p->net.net->join_count; i++) {
        const kg_net_join *join = &p->net.net->joins[i];
        if (on_number(v, join, px))
            return (int)i;
        for (int s = 0; s < 2; s++) {
            double d = side_distance(v, &join->sides[s], px);
            if (d < nearest) {
                nearest = d;
                best = (int)i;
            }
        }
    }
    return best;
}

int kg_net_view_lit_join(const kg_net_view *v, const kg_editor *e) {
    const kg_net_picture *p = picture_of(v);
    const int64_t *seam = e->hover_seam;
    double distance;
    if (v->hover_join >= 0 || !p || !kg_seam_is_hovered(e, seam[0], seam[1]))
        return v->hover_join;
    size_t join =
        kg_net_nearest_join(p->net.net, kg_editor_solution(e), seam, e->hover_seam_at, &distance);
    return join < p->net.net->join_count ? (int)join : -1;
}
