/* Whatever is accepted as an origami model is written, read and written again to the same bytes. */
#include "katagami/origami.h"
#include "tests/fuzz/fuzz.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

static char *write_text(const kg_origami *origami) {
    char *text = NULL;
    size_t size = 0;
    kg_status status = kg_origami_write_memory(origami, &text, &size, NULL);
    assert(status == KG_OK);
    assert(strlen(text) == size);
    return text;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    kg_origami *origami = NULL, *again = NULL;
    kg_error error;
    kg_status status =
        kg_origami_read_memory((const char *)data, size, "m.katagami", &origami, &error);
    if (status) {
        assert(!origami);
        return 0;
    }
    char *once = write_text(origami);
    status = kg_origami_read_memory(once, strlen(once), "m.katagami", &again, &error);
    assert(status == KG_OK);
    char *twice = write_text(again);
    assert(strcmp(once, twice) == 0);
    free(once);
    free(twice);
    kg_origami_destroy(origami);
    kg_origami_destroy(again);
    return 0;
}
