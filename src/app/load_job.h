/*
 * Reading a document, or a reference, on a thread of its own. A job that is given up ends within a
 * moment, or with the step that it is at: the text of a model, its patches, the JSON of a glTF
 * file; and what it made is thrown away.
 */
#ifndef KG_APP_LOAD_JOB_H
#define KG_APP_LOAD_JOB_H

#include "app/backdrop.h"
#include "app/gate.h"

typedef enum kg_load_step {
    KG_LOAD_READING,
    KG_LOAD_SOLVING,
    KG_LOAD_REFERENCE,
    KG_LOAD_STEP_COUNT
} kg_load_step;

typedef struct kg_load_job kg_load_job;

/* The document of a file, solved to `chord`, with its reference. `gate` may be NULL. KG_ERR_MEMORY.
 */
kg_status kg_load_job_document(const char *path, double chord, kg_gate *gate, kg_load_job **out_job,
                               kg_error *error) KG_CHECKED;
/* The reference of `document`; or, `path` not NULL, a mesh in that reference's place. The document
 * is copied. KG_ERR_MEMORY. */
kg_status kg_load_job_reference(const kg_document *document, const char *path, kg_gate *gate,
                                kg_load_job **out_job, kg_error *error) KG_CHECKED;

/* What the job was started with: the document's file, the mesh, or NULL. */
const char *kg_load_job_path(const kg_load_job *job);
/* Whether it reads a document and not only a reference. */
bool kg_load_job_is_document(const kg_load_job *job);
kg_load_step kg_load_job_step(const kg_load_job *job);
/* How far the whole is, in [0,1]. */
double kg_load_job_fraction(const kg_load_job *job);
bool kg_load_job_is_done(const kg_load_job *job);

/* Waits for its end and says what came of it: the document (NULL for a job that reads none), which
 * the caller destroys, and the backdrop. A document whose reference cannot be read is no failure:
 * `reference_error` has its message then, else it is empty. */
kg_status kg_load_job_finish(kg_load_job *job, kg_document **out_document,
                             kg_backdrop *out_backdrop, kg_error *reference_error,
                             kg_error *error) KG_CHECKED;
/* Asks it to end early; kg_load_job_finish gives KG_ERR_CANCELLED. */
void kg_load_job_cancel(kg_load_job *job);
/* Waits for its end and throws away what it made. */
void kg_load_job_destroy(kg_load_job *job);

#endif
