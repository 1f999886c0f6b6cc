/*
 * The net as FOLD 1.2 (E. Demaine, J. Ku, R. Lang, "A new file standard to represent folded
 * structures", 2016): lines broken wherever one ends or passes, so that the graph is planar.
 */
#include "base/array.h"
#include "base/json.h"
#include "oa/sheet.h"

#include <stdlib.h>

typedef struct grid {
    const kg_oa_sheet *sheet;
    double cell_mm;
    unsigned char *ends; /* per lattice point: a line ends or bends here */
    int32_t *vertex;     /* per lattice point, -1: none yet */
    int count;
    json_t *coordinates, *edges, *assignment;
} grid;

static size_t point_of(const grid *g, int x, int row) {
    return (size_t)row * (size_t)(g->sheet->width + 1) + (size_t)x;
}

static bool append(json_t *list, json_t *value) {
    return json_array_append_new(list, value) == 0;
}

/* The vertex at a lattice point, made when it is first asked for; -1 when memory runs out. */
static int vertex_at(grid *g, int x, int row) {
    int32_t *v = &g->vertex[point_of(g, x, row)];
    if (*v < 0) {
        json_t *point = json_pack("[f, f]", x * g->cell_mm, (g->sheet->rows - row) * g->cell_mm);
        if (!append(g->coordinates, point))
            return -1;
        *v = g->count++;
    }
    return *v;
}

/* Steps along a line; its ends are points where edges are broken. */
static void mark_ends(grid *g, const kg_oa_line *line) {
    g->ends[point_of(g, line->x0, line->row0)] = 1;
    g->ends[point_of(g, line->x1, line->row1)] = 1;
}

static int sign_of(int a) {
    return (a > 0) - (a < 0);
}

static bool add_edges(grid *g, const kg_oa_line *line, const char *letter) {
    int dx = sign_of(line->x1 - line->x0), drow = sign_of(line->row1 - line->row0);
    int x = line->x0, row = line->row0, from = vertex_at(g, x, row);
    while (from >= 0 && (x != line->x1 || row != line->row1)) {
        do
            x += dx, row += drow;
        while (!g->ends[point_of(g, x, row)]);
        int to = vertex_at(g, x, row);
        if (to < 0 || !append(g->edges, json_pack("[i, i]", from, to)) ||
            !append(g->assignment, json_string(letter)))
            return false;
        from = to;
    }
    return from >= 0;
}

/* Lines that pass over each other's inner points are broken there as well: a point is an end when
 * lines of two directions meet in it. */
static void mark_crossings(grid *g, const kg_oa_line *lines, size_t count, unsigned char *seen) {
    for (size_t i = 0; i < count; i++) {
        const kg_oa_line *l = &lines[i];
        int dx = sign_of(l->x1 - l->x0), drow = sign_of(l->row1 - l->row0);
        unsigned char direction = (unsigned char)(1 << (dx + 1 + 2 * (drow + 1)));
        for (int x = l->x0, row = l->row0;; x += dx, row += drow) {
            size_t p = point_of(g, x, row);
            if (seen[p] & ~direction)
                g->ends[p] = 1;
            seen[p] |= direction;
            if (x == l->x1 && row == l->row1)
                break;
        }
    }
}

static bool build(grid *g, const kg_oa_line *lines, size_t count, unsigned char *seen) {
    static const char *const letters[] = {"F", "C", "M", "V"};
    int w = g->sheet->width, h = g->sheet->rows;
    const kg_oa_line border[4] = {{KG_OA_CUT, 0, 0, w, 0},
                                  {KG_OA_CUT, w, 0, w, h},
                                  {KG_OA_CUT, 0, h, w, h},
                                  {KG_OA_CUT, 0, 0, 0, h}};
    for (size_t i = 0; i < 4; i++)
        mark_ends(g, &border[i]);
    for (size_t i = 0; i < count; i++)
        mark_ends(g, &lines[i]);
    mark_crossings(g, border, 4, seen);
    mark_crossings(g, lines, count, seen);
    bool done = true;
    for (size_t i = 0; i < 4 && done; i++)
        done = add_edges(g, &border[i], "B");
    for (size_t i = 0; i < count && done; i++)
        done = add_edges(g, &lines[i], letters[lines[i].kind]);
    return done;
}

static char *text_of(const grid *g, const char *title) {
    json_t *root = json_pack("{s:i, s:s, s:s, s:s, s:[s], s:[s], s:s, s:O, s:O, s:O}", "file_spec",
                             1, "file_creator", "katagami", "file_title", title, "frame_title",
                             title, "file_classes", "singleModel", "frame_classes", "creasePattern",
                             "frame_unit", "mm", "vertices_coords", g->coordinates,
                             "edges_vertices", g->edges, "edges_assignment", g->assignment);
    char *text = root ? kg_json_text(root) : NULL;
    json_decref(root);
    return text;
}

kg_status kg_oa_fold(const kg_oa *oa, const kg_oa_sheet *sheet, char **out_text, kg_error *error) {
    size_t points = ((size_t)sheet->width + 1) * ((size_t)sheet->rows + 1), count;
    kg_oa_line *lines;
    kg_status status = kg_oa_lines(sheet, &lines, &count, error);
    if (status)
        return status;
    grid g = {.sheet = sheet,
              .cell_mm = oa->cell_mm,
              .ends = calloc(points, 1),
              .vertex = malloc(points * sizeof *g.vertex),
              .coordinates = json_array(),
              .edges = json_array(),
              .assignment = json_array()};
    unsigned char *seen = calloc(points, 1);
    char *text = NULL;
    if (g.ends && g.vertex && seen && g.coordinates && g.edges && g.assignment) {
        for (size_t i = 0; i < points; i++)
            g.vertex[i] = -1;
        if (build(&g, lines, count, seen))
            text = text_of(&g, oa->title);
    }
    free(lines);
    free(seen);
    free(g.ends);
    free(g.vertex);
    json_decref(g.coordinates);
    json_decref(g.edges);
    json_decref(g.assignment);
    if (!text)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory, or a title that is not UTF-8");
    *out_text = text;
    return KG_OK;
}
