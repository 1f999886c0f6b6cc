#include "net/layout.h"

#include "net/shapes.h"
#include "net/shelf.h"

#include <stdlib.h>
#include <string.h>

static kg_vec2 turned(kg_vec2 p, double c, double s) {
    return kg_v2(c * p.x - s * p.y, s * p.x + c * p.y);
}

kg_vec2 kg_layout_apply(const kg_net_layout *layout, size_t part, kg_vec2 p) {
    const kg_net_placement *place = &layout->placements[part];
    double c = cos(place->angle), s = sin(place->angle);
    return kg_add2(turned(kg_scale2(p, layout->scale), c, s), place->offset);
}

/* ---- nesting --------------------------------------------------------------------------------- */

/* Tells nesting where the pinned parts lie. */
static void pin_parts(const kg_net *net, const kg_sheet *sheet, kg_nest_part *parts) {
    for (size_t i = 0; i < net->part_count; i++) {
        const kg_net_placement *pin = &net->parts[i].pin;
        parts[i].pinned = net->parts[i].pinned;
        parts[i].pin = (kg_nest_place){
            .page = pin->page, .angle = pin->angle, .offset = kg_sub2(pin->offset, sheet->origin)};
    }
}

/* Copies what nesting found. False: it left parts out. */
static bool take_places(const kg_net *net, const kg_sheet *sheet, const kg_nest_place *places,
                        kg_net_layout *layout) {
    for (size_t i = 0; i < net->part_count; i++) {
        const kg_nest_place *place = &places[i];
        if (place->page < 0)
            return false;
        layout->placements[i] = net->parts[i].pinned
                                    ? net->parts[i].pin
                                    : (kg_net_placement){place->page, place->angle,
                                                         kg_add2(place->offset, sheet->origin)};
        if (layout->page_count < (size_t)place->page + 1)
            layout->page_count = (size_t)place->page + 1;
    }
    return true;
}

static kg_status nest(const kg_net *net, const kg_net_options *options, const kg_sheet *sheet,
                      const kg_progress *progress, kg_net_layout *layout, kg_error *error) {
    kg_shapes shapes;
    if (!kg_shapes_create(net, options->scale, &shapes))
        return kg_fail(error, KG_ERR_MEMORY, "out of memory while placing the parts");
    kg_nest_options o = kg_nest_options_default();
    o.width = sheet->usable.x;
    o.height = sheet->usable.y;
    o.spacing = options->gap;
    o.turn = options->grain ? KG_NEST_HALF_TURN : KG_NEST_FREE;
    o.forbidden_count = (size_t)sheet->forbidden_count;
    o.forbidden = sheet->forbidden;
    pin_parts(net, sheet, shapes.parts);
    kg_nest_place *places = calloc(net->part_count, sizeof *places);
    kg_status status = places ? kg_nest(shapes.parts, net->part_count, &o, progress, places, error)
                              : kg_fail(error, KG_ERR_MEMORY, "out of memory while placing parts");
    if (!status && !take_places(net, sheet, places, layout)) {
        /* Nesting works on a raster; rows hold a part that fills its page to the last line, or say
         * what is wrong. */
        layout->page_count = 0;
        status = kg_shelf_place(net, options, sheet, layout, error);
    }
    free(places);
    kg_shapes_clear(&shapes);
    return status;
}

/* ---- layout ---------------------------------------------------------------------------------- */

/* A fitted curve may bulge over the box of its points by the tolerance; what is all corners may lie
 * at the very edge of the page. */
static double rim_of(const kg_net *net, double tolerance) {
    for (size_t i = 0; i < net->part_count; i++)
        for (size_t k = 0; k < net->parts[i].loop_count; k++) {
            const kg_net_line *line = &net->parts[i].loops[k].line;
            if (memchr(line->corners, 0, line->count))
                return tolerance;
        }
    return 0;
}

/* Makes sure that the sheet's margin is no less than the rim. */
static void sheet_keep_rim(kg_sheet *sheet, double rim) {
    double more = fmax(rim - sheet->origin.x, 0);
    sheet->origin = kg_add2(sheet->origin, kg_v2(more, more));
    sheet->usable = kg_sub2(sheet->usable, kg_v2(2 * more, 2 * more));
}

/* What is cut out of the page: with the tabs, without the holes. */
static double cut_area(const kg_net_part *part) {
    double area = 0;
    for (size_t i = 0; i < part->loop_count; i++) {
        const kg_net_line *l = &part->loops[i].line;
        for (size_t k = 0; k < l->count; k++)
            area += 0.5 * kg_cross2(l->points[k], l->points[(k + 1) % l->count]);
    }
    return area;
}

static void layout_fill(const kg_net *net, const kg_sheet *sheet, kg_net_layout *layout) {
    double area = 0;
    for (size_t i = 0; i < net->part_count; i++)
        area += cut_area(&net->parts[i]) * layout->scale * layout->scale;
    kg_vec2 room = sheet->endless ? layout->page_size : sheet->usable;
    double pages = room.x * room.y * (double)layout->page_count;
    layout->fill = pages > 0 ? area / pages : 0;
}

kg_status kg_net_layout_create(const kg_net *net, const kg_net_options *options,
                               const kg_progress *progress, kg_net_layout **out_layout,
                               kg_error *error) {
    kg_sheet sheet;
    kg_status status = kg_net_check(net, error);
    if (status == KG_OK && net->part_count == 0)
        status = kg_fail(error, KG_ERR_INPUT, "the net has no parts, there is nothing to lay out");
    if (status == KG_OK)
        status = kg_sheet_from_options(options, &sheet, error);
    if (status)
        return status;
    kg_net_layout *layout = calloc(1, sizeof *layout);
    if (layout)
        layout->placements = calloc(net->part_count + 1, sizeof *layout->placements);
    if (!layout || !layout->placements) {
        kg_net_layout_destroy(layout);
        return kg_fail(error, KG_ERR_MEMORY, "out of memory while placing the parts");
    }
    sheet_keep_rim(&sheet, rim_of(net, options->tolerance));
    layout->page_size = sheet.size;
    layout->part_count = net->part_count;
    layout->scale = options->scale;
    if (options->nest && !sheet.endless)
        status = nest(net, options, &sheet, progress, layout, error);
    else
        status = kg_shelf_place(net, options, &sheet, layout, error);
    if (status) {
        kg_net_layout_destroy(layout);
        return status;
    }
    layout_fill(net, &sheet, layout);
    *out_layout = layout;
    return KG_OK;
}

void kg_net_layout_destroy(kg_net_layout *layout) {
    if (!layout)
        return;
    free(layout->placements);
    free(layout);
}
