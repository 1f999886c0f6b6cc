/* Words of a command line: one input file, an output, and the command's own options. */
#ifndef KG_CLI_OPTIONS_H
#define KG_CLI_OPTIONS_H

#include "cli/command.h"

/* An option of a command. */
typedef struct kg_option {
    const char *name; /* without the two dashes */
    char letter;      /* short form, 0: none */
    bool has_value;
    const char *value; /* what the help calls the value: "MM" */
    const char *help;
} kg_option;

typedef struct kg_arguments {
    const char *command;
    int count; /* words that are no options */
    const char *words[4];
    struct {
        const kg_option *option;
        const char *value;
    } given[64];
    int given_count;
} kg_arguments;

/* Sorts a command line. Returns -1 to go on, else the exit code (help was printed, or misuse). */
int kg_arguments_parse(int argc, char **argv, const char *usage, const kg_option *options,
                       size_t option_count, kg_arguments *out) KG_CHECKED;

/* The last value given for an option; "" for one without value; NULL when it was not given. */
const char *kg_arguments_get(const kg_arguments *arguments, const char *name);

/* A number. False, with a message on stderr, when the text is none or not within [lo, hi]. */
bool kg_arguments_number(const kg_arguments *arguments, const char *name, double lo, double hi,
                         double *out) KG_CHECKED;

#endif
