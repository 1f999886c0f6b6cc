/*
 * katagami: the program. Finds the command in a table and runs it.
 */
#include "cli/command.h"
#include "cli/commands.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static int run_help(int argc, char **argv);
static int run_version(int argc, char **argv);

static const kg_command commands[] = {
    {"edit", "the desktop app; also: katagami MODEL, or katagami alone", kg_command_edit},
    {"new", "an empty patch model over a reference mesh, a card, or a sheet", kg_command_new},
    {"info", "what is in a model, measured", kg_command_info},
    {"check", "everything in a model that would not work on paper", kg_command_check},
    {"net", "the pages to cut: SVG, PDF or DXF", kg_command_net},
    {"export", "the surface as a mesh, or the crease pattern as FOLD or .cp", kg_command_export},
    {"render", "a picture as PNG", kg_command_render},
    {"apply", "the app's own edits, from a file", kg_command_apply},
    {"oa", "a pop-up card of a mesh", kg_command_oa},
    {"help", "this text, or the help of a command: katagami help COMMAND", run_help},
    {"version", "the version", run_version},
};
enum { COMMAND_COUNT = sizeof commands / sizeof commands[0] };

static const kg_command *find_command(const char *name) {
    if (strcmp(name, "--help") == 0 || strcmp(name, "-h") == 0)
        name = "help";
    else if (strcmp(name, "--version") == 0)
        name = "version";
    for (size_t i = 0; i < COMMAND_COUNT; i++)
        if (strcmp(commands[i].name, name) == 0)
            return &commands[i];
    return NULL;
}

static void print_help(FILE *out) {
    fputs(
        "usage: katagami COMMAND [ARGUMENT…]\n\n"
        "Models made of paper: curved strips, pop-up cards and folded sheets, and their nets.\n\n",
        out);
    for (size_t i = 0; i < COMMAND_COUNT; i++)
        fprintf(out, "  %-10s %s\n", commands[i].name, commands[i].summary);
    fputs("\n`katagami COMMAND --help` explains a command. As a file name, - is standard input or "
          "output.\nExit codes: 0 done, 1 the input is at fault, 2 wrong usage.\n",
          out);
}

static int run_help(int argc, char **argv) {
    if (argc < 2 || strcmp(argv[1], "help") == 0 || argv[1][0] == '-') {
        print_help(stdout);
        return KG_EXIT_DONE;
    }
    const kg_command *command = find_command(argv[1]);
    if (!command)
        return kg_command_misuse("help", "there is no command called %s", argv[1]);
    char help[] = "--help";
    char *words[] = {argv[1], help, NULL};
    return command->run(2, words);
}

static int run_version(int argc, char **argv) {
    if (argc > 1 && strcmp(argv[1], "--help") == 0)
        puts("usage: katagami version");
    else
        printf("katagami %s\n", kg_version());
    return KG_EXIT_DONE;
}

int kg_command_fail(const char *command, const kg_error *error) {
    fprintf(stderr, "katagami %s: %s\n", command, error->message);
    return KG_EXIT_FAILED;
}

void kg_command_say_skipped(const char *command, const kg_mesh *mesh, const char *path) {
    char text[KG_ERROR_SIZE];
    if (kg_mesh_say_skipped(mesh, path, text, sizeof text))
        fprintf(stderr, "katagami %s: warning: %s\n", command, text);
}

int kg_command_misuse(const char *command, const char *format, ...) {
    fprintf(stderr, "katagami %s: ", command);
    va_list args;
    va_start(args, format);
    vfprintf(stderr, format, args);
    va_end(args);
    fprintf(stderr, " (see katagami help %s)\n", command);
    return KG_EXIT_USAGE;
}

int main(int argc, char **argv) {
    if (argc < 2 && !getenv("DISPLAY") && !getenv("WAYLAND_DISPLAY")) {
        print_help(stderr);
        return KG_EXIT_USAGE;
    }
    const kg_command *command = find_command(argc < 2 ? "edit" : argv[1]);
    bool opens = argc < 2 || (!command && access(argv[1], F_OK) == 0);
    if (!command && !opens) {
        fprintf(stderr, "katagami: there is no command called %s (see katagami help)\n", argv[1]);
        return KG_EXIT_USAGE;
    }
    if (opens) { /* the model stands where the command would */
        command = find_command("edit");
        argc++;
        argv--;
    }
    int code = command->run(argc - 1, argv + 1);
    /* A full disk or a closed pipe shows itself only when the last bytes leave. */
    if (fflush(stdout) != 0 || ferror(stdout)) {
        fprintf(stderr, "katagami %s: standard output: %s\n", command->name, strerror(errno));
        return KG_EXIT_FAILED;
    }
    return code;
}
