#include "guide/fit.h"

/* Ends of joins nearer than this, mm, meet: the stretches of neighbouring seams may stop short of a
 * corner where a third part comes in. */
#define MEETING 0.5

kg_touch kg_touch_of(const kg_net *net, size_t join, int side, bool shell) {
    const kg_net_side *s = &net->joins[join].sides[side];
    const kg_net_part *part = &net->parts[s->part];
    kg_touch touch = {.join = (int)join, .shell = shell, .length = s->length};
    if (s->loop >= 0) {
        const kg_net_line *line = &part->loops[s->loop].line;
        touch.ends[0] = line->points[s->first % line->count];
        touch.ends[1] = line->points[(s->first + s->count - 1) % line->count];
    } else {
        const kg_net_line *line = &part->lines[s->line];
        touch.ends[0] = line->points[0];
        touch.ends[1] = line->points[line->closed ? 0 : line->count - 1];
    }
    return touch;
}

static bool meet(const kg_touch *a, const kg_touch *b) {
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 2; k++)
            if (kg_dist2(a->ends[i], b->ends[k]) <= MEETING)
                return true;
    return false;
}

static bool meets_any(const kg_touch *touches, size_t count, const kg_touch *next) {
    for (size_t i = 0; i < count; i++)
        if (touches[i].shell == next->shell && meet(&touches[i], next))
            return true;
    return false;
}

/* A run goes all round when every end of it meets another touch, or its own other end. */
static bool goes_round(const kg_touch *touches, size_t count) {
    for (size_t i = 0; i < count; i++)
        for (int end = 0; end < 2 && touches[i].shell; end++) {
            kg_vec2 at = touches[i].ends[end];
            bool met = kg_dist2(at, touches[i].ends[!end]) <= MEETING;
            for (size_t k = 0; k < count && !met; k++)
                met = k != i && touches[k].shell &&
                      fmin(kg_dist2(at, touches[k].ends[0]), kg_dist2(at, touches[k].ends[1])) <=
                          MEETING;
            if (!met)
                return false;
        }
    return true;
}

/* Mirrored joins differ in length by rounding: those count as equal. */
static bool is_longer(const kg_touch *a, const kg_touch *b) {
    return a->length > b->length * (1 + 1e-6);
}

static void swap(kg_touch *a, kg_touch *b) {
    kg_touch kept = *a;
    *a = *b;
    *b = kept;
}

/* The best of touches[done] … to go on with: shell joins before others, then what meets one of the
 * first `reached`, then the longest or shortest, then the lower number. */
static size_t next_touch(const kg_touch *touches, size_t reached, size_t done, size_t count,
                         bool shortest) {
    size_t best = done;
    bool best_meets = meets_any(touches, reached, &touches[done]);
    for (size_t i = done + 1; i < count; i++) {
        const kg_touch *a = &touches[i], *b = &touches[best];
        bool meets = meets_any(touches, reached, a), better = a->join < b->join;
        if (a->shell != b->shell)
            better = a->shell;
        else if (meets != best_meets)
            better = meets;
        else if (is_longer(a, b) || is_longer(b, a))
            better = is_longer(a, b) != shortest;
        if (better) {
            best = i;
            best_meets = meets;
        }
    }
    return best;
}

void kg_touches_sort(kg_touch *touches, size_t count) {
    for (size_t done = 0; done < count; done++)
        swap(&touches[done], &touches[next_touch(touches, done, done, count, false)]);
}

void kg_touches_close(kg_touch *touches, size_t done, size_t count) {
    for (size_t reached = done; done < count; done++) {
        size_t next = next_touch(touches, reached, done, count, true);
        if (!meets_any(touches, reached, &touches[next])) {
            reached = done;
            next = next_touch(touches, reached, done, count, true);
        }
        swap(&touches[done], &touches[next]);
    }
}

size_t kg_touches_run(const kg_touch *touches, size_t count) {
    size_t run = 1;
    while (run < count && touches[run].shell && meets_any(touches, run, &touches[run]))
        run++;
    return run;
}

kg_fit kg_touches_fit(const kg_touch *touches, size_t count) {
    kg_fit fit = {0};
    size_t shells = 0;
    for (size_t i = 0; i < count; i++) {
        fit.length += touches[i].length;
        shells += touches[i].shell;
    }
    fit.shell = shells > 0;
    fit.loop = fit.shell && goes_round(touches, count);
    fit.closing = fit.loop || (fit.shell && kg_touches_run(touches, count) < shells);
    return fit;
}
