#include "base/text.h"

#include <errno.h>
#include <libintl.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

const char *kg_text(const char *text) {
    return *text ? dgettext("katagami", text) : text; /* "" would be the catalogue's header */
}

void kg_text_vprint(char *out_text, size_t size, const char *format, va_list values) {
    int length = vsnprintf(out_text, size, kg_text(format), values);
    if (length < 0 || (size_t)length < size || size == 0)
        return;
    size_t end = size - 1, last = end;
    while (last > 0 && end - last < 4 && ((unsigned char)out_text[last - 1] & 0xc0) == 0x80)
        last--;
    unsigned char lead = last > 0 ? (unsigned char)out_text[last - 1] : 0;
    size_t need = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : lead >= 0xc0 ? 2 : 1;
    if (need > 1 && end - (last - 1) < need)
        out_text[last - 1] = '\0';
}

void kg_text_print(char *out_text, size_t size, const char *format, ...) {
    va_list values;
    va_start(values, format);
    kg_text_vprint(out_text, size, format, values);
    va_end(values);
}

const char *kg_text_of_errno(int code) {
    switch (code) { /* the usual ones: the system's own translations are seldom installed */
    case ENOENT:
        return kg_text("No such file or directory");
    case EACCES:
        return kg_text("Permission denied");
    case EISDIR:
        return kg_text("Is a directory");
    case ENOTDIR:
        return kg_text("Not a directory");
    case EEXIST:
        return kg_text("File exists");
    case ENAMETOOLONG:
        return kg_text("File name too long");
    case ENOSPC:
        return kg_text("No space left on device");
    case EROFS:
        return kg_text("Read-only file system");
    case EIO:
        return kg_text("Input/output error");
    default:
        return strerror(code);
    }
}

kg_status kg_fail(kg_error *error, kg_status status, const char *format, ...) {
    if (!error)
        return status;
    error->status = status;
    va_list args;
    va_start(args, format);
    kg_text_vprint(error->message, sizeof error->message, format, args);
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
    kg_text_vprint(error->message, sizeof error->message, format, args);
    va_end(args);
    size_t used = strlen(error->message);
    snprintf(error->message + used, sizeof error->message - used, "%s", tail);
    error->status = status;
    return status;
}

const char *kg_version(void) {
    return KG_VERSION;
}
