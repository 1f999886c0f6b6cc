/* What the command line starts. */
#ifndef KG_APP_RUN_H
#define KG_APP_RUN_H

#include "katagami/base.h"

typedef struct kg_run_options {
    const char *model;  /* to open; NULL: an empty one */
    const char *script; /* to run; NULL: none */
    const char *shot;   /* picture to make at the end; NULL: none */
    bool headless;
    int width, height; /* of the window, layout units */
    double scale;      /* of the picture without a window: 2 is a HiDPI screen */
} kg_run_options;

/* 1280 × 800, scale 1. */
kg_run_options kg_run_options_default(void);

/* The app in a window, until it is closed; or off-screen. KG_ERR_SYSTEM: no display, or no OpenGL.
 * KG_ERR_INPUT: the script failed. */
kg_status kg_run(const kg_run_options *options, kg_error *error) KG_CHECKED;

/* Runs the commands of a JSON list on a model and writes it. "-" is standard input or output.
 * KG_ERR_INPUT names the edit that failed, counted from 1; nothing is written then. */
kg_status kg_apply(const char *model, const char *edits, const char *output,
                   kg_error *error) KG_CHECKED;

#endif
