#include "base/phrase.h"

#include <errno.h>
#include <libintl.h>
#include <stdio.h>
#include <string.h>

const char *kg_phrase(const char *text) {
    return *text ? dgettext("katagami", text) : text; /* "" would be the catalogue's header */
}

void kg_phrase_vprint(char *out_text, size_t size, const char *format, va_list values) {
    int length = vsnprintf(out_text, size, kg_phrase(format), values);
    if (length < 0 || (size_t)length < size || size == 0)
        return;
    /* the last character's first byte says how many it should have */
    size_t end = size - 1, last = end;
    while (last > 0 && end - last < 4 && ((unsigned char)out_text[last - 1] & 0xc0) == 0x80)
        last--;
    unsigned char lead = last > 0 ? (unsigned char)out_text[last - 1] : 0;
    size_t need = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : lead >= 0xc0 ? 2 : 1;
    if (need > 1 && end - (last - 1) < need)
        out_text[last - 1] = '\0';
}

void kg_phrase_print(char *out_text, size_t size, const char *format, ...) {
    va_list values;
    va_start(values, format);
    kg_phrase_vprint(out_text, size, format, values);
    va_end(values);
}

const char *kg_phrase_of_errno(int code) {
    switch (code) { /* the usual ones: the system's own translations are seldom installed */
    case ENOENT:
        return kg_phrase("No such file or directory");
    case EACCES:
        return kg_phrase("Permission denied");
    case EISDIR:
        return kg_phrase("Is a directory");
    case ENOTDIR:
        return kg_phrase("Not a directory");
    case EEXIST:
        return kg_phrase("File exists");
    case ENAMETOOLONG:
        return kg_phrase("File name too long");
    case ENOSPC:
        return kg_phrase("No space left on device");
    case EROFS:
        return kg_phrase("Read-only file system");
    case EIO:
        return kg_phrase("Input/output error");
    default:
        return strerror(code);
    }
}
