#include "app/modes/sheet_scene.h"

#include "app/scenery.h"
#include "base/array.h"

#include <stdlib.h>

/* Over the size of the sheets: how far lines lie off their layer, on both sides; less than half of
 * the least distance of layers, so that the next one hides them. */
#define LINE_OFFSET 0.0009

/* Of the distance between two layers: how far their common edge bulges. */
#define BULGE 0.15

/* How far shadows lie below their layer, over the size of the sheets, and how dark each is. */
#define SHADOW_DEPTH 0.0012
#define SHADOW 0.08F

/* Edges of more complex states throw none: telling which lie on one another would take too long. */
enum { MOST_SHADOWS = 1000 };

static const kg_color ink = {0.1F, 0.1F, 0.12F, 1}, mark = {0.95F, 0.55F, 0.05F, 1},
                      hover = {0.1F, 0.45F, 0.9F, 1};

typedef enum paint { PAINT_PLAIN, PAINT_HOVERED, PAINT_MARKED, PAINT_COUNT } paint;

/* Triangles or lines while they are put together. */
typedef struct mesh {
    struct {
        kg_vec3 *items;
        size_t count, capacity;
    } points;
    struct {
        uint32_t *items;
        size_t count, capacity;
    } indices; /* of triangles, or where lines start */
    bool failed;
} mesh;

static void mesh_clear(mesh *m) {
    free(m->points.items);
    free(m->indices.items);
    *m = (mesh){0};
}

static void add_corner(mesh *m, kg_vec3 p) {
    m->failed =
        m->failed || !kg_push(&m->indices, (uint32_t)m->points.count) || !kg_push(&m->points, p);
}

static void add_triangle(mesh *m, kg_vec3 a, kg_vec3 b, kg_vec3 c) {
    add_corner(m, a);
    add_corner(m, b);
    add_corner(m, c);
}

static void add_line(mesh *m, kg_vec3 a, kg_vec3 b) {
    m->failed = m->failed || !kg_push(&m->indices, (uint32_t)m->points.count) ||
                !kg_push(&m->points, a) || !kg_push(&m->points, b);
}

/* Takes the mesh over. What cannot be shown for want of memory is left out. */
static void show_surface(mesh *m, kg_overlay *o, kg_style style) {
    kg_surface s = {.vertex_count = m->points.count,
                    .positions = m->points.items,
                    .triangle_count = m->points.count / 3,
                    .triangles = m->indices.items};
    if (!m->failed)
        kg_overlay_surface(o, &s, style);
    mesh_clear(m);
}

static void show_lines(mesh *m, kg_overlay *o, kg_style style) {
    if (!m->failed && m->points.count > 0 && kg_push(&m->indices, (uint32_t)m->points.count)) {
        kg_lines lines = {m->points.items, m->indices.items, m->indices.count - 1};
        kg_overlay_lines(o, &lines, style);
    }
    mesh_clear(m);
}

/* ---- paper ------------------------------------------------------------------------------- */

static int32_t next_half(const kg_sheets *s, int32_t half) {
    return s->state->halves.items[half].next;
}

/* Where two layers of a folded edge are drawn apart: corners of the strip that joins them. */
static bool bend_of(const kg_sheets *s, int32_t half, kg_vec3 out[4]) {
    int32_t twin = half ^ 1;
    if (s->state->halves.items[twin].loop < 0 || half > twin)
        return false;
    out[0] = s->drawn[next_half(s, half)];
    out[1] = s->drawn[half];
    out[2] = s->drawn[next_half(s, twin)];
    out[3] = s->drawn[twin];
    return kg_dist(out[1], out[2]) + kg_dist(out[0], out[3]) > 1e-6 * s->state->size;
}

/* The strip bulges, so that one around another lies outside of it. Its front is where the paper's
 * is. */
static void add_bend(mesh *m, const kg_sheets *s, int32_t half) {
    kg_vec3 p[4];
    if (s->spread > 0 || !bend_of(s, half, p))
        return;
    int32_t loop = s->state->halves.items[half].loop;
    kg_vec3 out = kg_unit(kg_cross(kg_sub(p[0], p[1]), s->normals[loop]));
    kg_vec3 a = kg_madd(kg_lerp(p[1], p[2], 0.5), BULGE * kg_dist(p[1], p[2]), out);
    kg_vec3 b = kg_madd(kg_lerp(p[0], p[3], 0.5), BULGE * kg_dist(p[0], p[3]), out);
    add_triangle(m, p[0], p[1], a);
    add_triangle(m, p[0], a, b);
    add_triangle(m, b, a, p[2]);
    add_triangle(m, b, p[2], p[3]);
}

static void add_loop(mesh *m, const kg_sheets *s, int32_t loop) {
    int32_t first = s->state->loops.items[loop].first, h = next_half(s, first);
    add_bend(m, s, first);
    for (int32_t next; (next = next_half(s, h)) != first; h = next) {
        add_triangle(m, s->drawn[first], s->drawn[h], s->drawn[next]);
        add_bend(m, s, h);
    }
    add_bend(m, s, h);
}

static paint paint_of(const kg_sheets *s, int32_t loop) {
    return kg_sheets_is_marked(&s->loops, loop) ? PAINT_MARKED
           : loop == s->hover_loop              ? PAINT_HOVERED
                                                : PAINT_PLAIN;
}

static int32_t sheet_count(const kg_sheets *s) {
    int32_t count = 0;
    for (size_t i = 0; i < s->state->loops.count; i++)
        if (s->state->loops.items[i].sheet >= count)
            count = s->state->loops.items[i].sheet + 1;
    return count;
}

static void show_paper(const kg_sheets *s, int32_t sheet, paint wanted, kg_overlay *o) {
    mesh m = {0};
    uint32_t front, back;
    for (int32_t i = 0; (size_t)i < s->state->loops.count; i++)
        if (s->state->loops.items[i].sheet == sheet && paint_of(s, i) == wanted)
            add_loop(&m, s, i);
    kg_origami_colors(s->origami, sheet, &front, &back);
    kg_style style = kg_style_default(kg_color_from_rgb(front));
    style.color.a = (float)s->opacity;
    style.back = kg_color_from_rgb(back);
    style.even = true;
    if (wanted == PAINT_HOVERED)
        style.highlight = (kg_color){hover.r, hover.g, hover.b, 0.2F};
    if (wanted == PAINT_MARKED)
        style.highlight = (kg_color){mark.r, mark.g, mark.b, 0.55F};
    show_surface(&m, o, style);
}

/* ---- edges ------------------------------------------------------------------------------- */

typedef enum line_kind { LINE_NONE, LINE_FLAT, LINE_STRONG } line_kind;

/* Borders and what is bent are strong, creases that lie flat are thin. */
static line_kind kind_of(const kg_sheets *s, size_t edge) {
    const kg_paper_edge *e = &s->state->edges.items[edge];
    const kg_half_edge *h = &s->state->halves.items[2 * edge];
    if (h[0].loop < 0 && h[1].loop < 0)
        return LINE_NONE;
    if (e->kind == KG_PAPER_JOIN)
        return LINE_NONE;
    if (e->kind == KG_PAPER_BORDER)
        return LINE_STRONG;
    double bent = kg_dot(s->normals[h[0].loop], s->normals[h[1].loop]);
    return bent < 1 - 1e-9 ? LINE_STRONG : LINE_FLAT;
}

/* An edge in each of its layers, on both sides of it. */
static void add_edge(mesh *m, const kg_sheets *s, size_t edge) {
    for (int32_t half = (int32_t)(2 * edge); half <= (int32_t)(2 * edge + 1); half++) {
        int32_t loop = s->state->halves.items[half].loop;
        if (loop < 0)
            continue;
        kg_vec3 a = s->drawn[half], b = s->drawn[next_half(s, half)];
        for (int side = -1; side <= 1; side += 2) {
            double by = side * LINE_OFFSET * s->state->size;
            add_line(m, kg_madd(a, by, s->normals[loop]), kg_madd(b, by, s->normals[loop]));
        }
    }
}

static void show_edges(const kg_sheets *s, line_kind wanted, kg_overlay *o, kg_style style) {
    mesh m = {0};
    for (size_t i = 0; i < s->state->edges.count; i++)
        if (kind_of(s, i) == wanted)
            add_edge(&m, s, i);
    show_lines(&m, o, style);
}

/* Between layers drawn far apart: what belongs together, without hiding what lies between. */
static void show_threads(const kg_sheets *s, kg_overlay *o) {
    mesh m = {0};
    kg_vec3 p[4];
    for (size_t h = 0; s->spread > 0 && h < s->state->halves.count; h++)
        if (s->state->halves.items[h].loop >= 0 && bend_of(s, (int32_t)h, p)) {
            add_line(&m, p[1], p[2]);
            add_line(&m, p[0], p[3]);
        }
    kg_style style = kg_line_style((kg_color){0.5F, 0.5F, 0.55F, 1}, 1);
    style.exact = true;
    show_lines(&m, o, style);
}

static void show_all_edges(const kg_sheets *s, kg_overlay *o) {
    kg_style strong = kg_line_style(ink, 1.4F), flat = kg_line_style(ink, 1);
    strong.exact = flat.exact = s->opacity >= 1;
    flat.color = (kg_color){0.35F, 0.35F, 0.37F, 1};
    if (s->opacity < 1) /* over the paper, which hides none of them */
        strong.color.a = flat.color.a = 0.7F;
    show_edges(s, LINE_FLAT, o, flat);
    show_edges(s, LINE_STRONG, o, strong);
    show_threads(s, o);
}

/* ---- shadows ----------------------------------------------------------------------------- */

static kg_vec3 to_eye(const kg_camera *camera, kg_vec3 from) {
    kg_vec3 right, up, back;
    kg_camera_axes(camera, &right, &up, &back);
    return camera->ortho ? back : kg_sub(kg_madd(camera->center, camera->distance, back), from);
}

/* Whether the eye is on the front of a loop. */
static bool faces_eye(const kg_sheets *s, const kg_camera *camera, int32_t loop) {
    kg_vec3 at = s->drawn[s->state->loops.items[loop].first];
    return kg_dot(s->normals[loop], to_eye(camera, at)) > 0;
}

/* Whether two half-edges lie on one another, and the second is nearer to the eye. */
static bool is_covered(const kg_sheets *s, const kg_camera *camera, int32_t half, int32_t by) {
    const kg_half_edge *h = s->state->halves.items;
    kg_vec3 a = s->positions[h[half].origin], b = s->positions[h[half ^ 1].origin];
    kg_vec3 c = s->positions[h[by].origin], d = s->positions[h[by ^ 1].origin];
    double apart = fmin(kg_dist(a, c) + kg_dist(b, d), kg_dist(a, d) + kg_dist(b, c));
    if (apart > 1e-6 * s->state->size)
        return false;
    kg_vec3 between = kg_sub(kg_lerp(s->drawn[by], s->drawn[h[by].next], 0.5),
                             kg_lerp(s->drawn[half], s->drawn[h[half].next], 0.5));
    double nearer = kg_dot(between, kg_unit(to_eye(camera, a)));
    return nearer > 1e-6 * s->state->size || (nearer > -1e-6 * s->state->size && by < half);
}

/* Half-edges that throw a shadow; of those in one place only the one nearest to the eye, or the
 * shadow of many would be black. */
static void find_shadows(const kg_sheets *s, const kg_camera *camera, kg_sheet_marks *out) {
    kg_sheet_marks all = {0};
    for (int32_t h = 0; (size_t)h < s->state->halves.count; h++)
        if (s->state->halves.items[h].loop >= 0 && kind_of(s, (size_t)h / 2) == LINE_STRONG &&
            !kg_push(&all, h))
            break; /* fewer shadows */
    for (size_t i = 0; i < all.count && all.count <= MOST_SHADOWS; i++) {
        bool covered = false;
        for (size_t k = 0; k < all.count && !covered; k++)
            covered = k != i && is_covered(s, camera, all.items[i], all.items[k]);
        if (!covered && !kg_push(out, all.items[i]))
            break;
    }
    free(all.items);
}

/* Bands in the plane of a layer, along its edges and around the corners between them. Lines, as
 * wide wherever they are seen from, would show through the layers above where these are seen at a
 * slant. */
static void add_shadow(mesh *m, const kg_sheets *s, int32_t half, bool goes_on, double by,
                       double width) {
    int32_t next = next_half(s, half);
    kg_vec3 n = s->normals[s->state->halves.items[half].loop], p[3], out[2];
    for (int k = 0; k < 3; k++)
        p[k] = kg_madd(s->drawn[k == 0 ? half : k == 1 ? next : next_half(s, next)], by, n);
    for (int k = 0; k < 2; k++)
        out[k] = kg_scale(kg_unit(kg_cross(kg_sub(p[k + 1], p[k]), n)), width);
    add_triangle(m, p[0], kg_add(p[0], out[0]), kg_add(p[1], out[0]));
    add_triangle(m, p[0], kg_add(p[1], out[0]), p[1]);
    if (goes_on)
        add_triangle(m, p[1], kg_add(p[1], out[0]), kg_add(p[1], out[1]));
}

/* Soft bands beside the edges of layers: shadows on the paper below. */
static void show_shadows(const kg_sheets *s, const kg_camera *camera, kg_overlay *o) {
    static const double widths[] = {0.004, 0.007, 0.011}; /* over the size of the sheets */
    kg_sheet_marks edges = {0};
    find_shadows(s, camera, &edges);
    for (size_t i = 0; i < sizeof widths / sizeof *widths; i++) {
        mesh m = {0};
        for (size_t k = 0; k < edges.count; k++) {
            int32_t h = edges.items[k], loop = s->state->halves.items[h].loop;
            double by = SHADOW_DEPTH * s->state->size * (faces_eye(s, camera, loop) ? -1 : 1);
            add_shadow(&m, s, h, kg_sheets_is_marked(&edges, next_half(s, h)), by,
                       widths[i] * s->state->size);
        }
        kg_style style = kg_style_default((kg_color){0, 0, 0, SHADOW});
        style.back = style.color;
        style.unlit = style.exact = true;
        show_surface(&m, o, style);
    }
    free(edges.items);
}

/* ---- marks ------------------------------------------------------------------------------- */

static void show_edge(const kg_sheets *s, int32_t edge, kg_overlay *o, kg_color color) {
    mesh m = {0};
    if (edge < 0 || (size_t)edge >= s->state->edges.count)
        return;
    add_edge(&m, s, (size_t)edge);
    kg_style style = kg_line_style(color, 4);
    style.hidden = 0.4F;
    show_lines(&m, o, style);
}

static void show_vertex(const kg_sheets *s, int32_t vertex, kg_overlay *o, kg_color color) {
    kg_style rim = kg_style_default(ink), dot = kg_style_default(color);
    rim.size_px = 12;
    dot.size_px = 9;
    rim.hidden = dot.hidden = 0.4F;
    for (size_t h = 0; h < s->state->halves.count; h++)
        if (s->state->halves.items[h].origin == vertex && s->state->halves.items[h].loop >= 0) {
            kg_overlay_points(o, &s->drawn[h], 1, rim);
            kg_overlay_points(o, &s->drawn[h], 1, dot);
        }
}

static void show_marks(const kg_sheets *s, kg_overlay *o) {
    show_edge(s, s->hover_edge, o, hover);
    for (size_t i = 0; i < s->edges.count; i++)
        show_edge(s, s->edges.items[i], o, mark);
    show_vertex(s, s->hover_vertex, o, hover);
    for (size_t i = 0; i < s->vertices.count; i++)
        show_vertex(s, s->vertices.items[i], o, mark);
}

/* ---- the picture ------------------------------------------------------------------------- */

void kg_sheet_scene_plain(const kg_sheets *s, kg_overlay *o) {
    int32_t sheets = s->state ? sheet_count(s) : 0;
    for (int32_t i = 0; i < sheets; i++)
        for (int p = 0; p < PAINT_COUNT; p++)
            show_paper(s, i, (paint)p, o);
    if (s->state)
        show_all_edges(s, o);
}

/* What stays on the graphics card until something else is shown. */
typedef struct stage {
    kg_overlay picture;
    uint64_t shown; /* signature */
} stage;

static uint64_t mix(uint64_t hash, uint64_t value) {
    return (hash ^ value) * 1099511628211u; /* FNV-1a, a word at a time */
}

static uint64_t mix_marks(uint64_t hash, const kg_sheet_marks *marks) {
    for (size_t i = 0; i < marks->count; i++)
        hash = mix(hash, (uint64_t)marks->items[i]);
    return mix(hash, marks->count);
}

/* Differs for pictures that differ. */
static uint64_t signature(const kg_editor *e, const kg_sheets *s) {
    uint64_t hash = mix(mix(14695981039346656037u, s->revision), e->solved);
    hash = mix_marks(mix_marks(mix_marks(hash, &s->loops), &s->edges), &s->vertices);
    hash = mix(mix(mix(hash, (uint64_t)s->hover_loop), (uint64_t)s->hover_edge),
               (uint64_t)s->hover_vertex);
    for (int32_t i = 0; s->state && (size_t)i < s->state->loops.count; i++)
        hash = mix(hash, faces_eye(s, &e->pane.camera, i));
    return mix(hash, (uint64_t)(1000 * s->opacity));
}

kg_status kg_sheet_scene_compose(void **cache, const kg_editor *e, kg_overlay *o, kg_error *error) {
    const kg_sheets *s = kg_sheets_of(e);
    if (!*cache && !(*cache = calloc(1, sizeof(stage))))
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    stage *st = *cache;
    if (st->shown != signature(e, s)) {
        kg_overlay_clear(&st->picture);
        kg_sheet_scene_plain(s, &st->picture);
        if (s->state && s->opacity >= 1 && s->spread <= 0)
            show_shadows(s, &e->pane.camera, &st->picture);
        if (s->state)
            show_marks(s, &st->picture);
        st->shown = signature(e, s);
    }
    for (size_t i = 0; i < st->picture.items.count; i++)
        kg_overlay_item(o, st->picture.items.items[i].shape, st->picture.items.items[i].style);
    return KG_OK;
}

void kg_sheet_scene_drop(void *cache) {
    stage *st = cache;
    kg_overlay_clear(&st->picture);
    free(st);
}
