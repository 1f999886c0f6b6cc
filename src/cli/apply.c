/* katagami apply: the app's own edits, from a file. */
#include "app/run.h"
#include "cli/commands.h"
#include "cli/options.h"

static const kg_option options[] = {
    {"output", 'o', true, "MODEL", "model file to write; required"},
};

int kg_command_apply(int argc, char **argv) {
    kg_arguments a;
    int code = kg_arguments_parse(argc, argv, "katagami apply MODEL EDITS.json -o MODEL", options,
                                  sizeof options / sizeof *options, &a);
    if (code >= 0)
        return code;
    const char *output = kg_arguments_get(&a, "output");
    kg_error error;
    if (a.count != 2 || !output)
        return kg_command_misuse("apply", "a model, a list of edits and an output (-o) are wanted");
    return kg_apply(a.words[0], a.words[1], output, &error) ? kg_command_fail("apply", &error)
                                                            : KG_EXIT_DONE;
}
