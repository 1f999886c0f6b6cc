#include "net/shapes.h"

#include <stdlib.h>

void kg_shapes_clear(kg_shapes *s) {
    free(s->parts);
    free(s->loops);
    free(s->points);
}

bool kg_shapes_create(const kg_net *net, double scale, kg_shapes *out_shapes) {
    size_t loops = 0, points = 0;
    for (size_t i = 0; i < net->part_count; i++) {
        loops += net->parts[i].loop_count;
        for (size_t k = 0; k < net->parts[i].loop_count; k++)
            points += net->parts[i].loops[k].line.count;
    }
    kg_shapes s = {calloc(net->part_count + 1, sizeof *s.parts), calloc(loops + 1, sizeof *s.loops),
                   calloc(points + 1, sizeof *s.points)};
    if (!s.parts || !s.loops || !s.points) {
        kg_shapes_clear(&s);
        return false;
    }
    kg_nest_loop *loop = s.loops;
    kg_vec2 *point = s.points;
    for (size_t i = 0; i < net->part_count; i++) {
        const kg_net_part *part = &net->parts[i];
        s.parts[i] = (kg_nest_part){.loops = loop, .loop_count = part->loop_count};
        for (size_t k = 0; k < part->loop_count; k++, loop++) {
            const kg_net_line *line = &part->loops[k].line;
            *loop = (kg_nest_loop){point, line->count};
            for (size_t j = 0; j < line->count; j++)
                *point++ = kg_scale2(line->points[j], scale);
        }
    }
    *out_shapes = s;
    return true;
}
