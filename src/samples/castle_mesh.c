#include "samples/castle_mesh.h"

enum { AROUND = 24 }; /* sides of what is round */

typedef struct builder {
    text *out;
    int next; /* number of the next vertex, from 1 */
} builder;

static void add_point(builder *b, double x, double y, double z) {
    text_add(b->out, "v ");
    text_number(b->out, x, 3);
    text_add(b->out, " ");
    text_number(b->out, y, 3);
    text_add(b->out, " ");
    text_number(b->out, z, 3);
    text_add(b->out, "\n");
    b->next++;
}

static void add_box(builder *b, kg_vec3 lo, kg_vec3 hi) {
    static const int sides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                    {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    int first = b->next;
    for (int i = 0; i < 8; i++)
        add_point(b, i & 1 ? hi.x : lo.x, i & 2 ? hi.y : lo.y, i & 4 ? hi.z : lo.z);
    for (int f = 0; f < 6; f++)
        text_add(b->out, "f %d %d %d %d\n", first + sides[f][0], first + sides[f][1],
                 first + sides[f][2], first + sides[f][3]);
}

/* A box and its mirror image behind the middle. */
static void add_boxes(builder *b, kg_vec3 lo, kg_vec3 hi) {
    add_box(b, lo, hi);
    add_box(b, kg_v3(lo.x, lo.y, -hi.z), kg_v3(hi.x, hi.y, -lo.z));
}

/* A round part between two heights, of different radius above and below, open at both ends. */
static void add_round(builder *b, double x, double z, double low, double r_low, double high,
                      double r_high) {
    int first = b->next;
    for (int i = 0; i < 2 * AROUND; i++) {
        double angle = 2 * KG_PI * (i / 2) / AROUND, r = i % 2 ? r_high : r_low;
        add_point(b, x + r * sin(angle), i % 2 ? high : low, z + r * cos(angle));
    }
    for (int i = 0; i < AROUND; i++) {
        int next = (i + 1) % AROUND;
        text_add(b->out, "f %d %d %d %d\n", first + 2 * i, first + 2 * next, first + 2 * next + 1,
                 first + 2 * i + 1);
    }
}

/* A tower with a wider gallery below its pointed roof. */
static void add_tower(builder *b, double x, double z, double r, double height, double roof) {
    add_round(b, x, z, 0, r, height, r);
    add_round(b, x, z, height, r, height + 0.3, r + 0.9);
    add_round(b, x, z, height + 0.3, r + 0.9, height + 2.6, r + 0.9);
    add_round(b, x, z, height + 2.6, r + 0.9, height + roof, 0.05);
}

/* Merlons on a wall from x0 to x1. */
static void add_merlons(builder *b, double x0, double x1, double y, double z0, double z1) {
    enum { PITCH = 3 };
    for (double x = x0; x + 1.6 <= x1; x += PITCH)
        add_boxes(b, kg_v3(x, y, z0), kg_v3(x + 1.6, y + 2.2, z1));
}

bool castle_mesh_write(text *out) {
    builder b = {out, 1};
    text_add(out, "g walls\n");
    add_boxes(&b, kg_v3(-26, 0, 5.1), kg_v3(-4.2, 11, 7.3));
    add_boxes(&b, kg_v3(4.2, 0, 5.1), kg_v3(26, 11, 7.3));
    add_boxes(&b, kg_v3(-4.2, 7.7, 5.1), kg_v3(4.2, 11, 7.3)); /* above the gate */
    add_merlons(&b, -21.3, -7, 11, 5.1, 7.3);
    add_merlons(&b, 7.7, 22, 11, 5.1, 7.3);
    text_add(out, "g gatehouse\n");
    for (int side = -1; side <= 1; side += 2)
        for (int back = -1; back <= 1; back += 2)
            add_tower(&b, side * 6.4, back * 8.1, 2.3, 14.2, 8.4);
    text_add(out, "g towers\n");
    for (int side = -1; side <= 1; side += 2)
        for (int back = -1; back <= 1; back += 2)
            add_tower(&b, side * 26, back * 6.6, 4.1, 17.3, 12.2);
    text_add(out, "g keep\n");
    add_box(&b, kg_v3(-12.4, 0, -3.3), kg_v3(12.4, 22.3, 3.3));
    add_merlons(&b, -12.4, 12.5, 22.3, 2.1, 3.3);
    add_tower(&b, 0, 0, 4.4, 32.6, 13.1);
    add_tower(&b, -15.2, 0, 3.1, 25.4, 10.3);
    add_tower(&b, 15.2, 0, 3.1, 25.4, 10.3);
    return !out->failed;
}
