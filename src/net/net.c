#include "katagami/net.h"

#include "base/phrase.h"
#include "net/text.h"

#include <stdlib.h>
#include <string.h>

static void line_clear(kg_net_line *line) {
    free(line->points);
    free(line->corners);
}

static void part_clear(kg_net_part *part) {
    for (size_t i = 0; i < part->loop_count; i++)
        line_clear(&part->loops[i].line);
    for (size_t i = 0; i < part->line_count; i++)
        line_clear(&part->lines[i]);
    free(part->loops);
    free(part->lines);
    free(part->name);
}

kg_net *kg_net_create(void) {
    return calloc(1, sizeof(kg_net));
}

void kg_net_destroy(kg_net *net) {
    if (!net)
        return;
    for (size_t i = 0; i < net->part_count; i++)
        part_clear(&net->parts[i]);
    free(net->parts);
    free(net->joins);
    free(net->title);
    free(net);
}

/* Makes room for one more item of `size` bytes at `items`; NULL when memory runs out. */
static void *grown(void *items, size_t count, size_t size) {
    return count >= SIZE_MAX / size - 1 ? NULL : realloc(items, (count + 1) * size);
}

static kg_status out_of_memory(kg_error *error) {
    return kg_fail(error, KG_ERR_MEMORY, "out of memory while building the net");
}

kg_status kg_net_add_part(kg_net *net, int64_t source, const char *name, size_t *out_part,
                          kg_error *error) {
    char *copy = strdup(name ? name : "");
    kg_net_part *parts = grown(net->parts, net->part_count, sizeof *parts);
    if (parts)
        net->parts = parts;
    if (!parts || !copy) {
        free(copy);
        return out_of_memory(error);
    }
    *out_part = net->part_count++;
    parts[*out_part] = (kg_net_part){
        .number = *out_part ? parts[*out_part - 1].number + 1 : 1, .source = source, .name = copy};
    return KG_OK;
}

/* A copy of `line` with points and corners of its own. */
static bool line_copy(const kg_net_line *line, kg_net_line *out) {
    size_t count = line->count;
    if (count > SIZE_MAX / sizeof(kg_vec2))
        return false;
    kg_net_line copy = *line;
    copy.points = malloc(count ? count * sizeof(kg_vec2) : 1);
    copy.corners = malloc(count ? count : 1);
    if (!copy.points || !copy.corners) {
        line_clear(&copy);
        return false;
    }
    if (count > 0)
        memcpy(copy.points, line->points, count * sizeof(kg_vec2));
    if (line->corners && count > 0)
        memcpy(copy.corners, line->corners, count);
    else
        memset(copy.corners, 1, count);
    *out = copy;
    return true;
}

kg_status kg_net_add_loop(kg_net *net, size_t part, const kg_vec2 *points,
                          const unsigned char *corners, size_t count, kg_error *error) {
    kg_net_part *p = &net->parts[part];
    kg_net_loop *loops = grown(p->loops, p->loop_count, sizeof *loops);
    if (!loops)
        return out_of_memory(error);
    p->loops = loops;
    /* line_copy only reads what these point to. */
    kg_net_line line = {.kind = KG_NET_CUT,
                        .closed = true,
                        .count = count,
                        .points = (kg_vec2 *)(uintptr_t)points,
                        .corners = (unsigned char *)(uintptr_t)corners,
                        .join = -1};
    if (!line_copy(&line, &loops[p->loop_count].line))
        return out_of_memory(error);
    p->loop_count++;
    return KG_OK;
}

kg_status kg_net_add_line(kg_net *net, size_t part, const kg_net_line *line, size_t *out_line,
                          kg_error *error) {
    kg_net_part *p = &net->parts[part];
    kg_net_line *lines = grown(p->lines, p->line_count, sizeof *lines);
    if (!lines)
        return out_of_memory(error);
    p->lines = lines;
    if (!line_copy(line, &lines[p->line_count]))
        return out_of_memory(error);
    if (out_line)
        *out_line = p->line_count;
    p->line_count++;
    return KG_OK;
}

kg_status kg_net_add_join(kg_net *net, const kg_net_join *join, size_t *out_join, kg_error *error) {
    kg_net_join *joins = grown(net->joins, net->join_count, sizeof *joins);
    if (!joins)
        return out_of_memory(error);
    net->joins = joins;
    joins[net->join_count] = *join;
    if (join->number == 0)
        joins[net->join_count].number = (int)net->join_count + 1;
    if (out_join)
        *out_join = net->join_count;
    net->join_count++;
    return KG_OK;
}

size_t kg_net_joins_beside(const kg_net *net, const kg_net_join *join) {
    const int64_t *a = join->sources;
    size_t count = 0;
    for (size_t i = 0; i < net->join_count; i++) {
        const int64_t *b = net->joins[i].sources;
        count += (a[0] == b[0] && a[1] == b[1]) || (a[0] == b[1] && a[1] == b[0]);
    }
    return count;
}

/* Twice the signed area of a closed polyline. */
static double shoelace(const kg_net_line *line) {
    double sum = 0;
    for (size_t i = 0, j = line->count - 1; i < line->count; j = i++)
        sum += kg_cross2(line->points[j], line->points[i]);
    return sum;
}

static kg_status line_check(const kg_net *net, const kg_net_line *line, size_t least, int number,
                            kg_error *error) {
    if (line->count < least)
        return kg_fail(error, KG_ERR_INPUT,
                       line->closed
                           ? N_("part %d: a contour of %zu points, at least %zu are needed")
                           : N_("part %d: a line of %zu points, at least %zu are needed"),
                       number, line->count, least);
    for (size_t i = 0; i < line->count; i++)
        if (!isfinite(line->points[i].x) || !isfinite(line->points[i].y))
            return kg_fail(error, KG_ERR_INPUT, "part %d: a coordinate is not a number", number);
    if (line->join < -1 || line->join >= (int)net->join_count)
        return kg_fail(error, KG_ERR_INPUT, "part %d: a line names join %d of %zu", number,
                       line->join, net->join_count);
    return KG_OK;
}

static kg_status part_check(const kg_net *net, const kg_net_part *part, kg_error *error) {
    if (part->loop_count == 0)
        return kg_fail(error, KG_ERR_INPUT, "part %d has no contour", part->number);
    if (!part->name || !kg_text_valid(part->name))
        return kg_fail(error, KG_ERR_INPUT, "part %d: its name is not UTF-8", part->number);
    for (size_t i = 0; i < part->loop_count; i++) {
        const kg_net_line *line = &part->loops[i].line;
        kg_status status = line_check(net, line, 3, part->number, error);
        if (status != KG_OK)
            return status;
        if (!line->closed || line->kind != KG_NET_CUT)
            return kg_fail(error, KG_ERR_INPUT, "part %d: contour %zu is not a closed cut",
                           part->number, i);
        if ((shoelace(line) > 0) != (i == 0))
            return kg_fail(error, KG_ERR_INPUT, "part %d: contour %zu runs the wrong way round",
                           part->number, i);
    }
    for (size_t i = 0; i < part->line_count; i++) {
        kg_status status = line_check(net, &part->lines[i], 2, part->number, error);
        if (status != KG_OK)
            return status;
    }
    const kg_net_placement *pin = &part->pin;
    if (part->pinned && !(pin->page >= 0 && pin->page < KG_NET_PAGES_MAX && isfinite(pin->angle) &&
                          fabs(pin->offset.x) <= 1e6 && fabs(pin->offset.y) <= 1e6))
        return kg_fail(error, KG_ERR_INPUT, "part %d is pinned to no place", part->number);
    return KG_OK;
}

static bool side_valid(const kg_net *net, const kg_net_side *side) {
    if (side->part == -1)
        return true;
    if (side->part < -1 || side->part >= (int)net->part_count)
        return false;
    const kg_net_part *part = &net->parts[side->part];
    if (side->loop == -1)
        return side->line >= 0 && side->line < (int)part->line_count;
    return side->loop >= 0 && side->loop < (int)part->loop_count && side->count >= 2 &&
           side->first < part->loops[side->loop].line.count &&
           side->count <= part->loops[side->loop].line.count + 1;
}

kg_status kg_net_check(const kg_net *net, kg_error *error) {
    if (net->title && !kg_text_valid(net->title))
        return kg_fail(error, KG_ERR_INPUT, "the net's title is not UTF-8");
    for (size_t i = 0; i < net->part_count; i++) {
        kg_status status = part_check(net, &net->parts[i], error);
        if (status != KG_OK)
            return status;
    }
    for (size_t i = 0; i < net->join_count; i++)
        for (int s = 0; s < 2; s++)
            if (!side_valid(net, &net->joins[i].sides[s]))
                return kg_fail(error, KG_ERR_INPUT, "join %d: side %d lies nowhere in the net",
                               net->joins[i].number, s);
    return KG_OK;
}
