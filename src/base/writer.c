#include "base/writer.h"

#include "base/file.h"
#include "base/reader.h"

#include <stdlib.h>
#include <string.h>

json_t *kg_write_start(const json_t *kept) {
    return json_is_object(kept) ? json_copy((json_t *)(uintptr_t)kept) : json_object();
}

bool kg_write(json_t *object, const char *key, json_t *value) {
    return json_object_set_new(object, key, value) == 0;
}

bool kg_write_unless(json_t *object, const char *key, bool is_default, json_t *value) {
    if (is_default && !json_object_get(object, key)) {
        json_decref(value);
        return true;
    }
    return kg_write(object, key, value);
}

bool kg_write_if(json_t *object, const char *key, bool is_there, json_t *value) {
    if (is_there)
        return kg_write(object, key, value);
    json_decref(value);
    json_object_del(object, key);
    return true;
}

bool kg_write_header(json_t *root, const char *kind, const char *title) {
    return kg_write(root, "katagami", json_integer(KG_FILE_VERSION)) &&
           kg_write(root, "kind", json_string(kind)) &&
           kg_write_unless(root, "title", title[0] == '\0', json_string(title));
}

json_t *kg_write_number(double x) {
    if (x == floor(x) && fabs(x) < 1e15)
        return json_integer((json_int_t)x);
    return json_real(x);
}

json_t *kg_write_end(json_t *object, bool ok) {
    if (ok)
        return object;
    json_decref(object);
    return NULL;
}

kg_status kg_write_text(json_t *root, char **out_text, size_t *out_size, kg_error *error) {
    char *text = root ? kg_json_text(root) : NULL;
    json_decref(root);
    if (!text)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory, or a text that is not UTF-8");
    *out_text = text;
    *out_size = strlen(text);
    return KG_OK;
}

kg_status kg_write_file(json_t *root, const char *path, kg_error *error) {
    char *text = NULL;
    size_t size = 0;
    kg_status status = kg_write_text(root, &text, &size, error);
    if (status)
        return status;
    status = kg_file_write(path, text, size, error);
    free(text);
    return status;
}
