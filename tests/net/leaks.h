/* For tests that draw text: Pango keeps a fontconfig pattern for the life of the process, which the
 * leak checker cannot know. */
#ifndef KG_TESTS_NET_LEAKS_H
#define KG_TESTS_NET_LEAKS_H

const char *__lsan_default_suppressions(void);
const char *__lsan_default_suppressions(void) {
    return "leak:libfontconfig\n";
}

#endif
