/* How the edges along which a part is glued lie on its outline: in one run, several, or all round.
 */
#ifndef KG_GUIDE_FIT_H
#define KG_GUIDE_FIT_H

#include "katagami/net.h"

/* One join, seen from one of its parts: a curve on that part's paper. */
typedef struct kg_touch {
    int join;
    bool shell;      /* closes surfaces together, as a fin on their outside does not */
    double length;   /* mm */
    kg_vec2 ends[2]; /* on the part */
} kg_touch;

typedef struct kg_fit {
    double length; /* of all touches, mm */
    bool shell;    /* there is a touch of that kind; the rest is about these */
    bool loop;     /* they go all round */
    bool closing;  /* all round, or in several runs */
} kg_fit;

kg_touch kg_touch_of(const kg_net *net, size_t join, int side, bool shell);

/* Sorts into the order of gluing: shell joins first, the longest at the beginning, then always one
 * that goes on where those before it end. */
void kg_touches_sort(kg_touch *touches, size_t count);

/* How many of sorted touches go on from the first without a gap. */
size_t kg_touches_run(const kg_touch *touches, size_t count);

/* Sorts those behind the first `done`, which are glued: the nearer to these along the outline, and
 * of those equally near the shorter, the earlier, so that a long one opposite comes last. */
void kg_touches_close(kg_touch *touches, size_t done, size_t count);

/* What sorted touches are together. */
kg_fit kg_touches_fit(const kg_touch *touches, size_t count);

#endif
