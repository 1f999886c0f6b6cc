/*
 * What every fuzz target defines: it reads `data` as one file, of any content, and returns 0. It
 * must not crash, hang, leak or depend on earlier inputs; it checks with assert what must hold of
 * whatever was accepted.
 */
#ifndef KG_TESTS_FUZZ_H
#define KG_TESTS_FUZZ_H

#include <stddef.h>
#include <stdint.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

#endif
