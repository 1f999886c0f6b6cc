#include "net/label.h"

#include "net/badge.h"
#include "net/layout.h"
#include "net/space.h"

#include <stdio.h>
#include <string.h>

/* Heights of capitals, mm: what is wished, and what can still be read and drawn. */
#define PART_CAPITAL 3.5
#define JOIN_CAPITAL 2.2
#define LEAST_CAPITAL 1.8

/* Free space around a frame, and what there is more between it and its edge, mm. */
#define CLEARANCE 0.3
#define EDGE_DISTANCE 0.2

typedef struct writer {
    const kg_net *net;
    const kg_net_layout *layout;
    const kg_net_options *options;
    kg_page *page;
    kg_space *space;
    const kg_net_part *part; /* whose label is being placed */
} writer;

/* Turns by half a circle what would stand on its head. */
static double upright(double angle) {
    angle = remainder(angle, 2 * KG_PI);
    if (angle > KG_PI / 2 + 1e-9)
        return angle - KG_PI;
    return angle <= -KG_PI / 2 + 1e-9 ? angle + KG_PI : angle;
}

static kg_block block_of(const kg_caption *caption, double clearance) {
    kg_vec2 half = kg_badge_half(caption);
    return (kg_block){caption->center, kg_v2(half.x + clearance, half.y + clearance),
                      caption->angle};
}

static bool on_captions(const writer *w, const kg_block *block) {
    for (size_t i = 0; i < w->page->captions.count; i++) {
        kg_block other = block_of(&w->page->captions.items[i], 0);
        if (kg_blocks_overlap(block, &other))
            return true;
    }
    return false;
}

/* Free on the paper of the part, or for `outside` on paper that falls away. */
static bool is_free(const writer *w, const kg_caption *caption, bool outside) {
    kg_badge badge;
    size_t count = kg_badge_split(caption, &badge);
    int part = outside ? 0 : w->part->number;
    for (size_t i = 0; i < count; i++) {
        kg_block block = block_of(&badge.pieces[i], CLEARANCE);
        if (!kg_space_holds(w->space, &block) ||
            kg_space_inside(w->space, part, badge.pieces[i].center) == outside ||
            kg_space_blocked(w->space, part, &block) || on_captions(w, &block))
            return false;
    }
    return true;
}

static kg_caption caption_new(const writer *w, kg_frame frame, const char *text, double capital) {
    /* kg_page_caption copies the text. */
    return (kg_caption){.layer = KG_LAYER_LABEL,
                        .frame = frame,
                        .part = w->part->number,
                        .source = w->part->source,
                        .capital = capital,
                        .text = (char *)(uintptr_t)text};
}

static bool label_add(const writer *w, const kg_caption *caption) {
    return kg_badge_draw(w->page, caption, w->part);
}

/* ---- leader lines ------------------------------------------------------------------------------
 */

static bool leader_free(const writer *w, kg_vec2 from, kg_vec2 to) {
    kg_vec2 way = kg_sub2(to, from);
    kg_block line = {kg_lerp2(from, to, 0.5), kg_v2(kg_len2(way) / 2, 0.1), atan2(way.y, way.x)};
    return !on_captions(w, &line);
}

static bool leader_draw(const writer *w, kg_vec2 from, kg_vec2 to) {
    kg_stroke *stroke = kg_page_stroke(w->page, KG_LAYER_LABEL, w->part);
    return stroke && kg_path_move(&stroke->path, from) && kg_path_line(&stroke->path, to) &&
           kg_space_add_wall(w->space, from, to, w->part->number);
}

/* Puts the text on free paper near `anchor` with a line to it; where there is none, on the anchor
 * itself, since a label on a line is better than no label. */
static bool place_with_leader(const writer *w, kg_frame frame, const char *text, kg_vec2 anchor) {
    kg_caption caption = caption_new(w, frame, text, LEAST_CAPITAL);
    kg_vec2 half = kg_badge_half(&caption);
    for (int ring = 1; ring <= 12; ring++) {
        for (int k = 0; k < 16; k++) {
            double angle = 2 * KG_PI * k / 16;
            kg_vec2 way = kg_v2(cos(angle), sin(angle));
            caption.center = kg_add2(anchor, kg_scale2(way, 2.5 * ring + half.x));
            kg_vec2 end = kg_sub2(caption.center, kg_scale2(way, kg_badge_reach(&caption, way)));
            if (is_free(w, &caption, true) && leader_free(w, anchor, end))
                return label_add(w, &caption) && leader_draw(w, anchor, end);
        }
    }
    caption.center = anchor;
    return label_add(w, &caption);
}

/* ---- parts -------------------------------------------------------------------------------------
 */

/* Tries a text at the part's roomiest place, upright, then turned, in the end by any multiple of 15
 * degrees; false when it does not fit. */
static bool fit_in_part(const writer *w, const char *text, kg_caption *out) {
    enum { USUAL = 4, ANGLES = 12 };
    static const int degrees[ANGLES] = {0, -90, -45, 45, -30, 30, -60, 60, -15, 15, -75, 75};
    double best = 0;
    for (size_t k = 0; k < (best > 0 ? USUAL : ANGLES); k++) {
        kg_caption caption = caption_new(w, KG_FRAME_BOX, text, PART_CAPITAL);
        caption.angle = degrees[k] * KG_PI / 180;
        kg_vec2 half = kg_badge_half(&caption);
        double room = kg_space_pole(w->space, w->part->number, caption.angle, half.x / half.y,
                                    &caption.center);
        /* The pole is careful about the box's corners: from what it promises the text grows to
         * what really is free. */
        for (caption.capital = PART_CAPITAL; caption.capital >= LEAST_CAPITAL;
             caption.capital *= 0.9)
            if (is_free(w, &caption, false))
                break;
        if (room > 0 && caption.capital >= LEAST_CAPITAL && caption.capital > 1.2 * best) {
            best = caption.capital;
            *out = caption;
        }
        if (best >= PART_CAPITAL)
            break;
    }
    return best > 0;
}

static bool label_part(const writer *w) {
    char text[512];
    snprintf(text, sizeof text, "%d %s", w->part->number, w->part->name);
    /* A name cut in the middle of a character would be no UTF-8. */
    if (!*w->part->name || strlen(w->part->name) > 400)
        snprintf(text, sizeof text, "%d", w->part->number);
    kg_caption caption;
    if (fit_in_part(w, text, &caption))
        return label_add(w, &caption);
    kg_vec2 pole = {0, 0};
    if (!(kg_space_pole(w->space, w->part->number, 0, 1, &pole) > 0))
        return true; /* no paper to speak of */
    char number[16];
    snprintf(number, sizeof number, "%d", w->part->number);
    if (fit_in_part(w, number, &caption))
        return label_add(w, &caption);
    return place_with_leader(w, KG_FRAME_BOX, text, pole);
}

/* ---- joins -------------------------------------------------------------------------------------
 */

typedef struct stretch {
    const kg_vec2 *points; /* of the part */
    size_t first, count, cycle;
    bool edge; /* of the outline: its paper lies on the side x turns to y */
} stretch;

static kg_vec2 stretch_point(const stretch *s, size_t i) {
    return s->points[(s->first + i) % s->cycle];
}

/* Where a join shows on a part: on its mark or the fold of its middle tab when there is one, else
 * on the outline. */
static bool stretch_find(const kg_net_part *part, const kg_net_side *side, int join, stretch *out) {
    const kg_net_line *mine = NULL;
    size_t tabs = 0, seen = 0;
    for (size_t i = 0; i < part->line_count; i++)
        tabs += part->lines[i].join == join && part->lines[i].tab > 0;
    for (size_t i = 0; i < part->line_count; i++) {
        const kg_net_line *line = &part->lines[i];
        if (line->join == join && line->tab > 0 && seen++ == tabs / 2)
            mine = line;
    }
    if (!mine && side->loop < 0 && side->line >= 0 && (size_t)side->line < part->line_count)
        mine = &part->lines[side->line];
    if (mine) {
        *out = (stretch){mine->points, 0, mine->count, mine->count, false};
    } else if (side->loop >= 0 && (size_t)side->loop < part->loop_count) {
        const kg_net_line *loop = &part->loops[side->loop].line;
        *out = (stretch){loop->points, side->first, side->count, loop->count, true};
    } else {
        return false;
    }
    return out->count >= 2;
}

/* Point and direction on the page at a fraction of the stretch's length. */
static kg_vec2 stretch_at(const writer *w, const stretch *s, double fraction, kg_vec2 *out_way) {
    size_t part = (size_t)(w->part - w->net->parts);
    double total = 0, sum = 0;
    for (size_t i = 0; i + 1 < s->count; i++)
        total += kg_dist2(stretch_point(s, i), stretch_point(s, i + 1));
    size_t i = 0;
    double step = 0;
    for (; i + 1 < s->count; i++) {
        step = kg_dist2(stretch_point(s, i), stretch_point(s, i + 1));
        if (sum + step >= fraction * total || i + 2 == s->count)
            break;
        sum += step;
    }
    kg_vec2 a = kg_layout_apply(w->layout, part, stretch_point(s, i));
    kg_vec2 b = kg_layout_apply(w->layout, part, stretch_point(s, i + 1));
    double length = kg_dist2(a, b);
    *out_way = length > 0 ? kg_scale2(kg_sub2(b, a), 1 / length) : kg_v2(1, 0);
    return kg_lerp2(a, b, step > 0 ? fmin((fraction * total - sum) / step, 1) : 0);
}

static bool fit_at_edge(const writer *w, const stretch *s, const char *text, bool outside,
                        kg_caption *out) {
    static const double fractions[] = {0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8, 0.1, 0.9};
    static const double further[] = {0, 1.2, 3};
    for (double capital = JOIN_CAPITAL; capital >= LEAST_CAPITAL; capital -= 0.35) {
        for (size_t k = 0; k < 27; k++) {
            kg_vec2 way;
            kg_vec2 at = stretch_at(w, s, fractions[k % 9], &way);
            kg_caption caption = caption_new(w, KG_FRAME_RING, text, capital);
            caption.angle = upright(atan2(way.y, way.x));
            double away = kg_badge_half(&caption).y + CLEARANCE + EDGE_DISTANCE + further[k / 9];
            for (int side = 0; side < (s->edge ? 1 : 2); side++) {
                double sign = (side == 0) != (s->edge && outside) ? 1 : -1;
                caption.center = kg_add2(at, kg_scale2(kg_v2(-way.y, way.x), sign * away));
                if (is_free(w, &caption, outside && s->edge)) {
                    *out = caption;
                    return true;
                }
            }
        }
    }
    return false;
}

static bool label_join_side(const writer *w, const kg_net_side *side, int join) {
    stretch s;
    if (!stretch_find(w->part, side, join, &s))
        return true;
    char text[16];
    snprintf(text, sizeof text, "%d", w->net->joins[join].number);
    kg_caption caption;
    bool outside = w->options->labels == KG_LABELS_OUTSIDE;
    if (fit_at_edge(w, &s, text, outside, &caption) ||
        (outside && fit_at_edge(w, &s, text, false, &caption)))
        return label_add(w, &caption);
    kg_vec2 way;
    return place_with_leader(w, KG_FRAME_RING, text, stretch_at(w, &s, 0.5, &way));
}

/* Parts first: their labels need the most room. */
static bool label_page(writer *w, int page) {
    const kg_net *net = w->net;
    for (size_t i = 0; i < net->part_count; i++) {
        w->part = &net->parts[i];
        if (w->layout->placements[i].page == page && !label_part(w))
            return false;
    }
    for (size_t i = 0; i < net->join_count; i++) {
        for (int s = 0; s < 2; s++) {
            const kg_net_side *side = &net->joins[i].sides[s];
            if (side->part < 0 || w->layout->placements[side->part].page != page)
                continue;
            w->part = &net->parts[side->part];
            if (!label_join_side(w, side, (int)i))
                return false;
        }
    }
    return true;
}

kg_status kg_label_draw(const kg_net *net, const kg_net_layout *layout,
                        const kg_net_options *options, kg_drawing *drawing, kg_error *error) {
    if (options->labels == KG_LABELS_NONE)
        return KG_OK;
    /* No text where a printer does not print. */
    double margin = options->paper.x > 0 ? options->margin : 0;
    kg_box2 room = {kg_v2(margin, margin),
                    kg_v2(drawing->size.x - margin, drawing->size.y - margin)};
    for (size_t i = 0; i < drawing->page_count; i++) {
        kg_space space;
        writer w = {net, layout, options, &drawing->pages[i], &space, NULL};
        bool done = kg_space_create(&drawing->pages[i], room, &space);
        if (done) {
            done = label_page(&w, (int)i);
            kg_space_clear(&space);
        }
        if (!done)
            return kg_fail(error, KG_ERR_MEMORY, "out of memory while placing labels");
    }
    return KG_OK;
}
