/* The parts of a net in space: their surfaces, and the curves along which they are glued. */
#ifndef KG_GUIDE_ASSEMBLY_H
#define KG_GUIDE_ASSEMBLY_H

#include "katagami/document.h"
#include "katagami/render.h"

/* Points spread evenly over a part, for asking what of it is seen. */
enum { KG_ASSEMBLY_SAMPLES = 96 };

typedef struct kg_assembly_part {
    kg_surface surface; /* fronts outward; without triangles when nothing is known of the part */
    size_t piece_count;
    kg_color color; /* of the patch it is made from */
    kg_box3 box;
    kg_vec3 center; /* of its area */
    kg_vec3 front;  /* mean normal, not of unit length */
    size_t sample_count;
    kg_vec3 samples[KG_ASSEMBLY_SAMPLES], normals[KG_ASSEMBLY_SAMPLES];
    /* mm, of the tightest bends that make the front hollow and bulging; infinite: none */
    double radius_in, radius_out;
    size_t ruling_count; /* lines it is rolled around, on paper as the net has it */
    kg_vec2 (*rulings)[2];
} kg_assembly_part;

typedef struct kg_assembly_join {
    size_t count; /* 0: nothing is known of it */
    kg_vec3 *points;
    bool inside; /* a contact on the back of the part that bears the mark */
} kg_assembly_join;

typedef struct kg_assembly {
    const kg_net *net;
    kg_assembly_part *parts;
    kg_assembly_join *joins;
    kg_box3 box;
} kg_assembly;

/* Works out where the parts of the document's net are.
 *   room  that the net was made for, as kg_document_net has it
 * KG_ERR_MEMORY. */
kg_status kg_assembly_create(const kg_document *document, const kg_net *net, kg_vec2 room,
                             kg_assembly **out_assembly, kg_error *error) KG_CHECKED;
void kg_assembly_destroy(kg_assembly *assembly);

/* The length of a box's diagonal, 0 when it is empty. */
double kg_box_size(kg_box3 box);

#endif
