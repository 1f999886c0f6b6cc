#include "katagami/trim.h"

#include "base/array.h"
#include "trim/cutting.h"
#include "trim/region.h"

#include <assert.h>
#include <stdlib.h>

static bool is_sliver(const kg_arrangement *a, size_t face) {
    double area = 0, length = 0;
    for (size_t i = 0; i < a->loop_count; i++)
        if (a->loops[i].face == face) {
            area += a->loops[i].area;
            length += a->loops[i].length;
        }
    return kg_is_sliver(a, area, length);
}

kg_status kg_regions_from_faces(const kg_arrangement *a, kg_face_filter wanted, const void *user,
                                kg_regions *out) {
    for (size_t f = 1; f < a->face_count; f++) {
        if (!(a->labels[f] & KG_LABEL_REGION) || is_sliver(a, f) || (wanted && !wanted(a, f, user)))
            continue;
        kg_region region;
        kg_status status = kg_region_from_face(a, f, &region);
        if (status)
            return status;
        if ((status = kg_regions_add(out, region)))
            return status;
    }
    return KG_OK;
}

static size_t nearest_piece(const kg_patch *patch, const kg_regions *pieces, kg_vec3 point) {
    /* the piece that holds the patch's nearest point, if any holds it, is the nearest */
    double u, v, least = INFINITY;
    size_t best = 0;
    kg_patch_closest(patch, point, &u, &v);
    for (size_t i = 0; i < pieces->count; i++)
        if (kg_region_contains(&pieces->items[i], u, v))
            return i;
    kg_feet feet;
    kg_feet_find(patch, point, &feet);
    for (size_t i = 0; i < pieces->count; i++) {
        double d = kg_feet_distance2(&feet, &pieces->items[i], least);
        if (d < least)
            least = d, best = i;
    }
    return best;
}

/* Keeps, for each point, the piece nearest to it. */
static kg_status keep_nearest(const kg_patch *patch, kg_regions *pieces, const kg_vec3 *keep,
                              size_t keep_count) {
    if (keep_count == 0 || pieces->count < 2)
        return KG_OK;
    bool *kept = calloc(pieces->count, sizeof *kept);
    if (!kept)
        return KG_ERR_MEMORY;
    for (size_t k = 0; k < keep_count; k++)
        kept[nearest_piece(patch, pieces, keep[k])] = true;
    size_t n = 0;
    for (size_t i = 0; i < pieces->count; i++) {
        if (kept[i])
            pieces->items[n++] = pieces->items[i];
        else
            kg_region_clear(&pieces->items[i]);
    }
    pieces->count = n;
    free(kept);
    return KG_OK;
}

kg_status kg_trim_finish(kg_status status, kg_regions *pieces, kg_regions *out_regions,
                         kg_error *error) {
    if (status) {
        kg_regions_clear(pieces);
        return status == KG_ERR_MEMORY ? kg_fail(error, status, "out of memory") : status;
    }
    *out_regions = *pieces;
    return KG_OK;
}

/* ---- single surface --------------------------------------------------------------------- */

/* A cutter that misses the patch, or of which nothing is left where it met it, is a mistake. */
static kg_status check_meets(const kg_patch *patch, const kg_cut *cut, kg_error *error) {
    if (cut->crossings->count == 0)
        return kg_fail(error, KG_ERR_INPUT,
                       "patch %lld does not meet it, so it cannot cut it; move one of them, widen "
                       "its extent or remove the trim",
                       (long long)cut->source);
    if (!cut->bounded)
        return KG_OK;
    kg_chains chains = {0};
    kg_status status = kg_cut_chains(patch, cut, &chains);
    bool meets = chains.count > 0;
    kg_chains_clear(&chains);
    if (status)
        return kg_fail(error, status, "out of memory");
    if (!meets)
        return kg_fail(error, KG_ERR_INPUT,
                       "patch %lld does not meet it with what is left of it, so it cannot cut it; "
                       "let it cut with its whole rectangle, change its trims or remove this one",
                       (long long)cut->source);
    return KG_OK;
}

static kg_status split_region(const kg_trim *t, const kg_region *region, const kg_cut *cut,
                              kg_regions *pieces) {
    kg_chains chains = {0};
    kg_arrangement a = {0};
    kg_status status = kg_region_chains(region, t->finder, &chains);
    size_t outline = chains.count;
    if (!status)
        status = kg_cut_chains(t->patch, cut, &chains);
    if (!status)
        status = kg_cut_prolong(t, region, outline, &chains);
    if (!status)
        status = kg_arrangement_build(t->patch, &chains, &a);
    if (!status)
        status = kg_regions_from_faces(&a, NULL, NULL, pieces);
    kg_arrangement_clear(&a);
    kg_chains_clear(&chains);
    return status;
}

kg_status kg_trim_by(const kg_trim *trim, const kg_regions *regions, const kg_cut *cut,
                     const kg_vec3 *keep, size_t keep_count, kg_regions *out_regions,
                     kg_error *error) {
    kg_regions pieces = {0};
    kg_status status = check_meets(trim->patch, cut, error);
    if (status)
        return status;
    for (size_t i = 0; i < regions->count && !status; i++)
        status = split_region(trim, &regions->items[i], cut, &pieces);
    if (!status && pieces.count == regions->count) {
        kg_trim_note note = {KG_NOTE_OUTSIDE, cut->source, cut->crossings->branches[0].points[0].x,
                             0};
        status = kg_trim_note_add(trim, note);
    }
    if (!status)
        status = keep_nearest(trim->patch, &pieces, keep, keep_count);
    return kg_trim_finish(status, &pieces, out_regions, error);
}

/* ---- several surfaces ------------------------------------------------------------------- */

typedef struct wanted_cutters {
    const kg_cut *cuts;
    size_t count;
} wanted_cutters;

/* Is the arc on the boundary of a face, by itself or through the older arc it lies on? */
static bool borders(const kg_arc *arc, size_t face) {
    return (!arc->dropped || arc->doubles != KG_NO_ARC) &&
           (arc->face[0] == face || arc->face[1] == face);
}

/* Borders every cutter and no side of the rectangle, unless a cutter lies along that. */
static bool is_enclosed(const kg_arrangement *a, size_t face, const void *user) {
    const wanted_cutters *w = user;
    size_t met = 0, outline = 0;
    for (size_t k = 0; k < w->count; k++) {
        bool found = false;
        for (size_t i = 0; i < a->arc_count; i++) {
            const kg_chain *c = &a->chains->items[a->arcs[i].chain];
            if (!borders(&a->arcs[i], face) || c->kind != KG_EDGE_CUT ||
                c->source != w->cuts[k].source)
                continue;
            found = true;
            size_t j = a->arcs[i].doubles;
            if (j != KG_NO_ARC && a->chains->items[a->arcs[j].chain].kind == KG_EDGE_OUTLINE)
                outline--;
        }
        met += found;
    }
    for (size_t i = 0; i < a->arc_count; i++)
        outline += borders(&a->arcs[i], face) &&
                   a->chains->items[a->arcs[i].chain].kind == KG_EDGE_OUTLINE;
    return met == w->count && outline == 0;
}

static kg_status enclosed_faces(const kg_trim *t, const kg_region *region, wanted_cutters wanted,
                                kg_regions *faces) {
    kg_chains chains = {0};
    kg_status status = kg_region_chains(region, t->finder, &chains);
    size_t outline = chains.count, before = faces->count;
    for (size_t k = 0; k < wanted.count && !status; k++)
        status = kg_cut_chains(t->patch, &wanted.cuts[k], &chains);
    for (int attempt = 0; attempt < 2 && !status && faces->count == before; attempt++) {
        kg_arrangement a = {0};
        if (attempt > 0)
            status = kg_cut_join(t, outline, &chains);
        if (!status)
            status = kg_arrangement_build(t->patch, &chains, &a);
        if (!status)
            status = kg_regions_from_faces(&a, is_enclosed, &wanted, faces);
        kg_arrangement_clear(&a);
    }
    kg_chains_clear(&chains);
    return status;
}

kg_status kg_trim_inside(const kg_trim *trim, const kg_regions *regions, const kg_cut *cuts,
                         size_t cut_count, const kg_vec3 *keep, size_t keep_count,
                         kg_regions *out_regions, kg_error *error) {
    kg_regions faces = {0};
    kg_status status = KG_OK;
    for (size_t k = 0; k < cut_count && !status; k++)
        status = check_meets(trim->patch, &cuts[k], error);
    if (status)
        return status;
    for (size_t i = 0; i < regions->count && !status; i++)
        status =
            enclosed_faces(trim, &regions->items[i], (wanted_cutters){cuts, cut_count}, &faces);
    if (!status && faces.count == 0)
        status = kg_fail(error, KG_ERR_INPUT,
                         "its %zu cutters do not enclose a piece of it; let neighbouring cutters "
                         "cross on it",
                         cut_count);
    if (!status && faces.count > 1 && keep_count == 0)
        status = kg_fail(error, KG_ERR_INPUT,
                         "its cutters enclose %zu pieces; name one with a point near it (\"keep\")",
                         faces.count);
    if (!status)
        status = keep_nearest(trim->patch, &faces, keep, keep_count);
    return kg_trim_finish(status, &faces, out_regions, error);
}
