#include "samples/dolphin_mesh.h"

#include "samples/dolphin_shape.h"

enum { AROUND = 32 };

/* One closed component: `rings` rings of AROUND points, pole points before and behind them.
 * `mirrored` turns y and the faces around. */
typedef struct loft {
    text *out;
    int first; /* OBJ number of the front pole */
    int rings;
    bool mirrored;
} loft;

static void add_point(loft *l, kg_vec3 p) {
    text_add(l->out, "v ");
    text_number(l->out, p.x, 4);
    text_add(l->out, " ");
    text_number(l->out, l->mirrored ? -p.y : p.y, 4);
    text_add(l->out, " ");
    text_number(l->out, p.z, 4);
    text_add(l->out, "\n");
}

static void add_face(loft *l, int a, int b, int c, int d) {
    if (l->mirrored) {
        int swap = a;
        a = c, c = swap;
    }
    text_add(l->out, "f %d %d %d", a, b, c);
    if (d)
        text_add(l->out, " %d", d);
    text_add(l->out, "\n");
}

static int ring_point(const loft *l, int ring, int i) {
    return l->first + 1 + ring * AROUND + i % AROUND;
}

/* Faces of a loft whose points are written; returns the number of the next point. */
static int close_loft(loft *l) {
    int last = l->first + 1 + l->rings * AROUND;
    for (int i = 0; i < AROUND; i++)
        add_face(l, l->first, ring_point(l, 0, i), ring_point(l, 0, i + 1), 0);
    for (int r = 0; r + 1 < l->rings; r++)
        for (int i = 0; i < AROUND; i++)
            add_face(l, ring_point(l, r, i + 1), ring_point(l, r, i), ring_point(l, r + 1, i),
                     ring_point(l, r + 1, i + 1));
    for (int i = 0; i < AROUND; i++)
        add_face(l, last, ring_point(l, l->rings - 1, i + 1), ring_point(l, l->rings - 1, i), 0);
    return last + 1;
}

static int add_tube(text *out, int first, const char *name, dolphin_tube tube, int rings) {
    loft l = {.out = out, .first = first, .rings = rings};
    text_add(out, "g %s\n", name);
    dolphin_section s = dolphin_section_at(tube, 0);
    add_point(&l, dolphin_section_point(&s, 0));
    for (int r = 1; r <= rings; r++) {
        /* denser towards the round front end */
        double t = 0.5 * (1 - cos(KG_PI * r / (rings + 1)));
        s = dolphin_section_at(tube, t);
        for (int i = 0; i < AROUND; i++)
            add_point(&l, dolphin_section_point(&s, 2 * KG_PI * i / AROUND));
    }
    s = dolphin_section_at(tube, 1);
    add_point(&l, dolphin_section_point(&s, 0));
    return close_loft(&l);
}

/* A lens: around the chord at every ring, leading edge first, over one side and back. */
static kg_vec3 fin_surface(dolphin_fin fin, double span, int i) {
    double angle = 2 * KG_PI * i / AROUND, thickness;
    kg_vec3 p = dolphin_fin_point(fin, span, 0.5 * (1 - cos(angle)), &thickness);
    return kg_madd(p, (i < AROUND / 2 ? 0.5 : -0.5) * thickness, dolphin_fin_normal(fin, span));
}

static int add_fin(text *out, int first, const char *name, dolphin_fin fin, bool mirrored) {
    enum { RINGS = 18 };
    loft l = {.out = out, .first = first, .rings = RINGS, .mirrored = mirrored};
    text_add(out, "g %s\n", name);
    add_point(&l, dolphin_fin_point(fin, 0, 0.5, NULL));
    for (int r = 0; r < RINGS; r++)
        for (int i = 0; i < AROUND; i++)
            add_point(&l, fin_surface(fin, (double)r / RINGS, i));
    add_point(&l, dolphin_fin_point(fin, 1, 0.5, NULL));
    return close_loft(&l);
}

bool dolphin_mesh_write(text *out) {
    int next = 1;
    next = add_tube(out, next, "trunk", DOLPHIN_TRUNK, 64);
    next = add_tube(out, next, "beak", DOLPHIN_BEAK, 16);
    next = add_fin(out, next, "dorsal_fin", DOLPHIN_DORSAL, false);
    next = add_fin(out, next, "flipper_left", DOLPHIN_FLIPPER, false);
    next = add_fin(out, next, "flipper_right", DOLPHIN_FLIPPER, true);
    next = add_fin(out, next, "fluke_left", DOLPHIN_FLUKE, false);
    add_fin(out, next, "fluke_right", DOLPHIN_FLUKE, true);
    return !out->failed;
}
