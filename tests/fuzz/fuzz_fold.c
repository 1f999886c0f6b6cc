/* Crease patterns as FOLD: read and folded, or refused with the file's name; what was read comes
 * back from what is written. */
#include "katagami/origami.h"
#include "tests/fuzz/fuzz.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

#ifndef FUZZ_NAME
#define FUZZ_NAME "p.fold"
#endif

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    kg_origami *origami = NULL;
    kg_error error;
    kg_layer_report report = kg_layer_report_default();
    report.most_steps = 1e4;
    report.most_states = 100;
    kg_status status = kg_origami_import_memory((const char *)data, size, FUZZ_NAME, NULL, &origami,
                                                &report, &error);
    if (status) {
        assert(!origami);
        assert(strncmp(error.message, FUZZ_NAME, strlen(FUZZ_NAME)) == 0);
        return 0;
    }
    char *text;
    status = kg_origami_fold_text(origami, 0, false, &text, &size, &error);
    assert(status == KG_OK);
    free(text);
    kg_origami_destroy(origami);
    return 0;
}
