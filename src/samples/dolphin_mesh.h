/* The dolphin's reference mesh. */
#ifndef KG_SAMPLES_DOLPHIN_MESH_H
#define KG_SAMPLES_DOLPHIN_MESH_H

#include "samples/text.h"

/* Adds the mesh as OBJ: seven closed components (trunk, beak, fins) that reach into each other. */
bool dolphin_mesh_write(text *out);

#endif
