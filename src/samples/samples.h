/* The sample files of data/, by name. */
#ifndef KG_SAMPLES_SAMPLES_H
#define KG_SAMPLES_SAMPLES_H

#include "samples/text.h"

typedef struct sample_file {
    const char *name;
    /* Adds the file's whole text to `out`. Errors: KG_ERR_INPUT, KG_ERR_MEMORY. */
    kg_status (*write)(text *out, kg_error *error);
} sample_file;

enum { SAMPLE_FILE_COUNT = 10 };
extern const sample_file sample_files[SAMPLE_FILE_COUNT];

#endif
