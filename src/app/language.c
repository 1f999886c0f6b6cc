#include "app/language.h"

#include "katagami/base.h"

#include <libintl.h>
#include <locale.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define DOMAIN "katagami"

/* Holds the folder of the running program followed by `below`; false when that has no texts. */
static bool beside_program(const char *below, char *out, size_t size) {
    char file[4096];
    ssize_t n = readlink("/proc/self/exe", out, size - 1);
    if (n <= 0)
        return false;
    out[n] = '\0';
    char *slash = strrchr(out, '/');
    size_t folder = slash ? (size_t)(slash - out) : 0;
    if (folder + strlen(below) >= size)
        return false;
    strcpy(out + folder, below);
    n = snprintf(file, sizeof file, "%s/ja/LC_MESSAGES/" DOMAIN ".mo", out);
    return n > 0 && (size_t)n < sizeof file && access(file, R_OK) == 0;
}

/* What the environment asks for first, NULL for nothing. */
static const char *environment(void) {
    static const char *const names[] = {"LC_ALL", "LC_MESSAGES", "LANG"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        const char *value = getenv(names[i]);
        if (value && *value)
            return value;
    }
    return NULL;
}

void kg_language_use(const char *code) {
    static const char *asked_for; /* LANGUAGE before it was first changed */
    static bool is_known;
    char folder[4096];
    if (!is_known) {
        const char *before = getenv("LANGUAGE"),
                   *wanted = before && *before ? before : environment();
        asked_for = wanted ? strdup(wanted) : NULL;
        is_known = true;
    }
    /* gettext goes by LANGUAGE in every locale but the plain "C", whether or not that of the
     * language is installed on the machine; only messages follow it. */
    const char *language = *code ? code : asked_for ? asked_for : "en";
    setenv("LANGUAGE", language, 1);
    setlocale(LC_MESSAGES, "C");
    setlocale(LC_MESSAGES, "C.UTF-8");
    bool found = beside_program("/../share/locale", folder, sizeof folder) ||
                 beside_program("/src/app/po", folder, sizeof folder); /* where it is built */
    bindtextdomain(DOMAIN, found ? folder : KG_LOCALE_FOLDER);
    bind_textdomain_codeset(DOMAIN, "UTF-8");
    bind_textdomain_codeset("libc", "UTF-8"); /* strerror's, by LC_CTYPE else, which stays "C" */
    textdomain(DOMAIN);
}
