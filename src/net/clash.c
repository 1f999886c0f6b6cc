#include "net/clash.h"

#include "net/nest_exact.h"
#include "net/shapes.h"
#include "net/sheet.h"
#include "net/tab_place.h"

#include <stdlib.h>
#include <string.h>

static kg_status place_all(kg_nest_exact *exact, const kg_net_layout *layout, kg_vec2 origin) {
    kg_status status = KG_OK;
    for (size_t i = 0; i < layout->part_count && !status; i++) {
        const kg_net_placement *p = &layout->placements[i];
        kg_nest_place place = {
            .page = p->page, .angle = p->angle, .offset = kg_sub2(p->offset, origin)};
        status = kg_nest_exact_place(exact, i, place);
    }
    return status;
}

static bool leaves_page(const kg_nest_exact *exact, size_t part, const kg_sheet *sheet) {
    if (sheet->endless)
        return false;
    if (!kg_nest_exact_inside(exact, part, (kg_box2){{0, 0}, sheet->usable}))
        return true;
    for (int i = 0; i < sheet->forbidden_count; i++)
        if (kg_nest_exact_near_box(exact, part, sheet->forbidden[i], 0))
            return true;
    return false;
}

kg_status kg_net_clashes(const kg_net *net, const kg_net_layout *layout,
                         const kg_net_options *options, unsigned *out_clashes, kg_error *error) {
    kg_sheet sheet;
    kg_shapes shapes;
    kg_nest_exact *exact;
    kg_status status = kg_sheet_from_options(options, &sheet, error);
    if (status)
        return status;
    if (!kg_shapes_create(net, layout->scale, &shapes))
        return kg_fail(error, KG_ERR_MEMORY, "out of memory while looking for overlaps");
    status = kg_nest_exact_create(shapes.parts, net->part_count, &exact, error);
    if (!status) {
        status = place_all(exact, layout, sheet.origin);
        if (!status)
            memset(out_clashes, 0, net->part_count * sizeof *out_clashes);
        for (size_t i = 0; i < net->part_count && !status; i++) {
            if (leaves_page(exact, i, &sheet))
                out_clashes[i] |= KG_CLASH_PAGE;
            for (size_t k = 0; k < i; k++)
                if (layout->placements[k].page == layout->placements[i].page &&
                    kg_nest_exact_near(exact, i, k, 0)) {
                    out_clashes[i] |= KG_CLASH_OVERLAP;
                    out_clashes[k] |= KG_CLASH_OVERLAP;
                }
        }
        kg_nest_exact_destroy(exact);
        if (status)
            kg_fail(error, status, "out of memory while looking for overlaps");
    }
    kg_shapes_clear(&shapes);
    return status;
}

/* A contour that tabs make cross itself is no polygon any more. */
static kg_status crossing_contours(const kg_net *net, int *out_count) {
    GEOSContextHandle_t geos = GEOS_init_r();
    int count = 0;
    if (!geos)
        return KG_ERR_MEMORY;
    for (size_t i = 0; i < net->part_count; i++) {
        const kg_net_part *p = &net->parts[i];
        kg_net_line *contours = calloc(p->loop_count, sizeof *contours);
        if (!contours) {
            GEOS_finish_r(geos);
            return KG_ERR_MEMORY;
        }
        for (size_t k = 0; k < p->loop_count; k++)
            contours[k] = p->loops[k].line;
        kg_vec2 at;
        count += !kg_tab_contours_valid(geos, contours, p->loop_count, &at);
        free(contours);
    }
    GEOS_finish_r(geos);
    *out_count = count;
    return KG_OK;
}

kg_status kg_net_tab_overlaps(const kg_net *net, const kg_net_layout *layout,
                              const kg_net_options *options, int *out_count, kg_error *error) {
    int count = 0;
    unsigned *clashes = calloc(net->part_count + 1, sizeof *clashes);
    kg_status status = clashes ? crossing_contours(net, &count) : KG_ERR_MEMORY;
    if (!status && count == 0) /* what is no polygon cannot be laid on others */
        status = kg_net_clashes(net, layout, options, clashes, error);
    else if (status)
        kg_fail(error, status, "out of memory while looking for overlaps");
    for (size_t i = 0; i < net->part_count && !status; i++)
        count += (clashes[i] & KG_CLASH_OVERLAP) != 0;
    free(clashes);
    if (!status)
        *out_count = count;
    return status;
}
