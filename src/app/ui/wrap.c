#include "app/ui/wrap.h"

#include <stdbool.h>
#include <string.h>

/* JIS X 4051: these do not begin a line, those do not end one. */
static const char not_first[] =
    "、。，．・：；？！)）]］」』】〉》…‥ー々ぁぃぅぇぉっゃゅょァィゥェォッャュョ°%％";
static const char not_last[] = "(（[［「『【〈《";

static size_t length_of(const char *at) {
    unsigned char c = (unsigned char)*at;
    size_t wanted = c < 0x80 ? 1 : c < 0xE0 ? 2 : c < 0xF0 ? 3 : 4, n = 1;
    while (n < wanted && ((unsigned char)at[n] & 0xC0) == 0x80)
        n++;
    return n;
}

static bool is_in(const char *marks, const char *at) {
    size_t n = length_of(at);
    for (const char *m = marks; *m; m += length_of(m))
        if (length_of(m) == n && memcmp(m, at, n) == 0)
            return true;
    return false;
}

/* Three bytes from U+2E80 on: characters that are written without spaces. */
static bool is_ideographic(const char *at) {
    return (unsigned char)*at >= 0xE3 ||
           ((unsigned char)*at == 0xE2 && (unsigned char)at[1] >= 0xBA);
}

static bool may_break(const char *before, const char *after) {
    return *after != ' ' && (is_ideographic(before) || is_ideographic(after)) &&
           !is_in(not_first, after) && !is_in(not_last, before) && *before != ' ';
}

void kg_ui_wrap(const char *text, double width, double (*measure)(const char *, const char *),
                char *out, size_t size) {
    const char *line = text, *rest = NULL, *end = NULL; /* where the line may end, and go on */
    size_t n = 0;
    for (const char *at = text; *at;) {
        const char *next = at + length_of(at);
        if (*at == '\n') {
            line = next;
            rest = NULL;
        } else if (rest && *at != ' ' && measure(line, next) > width) {
            size_t kept = n - (size_t)(at - end);
            if (end == rest) { /* between two characters */
                if (n + 2 >= size)
                    break;
                memmove(out + kept + 1, out + kept, (size_t)(at - end));
                n++;
            }
            out[kept] = '\n';
            line = rest;
            rest = NULL;
        }
        if (n + (size_t)(next - at) >= size)
            break;
        memcpy(out + n, at, (size_t)(next - at));
        n += (size_t)(next - at);
        if (*at == ' ') {
            end = at;
            rest = next;
        } else if (*next && may_break(at, next)) {
            end = rest = next;
        }
        at = next;
    }
    out[n < size ? n : size - 1] = '\0';
}
