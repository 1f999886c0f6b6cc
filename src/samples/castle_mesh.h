/* A castle, y up and z to the front: walls with merlons, a gate, round towers, a keep. Front and
 * back are alike, so that its middle is the middle of the walls. */
#ifndef KG_SAMPLES_CASTLE_MESH_H
#define KG_SAMPLES_CASTLE_MESH_H

#include "samples/text.h"

/* Writes the mesh as OBJ; false when memory runs out. */
bool castle_mesh_write(text *out);

#endif
