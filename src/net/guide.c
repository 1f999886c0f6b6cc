#include "net/guide.h"

#include "net/sheet.h"

#include <stdio.h>

#define BAR_LENGTH 50.0
#define CAPITAL 2.0

static bool polygon(kg_page *page, const kg_vec2 *points, int count, bool filled) {
    kg_stroke *stroke = kg_page_stroke(page, KG_LAYER_GUIDE, NULL);
    if (!stroke || !kg_path_move(&stroke->path, points[0]))
        return false;
    stroke->filled = filled;
    for (int i = 1; i < count; i++)
        if (!kg_path_line(&stroke->path, points[i]))
            return false;
    return kg_path_close(&stroke->path);
}

static bool rectangle(kg_page *page, kg_vec2 lo, kg_vec2 hi, bool filled) {
    const kg_vec2 points[] = {lo, {hi.x, lo.y}, hi, {lo.x, hi.y}};
    return polygon(page, points, 4, filled);
}

/* A bar of 50 mm with ticks at its ends, its length and the page's number beside it. */
static bool scale_bar(kg_page *page, kg_vec2 at, size_t number, size_t count) {
    kg_stroke *bar = kg_page_stroke(page, KG_LAYER_GUIDE, NULL);
    double end = at.x + BAR_LENGTH, tick = 1;
    if (!bar || !kg_path_move(&bar->path, kg_v2(at.x, at.y - tick)) ||
        !kg_path_line(&bar->path, kg_v2(at.x, at.y + tick)) || !kg_path_move(&bar->path, at) ||
        !kg_path_line(&bar->path, kg_v2(end, at.y)) ||
        !kg_path_move(&bar->path, kg_v2(end, at.y - tick)) ||
        !kg_path_line(&bar->path, kg_v2(end, at.y + tick)))
        return false;
    char text[64];
    snprintf(text, sizeof text, "50 mm");
    kg_caption caption = {
        .layer = KG_LAYER_GUIDE, .center = kg_v2(end + 6, at.y), .capital = CAPITAL, .text = text};
    if (!kg_page_caption(page, &caption))
        return false;
    snprintf(text, sizeof text, "%zu / %zu", number, count);
    caption.center.x = end + 20;
    return kg_page_caption(page, &caption);
}

static bool registration(kg_page *page, kg_vec2 lo, kg_vec2 hi) {
    const double s = KG_REGISTRATION_SQUARE, l = KG_REGISTRATION_LEG, w = KG_REGISTRATION_WIDTH;
    const kg_vec2 right[] = {{hi.x - l, lo.y},     {hi.x, lo.y},         {hi.x, lo.y + l},
                             {hi.x - w, lo.y + l}, {hi.x - w, lo.y + w}, {hi.x - l, lo.y + w}};
    const kg_vec2 left[] = {{lo.x, hi.y - l},     {lo.x + w, hi.y - l}, {lo.x + w, hi.y - w},
                            {lo.x + l, hi.y - w}, {lo.x + l, hi.y},     {lo.x, hi.y}};
    return rectangle(page, lo, kg_v2(lo.x + s, lo.y + s), true) && polygon(page, right, 6, true) &&
           polygon(page, left, 6, true);
}

kg_status kg_guide_draw(kg_drawing *drawing, const kg_net_options *options, kg_error *error) {
    kg_sheet sheet;
    kg_status status = kg_sheet_from_options(options, &sheet, error);
    if (status || sheet.endless)
        return status;
    kg_vec2 lo = sheet.origin, hi = kg_add2(lo, sheet.usable);
    /* In the middle of the lower margin, else in the room that sheet.c keeps free for it. */
    double y = options->margin >= KG_SHEET_BAR_HEIGHT ? hi.y + options->margin / 2
                                                      : hi.y - KG_SHEET_BAR_HEIGHT / 2;
    double frame = kg_sheet_frame(options->margin);
    bool done = true;
    for (size_t i = 0; done && i < drawing->page_count; i++) {
        kg_page *page = &drawing->pages[i];
        if (options->frame)
            done = rectangle(page, kg_v2(frame, frame),
                             kg_v2(drawing->size.x - frame, drawing->size.y - frame), false) &&
                   (sheet.usable.x < KG_SHEET_BAR_WIDTH ||
                    scale_bar(page, kg_v2(lo.x + 1, y), i + 1, drawing->page_count));
        if (done && options->registration)
            done = registration(page, lo, hi);
    }
    return done ? KG_OK : kg_fail(error, KG_ERR_MEMORY, "out of memory while drawing the page");
}
