#include "model/signature.h"

uint64_t kg_hash_bytes(uint64_t h, const void *data, size_t size) {
    const unsigned char *p = data;
    for (size_t i = 0; i < size; i++)
        h = (h ^ p[i]) * 0x100000001b3u;
    return h;
}

uint64_t kg_hash_input(const kg_patch_input *in) {
    uint64_t h = 0xcbf29ce484222325u;
    unsigned char flags[2] = {in->flip, in->has_ruling};
    h = kg_hash_bytes(h, in->points, in->point_count * sizeof in->points[0]);
    h = kg_hash_bytes(h, in->extent, sizeof in->extent);
    h = kg_hash_bytes(h, flags, sizeof flags);
    return in->has_ruling ? kg_hash_bytes(h, &in->ruling, sizeof in->ruling) : h;
}

uint64_t kg_hash_op(uint64_t h, const kg_trim_op *op) {
    unsigned char flags[5] = {(unsigned char)op->kind, op->off, op->bounded, op->trim_cutters,
                              op->outside};
    const uint64_t counts[3] = {op->by_count, op->keep_count, op->contour_count};
    h = kg_hash_bytes(h, flags, sizeof flags);
    h = kg_hash_bytes(h, counts, sizeof counts);
    if (op->by_count)
        h = kg_hash_bytes(h, op->by, op->by_count * sizeof *op->by);
    if (op->keep_count)
        h = kg_hash_bytes(h, op->keep, op->keep_count * sizeof *op->keep);
    if (op->contour_count)
        h = kg_hash_bytes(h, op->contour, op->contour_count * sizeof *op->contour);
    return h;
}
