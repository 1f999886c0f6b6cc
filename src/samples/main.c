/*
 * make-samples: writes the sample models of data/ anew.
 */
#include "base/file.h"
#include "samples/samples.h"

#include <stdio.h>
#include <stdlib.h>

static kg_status write_file(const char *folder, const sample_file *file, kg_error *error) {
    text path = {0}, content = {0};
    text_add(&path, "%s/%s%c", folder, file->name, '\0');
    kg_status status = path.failed ? kg_fail(error, KG_ERR_INPUT, "the path is too long")
                                   : file->write(&content, error);
    if (status == KG_OK)
        status = kg_file_write(path.items, content.items, content.count, error);
    text_clear(&path);
    text_clear(&content);
    return status;
}

int main(int argc, char **argv) {
    if (argc != 2 || argv[1][0] == '-') {
        fputs("usage: make-samples FOLDER\n", stderr);
        return 2;
    }
    for (size_t i = 0; i < SAMPLE_FILE_COUNT; i++) {
        kg_error error;
        if (write_file(argv[1], &sample_files[i], &error) != KG_OK) {
            fprintf(stderr, "make-samples: %s: %s\n", sample_files[i].name, error.message);
            return 1;
        }
    }
    return 0;
}
