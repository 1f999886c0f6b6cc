/* Paths of straight lines and cubic Béziers, what every writer draws. */
#ifndef KG_NET_PATH_H
#define KG_NET_PATH_H

#include "katagami/base.h"

typedef enum kg_path_verb { KG_PATH_MOVE, KG_PATH_LINE, KG_PATH_CURVE, KG_PATH_CLOSE } kg_path_verb;

/* MOVE and LINE use p[0], CURVE two control points and the end, CLOSE none. */
typedef struct kg_path_step {
    kg_path_verb verb;
    kg_vec2 p[3];
} kg_path_step;

typedef struct kg_path {
    kg_path_step *items;
    size_t count, capacity;
} kg_path;

void kg_path_clear(kg_path *path);

/* Each adds a step; false when memory runs out. */
bool kg_path_move(kg_path *path, kg_vec2 p) KG_CHECKED;
bool kg_path_line(kg_path *path, kg_vec2 p) KG_CHECKED;
bool kg_path_curve(kg_path *path, kg_vec2 p1, kg_vec2 p2, kg_vec2 p3) KG_CHECKED;
bool kg_path_close(kg_path *path) KG_CHECKED;

/* The point of a step's end. A step's start is the end of the one before. */
kg_vec2 kg_path_end(const kg_path_step *step);

/* Point of the Bézier p[0..3] at t. */
kg_vec2 kg_bezier2(const kg_vec2 p[4], double t);

/* The number of equal steps in t, at most `limit`, that keep a flattened Bézier within `tolerance`:
 * ceil(sqrt(6 max|p[i] - 2 p[i+1] + p[i+2]| / (8 tolerance))) (Wang's formula). */
int kg_bezier2_chords(const kg_vec2 p[4], double tolerance, int limit);

#endif
