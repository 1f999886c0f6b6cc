/* Lawson's flips towards triangles that follow the rulings. */
#include "trim/triangulation.h"

#include <stdlib.h>

#define NO_MATE UINT32_MAX

/* Side 3 t + k of triangle t runs from its corner k to the next; mate: the same side seen from the
 * neighbour. */
typedef struct mesh {
    const kg_polygon *polygon;
    uint32_t *corners, *mates;
    size_t triangle_count;
} mesh;

static uint32_t next_side(uint32_t s) {
    return s % 3 == 2 ? s - 2 : s + 1;
}

static uint32_t low_point(const mesh *m, uint32_t s) {
    uint32_t a = m->corners[s], b = m->corners[next_side(s)];
    return a < b ? a : b;
}

/* Sides go into buckets by their lower point, each a few, where their mates find them. */
static bool find_mates(mesh *m, size_t point_count) {
    size_t sides = 3 * m->triangle_count;
    uint32_t *begin = calloc(point_count + 1, sizeof *begin);
    uint32_t *filled = calloc(point_count + 1, sizeof *filled);
    uint32_t *bucket = calloc(sides + 1, sizeof *bucket);
    bool ok = begin && filled && bucket;
    for (uint32_t s = 0; ok && s < sides; s++)
        begin[low_point(m, s) + 1]++;
    for (size_t i = 1; ok && i <= point_count; i++)
        begin[i] += begin[i - 1];
    for (uint32_t s = 0; ok && s < sides; s++) {
        uint32_t low = low_point(m, s);
        m->mates[s] = NO_MATE;
        for (uint32_t k = 0; k < filled[low]; k++) {
            uint32_t t = bucket[begin[low] + k];
            if (m->corners[t] != m->corners[next_side(s)] ||
                m->corners[next_side(t)] != m->corners[s] || m->mates[t] != NO_MATE)
                continue;
            m->mates[s] = t;
            m->mates[t] = s;
            break;
        }
        bucket[begin[low] + filled[low]++] = s;
    }
    free(begin);
    free(filled);
    free(bucket);
    return ok;
}

/* Is the edge between triangles (a, b, c) and (b, a, d) above the hull, and may it be flipped to
 * (c, d)? */
static bool wants_flip(const kg_polygon *p, uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
    kg_vec2 ad = kg_sub2(p->paper[a], p->paper[d]), bd = kg_sub2(p->paper[b], p->paper[d]),
            cd = kg_sub2(p->paper[c], p->paper[d]);
    double x = kg_cross2(bd, cd), y = kg_cross2(cd, ad), z = kg_cross2(ad, bd);
    /* convex: c and d see each other across the edge */
    if (!(x > 0 && y > 0))
        return false;
    double ha = p->points[a].y - p->points[d].y, hb = p->points[b].y - p->points[d].y,
           hc = p->points[c].y - p->points[d].y;
    double lift = ha * ha * x + hb * hb * y + hc * hc * z;
    double size = ha * ha * x + hb * hb * y + hc * hc * fabs(z);
    /* ties stay: flips must come to an end */
    return lift > 1e-12 * size;
}

/* Turns the edge of side s to join the two corners opposite to it. */
static void flip(mesh *m, uint32_t s) {
    uint32_t t = m->mates[s], s1 = next_side(s), s2 = next_side(s1), t1 = next_side(t),
             t2 = next_side(t1);
    uint32_t c = m->corners[s2], d = m->corners[t2], outer_s = m->mates[s1], outer_t = m->mates[t1];
    /* (a, b, c), (b, a, d) become (a, d, c), (b, c, d): sides s and t keep their starts */
    m->corners[s1] = d;
    m->corners[t1] = c;
    m->mates[s] = outer_t;
    m->mates[t] = outer_s;
    if (outer_t != NO_MATE)
        m->mates[outer_t] = s;
    if (outer_s != NO_MATE)
        m->mates[outer_s] = t;
    m->mates[s1] = t1;
    m->mates[t1] = s1;
}

static bool flip_if_wanted(mesh *m, uint32_t s) {
    uint32_t t = m->mates[s];
    if (t == NO_MATE)
        return false;
    if (!wants_flip(m->polygon, m->corners[s], m->corners[t], m->corners[next_side(next_side(s))],
                    m->corners[next_side(next_side(t))]))
        return false;
    flip(m, s);
    return true;
}

kg_status kg_ruling_flips(const kg_polygon *polygon, uint32_t *triangles, size_t triangle_count) {
    size_t sides = 3 * triangle_count;
    mesh m = {polygon, triangles, calloc(sides + 1, sizeof *m.mates), triangle_count};
    if (!m.mates || !find_mates(&m, polygon->count)) {
        free(m.mates);
        return KG_ERR_MEMORY;
    }
    /* every flip lowers the lifted surface; rounding cannot keep it up for ever */
    size_t left = 20 * sides + 100;
    for (bool again = true; again && left > 0;) {
        again = false;
        for (uint32_t s = 0; s < sides && left > 0; s++)
            if (m.mates[s] > s && flip_if_wanted(&m, s)) {
                again = true;
                left--;
            }
    }
    free(m.mates);
    return KG_OK;
}
