/* States: the half-edge model of all sheets. */
#include "origami/state.h"

#include "origami/convex.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

/* A state and how many origamis hold it; these may belong to several threads. */
typedef struct shared_state {
    kg_origami_state state; /* first: the same address */
    atomic_size_t holders;
} shared_state;

kg_origami_state *kg_state_create(void) {
    shared_state *shared = calloc(1, sizeof *shared);
    if (!shared)
        return NULL;
    atomic_init(&shared->holders, 1);
    return &shared->state;
}

kg_origami_state *kg_state_share(kg_origami_state *s) {
    atomic_fetch_add(&((shared_state *)s)->holders, 1);
    return s;
}

void kg_state_destroy(kg_origami_state *s) {
    if (!s || atomic_fetch_sub(&((shared_state *)s)->holders, 1) > 1)
        return;
    free(s->vertices.items);
    free(s->halves.items);
    free(s->edges.items);
    free(s->loops.items);
    free(s->groups.items);
    free(s->layers.bits);
    free(s);
}

static bool copy_items(void **out, const void *items, size_t count, size_t size) {
    if (!(*out = malloc(count * size + 1)))
        return false;
    if (count > 0)
        memcpy(*out, items, count * size);
    return true;
}

#define COPY(array)                                                                                \
    (c->array.capacity = c->array.count,                                                           \
     copy_items((void **)&c->array.items, s->array.items, s->array.count, sizeof *s->array.items))

kg_origami_state *kg_state_copy(const kg_origami_state *s) {
    kg_origami_state *c = kg_state_create();
    if (!c)
        return NULL;
    *c = *s;
    c->vertices.items = NULL, c->halves.items = NULL, c->edges.items = NULL;
    c->loops.items = NULL, c->groups.items = NULL;
    c->layers.bits = NULL, c->layers.words = 0;
    if (COPY(vertices) && COPY(halves) && COPY(edges) && COPY(loops) && COPY(groups))
        return c;
    kg_state_destroy(c);
    return NULL;
}

/* ---- questions -------------------------------------------------------------------------- */

kg_vec3 kg_origami_normal(const kg_origami_state *s, int32_t loop) {
    int32_t first = s->loops.items[loop].first, h = kg_next(s, first);
    const kg_vec3 *o = kg_origin(s, first);
    kg_vec3 sum = kg_v3(0, 0, 0);
    for (; kg_next(s, h) != first; h = kg_next(s, h))
        sum = kg_add(
            sum, kg_cross(kg_sub(*kg_origin(s, h), *o), kg_sub(*kg_origin(s, kg_next(s, h)), *o)));
    return kg_unit(sum);
}

size_t kg_state_polygon(const kg_origami_state *s, int32_t loop, const kg_vec3 *u, const kg_vec3 *v,
                        kg_vec2 *out) {
    int32_t first = s->loops.items[loop].first, h = first;
    size_t n = 0;
    do {
        const kg_paper_vertex *p = &s->vertices.items[s->halves.items[h].origin];
        if (out)
            out[n] = u ? kg_v2(kg_dot(*u, p->position), kg_dot(*v, p->position)) : p->paper;
        n++;
        h = kg_next(s, h);
    } while (h != first);
    return n;
}

void kg_state_measure(kg_origami_state *s) {
    kg_box2 box = kg_box2_empty();
    for (size_t i = 0; i < s->vertices.count; i++)
        kg_box2_add(&box, s->vertices.items[i].paper);
    s->size = s->vertices.count ? fmax(box.hi.x - box.lo.x, box.hi.y - box.lo.y) : 0;
    s->touch = KG_OVERLAP * s->size;
}

/* ---- changes ---------------------------------------------------------------------------- */

kg_status kg_state_split_edge(kg_origami_state *s, int32_t half, double t, int32_t *out_vertex) {
    if (!kg_reserve(&s->vertices, s->vertices.count + 1) ||
        !kg_reserve(&s->halves, s->halves.count + 2) || !kg_reserve(&s->edges, s->edges.count + 1))
        return KG_ERR_MEMORY;
    kg_half_edge *halves = s->halves.items;
    int32_t twin = kg_twin(half), ahead = (int32_t)s->halves.count, back = ahead + 1,
            vertex = (int32_t)s->vertices.count;
    const kg_paper_vertex *a = &s->vertices.items[halves[half].origin],
                          *b = &s->vertices.items[halves[twin].origin];
    s->vertices.items[s->vertices.count++] = (kg_paper_vertex){
        kg_lerp2(a->paper, b->paper, t), kg_lerp(a->position, b->position, t), a->sheet};
    s->edges.items[s->edges.count++] = s->edges.items[half >> 1];
    s->halves.count += 2;
    /* half: a → new, ahead: new → b; back: b → new, twin: new → a */
    halves[ahead] = (kg_half_edge){vertex, halves[half].next, halves[half].loop};
    halves[half].next = ahead;
    halves[back] = halves[twin];
    halves[twin].origin = vertex;
    halves[back].next = twin;
    if (halves[twin].loop >= 0) {
        int32_t h = halves[twin].next;
        while (halves[h].next != twin)
            h = halves[h].next;
        halves[h].next = back;
        if (s->loops.items[halves[twin].loop].first == twin)
            s->loops.items[halves[twin].loop].first = back;
    }
    *out_vertex = vertex;
    return KG_OK;
}

kg_status kg_state_split_loop(kg_origami_state *s, int32_t h, int32_t k) {
    if (!kg_reserve(&s->halves, s->halves.count + 2) ||
        !kg_reserve(&s->edges, s->edges.count + 1) || !kg_reserve(&s->loops, s->loops.count + 1))
        return KG_ERR_MEMORY;
    kg_half_edge *halves = s->halves.items;
    int32_t loop = halves[h].loop, created = (int32_t)s->loops.count,
            closing = (int32_t)s->halves.count; /* from the origin of k to that of h */
    int32_t before_h = h, before_k = h;
    while (halves[before_k].next != k)
        before_k = halves[before_k].next;
    for (before_h = k; halves[before_h].next != h;)
        before_h = halves[before_h].next;
    halves[closing] = (kg_half_edge){halves[k].origin, h, loop};
    halves[closing + 1] = (kg_half_edge){halves[h].origin, k, created};
    halves[before_k].next = closing;
    halves[before_h].next = closing + 1;
    s->halves.count += 2;
    s->edges.items[s->edges.count++] = (kg_paper_edge){KG_PAPER_CREASE, 0};
    kg_paper_loop l = s->loops.items[loop];
    l.first = k;
    l.parent = loop;
    s->loops.items[s->loops.count++] = l;
    s->loops.items[loop].first = h;
    for (int32_t i = k;;) {
        halves[i].loop = created;
        if ((i = halves[i].next) == k)
            return KG_OK;
    }
}
