#include "app/panels/net_draw.h"

#include "app/mode.h"
#include "app/panels/net_fill.h"
#include "app/scenery.h"
#include "app/ui/ui.h"
#include "base/array.h"
#include "net/clash.h"
#include "net/sheet.h"
#include "net/text.h"

#include <stdio.h>
#include <stdlib.h>

/* Pixels a curve may be off on the screen, and the chords it takes at most. */
#define SAG_PX 0.2
enum { MOST_CHORDS = 64 };

/* A dash is drawn at least this long, layout units, however small the page is. */
#define LEAST_DASH 2.5

static const kg_color paper = {0.985F, 0.982F, 0.97F, 1};
static const kg_color lit = {0.95F, 0.55F, 0.0F, 1};
static const kg_color wrong = {0.84F, 0.1F, 0.1F, 1};

/* Takes points of a page as drawn to pixels. A part that was moved since is moved along. */
typedef struct pen {
    const kg_net_view *view;
    double c, s; /* zoom and rotation */
    kg_vec2 offset;
    kg_polyline *line; /* scratch */
    kg_fill *fill;     /* of an area, all its outlines */
} pen;

static kg_vec2 to_px(const pen *p, kg_vec2 v) {
    return kg_v2(p->c * v.x - p->s * v.y + p->offset.x, p->s * v.x + p->c * v.y + p->offset.y);
}

static pen pen_of_page(const kg_net_view *view, int page, kg_polyline *line) {
    return (pen){view, view->zoom, 0, kg_net_view_to_px(view, kg_net_view_page_origin(view, page)),
                 line, NULL};
}

static pen pen_of_moved(const kg_net_view *view, kg_polyline *line) {
    const kg_net_placement *to = &view->moved;
    const kg_net_placement *from =
        &kg_net_state_picture(view->state)->layout->placements[view->moved_part];
    double by = to->angle - from->angle, c = view->zoom * cos(by), s = view->zoom * sin(by);
    kg_vec2 turned =
        kg_v2(c * from->offset.x - s * from->offset.y, s * from->offset.x + c * from->offset.y);
    kg_vec2 at =
        kg_net_view_to_px(view, kg_add2(kg_net_view_page_origin(view, to->page), to->offset));
    return (pen){view, c, s, kg_sub2(at, turned), line, NULL};
}

/* ---- strokes ---------------------------------------------------------------------------- */

static void draw_dashed(const kg_polyline *line, const double *dashes, int count, double unit,
                        kg_color color, double width) {
    int k = 0;
    double left = dashes[0] * unit;
    for (size_t i = 1; i < line->count; i++) {
        kg_vec2 a = line->items[i - 1], b = line->items[i];
        double length = kg_dist2(a, b), at = 0;
        while (at < length) {
            double to = fmin(at + left, length);
            if (k % 2 == 0)
                kg_ui_canvas_line(kg_lerp2(a, b, at / length), kg_lerp2(a, b, to / length), color,
                                  width);
            left -= to - at;
            at = to;
            if (left <= 1e-9) {
                k = (k + 1) % count;
                left = dashes[k] * unit;
            }
        }
    }
}

static void end_line(const pen *p, const kg_stroke *stroke, bool closed, kg_color color) {
    const kg_drawing *drawing = kg_net_state_picture(p->view->state)->drawing;
    double width = fmax(drawing->styles[stroke->layer].width * p->view->zoom, p->view->scale);
    const double *dashes;
    int count = stroke->dashed ? kg_layer_dashes(stroke->layer, &dashes) : 0;
    if (p->fill) {
        kg_color soft = color; /* rows alone have jagged rims */
        soft.a *= 0.5F;
        kg_fill_add(p->fill, p->line);
        kg_ui_canvas_polyline(p->line->items, p->line->count, true, soft, p->view->scale);
    } else if (p->line->count > 1 && count > 0)
        draw_dashed(p->line, dashes, count,
                    fmax(p->view->zoom, LEAST_DASH * p->view->scale / dashes[0]), color, width);
    else if (p->line->count > 1)
        kg_ui_canvas_polyline(p->line->items, p->line->count, closed, color, width);
    p->line->count = 0;
}

static bool add_curve(const pen *p, kg_vec2 from, const kg_path_step *step) {
    const kg_vec2 b[4] = {from, step->p[0], step->p[1], step->p[2]};
    int chords = kg_bezier2_chords(b, SAG_PX / p->view->zoom, MOST_CHORDS);
    bool ok = true;
    for (int i = 1; i <= chords && ok; i++)
        ok = kg_push(p->line, to_px(p, kg_bezier2(b, (double)i / chords)));
    return ok;
}

/* What there is no memory for is not drawn. */
static void draw_lines(const pen *p, const kg_stroke *stroke, kg_color color) {
    kg_vec2 at = {0, 0};
    bool ok = true;
    p->line->count = 0;
    for (size_t i = 0; i < stroke->path.count && ok; i++) {
        const kg_path_step *step = &stroke->path.items[i];
        switch (step->verb) {
        case KG_PATH_MOVE:
            end_line(p, stroke, false, color);
            ok = kg_push(p->line, to_px(p, step->p[0]));
            break;
        case KG_PATH_LINE:
            ok = kg_push(p->line, to_px(p, step->p[0]));
            break;
        case KG_PATH_CURVE:
            ok = add_curve(p, at, step);
            break;
        case KG_PATH_CLOSE:
            end_line(p, stroke, true, color);
            break;
        }
        if (step->verb != KG_PATH_CLOSE)
            at = kg_path_end(step);
    }
    end_line(p, stroke, false, color);
}

static void draw_stroke(const pen *p, const kg_stroke *stroke, kg_color color) {
    pen filling = *p;
    kg_fill fill;
    if (!stroke->filled) {
        draw_lines(p, stroke, color);
        return;
    }
    kg_fill_begin(&fill);
    filling.fill = &fill;
    draw_lines(&filling, stroke, color);
    kg_fill_rows(&fill, color, &p->view->area);
    kg_fill_end(&fill);
}

static void draw_caption(const pen *p, const kg_caption *c, kg_color color) {
    double turn = atan2(p->s, p->c);
    kg_ui_canvas_text_turned(to_px(p, kg_caption_anchor(c)), c->angle + turn, kg_caption_share(c),
                             c->capital * p->view->zoom, color, c->text);
}

/* ---- parts ------------------------------------------------------------------------------ */

static void add_loop(const kg_net_view *v, size_t part, size_t loop, kg_polyline *out) {
    const kg_net_line *line =
        &kg_net_state_picture(v->state)->net.net->parts[part].loops[loop].line;
    kg_net_map map = kg_net_view_map(v, part);
    for (size_t i = 0; i <= line->count; i++)
        if (!kg_push(out, kg_net_map_apply(&map, line->points[i % line->count])))
            return;
}

static size_t patch_index(const kg_model *m, int64_t id) {
    size_t i = 0;
    while (i < m->patch_count && m->patches[i].id != id)
        i++;
    return i;
}

static void fill_part(const kg_net_view *v, const kg_editor *e, size_t index, kg_polyline *line) {
    const kg_net_part *part = &kg_net_state_picture(v->state)->net.net->parts[index];
    const kg_model *m = kg_editor_model(e);
    size_t patch = m ? patch_index(m, part->source) : 0;
    int rank = kg_editor_selection_rank(e, part->source);
    bool hovered = m && e->hover_patch == part->source;
    kg_color color = m && patch < m->patch_count ? kg_patch_color(&m->patches[patch]) : lit;
    if (rank >= 0)
        color = kg_rank_color(rank);
    color.a = hovered ? 0.5F : rank >= 0 ? 0.34F : 0.16F;
    kg_fill fill;
    kg_fill_begin(&fill);
    for (size_t k = 0; k < part->loop_count; k++) {
        line->count = 0;
        add_loop(v, index, k, line);
        kg_fill_add(&fill, line);
    }
    kg_fill_rows(&fill, color, &v->area);
    if (kg_net_view_clash(v, index))
        kg_fill_hatch(&fill, wrong, 7 * v->scale, 1.5 * v->scale, &v->area);
    kg_fill_end(&fill);
    if (hovered || kg_net_view_clash(v, index)) {
        line->count = 0;
        add_loop(v, index, 0, line);
        kg_ui_canvas_polyline(line->items, line->count, false, hovered ? lit : wrong,
                              (hovered ? 3 : 2) * v->scale);
    }
}

/* A pin: a disc on a needle. */
static void draw_pin(const kg_net_view *v, size_t part) {
    kg_box2 box = kg_net_view_part_box(v, part);
    kg_vec2 at = kg_lerp2(box.lo, box.hi, 0.5);
    double r = 4 * v->scale;
    at.y = box.lo.y + r;
    kg_vec2 head = kg_v2(at.x + r, at.y - 2 * r);
    kg_ui_canvas_line(at, head, (kg_color){0.25F, 0.25F, 0.28F, 1}, 1.5 * v->scale);
    kg_ui_canvas_disc(head, r, (kg_color){0.12F, 0.45F, 0.75F, 1});
    kg_ui_canvas_circle(head, r, (kg_color){1, 1, 1, 1}, v->scale);
}

static void draw_handle(const kg_net_view *v) {
    kg_vec2 center, handle;
    if (!kg_net_view_handle(v, &center, &handle))
        return;
    kg_ui_canvas_line(center, handle, lit, 1.5 * v->scale);
    kg_ui_canvas_disc(center, 3 * v->scale, lit);
    kg_ui_canvas_disc(handle, 6 * v->scale, lit);
    kg_ui_canvas_circle(handle, 6 * v->scale, (kg_color){1, 1, 1, 1}, 1.5 * v->scale);
}

/* Both sides of a join, and what leads from one to the other. */
static void draw_join(const kg_net_view *v, const kg_net_join *join, kg_polyline *line) {
    const kg_net *net = kg_net_state_picture(v->state)->net.net;
    kg_vec2 middles[2];
    int shown = 0;
    for (int s = 0; s < 2; s++) {
        kg_vec2 p;
        line->count = 0;
        if (join->sides[s].part < 0)
            continue;
        kg_net_map map = kg_net_view_map(v, (size_t)join->sides[s].part);
        for (size_t i = 0; kg_net_side_points(net, &join->sides[s], i, &p); i++)
            if (!kg_push(line, kg_net_map_apply(&map, p)))
                return;
        if (line->count < 2)
            continue;
        kg_ui_canvas_polyline(line->items, line->count, false, lit, 4.5 * v->scale);
        middles[shown++] = line->items[line->count / 2];
    }
    if (shown < 2)
        return;
    const double dots[] = {1, 1.5};
    line->count = 0;
    if (kg_push(line, middles[0]) && kg_push(line, middles[1]))
        draw_dashed(line, dots, 2, 4 * v->scale, lit, 1.5 * v->scale);
    for (int s = 0; s < 2; s++) {
        char number[16];
        snprintf(number, sizeof number, "%d", join->number);
        kg_ui_canvas_disc(middles[s], 10 * v->scale, lit);
        kg_ui_canvas_text(middles[s], (kg_color){1, 1, 1, 1}, number);
    }
}

/* ---- pages ------------------------------------------------------------------------------ */

static void draw_sheet(const kg_net_view *v, int page, bool extra) {
    const kg_net_picture *p = kg_net_state_picture(v->state);
    kg_vec2 at = kg_net_view_to_px(v, kg_net_view_page_origin(v, page));
    kg_vec2 size = kg_scale2(p->layout->page_size, v->zoom);
    kg_area sheet = {at.x, at.y, size.x, size.y};
    kg_color color = paper;
    double shadow = 3 * v->scale, margin = kg_sheet_frame(p->options.margin) * v->zoom;
    color.a = extra ? 0.35F : 1;
    if (!extra)
        kg_ui_canvas_rect((kg_area){at.x + shadow, at.y + shadow, size.x, size.y},
                          (kg_color){0, 0, 0, 0.25F}, 0);
    kg_ui_canvas_rect(sheet, color, 0);
    if (p->options.paper.x > 0 && margin > 1 && size.x > 2 * margin && size.y > 2 * margin)
        kg_ui_canvas_frame(
            (kg_area){at.x + margin, at.y + margin, size.x - 2 * margin, size.y - 2 * margin},
            (kg_color){0.55F, 0.6F, 0.66F, 0.45F}, 1, 0);
    char name[32];
    snprintf(name, sizeof name, "page %d", page + 1);
    kg_ui_name(name, sheet);
}

static void draw_page(const kg_net_view *v, int page, kg_polyline *line) {
    const kg_net_picture *p = kg_net_state_picture(v->state);
    const kg_page *content = &p->drawing->pages[page];
    int moved = v->moved_part >= 0 ? p->net.net->parts[v->moved_part].number : 0;
    const pen still = pen_of_page(v, page, line);
    const pen moving = moved ? pen_of_moved(v, line) : still;
    for (size_t i = 0; i < content->strokes.count; i++) {
        const kg_stroke *stroke = &content->strokes.items[i];
        bool goes_along = moved && stroke->part == moved;
        draw_stroke(goes_along ? &moving : &still, stroke,
                    kg_color_from_rgb(p->drawing->styles[stroke->layer].color));
    }
    for (size_t i = 0; i < content->captions.count; i++) {
        const kg_caption *caption = &content->captions.items[i];
        bool goes_along = moved && caption->part == moved;
        draw_caption(goes_along ? &moving : &still, caption,
                     kg_color_from_rgb(p->drawing->styles[caption->layer].color));
    }
}

/* Tells scripts where something is, when it is in sight. */
static void name(const kg_net_view *v, kg_vec2 at, const char *format, int number) {
    char text[32];
    snprintf(text, sizeof text, format, number);
    if (kg_area_contains(v->area, at))
        kg_ui_name(text, (kg_area){at.x - 1, at.y - 1, 2, 2});
}

static void name_all(const kg_net_view *v) {
    const kg_net *net = kg_net_state_picture(v->state)->net.net;
    kg_vec2 at, handle;
    for (size_t i = 0; i < net->part_count; i++)
        if (kg_fill_inside(v, i, &at))
            name(v, at, "part %d", net->parts[i].number);
    for (size_t i = 0; i < net->join_count; i++) {
        const kg_net_side *side = &net->joins[i].sides[0];
        if (!kg_net_side_points(net, side, side->count / 2, &at))
            continue;
        kg_net_map map = kg_net_view_map(v, (size_t)side->part);
        name(v, kg_net_map_apply(&map, at), "join %d", net->joins[i].number);
    }
    if (kg_net_view_handle(v, &at, &handle))
        name(v, handle, "turn part", 0);
}

void kg_net_draw_pages(const kg_net_view *v, const kg_editor *e) {
    const kg_net_picture *p = kg_net_state_picture(v->state);
    bool dark = e->settings.theme == KG_UI_DARK;
    float shade = dark ? 0.2F : 0.74F;
    kg_polyline line = {0};
    kg_ui_canvas(KG_CANVAS_BEHIND);
    kg_ui_canvas_rect(v->area, (kg_color){shade, shade, shade + 0.015F, 1}, 0);
    kg_ui_canvas_clip(v->area);
    size_t pages = kg_net_view_page_count(v);
    for (size_t i = 0; i < pages; i++)
        draw_sheet(v, (int)i, i >= p->layout->page_count);
    for (size_t i = 0; pages > 0 && i < p->net.net->part_count; i++)
        fill_part(v, e, i, &line);
    if (e->mode->net_draw && pages > 0 && p->net.net->part_count > 0) {
        kg_net_map map = kg_net_view_map(v, 0);
        e->mode->net_draw(e, &map, v->scale);
    }
    for (size_t i = 0; i < pages && i < p->layout->page_count; i++)
        draw_page(v, (int)i, &line);
    for (size_t i = 0; pages > 0 && i < p->net.net->part_count; i++)
        if (p->net.net->parts[i].pinned || (int)i == v->moved_part)
            draw_pin(v, i);
    if (pages > 0) {
        int join = kg_net_view_lit_join(v, e);
        if (join >= 0)
            draw_join(v, &p->net.net->joins[join], &line);
        draw_handle(v);
        name_all(v);
    }
    kg_ui_canvas_unclip();
    free(line.items);
}
