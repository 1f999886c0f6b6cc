#include "patch/simplex.h"

#include <string.h>

enum { MOST = KG_SIMPLEX_MOST };

typedef struct corner {
    double x[MOST], value;
} corner;

/* out = a + f (b - a), and its value. */
static corner between(const corner *a, const corner *b, double f, int count, kg_simplex_cost cost,
                      const void *data) {
    corner out = {{0}, 0};
    for (int k = 0; k < count; k++)
        out.x[k] = a->x[k] + f * (b->x[k] - a->x[k]);
    out.value = cost(out.x, data);
    return out;
}

/* Puts the last corner in its place among the others, which are sorted. */
static void sort_last(corner *c, int last) {
    corner moving = c[last];
    int i = last;
    for (; i > 0 && c[i - 1].value > moving.value; i--)
        c[i] = c[i - 1];
    c[i] = moving;
}

double kg_simplex_descend(kg_simplex_cost cost, const void *data, int count, double step,
                          int rounds, double *x) {
    corner c[MOST + 1];
    for (int i = 0; i <= count; i++) {
        memset(&c[i], 0, sizeof c[i]);
        memcpy(c[i].x, x, (size_t)count * sizeof *x);
        if (i > 0)
            c[i].x[i - 1] += step;
        c[i].value = cost(c[i].x, data);
        sort_last(c, i);
    }
    for (int round = 0; round < rounds; round++) {
        corner middle = {{0}, 0};
        for (int i = 0; i < count; i++)
            for (int k = 0; k < count; k++)
                middle.x[k] += c[i].x[k] / count;
        corner *worst = &c[count];
        corner next = between(worst, &middle, 2, count, cost, data);
        if (next.value < c[0].value) {
            corner farther = between(worst, &middle, 3, count, cost, data);
            *worst = farther.value < next.value ? farther : next;
        } else if (next.value < c[count - 1].value) {
            *worst = next;
        } else {
            corner nearer =
                between(worst, &middle, next.value < worst->value ? 1.5 : 0.5, count, cost, data);
            if (nearer.value < (next.value < worst->value ? next.value : worst->value)) {
                *worst = nearer;
            } else {
                for (int i = 1; i <= count; i++) {
                    c[i] = between(&c[0], &c[i], 0.5, count, cost, data);
                    sort_last(c, i);
                }
                continue;
            }
        }
        sort_last(c, count);
    }
    memcpy(x, c[0].x, (size_t)count * sizeof *x);
    return c[0].value;
}
