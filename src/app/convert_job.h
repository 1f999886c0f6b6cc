/*
 * Making a card of a mesh on a thread of its own, with what is needed to show it. The mesh is read
 * by the first job and lent to the next ones, which try other options.
 */
#ifndef KG_APP_CONVERT_JOB_H
#define KG_APP_CONVERT_JOB_H

#include "app/gate.h"
#include "katagami/document.h"
#include "katagami/render.h"

typedef struct kg_convert_job kg_convert_job;

/* A card, solved, and how it stands; all NULL: none. */
typedef struct kg_converted {
    kg_document *document;
    kg_mesh *standing;
} kg_converted;

void kg_converted_clear(kg_converted *converted);

/* The card of a mesh file, entitled as that is named. KG_ERR_INPUT, KG_ERR_IO, KG_ERR_PARSE,
 * KG_ERR_CANCELLED. */
kg_status kg_convert(const kg_mesh *mesh, const char *path, const kg_oa_options *options,
                     const kg_progress *progress, kg_document **out_document,
                     kg_error *error) KG_CHECKED;

/* `mesh` is taken over until the end, also on failure; NULL: it is read from `path`. `gate` may be
 * NULL. KG_ERR_MEMORY. */
kg_status kg_convert_job_start(const char *path, kg_mesh *mesh, const kg_oa_options *options,
                               kg_gate *gate, kg_convert_job **out_job, kg_error *error) KG_CHECKED;
double kg_convert_job_fraction(const kg_convert_job *job);
bool kg_convert_job_is_done(const kg_convert_job *job);
/* Asks it to end early. */
void kg_convert_job_cancel(kg_convert_job *job);
/* Waits for its end, frees it and says what came of it. The mesh (NULL: it could not be read) goes
 * to `out_mesh` whatever happened. */
kg_status kg_convert_job_finish(kg_convert_job *job, kg_mesh **out_mesh,
                                kg_converted *out_converted, kg_error *error) KG_CHECKED;

#endif
