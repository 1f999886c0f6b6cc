#include "tests/fuzz/mesh.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    return kg_fuzz_mesh(data, size, KG_MESH_STL);
}
