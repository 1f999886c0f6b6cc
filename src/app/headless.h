/* The app off-screen. */
#ifndef KG_APP_HEADLESS_H
#define KG_APP_HEADLESS_H

#include "app/run.h"

kg_status kg_headless_run(const kg_run_options *options, kg_error *error) KG_CHECKED;

#endif
