/* Telling how far long work is. */
#ifndef KG_BASE_PROGRESS_H
#define KG_BASE_PROGRESS_H

#include "katagami/base.h"

#ifdef __cplusplus
extern "C" {
#endif

/* KG_ERR_CANCELLED when whoever is told wants no more. `progress` and its function may be NULL. */
kg_status kg_progress_tell(const kg_progress *progress, double fraction, const char *what,
                           kg_error *error) KG_CHECKED;

/* A share of longer work, of which `whole` (may be NULL) is told. */
typedef struct kg_progress_share {
    const kg_progress *whole;
    double from, to; /* in [0,1] of the whole */
} kg_progress_share;

/* What the share's own work is given, which counts from 0 to 1; it points to the share. */
kg_progress kg_progress_of_share(kg_progress_share *share);

#ifdef __cplusplus
}
#endif
#endif
