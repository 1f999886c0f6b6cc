/*
 * What the commands of the program share: one file per command, one line per command in the table
 * of main.c.
 */
#ifndef KG_CLI_COMMAND_H
#define KG_CLI_COMMAND_H

#include "katagami/mesh.h"

/* Exit codes of the program. */
enum {
    KG_EXIT_DONE = 0,
    KG_EXIT_FAILED = 1, /* the input or the model is at fault */
    KG_EXIT_USAGE = 2   /* the command line is */
};

typedef struct kg_command {
    const char *name;
    const char *summary; /* one line of `katagami --help` */
    /* Gets the words after "katagami", its own name first, and returns an exit code. Knows --help
     * itself. */
    int (*run)(int argc, char **argv);
} kg_command;

/* Says on stderr what is wrong with the input: "katagami net: message". Returns KG_EXIT_FAILED. */
int kg_command_fail(const char *command, const kg_error *error) KG_CHECKED;

/* Warns on stderr of the faces of a mesh file that were skipped. */
void kg_command_say_skipped(const char *command, const kg_mesh *mesh, const char *path);

/* Says on stderr what is wrong with the command line and where help is. Returns KG_EXIT_USAGE. */
int kg_command_misuse(const char *command, const char *format, ...) KG_PRINTF(2, 3) KG_CHECKED;

#endif
