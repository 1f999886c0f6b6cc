/*
 * Runs a fuzz target over its corpus, as an ordinary test: every file whole and cut off at every
 * byte. usage: replay CORPUS
 */
#include "base/file.h"
#include "tests/fuzz/fuzz.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Longer files are cut off at this many places only, evenly spread, to bound the time. */
enum { MAX_CUTS = 2000 };

/* The target sees a copy of exactly `size` bytes, so that sanitizers notice one byte more. */
static void run(const char *data, size_t size) {
    uint8_t *copy = malloc(size > 0 ? size : 1);
    if (!copy)
        abort();
    memcpy(copy, data, size);
    LLVMFuzzerTestOneInput(copy, size);
    free(copy);
}

static bool replay(const char *path) {
    char *data;
    size_t size;
    kg_error error;
    if (kg_file_read(path, &data, &size, &error)) {
        printf("# %s\n", error.message);
        return false;
    }
    size_t step = size / MAX_CUTS + 1;
    for (size_t cut = 0; cut < size; cut += step)
        run(data, cut);
    run(data, size);
    free(data);
    return true;
}

int main(int argc, char **argv) {
    struct dirent **entries = NULL;
    int count = argc == 2 ? scandir(argv[1], &entries, NULL, alphasort) : -1;
    int number = 0, failed = 0;
    for (int i = 0; i < count; i++) {
        const char *name = entries[i]->d_name;
        char path[4096];
        snprintf(path, sizeof path, "%s/%s", argv[1], name);
        if (name[0] != '.') {
            bool ok = replay(path);
            printf("%s %d - %s\n", ok ? "ok" : "not ok", ++number, name);
            fflush(stdout);
            failed += !ok;
        }
        free(entries[i]);
    }
    free(entries);
    if (number == 0)
        printf("not ok 1 - there is no corpus\n");
    return number > 0 && failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
