/* Sample models as text in the form of .katagami files. */
#ifndef KG_SAMPLES_MODEL_WRITER_H
#define KG_SAMPLES_MODEL_WRITER_H

#include "katagami/patch.h"
#include "samples/text.h"

enum { SAMPLE_MAX_BY = 4, SAMPLE_MAX_TRIMS = 10, SAMPLE_MAX_CONTOUR = 64, SAMPLE_MAX_PATCHES = 16 };

typedef enum sample_trim_kind {
    SAMPLE_KEEP,    /* cut by one patch; the piece nearest to `keep` stays */
    SAMPLE_SPLIT,   /* cut by one patch; all pieces stay */
    SAMPLE_ENCLOSE, /* cut by several; what lies between them stays */
    SAMPLE_OUTLINE, /* what lies inside of a contour stays */
    SAMPLE_HOLE     /* what lies outside */
} sample_trim_kind;

typedef struct sample_trim {
    sample_trim_kind kind;
    int by[SAMPLE_MAX_BY]; /* ids; 0 behind the last */
    kg_vec3 keep;
    size_t count;
    kg_vec2 contour[SAMPLE_MAX_CONTOUR]; /* (u,v) */
} sample_trim;

typedef struct sample_patch {
    int id; /* 0: none */
    const char *name;
    kg_patch_input input;
    bool construction;
    size_t trim_count;
    sample_trim trims[SAMPLE_MAX_TRIMS];
} sample_patch;

typedef struct sample_model {
    const char *title, *reference; /* reference may be NULL */
    const char *scale;             /* of the net; NULL: 1 */
    size_t count;
    sample_patch patches[SAMPLE_MAX_PATCHES];
} sample_model;

/* A new patch at the end of the model; its id is its number from 1. */
sample_patch *sample_add(sample_model *model, const char *name, const kg_patch_input *input);

/* The model's patch with this id. */
sample_patch *sample_find(sample_model *model, int id);

/* A new patch, the mirror image in y of one of the model's. Its cuts are the mirrored ones, by the
 * same patches. */
sample_patch *sample_mirror(sample_model *model, const char *name, const sample_patch *of);

void sample_cut(sample_patch *patch, int by, kg_vec3 keep);
void sample_split(sample_patch *patch, int by);
/* By the patches `first` to `last`, SAMPLE_MAX_BY at most. */
void sample_enclose(sample_patch *patch, int first, int last);
/* A contour without points yet. */
sample_trim *sample_contour(sample_patch *patch, sample_trim_kind kind);
/* A hole round (u,v) as wide as 2 * radius along u and 2 * stretch * radius along the geodesic. */
void sample_hole(sample_patch *patch, kg_vec2 middle, double radius, double stretch);

bool sample_write(const sample_model *model, text *out);

#endif
