#include "net/badge.h"

#include "net/text.h"

#include <stdio.h>
#include <string.h>

/* From a text to its frame, mm; a ring's round ends need more beside the text. */
#define PAD 0.45
#define RING_PAD 0.55

/* From a part's box to its name, mm. */
#define NAME_GAP 0.8

#define UNDERLINE_DISTANCE 0.3
#define UNDERLINE_ROOM 0.25 /* that frames are higher for it, above and below */

/* Handles of a Bézier that is a quarter of a circle. */
#define QUARTER 0.5522847498

/* Numbers that read as another one upside down, as loose parts lie: 6 and 9, 16 and 91. */
static bool turns_over(const char *text) {
    return text[strspn(text, "01689")] == '\0' && strpbrk(text, "69");
}

/* Half the size of the frame, or of a text without. */
static kg_vec2 frame_half(const kg_caption *caption) {
    kg_vec2 half = kg_caption_half(caption);
    if (caption->frame == KG_FRAME_NONE)
        return half;
    half.y += PAD + (turns_over(caption->text) ? UNDERLINE_ROOM : 0);
    half.x += caption->frame == KG_FRAME_RING ? RING_PAD : PAD;
    /* A ring is at least round. */
    return kg_v2(caption->frame == KG_FRAME_RING ? fmax(half.x, half.y) : half.x, half.y);
}

/* A point in the caption's axes, on the page. */
static kg_vec2 on_page(const kg_caption *caption, double x, double y) {
    double c = cos(caption->angle), s = sin(caption->angle);
    return kg_add2(caption->center, kg_v2(c * x - s * y, s * x + c * y));
}

size_t kg_badge_split(const kg_caption *caption, kg_badge *out) {
    kg_caption *number = &out->pieces[0], *name = &out->pieces[1];
    const char *blank = caption->frame == KG_FRAME_BOX ? strchr(caption->text, ' ') : NULL;
    *number = *caption;
    if (!blank)
        return 1;
    snprintf(out->number, sizeof out->number, "%.*s", (int)(blank - caption->text), caption->text);
    number->text = out->number;
    *name = *caption;
    name->frame = KG_FRAME_NONE;
    name->align = KG_CAPTION_START;
    name->text = (char *)(uintptr_t)(blank + 1); /* kg_page_caption copies it */
    double box = frame_half(number).x, beside = kg_caption_half(name).x + NAME_GAP / 2;
    number->center = on_page(caption, -beside, 0);
    name->center = on_page(caption, box + NAME_GAP / 2, 0);
    return 2;
}

kg_vec2 kg_badge_half(const kg_caption *caption) {
    kg_badge badge;
    size_t count = kg_badge_split(caption, &badge);
    kg_vec2 half = frame_half(&badge.pieces[0]);
    if (count == 2)
        half.x += kg_caption_half(&badge.pieces[1]).x + NAME_GAP / 2;
    return half;
}

double kg_badge_reach(const kg_caption *caption, kg_vec2 way) {
    kg_vec2 half = kg_badge_half(caption);
    double x = fabs(way.x), y = fabs(way.y), straight = half.x - half.y;
    double box = fmin(x > 1e-9 ? half.x / x : HUGE_VAL, y > 1e-9 ? half.y / y : HUGE_VAL);
    if (caption->frame != KG_FRAME_RING || box * x <= straight)
        return box;
    /* The half circle of radius half.y about (straight, 0). */
    return straight * x + sqrt(fmax(half.y * half.y - straight * straight * y * y, 0));
}

static bool draw_box(const kg_caption *c, kg_path *path) {
    kg_vec2 h = frame_half(c);
    return kg_path_move(path, on_page(c, -h.x, -h.y)) &&
           kg_path_line(path, on_page(c, h.x, -h.y)) && kg_path_line(path, on_page(c, h.x, h.y)) &&
           kg_path_line(path, on_page(c, -h.x, h.y)) && kg_path_close(path);
}

/* From the upper end of the right half circle clockwise: two quarters, the lower side, two more. */
static bool draw_ring(const kg_caption *c, kg_path *path) {
    kg_vec2 h = frame_half(c);
    double r = h.y, m = h.x - r, k = QUARTER * r;
    bool done = kg_path_move(path, on_page(c, m, -r));
    for (int side = 1; done && side >= -1; side -= 2) {
        kg_vec2 p[7] = {{m, -r},    {m + k, -r}, {m + r, -k}, {m + r, 0},
                        {m + r, k}, {m + k, r},  {m, r}};
        for (int i = 0; i < 7; i++)
            p[i] = on_page(c, side * p[i].x, side * p[i].y);
        if (side < 0 && m > 0)
            done = kg_path_line(path, p[0]);
        done =
            done && kg_path_curve(path, p[1], p[2], p[3]) && kg_path_curve(path, p[4], p[5], p[6]);
    }
    return done && kg_path_close(path);
}

static bool draw_underline(const kg_caption *c, kg_path *path) {
    kg_vec2 half = kg_caption_half(c);
    double y = half.y + UNDERLINE_DISTANCE;
    return kg_path_move(path, on_page(c, -half.x, y)) && kg_path_line(path, on_page(c, half.x, y));
}

/* A framed number. */
static bool draw_number(kg_page *page, const kg_caption *inside, const kg_net_part *part) {
    if (!kg_page_caption(page, inside))
        return false;
    if (inside->frame != KG_FRAME_NONE) {
        kg_stroke *frame = kg_page_stroke(page, inside->layer, part);
        if (!frame || !(inside->frame == KG_FRAME_BOX ? draw_box : draw_ring)(inside, &frame->path))
            return false;
    }
    if (!turns_over(inside->text))
        return true;
    kg_stroke *line = kg_page_stroke(page, inside->layer, part);
    return line && draw_underline(inside, &line->path);
}

bool kg_badge_draw(kg_page *page, const kg_caption *caption, const kg_net_part *part) {
    kg_badge badge;
    size_t count = kg_badge_split(caption, &badge);
    return draw_number(page, &badge.pieces[0], part) &&
           (count == 1 || kg_page_caption(page, &badge.pieces[1]));
}
