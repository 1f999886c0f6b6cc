#include "net/layout.h"

#include "net/nest.h"
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

/* The net's parts in written size, as nesting wants them. */
typedef struct shapes {
    kg_nest_part *parts;
    kg_nest_loop *loops;
    kg_vec2 *points;
    kg_nest_place *places;
} shapes;

static void shapes_clear(shapes *s) {
    free(s->parts);
    free(s->loops);
    free(s->points);
    free(s->places);
}

static bool shapes_create(const kg_net *net, double scale, shapes *out) {
    size_t loops = 0, points = 0;
    for (size_t i = 0; i < net->part_count; i++) {
        loops += net->parts[i].loop_count;
        for (size_t k = 0; k < net->parts[i].loop_count; k++)
            points += net->parts[i].loops[k].line.count;
    }
    shapes s = {calloc(net->part_count, sizeof *s.parts), calloc(loops, sizeof *s.loops),
                calloc(points, sizeof *s.points), calloc(net->part_count, sizeof *s.places)};
    if (!s.parts || !s.loops || !s.points || !s.places) {
        shapes_clear(&s);
        return false;
    }
    kg_nest_loop *loop = s.loops;
    kg_vec2 *point = s.points;
    for (size_t i = 0; i < net->part_count; i++) {
        const kg_net_part *part = &net->parts[i];
        s.parts[i] = (kg_nest_part){.loops = loop, .loop_count = part->loop_count};
        for (size_t k = 0; k < part->loop_count; k++, loop++) {
            const kg_net_line *line = &part->loops[k].line;
            *loop = (kg_nest_loop){point, line->count};
            for (size_t j = 0; j < line->count; j++)
                *point++ = kg_scale2(line->points[j], scale);
        }
    }
    *out = s;
    return true;
}

static kg_status nest(const kg_net *net, const kg_net_options *options, const kg_sheet *sheet,
                      const kg_progress *progress, kg_net_layout *layout, kg_error *error) {
    shapes s;
    if (!shapes_create(net, options->scale, &s))
        return kg_fail(error, KG_ERR_MEMORY, "out of memory while placing the parts");
    kg_nest_options o = kg_nest_options_default();
    o.width = sheet->usable.x;
    o.height = sheet->usable.y;
    o.spacing = options->gap;
    o.turn = options->grain ? KG_NEST_HALF_TURN : KG_NEST_FREE;
    o.forbidden_count = (size_t)sheet->forbidden_count;
    o.forbidden = sheet->forbidden;
    kg_status status = kg_nest(s.parts, net->part_count, &o, progress, s.places, error);
    for (size_t i = 0; status == KG_OK && i < net->part_count; i++) {
        const kg_nest_place *place = &s.places[i];
        if (place->page < 0) {
            /* Nesting works on a raster; rows hold a part that fills its page to the last line, or
             * say what is wrong. */
            layout->page_count = 0;
            status = kg_shelf_place(net, options, sheet, layout, error);
            break;
        }
        layout->placements[i] =
            (kg_net_placement){place->page, place->angle, kg_add2(place->offset, sheet->origin)};
        if (layout->page_count < (size_t)place->page + 1)
            layout->page_count = (size_t)place->page + 1;
    }
    shapes_clear(&s);
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
