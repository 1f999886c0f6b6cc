/* katagami edit: the desktop app, in a window or off-screen. */
#include "app/run.h"
#include "cli/commands.h"
#include "cli/options.h"

#include <stdio.h>

static const kg_option options[] = {
    {"headless", 0, false, NULL, "off-screen, for scripts and pictures"},
    {"script", 0, true, "FILE", "a script of clicks, keys and expectations to run (docs/app.md)"},
    {"shot", 0, true, "FILE.png", "picture of the window to make at the end (with --headless)"},
    {"size", 0, true, "WxH", "size of the window (1280x800)"},
    {"scale", 0, true, "F", "pixels per unit of the layout off-screen, 2 is HiDPI (1)"},
};

int kg_command_edit(int argc, char **argv) {
    kg_arguments a;
    int code = kg_arguments_parse(argc, argv, "katagami [edit] [MODEL] [OPTION…]", options,
                                  sizeof options / sizeof *options, &a);
    if (code >= 0)
        return code;
    kg_run_options wanted = kg_run_options_default();
    const char *size = kg_arguments_get(&a, "size");
    char rest;
    wanted.model = a.count > 0 ? a.words[0] : NULL;
    wanted.script = kg_arguments_get(&a, "script");
    wanted.shot = kg_arguments_get(&a, "shot");
    wanted.headless = kg_arguments_get(&a, "headless") != NULL;
    if (a.count > 1)
        return kg_command_misuse("edit", "one model at a time");
    if (size &&
        (sscanf(size, "%dx%d%c", &wanted.width, &wanted.height, &rest) != 2 || wanted.width < 64 ||
         wanted.height < 64 || wanted.width > 8192 || wanted.height > 8192))
        return kg_command_misuse("edit", "--size is WxH in pixels, not %s", size);
    if (!kg_arguments_number(&a, "scale", 0.5, 4, &wanted.scale))
        return KG_EXIT_USAGE;
    if (wanted.shot && !wanted.headless)
        return kg_command_misuse("edit", "--shot needs --headless");
    kg_error error;
    return kg_run(&wanted, &error) ? kg_command_fail("edit", &error) : KG_EXIT_DONE;
}
