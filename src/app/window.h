/* The app in a window. */
#ifndef KG_APP_WINDOW_H
#define KG_APP_WINDOW_H

#include "app/run.h"

kg_status kg_window_run(const kg_run_options *options, kg_error *error) KG_CHECKED;

#endif
