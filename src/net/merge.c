#include "net/merge.h"

#include <geos_c.h>

#include <stdlib.h>
#include <string.h>

/* A seam this near to a straight line, mm, folds as one: a tenth of what a blade can follow. */
#define STRAIGHT 0.01
/* Seams folded by less than this, radians (1 degree), need no fold line. */
#define FLAT 0.0174533
/* Parts may touch along the seam and by rounding, mm², but not overlap. */
#define OVERLAP 0.01
/* Bytes: a merged part carries both names while they fit on it, then the first alone. */
enum { LONGEST_NAME = 24 };

static kg_net_line *outer(const kg_net *net, int part) {
    return &net->parts[part].loops[0].line;
}

static kg_vec2 side_point(const kg_net *net, const kg_net_side *s, size_t i) {
    const kg_net_line *l = outer(net, s->part);
    return l->points[(s->first + i) % l->count];
}

static bool is_straight(const kg_net *net, const kg_net_side *s) {
    kg_vec2 a = side_point(net, s, 0), b = side_point(net, s, s->count - 1), d = kg_sub2(b, a);
    double length = kg_len2(d);
    for (size_t i = 1; i + 1 < s->count; i++)
        if (fabs(kg_cross2(d, kg_sub2(side_point(net, s, i), a))) > STRAIGHT * length)
            return false;
    return length > STRAIGHT;
}

/* ---- moving one part beside the other ---------------------------------------------------- */

typedef struct motion {
    double c, s;
    kg_vec2 from, to;
} motion;

static kg_vec2 moved(const motion *m, kg_vec2 p) {
    kg_vec2 d = kg_sub2(p, m->from);
    return kg_add2(m->to, kg_v2(m->c * d.x - m->s * d.y, m->s * d.x + m->c * d.y));
}

/* The motion of side 1's part that lays its stretch on side 0's; the middles coincide, so that a
 * rounding difference in length is shared by both ends. */
static motion seam_motion(const kg_net *net, const kg_net_join *j) {
    kg_vec2 a0 = side_point(net, &j->sides[0], 0),
            a1 = side_point(net, &j->sides[0], j->sides[0].count - 1);
    kg_vec2 b0 = side_point(net, &j->sides[1], 0),
            b1 = side_point(net, &j->sides[1], j->sides[1].count - 1);
    kg_vec2 a = kg_sub2(a1, a0), b = kg_sub2(b0, b1);
    double scale = kg_len2(a) * kg_len2(b);
    return (motion){kg_dot2(b, a) / scale, kg_cross2(b, a) / scale, kg_lerp2(b0, b1, 0.5),
                    kg_lerp2(a0, a1, 0.5)};
}

/* ---- may they be one? -------------------------------------------------------------------- */

static GEOSGeometry *polygon_of(GEOSContextHandle_t geos, const kg_net_line *l, const motion *m) {
    GEOSCoordSequence *s = GEOSCoordSeq_create_r(geos, (unsigned)l->count + 1, 2);
    for (size_t i = 0; s && i <= l->count; i++) {
        kg_vec2 p = l->points[i % l->count];
        if (m)
            p = moved(m, p);
        GEOSCoordSeq_setXY_r(geos, s, (unsigned)i, p.x, p.y);
    }
    GEOSGeometry *ring = s ? GEOSGeom_createLinearRing_r(geos, s) : NULL;
    return ring ? GEOSGeom_createPolygon_r(geos, ring, NULL, 0) : NULL;
}

/* Does the smallest rectangle around both parts fit the room, in either direction? */
static bool fits(GEOSContextHandle_t geos, const GEOSGeometry *whole, kg_vec2 room) {
    GEOSGeometry *box = GEOSMinimumRotatedRectangle_r(geos, whole);
    const GEOSGeometry *ring = box ? GEOSGetExteriorRing_r(geos, box) : NULL;
    const GEOSCoordSequence *s = ring ? GEOSGeom_getCoordSeq_r(geos, ring) : NULL;
    kg_vec2 p[3];
    bool ok = s != NULL;
    for (unsigned i = 0; i < 3 && ok; i++)
        ok = GEOSCoordSeq_getXY_r(geos, s, i, &p[i].x, &p[i].y) == 1;
    if (box)
        GEOSGeom_destroy_r(geos, box);
    if (!ok)
        return false;
    double w = kg_dist2(p[0], p[1]), h = kg_dist2(p[1], p[2]);
    return fmin(w, h) <= fmin(room.x, room.y) && fmax(w, h) <= fmax(room.x, room.y);
}

/* KG_MERGE_SAME + 1: it may be done. */
static int refusal(GEOSContextHandle_t geos, const kg_net *net, const kg_net_join *j,
                   kg_vec2 room) {
    const kg_net_side *a = &j->sides[0], *b = &j->sides[1];
    if (a->part == b->part)
        return KG_MERGE_SAME;
    if (a->loop != 0 || b->loop != 0 || !is_straight(net, a) || !is_straight(net, b))
        return KG_MERGE_BENT;
    if (!b->reversed)
        return KG_MERGE_SIDES;
    motion m = seam_motion(net, j);
    GEOSGeometry *x = polygon_of(geos, outer(net, a->part), NULL);
    GEOSGeometry *y = polygon_of(geos, outer(net, b->part), &m);
    GEOSGeometry *common = x && y ? GEOSIntersection_r(geos, x, y) : NULL;
    GEOSGeometry *whole = common ? GEOSUnion_r(geos, x, y) : NULL;
    double area = 0;
    int result = KG_MERGE_SAME + 1;
    if (!whole || !GEOSArea_r(geos, common, &area) || area > OVERLAP)
        result = KG_MERGE_OVERLAPS;
    else if (room.x > 0 && !fits(geos, whole, room))
        result = KG_MERGE_TOO_BIG;
    GEOSGeometry *all[4] = {x, y, common, whole};
    for (int i = 0; i < 4; i++)
        if (all[i])
            GEOSGeom_destroy_r(geos, all[i]);
    return result;
}

/* ---- making one of two ------------------------------------------------------------------- */

/* The joint contour: side 0's part from the end of the seam round to its start, then side 1's. */
static kg_status join_contours(const kg_net *net, const kg_net_join *j, const motion *m,
                               kg_net_line *out) {
    const kg_net_side *a = &j->sides[0], *b = &j->sides[1];
    const kg_net_line *la = outer(net, a->part), *lb = outer(net, b->part);
    size_t keep_a = la->count - a->count + 2, keep_b = lb->count - b->count;
    kg_net_line line = *la;
    line.count = keep_a + keep_b;
    line.points = malloc(line.count * sizeof *line.points);
    line.corners = malloc(line.count);
    if (!line.points || !line.corners) {
        free(line.points);
        free(line.corners);
        return KG_ERR_MEMORY;
    }
    size_t end_a = a->first + a->count - 1, end_b = b->first + b->count - 1;
    for (size_t i = 0; i < keep_a; i++) {
        line.points[i] = la->points[(end_a + i) % la->count];
        line.corners[i] = la->corners[(end_a + i) % la->count];
    }
    for (size_t i = 0; i < keep_b; i++) {
        line.points[keep_a + i] = moved(m, lb->points[(end_b + 1 + i) % lb->count]);
        line.corners[keep_a + i] = lb->corners[(end_b + 1 + i) % lb->count];
    }
    line.corners[0] = line.corners[keep_a - 1] = 1;
    *out = line;
    return KG_OK;
}

static void move_line(kg_net_line *l, const motion *m) {
    for (size_t i = 0; i < l->count; i++)
        l->points[i] = moved(m, l->points[i]);
}

/* The seam as a line across the new part; false when memory runs out. */
static bool fold_line(const kg_net *net, const kg_net_join *j, kg_net_line *out) {
    kg_net_line line = {.kind = j->fold[0] < 0 ? KG_NET_MOUNTAIN : KG_NET_VALLEY,
                        .count = 2,
                        .points = malloc(2 * sizeof *line.points),
                        .corners = malloc(2),
                        .join = -1};
    if (!line.points || !line.corners) {
        free(line.points);
        free(line.corners);
        return false;
    }
    line.points[0] = side_point(net, &j->sides[0], 0);
    line.points[1] = side_point(net, &j->sides[0], j->sides[0].count - 1);
    line.corners[0] = line.corners[1] = 1;
    *out = line;
    return true;
}

static void *grown(void *items, size_t count, size_t size) {
    return realloc(items, (count ? count : 1) * size);
}

/* Joins' sides follow their parts: `shift` tells where points of the two contours went. */
static void follow(kg_net *net, const kg_net_join *seam, size_t loops_a, size_t lines_a) {
    int a = seam->sides[0].part, b = seam->sides[1].part;
    size_t na = outer(net, a)->count, nb = outer(net, b)->count;
    size_t end_a = seam->sides[0].first + seam->sides[0].count - 1;
    size_t end_b = seam->sides[1].first + seam->sides[1].count - 1;
    size_t keep_a = na - seam->sides[0].count + 2;
    for (size_t k = 0; k < 2 * net->join_count; k++) {
        kg_net_side *s = &net->joins[k / 2].sides[k % 2];
        if (s->part == a && s->loop == 0) {
            s->first = (s->first + na - end_a % na) % na;
        } else if (s->part == b) {
            if (s->loop == 0)
                s->first = keep_a - 1 + (s->first + nb - end_b % nb) % nb;
            else if (s->loop > 0)
                s->loop += (int)loops_a - 1;
            else
                s->line += (int)lines_a;
            s->part = a;
        }
        if (s->part > b)
            s->part--;
    }
}

static void remove_join(kg_net *net, size_t index, double **bends) {
    if (bends) {
        free(bends[2 * index]);
        free(bends[2 * index + 1]);
        memmove(bends + 2 * index, bends + 2 * index + 2,
                2 * (net->join_count - index - 1) * sizeof *bends);
        bends[2 * net->join_count - 1] = bends[2 * net->join_count - 2] = NULL;
    }
    memmove(net->joins + index, net->joins + index + 1,
            (net->join_count - index - 1) * sizeof *net->joins);
    net->join_count--;
    for (size_t p = 0; p < net->part_count; p++)
        for (size_t i = 0; i < net->parts[p].line_count; i++) {
            kg_net_line *l = &net->parts[p].lines[i];
            if (l->join == (int)index)
                l->join = -1;
            else if (l->join > (int)index)
                l->join--;
        }
}

static kg_status merge_seam(kg_net *net, size_t index, double **bends) {
    const kg_net_join seam = net->joins[index];
    kg_net_part *a = &net->parts[seam.sides[0].part], *b = &net->parts[seam.sides[1].part];
    motion m = seam_motion(net, &seam);
    bool folds = fabs(seam.fold[0]) > FLAT;
    size_t loops = a->loop_count + b->loop_count - 1, lines = a->line_count + b->line_count + folds;
    char *name = malloc(strlen(a->name) + strlen(b->name) + 4);
    kg_net_line contour, fold;
    if (!name || (folds && !fold_line(net, &seam, &fold))) {
        free(name);
        return KG_ERR_MEMORY;
    }
    void *more_loops = grown(a->loops, loops, sizeof *a->loops);
    if (more_loops)
        a->loops = more_loops;
    void *more_lines = grown(a->lines, lines, sizeof *a->lines);
    if (more_lines)
        a->lines = more_lines;
    if (!more_loops || !more_lines || join_contours(net, &seam, &m, &contour)) {
        free(name);
        if (folds) {
            free(fold.points);
            free(fold.corners);
        }
        return KG_ERR_MEMORY;
    }
    /* nothing can fail from here on */
    follow(net, &seam, a->loop_count, a->line_count);
    strcpy(name, a->name);
    if (b->name[0] && strlen(a->name) + strlen(b->name) <= LONGEST_NAME) {
        strcat(name, a->name[0] ? " + " : "");
        strcat(name, b->name);
    }
    free(a->name);
    free(b->name);
    a->name = name;
    free(a->loops[0].line.points);
    free(a->loops[0].line.corners);
    free(b->loops[0].line.points);
    free(b->loops[0].line.corners);
    a->loops[0].line = contour;
    for (size_t i = 1; i < b->loop_count; i++) {
        move_line(&b->loops[i].line, &m);
        a->loops[a->loop_count++] = b->loops[i];
    }
    for (size_t i = 0; i < b->line_count; i++) {
        move_line(&b->lines[i], &m);
        a->lines[a->line_count++] = b->lines[i];
    }
    if (folds)
        a->lines[a->line_count++] = fold;
    a->area += b->area;
    a->surface += b->surface;
    a->perimeter += b->perimeter - seam.sides[0].length - seam.sides[1].length;
    a->isometry_error = fmax(a->isometry_error, b->isometry_error);
    free(b->loops);
    free(b->lines);
    size_t after = (size_t)(net->parts + net->part_count - (b + 1));
    memmove(b, b + 1, after * sizeof *b);
    net->part_count--;
    remove_join(net, index, bends);
    for (size_t i = 0; i < net->part_count; i++)
        net->parts[i].number = (int)i + 1;
    return KG_OK;
}

/* ---- which ------------------------------------------------------------------------------- */

static kg_status add_remark(kg_merge_report *report, const kg_net_join *j, kg_merge_refusal why) {
    kg_merge_remark *more =
        grown(report->remarks, report->remark_count + 1, sizeof *report->remarks);
    if (!more)
        return KG_ERR_MEMORY;
    report->remarks = more;
    more[report->remark_count++] =
        (kg_merge_remark){j->number, {j->sources[0], j->sources[1]}, why};
    return KG_OK;
}

kg_status kg_net_merge(kg_net *net, const kg_merge_options *options, kg_merge_report *out_report,
                       kg_error *error) {
    kg_merge_report report = {0};
    size_t count = net->join_count;
    /* 0: not to be tried, 1: by the way, 2: the user's wish; moved along with the joins */
    unsigned char *wish = calloc(count + 1, 1);
    GEOSContextHandle_t geos = GEOS_init_r();
    kg_status status = wish && geos ? KG_OK : KG_ERR_MEMORY;
    for (size_t i = 0; i < count && !status; i++)
        if (net->joins[i].kind == KG_JOIN_SEAM)
            wish[i] = options->wanted && options->wanted[i] ? 2 : options->all;
    while (!status) {
        size_t best = net->join_count;
        for (size_t i = 0; i < net->join_count; i++) {
            if (wish[i] == 0)
                continue;
            bool better = best == net->join_count || wish[i] > wish[best] ||
                          (wish[i] == wish[best] &&
                           net->joins[i].sides[0].length > net->joins[best].sides[0].length);
            if (better)
                best = i;
        }
        if (best == net->join_count)
            break;
        int why = refusal(geos, net, &net->joins[best], options->room);
        bool asked = wish[best] == 2;
        wish[best] = 0;
        if (why > KG_MERGE_SAME) {
            memmove(wish + best, wish + best + 1, net->join_count - best);
            status = merge_seam(net, best, options->bends);
            report.merged++;
        } else if (asked) {
            status = add_remark(&report, &net->joins[best], (kg_merge_refusal)why);
        }
    }
    free(wish);
    if (geos)
        GEOS_finish_r(geos);
    if (status) {
        free(report.remarks);
        return kg_fail(error, status, "out of memory");
    }
    *out_report = report;
    return KG_OK;
}
