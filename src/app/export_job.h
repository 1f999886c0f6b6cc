/* Writing a file on a thread of its own, with progress. */
#ifndef KG_APP_EXPORT_JOB_H
#define KG_APP_EXPORT_JOB_H

#include "app/editor.h"
#include "app/gate.h"
#include "katagami/render.h"

typedef struct kg_export_job kg_export_job;

/* Starts to write the model as it is now: what the name's ending says, nets with the model's
 * settings and the user's choices; or its guide. `gate` may be NULL. KG_ERR_MEMORY. */
kg_status kg_export_job_start(const kg_editor *editor, const char *path, bool guide, kg_gate *gate,
                              kg_export_job **out_job, kg_error *error) KG_CHECKED;
/* Starts to write a picture, which it takes over. KG_ERR_MEMORY. */
kg_status kg_export_job_picture(kg_image *image, const char *path, kg_gate *gate,
                                kg_export_job **out_job, kg_error *error) KG_CHECKED;
double kg_export_job_fraction(const kg_export_job *job);
const char *kg_export_job_path(const kg_export_job *job);
/* Asks it to end early; nothing is written then. */
void kg_export_job_cancel(kg_export_job *job);
bool kg_export_job_is_done(const kg_export_job *job);
/* Waits for its end, frees it and says what came of it. */
kg_status kg_export_job_finish(kg_export_job *job, kg_error *error) KG_CHECKED;

#endif
