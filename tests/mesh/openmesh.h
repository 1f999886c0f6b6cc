/* OpenMesh as the other program that files come from and go to. */
#ifndef KG_TESTS_MESH_OPENMESH_H
#define KG_TESTS_MESH_OPENMESH_H

#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Lets OpenMesh read `data`, a file of extension `from` (".obj"), and write it as a file of
 * extension `to`, text or binary; the caller frees `*out_data`. */
bool kg_openmesh_convert(const void *data, size_t size, const char *from, bool from_binary,
                         const char *to, bool to_binary, char **out_data, size_t *out_size);

#ifdef __cplusplus
}
#endif
#endif
