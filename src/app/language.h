/* The language of the user interface, by gettext. */
#ifndef KG_APP_LANGUAGE_H
#define KG_APP_LANGUAGE_H

/* Texts are in this language from now on, those of the kernel too: "en", "ja", or "" for the one of
 * the environment (LANGUAGE, LC_ALL, LC_MESSAGES, LANG). Numbers stay as they are everywhere. The
 * first call has to come before other threads are started: it may move the environment, which they
 * read when they look up a text. */
void kg_language_use(const char *code);

#endif
