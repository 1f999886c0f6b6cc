/* Signatures: 64-bit hashes of what a result depends on, so that equal ones need no new work. */
#ifndef KG_MODEL_SIGNATURE_H
#define KG_MODEL_SIGNATURE_H

#include "katagami/model.h"

/* FNV-1a, going on from `h`. */
uint64_t kg_hash_bytes(uint64_t h, const void *data, size_t size);

uint64_t kg_hash_input(const kg_patch_input *input);
uint64_t kg_hash_op(uint64_t h, const kg_trim_op *op);

#endif
