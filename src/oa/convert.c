/* Cards of polygon meshes (section 3): depth from the front, smoothing, staircase, then windows
 * and thin tops. */
#include "katagami/oa.h"

#include <stdlib.h>
#include <string.h>

kg_oa_options kg_oa_options_default(void) {
    return (kg_oa_options){.width = 80,
                           .depth = 40,
                           .height = 40,
                           .cell_mm = 2.5,
                           .up = {0, 1, 0},
                           .front = {0, 0, 1},
                           .smooth = 3,
                           .windows = true,
                           .tiny_mm = KG_OA_TINY};
}

bool kg_oa_axis_parse(const char *text, kg_vec3 *out_axis) {
    double sign = text[0] == '-' ? -1 : 1;
    const char *letter = text + (text[0] == '-' || text[0] == '+');
    if (strlen(letter) != 1 || letter[0] < 'x' || letter[0] > 'z')
        return false;
    *out_axis = kg_v3(letter[0] == 'x' ? sign : 0, letter[0] == 'y' ? sign : 0,
                      letter[0] == 'z' ? sign : 0);
    return true;
}

static bool asked_to_stop(const kg_progress *progress, double fraction, const char *what) {
    return progress && progress->call && !progress->call(progress->user, fraction, what);
}

/* ---- depth ------------------------------------------------------------------------------ */

/* From cells to the mesh: the point of cell coordinates (x, y, z). */
typedef struct view {
    kg_vec3 origin, right, front, up; /* of one cell */
} view;

static kg_vec3 point_in(const view *v, double x, double y, double z) {
    return kg_madd(kg_madd(kg_madd(v->origin, x, v->right), y, v->front), z, v->up);
}

/* Fits the mesh's front half into what stays between the plain border cells. */
static kg_status view_of(const kg_mesh *mesh, const kg_oa_options *o, view *out, kg_error *error) {
    kg_vec3 axes[3] = {kg_cross(o->up, o->front), o->front, o->up};
    double lo[3], hi[3], room[3] = {o->width - 2, o->depth - 1, o->height - 1}, scale[3];
    for (int i = 0; i < 3; i++) {
        lo[i] = INFINITY;
        hi[i] = -INFINITY;
        for (size_t c = 0; c < mesh->face_starts[mesh->face_count]; c++) {
            double t = kg_dot(mesh->positions[mesh->face_corners[c]], axes[i]);
            lo[i] = fmin(lo[i], t);
            hi[i] = fmax(hi[i], t);
        }
    }
    lo[1] = (lo[1] + hi[1]) / 2;
    if (!(hi[0] > lo[0]) || !(hi[2] > lo[2]))
        return kg_fail(error, KG_ERR_INPUT,
                       "the mesh has no width or no height as seen from the front; turn it");
    double least = INFINITY;
    for (int i = 0; i < 3; i++) {
        scale[i] = room[i] / (hi[i] - lo[i]);
        least = fmin(least, scale[i]);
    }
    for (int i = 0; i < 3; i++)
        scale[i] = o->stretch && isfinite(scale[i]) ? scale[i] : least;
    *out = (view){.right = kg_scale(axes[0], 1 / scale[0]),
                  .front = kg_scale(axes[1], 1 / scale[1]),
                  .up = kg_scale(axes[2], 1 / scale[2])};
    double middle = (lo[0] + hi[0]) / 2 - o->width / (2 * scale[0]);
    out->origin = kg_madd(kg_madd(kg_scale(axes[0], middle), lo[1], axes[1]), lo[2], axes[2]);
    return KG_OK;
}

static kg_status check_options(const kg_mesh *mesh, const kg_oa_options *o, kg_error *error) {
    kg_status status = kg_mesh_check(mesh, error);
    if (status)
        return status;
    if (mesh->face_count == 0)
        return kg_fail(error, KG_ERR_INPUT, "the mesh has no faces");
    if (o->width < 3 || o->depth < 2 || o->height < 2)
        return kg_fail(error, KG_ERR_INPUT,
                       "a card made of a mesh has at least 3x2x2 cells, not %dx%dx%d", o->width,
                       o->depth, o->height);
    if (fabs(kg_dot(o->up, o->front)) > 1e-9) /* of unit vectors: rounding only */
        return kg_fail(error, KG_ERR_INPUT, "what points up cannot point to the front");
    if (o->margin < 0 || o->margin > KG_OA_MAX_MARGIN)
        return kg_fail(error, KG_ERR_INPUT, "the margin is 0 to %d cells, not %d", KG_OA_MAX_MARGIN,
                       o->margin);
    if (o->smooth < 0 || (o->smooth > 1 && o->smooth % 2 == 0))
        return kg_fail(error, KG_ERR_INPUT, "the square that smooths has an odd side, not %d",
                       o->smooth);
    return KG_OK;
}

kg_status kg_oa_depth_map(const kg_mesh *mesh, const kg_oa_options *o, const kg_progress *progress,
                          int *out_depth, kg_error *error) {
    view v = {0};
    kg_mesh_query *query = NULL;
    kg_status status = check_options(mesh, o, error);
    if (!status)
        status = view_of(mesh, o, &v, error);
    if (!status)
        status = kg_mesh_query_create(mesh, progress, &query, error);
    if (status)
        return status;
    memset(out_depth, 0, (size_t)o->width * (size_t)o->height * sizeof *out_depth);
    for (int x = 1; x < o->width - 1 && !status; x++) {
        for (int z = 0; z < o->height - 1; z++) {
            kg_mesh_hit hit;
            kg_vec3 from = point_in(&v, x + 0.5, o->depth, z + 0.5);
            if (!kg_mesh_query_ray(query, from, kg_neg(v.front), &hit))
                continue;
            double y = kg_dot(kg_sub(hit.point, v.origin), v.front) / kg_dot(v.front, v.front);
            out_depth[x * o->height + z] = (int)fmin(fmax(floor(y + 0.5), 0), o->depth - 1);
        }
        if (asked_to_stop(progress, (double)x / o->width, "depth"))
            status = kg_fail(error, KG_ERR_CANCELLED, "cancelled");
    }
    kg_mesh_query_destroy(query);
    return status;
}

/* ---- smoothing and staircase ------------------------------------------------------------ */

/* The least or greatest of the `size` values around each of in[half … count - half). */
static void extremes(const int *in, int *out, int count, int size, bool greatest) {
    for (int i = size / 2; i < count - size / 2; i++) {
        out[i] = in[i];
        for (int k = i - size / 2; k <= i + size / 2; k++)
            out[i] = (in[k] > out[i]) == greatest ? in[k] : out[i];
    }
}

/*
 * A section is all that lies behind its profile, which reaches back without end. Eroding it by a
 * square of side n = 2 r + 1 leaves what lies r behind the least of n neighbours, dilating adds r
 * before the greatest: in opening and closing r cancels, and only the profile's running extremes
 * remain. Below the base the lowest level goes on, above the card there is nothing.
 */
kg_status kg_oa_smooth(int *depth, int width, int height, int size, kg_error *error) {
    if (size <= 1)
        return KG_OK;
    if (size > 2 * height)
        size = 2 * height + 1; /* no larger square finds anything else */
    int pad = 2 * size, count = height + 2 * pad;
    int *a = calloc((size_t)count, sizeof *a), *b = calloc((size_t)count, sizeof *b);
    for (int x = 0; x < width && a && b; x++) {
        int *column = depth + x * height;
        for (int i = 0; i < count; i++)
            a[i] = i < pad ? column[0] : i < pad + height ? column[i - pad] : 0;
        memcpy(b, a, (size_t)count * sizeof *b);
        extremes(a, b, count, size, false);
        extremes(b, a, count, size, true);
        extremes(a, b, count, size, true);
        extremes(b, a, count, size, false);
        memcpy(column, a + pad, (size_t)height * sizeof *column);
    }
    kg_status status = a && b ? KG_OK : kg_fail(error, KG_ERR_MEMORY, "out of memory");
    free(a);
    free(b);
    return status;
}

void kg_oa_staircase(int *depth, int width, int height, unsigned char *out_raised) {
    for (int x = 0; x < width; x++) {
        int *column = depth + x * height;
        for (int z = height - 1; z >= 0; z--) {
            bool raised = z + 1 < height && column[z + 1] > column[z];
            if (raised)
                column[z] = column[z + 1];
            out_raised[x * height + z] = raised;
        }
    }
}

/* ---- the whole -------------------------------------------------------------------------- */

/* Pyramids must leave everything held; where they do not, the steps stay. */
static kg_status try_diagonals(kg_oa *oa, kg_error *error) {
    kg_oa_sheet *sheet;
    size_t missing = 0;
    oa->diagonals = true;
    kg_status status = kg_oa_sheet_create(oa, &sheet, error);
    if (status)
        return status;
    unsigned char *reached = malloc((size_t)sheet->width * (size_t)sheet->rows);
    status = reached ? kg_oa_flood(sheet, reached, &missing, error)
                     : kg_fail(error, KG_ERR_MEMORY, "out of memory");
    free(reached);
    kg_oa_sheet_destroy(sheet);
    oa->diagonals = missing == 0;
    return status;
}

static kg_status fill(const kg_mesh *mesh, const kg_oa_options *o, const kg_progress *progress,
                      kg_oa *oa, unsigned char *raised, kg_error *error) {
    kg_status status = kg_oa_depth_map(mesh, o, progress, oa->depth, error);
    if (!status)
        status = kg_oa_smooth(oa->depth, oa->width, oa->height, o->smooth, error);
    if (status)
        return status;
    kg_oa_staircase(oa->depth, oa->width, oa->height, raised);
    if (o->windows)
        status = kg_oa_open_windows(oa, raised, progress, error);
    if (!status && o->thin_top > 0)
        status = kg_oa_thin_tops(oa, o->thin_top, error);
    if (!status && o->diagonals)
        status = try_diagonals(oa, error);
    kg_oa_mended mended;
    if (!status && o->stable)
        status = kg_oa_stabilize(oa, progress, &mended, error);
    return status;
}

/* As many cells more that the closed card covers its model. */
static kg_status widen(kg_oa *oa, kg_error *error) {
    kg_oa_sheet *sheet;
    kg_status status = kg_oa_sheet_create(oa, &sheet, error);
    if (status)
        return status;
    int margin = oa->margin_cells + kg_oa_overhang(sheet);
    oa->margin_cells = margin < KG_OA_MAX_MARGIN ? margin : KG_OA_MAX_MARGIN;
    kg_oa_sheet_destroy(sheet);
    return KG_OK;
}

kg_status kg_oa_convert(const kg_mesh *mesh, const kg_oa_options *options,
                        const kg_progress *progress, kg_oa **out_oa, kg_error *error) {
    kg_oa *oa;
    kg_status status =
        kg_oa_create(options->width, options->depth, options->height, options->cell_mm, &oa, error);
    if (status)
        return status;
    oa->tiny_mm = options->tiny_mm;
    oa->margin_cells = options->margin;
    unsigned char *raised = calloc((size_t)oa->width, (size_t)oa->height);
    status = raised ? fill(mesh, options, progress, oa, raised, error)
                    : kg_fail(error, KG_ERR_MEMORY, "out of memory");
    free(raised);
    if (!status && options->covering)
        status = widen(oa, error);
    if (status)
        kg_oa_destroy(oa);
    else
        *out_oa = oa;
    return status;
}
