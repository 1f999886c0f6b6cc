#include "katagami/guide.h"

#include "guide/fit.h"

#include <stdlib.h>
#include <string.h>

typedef struct builder {
    const kg_net *net;
    kg_guide_order_options options;
    kg_guide_order *order;
    int *shells;    /* per part: the shell it belongs to */
    bool *standing; /* per part */
    bool *glued;    /* per join */
    double *open;   /* per shell: length of edges of standing parts that are not glued */
    kg_touch *touches;
    size_t joins_used;
} builder;

kg_guide_order_options kg_guide_order_options_default(void) {
    return (kg_guide_order_options){.opening = 60};
}

/* Equal parts of a symmetric model differ by rounding: a value counts as larger from here on. */
static bool is_larger(double a, double b) {
    return a > b * (1 + 1e-6);
}

static bool is_held(const kg_net_join *join) {
    return join->sides[0].part >= 0 && join->sides[1].part >= 0;
}

/* A join that closes surfaces together: all but the fins' contacts on the outside. */
static bool is_shell_join(const builder *b, size_t join) {
    return b->net->joins[join].kind == KG_JOIN_SEAM ||
           (b->options.inside && b->options.inside[join]);
}

/* ---- groups of parts -------------------------------------------------------------------- */

static int root_of(int *parent, int i) {
    while (parent[i] != i)
        i = parent[i] = parent[parent[i]];
    return i;
}

/* Names each part by the first part of its group; groups are joined by all joins or by shell joins
 * only. */
static void find_groups(const builder *b, bool shells, int *out) {
    for (size_t i = 0; i < b->net->part_count; i++)
        out[i] = (int)i;
    for (size_t i = 0; i < b->net->join_count; i++) {
        const kg_net_join *join = &b->net->joins[i];
        if (!is_held(join) || (shells && !is_shell_join(b, i)))
            continue;
        int p = root_of(out, join->sides[0].part), q = root_of(out, join->sides[1].part);
        out[p > q ? p : q] = p < q ? p : q;
    }
    for (size_t i = 0; i < b->net->part_count; i++)
        out[i] = root_of(out, (int)i);
}

static double area_of_group(const kg_net *net, const int *groups, int group) {
    double area = 0;
    for (size_t i = 0; i < net->part_count; i++)
        if (groups[i] == group)
            area += net->parts[i].area;
    return area;
}

/* The largest part of the largest shell of a component. */
static int first_part(const builder *b, int component) {
    int best = -1;
    double best_shell = 0;
    for (size_t i = 0; i < b->net->part_count; i++) {
        if (b->order->components[i] != component)
            continue;
        double shell = area_of_group(b->net, b->shells, b->shells[i]);
        bool better = best < 0 || is_larger(shell, best_shell) ||
                      (b->shells[i] == b->shells[best] &&
                       is_larger(b->net->parts[i].area, b->net->parts[best].area));
        if (better) {
            best = (int)i;
            best_shell = shell;
        }
    }
    return best;
}

/* Numbers the components by area from 0. */
static kg_status number_components(builder *b) {
    size_t n = b->net->part_count;
    int *groups = calloc(n + 1, sizeof *groups), *components = b->order->components;
    if (!groups)
        return KG_ERR_MEMORY;
    find_groups(b, false, groups);
    for (size_t i = 0; i < n; i++)
        components[i] = -1;
    for (int number = 0;; number++) {
        int best = -1;
        double best_area = 0;
        for (size_t i = 0; i < n; i++) {
            if (groups[i] != (int)i || components[i] >= 0)
                continue;
            double area = area_of_group(b->net, groups, (int)i);
            if (best < 0 || is_larger(area, best_area)) {
                best = (int)i;
                best_area = area;
            }
        }
        if (best < 0)
            break;
        for (size_t i = 0; i < n; i++)
            if (groups[i] == best)
                components[i] = number;
        b->order->component_count = (size_t)number + 1;
    }
    free(groups);
    return KG_OK;
}

/* ---- steps ------------------------------------------------------------------------------ */

static kg_guide_step *add_step(builder *b, kg_guide_step_kind kind, int part) {
    kg_guide_step *step = &b->order->steps[b->order->step_count++];
    *step = (kg_guide_step){.kind = kind,
                            .part = part,
                            .component = b->order->components[part],
                            .joins = b->order->joins + b->joins_used};
    return step;
}

static void glue(builder *b, kg_guide_step *step, int join) {
    b->order->joins[b->joins_used++] = join;
    step->join_count++;
    b->glued[join] = true;
    const kg_net_join *j = &b->net->joins[join];
    if (!is_shell_join(b, (size_t)join))
        return;
    for (int side = 0; side < 2; side++)
        if (j->sides[side].loop >= 0)
            b->open[b->shells[j->sides[side].part]] -= j->sides[side].length;
}

/* Collects the joins of a part with what stands (`own`: with itself) that are not glued yet, in
 * the order of gluing. */
static size_t find_touches(builder *b, int part, bool own) {
    size_t count = 0;
    for (size_t i = 0; i < b->net->join_count; i++) {
        const kg_net_join *join = &b->net->joins[i];
        if (b->glued[i] || !is_held(join))
            continue;
        int p = join->sides[0].part, q = join->sides[1].part;
        bool self = p == part && q == part;
        bool meets = (p == part && b->standing[q]) || (q == part && b->standing[p]);
        if (own ? !self : self || !meets)
            continue;
        b->touches[count++] = kg_touch_of(b->net, i, p == part ? 0 : 1, is_shell_join(b, i));
    }
    kg_touches_sort(b->touches, count);
    return count;
}

/* A part whose glued edges are all marks inside it is a wall that others stand on: its outline is
 * no way in. */
static void stand(builder *b, int part) {
    b->standing[part] = true;
    bool edge = false, mark = false;
    for (size_t i = 0; i < b->net->join_count; i++)
        for (int side = 0; side < 2; side++) {
            const kg_net_side *s = &b->net->joins[i].sides[side];
            if (s->part == part && is_held(&b->net->joins[i]) && is_shell_join(b, i))
                *(s->loop >= 0 ? &edge : &mark) = true;
        }
    if (edge || !mark)
        b->open[b->shells[part]] += b->net->parts[part].perimeter;
}

static void glue_own(builder *b, int part) {
    size_t count = find_touches(b, part, true);
    if (count == 0)
        return;
    kg_guide_step *step = add_step(b, KG_STEP_OWN, part);
    for (size_t i = 0; i < count; i++)
        glue(b, step, b->touches[i].join);
    step->seals = b->standing[part] && b->open[b->shells[part]] < b->options.opening;
    step->closing = step->seals;
}

static void attach(builder *b, int part) {
    glue_own(b, part);
    size_t count = find_touches(b, part, false), first = count;
    kg_fit fit = kg_touches_fit(b->touches, count);
    if (fit.closing && count > 1) {
        first = fit.loop ? 1 : kg_touches_run(b->touches, count);
        kg_touches_close(b->touches, first, count);
    }
    kg_guide_step *step = add_step(b, KG_STEP_ATTACH, part);
    stand(b, part);
    for (size_t i = 0; i < count; i++) {
        if (i == first)
            step = add_step(b, KG_STEP_CLOSE, part);
        glue(b, step, b->touches[i].join);
    }
    step->closing = fit.closing;
    step->seals = fit.closing && b->open[b->shells[part]] < b->options.opening;
}

/* ---- what comes next -------------------------------------------------------------------- */

enum { RANK_SHELL, RANK_FIN, RANK_CLOSING, RANK_WAITING, RANK_NONE };

/* Does the part sit on the outside of one that is still missing? */
static bool is_waiting(const builder *b, int part) {
    for (size_t i = 0; i < b->net->join_count; i++) {
        const kg_net_join *join = &b->net->joins[i];
        if (is_held(join) && !is_shell_join(b, i) && join->sides[0].part == part &&
            join->sides[1].part != part && !b->standing[join->sides[1].part])
            return true;
    }
    return false;
}

/* How urgent a part is. */
typedef struct claim {
    int part, rank;
    double share;  /* of the length of its joins, those with what stands */
    double length; /* mm, of these */
} claim;

static claim claim_of(builder *b, int part) {
    double all = 0;
    claim c = {.part = part, .rank = RANK_NONE};
    size_t count = find_touches(b, part, false);
    if (count == 0)
        return c;
    for (size_t i = 0; i < b->net->join_count; i++) {
        const kg_net_join *join = &b->net->joins[i];
        bool own = join->sides[0].part == join->sides[1].part;
        if (is_held(join) && !own && (join->sides[0].part == part || join->sides[1].part == part))
            all += join->sides[join->sides[0].part == part ? 0 : 1].length;
    }
    kg_fit fit = kg_touches_fit(b->touches, count);
    c.length = fit.length;
    c.share = all > 0 ? fit.length / all : 0;
    if (fit.shell)
        c.rank = fit.closing ? RANK_CLOSING : RANK_SHELL;
    else
        c.rank = is_waiting(b, part) ? RANK_WAITING : RANK_FIN;
    return c;
}

static bool is_more_urgent(const claim *a, const claim *b) {
    if (a->rank != b->rank)
        return a->rank < b->rank;
    if (is_larger(a->share, b->share) || is_larger(b->share, a->share))
        return a->share > b->share;
    return is_larger(a->length, b->length);
}

/* The part to attach next, or -1 when the component is complete. */
static int next_part(builder *b) {
    claim best = {.part = -1, .rank = RANK_NONE};
    for (size_t i = 0; i < b->net->part_count; i++) {
        if (b->standing[i])
            continue;
        claim c = claim_of(b, (int)i);
        if (is_more_urgent(&c, &best))
            best = c;
    }
    return best.part;
}

static void build_component(builder *b, int component) {
    int part = first_part(b, component);
    add_step(b, KG_STEP_START, part);
    stand(b, part);
    glue_own(b, part);
    while ((part = next_part(b)) >= 0)
        attach(b, part);
}

static kg_status build(builder *b) {
    kg_status status = number_components(b);
    if (status)
        return status;
    find_groups(b, true, b->shells);
    for (size_t i = 0; i < b->order->component_count; i++)
        build_component(b, (int)i);
    for (size_t i = 1; i < b->order->component_count; i++)
        add_step(b, KG_STEP_PLACE, first_part(b, (int)i));
    return KG_OK;
}

kg_status kg_guide_order_create(const kg_net *net, const kg_guide_order_options *options,
                                kg_guide_order **out_order, kg_error *error) {
    size_t parts = net->part_count + 1, joins = net->join_count + 1;
    builder b = {.net = net,
                 .options = *options,
                 .order = calloc(1, sizeof *b.order),
                 .shells = calloc(parts, sizeof *b.shells),
                 .standing = calloc(parts, sizeof *b.standing),
                 .glued = calloc(joins, sizeof *b.glued),
                 .open = calloc(parts, sizeof *b.open),
                 .touches = calloc(joins, sizeof *b.touches)};
    kg_status status = KG_ERR_MEMORY;
    if (b.order) {
        /* each part: its own joins, attached or started, closed, and placed */
        b.order->steps = calloc(4 * parts, sizeof *b.order->steps);
        b.order->components = calloc(parts, sizeof *b.order->components);
        b.order->joins = calloc(joins, sizeof *b.order->joins);
        if (b.order->steps && b.order->components && b.order->joins && b.shells && b.standing &&
            b.glued && b.open && b.touches)
            status = build(&b);
    }
    free(b.shells);
    free(b.standing);
    free(b.glued);
    free(b.open);
    free(b.touches);
    if (status) {
        kg_guide_order_destroy(b.order);
        return kg_fail(error, status, "out of memory");
    }
    *out_order = b.order;
    return KG_OK;
}

void kg_guide_order_destroy(kg_guide_order *order) {
    if (!order)
        return;
    free(order->steps);
    free(order->components);
    free(order->joins);
    free(order);
}
