#include "base/phrase.h"

#include <stdarg.h>
#include <string.h>

kg_status kg_fail(kg_error *error, kg_status status, const char *format, ...) {
    if (!error)
        return status;
    error->status = status;
    va_list args;
    va_start(args, format);
    kg_phrase_vprint(error->message, sizeof error->message, format, args);
    va_end(args);
    return status;
}

kg_status kg_fail_in(kg_error *error, kg_status status, const char *format, ...) {
    if (!error)
        return status;
    char tail[KG_ERROR_SIZE];
    memcpy(tail, error->message, sizeof tail);
    tail[sizeof tail - 1] = '\0';
    va_list args;
    va_start(args, format);
    kg_phrase_vprint(error->message, sizeof error->message, format, args);
    va_end(args);
    size_t used = strlen(error->message);
    kg_phrase_print(error->message + used, sizeof error->message - used, "%s", tail);
    error->status = status;
    return status;
}

const char *kg_version(void) {
    return KG_VERSION;
}
