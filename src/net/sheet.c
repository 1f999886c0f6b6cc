#include "net/sheet.h"

static kg_status options_check(const kg_net_options *o, kg_error *error) {
    bool none = o->paper.x == 0 && o->paper.y == 0;
    if (!none && !(o->paper.x > 0 && o->paper.y > 0 && o->paper.x <= 1e5 && o->paper.y <= 1e5))
        return kg_fail(error, KG_ERR_INPUT,
                       "paper of %g x %g mm: both sides must be above 0 and at most 100000",
                       o->paper.x, o->paper.y);
    if (!(o->margin >= 0 && isfinite(o->margin)))
        return kg_fail(error, KG_ERR_INPUT, "a margin of %g mm: it must be 0 or more", o->margin);
    if (!(o->gap >= 0 && isfinite(o->gap)))
        return kg_fail(error, KG_ERR_INPUT, "a gap of %g mm between parts: it must be 0 or more",
                       o->gap);
    if (!(o->scale >= 1e-4 && o->scale <= 1e4))
        return kg_fail(error, KG_ERR_INPUT, "a scale of %g: it must be between 0.0001 and 10000",
                       o->scale);
    if (!(o->tolerance >= 1e-4 && o->tolerance <= 10))
        return kg_fail(error, KG_ERR_INPUT,
                       "a tolerance of %g mm: it must be between 0.0001 and 10", o->tolerance);
    const double *p = o->perforate;
    bool whole = p[0] == 0 && p[1] == 0;
    if (!whole && !(p[0] >= 0.05 && p[1] >= 0.05 && p[0] <= 1e3 && p[1] <= 1e3))
        return kg_fail(error, KG_ERR_INPUT,
                       "perforation of %g mm with gaps of %g mm: both must be at least 0.05", p[0],
                       p[1]);
    return KG_OK;
}

static void forbid(kg_sheet *sheet, double x0, double y0, double x1, double y1) {
    sheet->forbidden[sheet->forbidden_count++] = (kg_box2){kg_v2(x0, y0), kg_v2(x1, y1)};
}

/* Parts are placed before pages are mirrored, what they keep clear of is not. */
static void forbidden_mirror(kg_sheet *sheet) {
    for (int i = 0; i < sheet->forbidden_count; i++) {
        kg_box2 *f = &sheet->forbidden[i];
        double lo = sheet->usable.x - f->hi.x;
        f->hi.x = sheet->usable.x - f->lo.x;
        f->lo.x = lo;
    }
}

kg_status kg_sheet_from_options(const kg_net_options *options, kg_sheet *out_sheet,
                                kg_error *error) {
    kg_status status = options_check(options, error);
    if (status)
        return status;
    kg_sheet sheet = {.size = options->paper};
    if (options->paper.x == 0) {
        sheet.endless = true;
        *out_sheet = sheet;
        return KG_OK;
    }
    if (options->landscape && sheet.size.x < sheet.size.y)
        sheet.size = kg_v2(sheet.size.y, sheet.size.x);
    double margin = options->margin;
    sheet.origin = kg_v2(margin, margin);
    sheet.usable = kg_v2(sheet.size.x - 2 * margin, sheet.size.y - 2 * margin);
    double w = sheet.usable.x, h = sheet.usable.y;
    if (!(w > 0 && h > 0))
        return kg_fail(error, KG_ERR_INPUT,
                       "a margin of %g mm leaves nothing of a page of %g x %g mm", margin,
                       sheet.size.x, sheet.size.y);
    if (options->frame && margin < KG_SHEET_BAR_HEIGHT)
        forbid(&sheet, 0, h - KG_SHEET_BAR_HEIGHT, KG_SHEET_BAR_WIDTH, h);
    if (options->registration) {
        const double square = KG_REGISTRATION_SQUARE, leg = KG_REGISTRATION_LEG;
        const double thick = KG_REGISTRATION_WIDTH;
        forbid(&sheet, 0, 0, square, square);
        forbid(&sheet, w - leg, 0, w, thick);
        forbid(&sheet, w - thick, 0, w, leg);
        forbid(&sheet, 0, h - leg, thick, h);
        forbid(&sheet, 0, h - thick, leg, h);
    }
    if (options->mirrored)
        forbidden_mirror(&sheet);
    *out_sheet = sheet;
    return KG_OK;
}
