/* Whatever is accepted as a patch model is written, read and written again to the same bytes. */
#include "katagami/model.h"
#include "tests/fuzz/fuzz.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

static char *write_text(const kg_model *model) {
    char *text = NULL;
    size_t size = 0;
    kg_status status = kg_model_write_memory(model, &text, &size, NULL);
    assert(status == KG_OK);
    assert(strlen(text) == size);
    return text;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    kg_model *model = NULL, *again = NULL;
    kg_error error;
    kg_status status = kg_model_read_memory((const char *)data, size, "m.katagami", &model, &error);
    if (status) {
        assert(!model && status == KG_ERR_PARSE);
        assert(strncmp(error.message, "m.katagami:", 11) == 0);
        return 0;
    }
    char *once = write_text(model);
    status = kg_model_read_memory(once, strlen(once), "m.katagami", &again, &error);
    assert(status == KG_OK);
    char *twice = write_text(again);
    assert(strcmp(once, twice) == 0);
    free(once);
    free(twice);
    kg_model_destroy(model);
    kg_model_destroy(again);
    return 0;
}
