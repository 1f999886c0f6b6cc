/* The language of the user interface, by gettext. */
#ifndef KG_APP_LANGUAGE_H
#define KG_APP_LANGUAGE_H

/* Texts are in this language from now on: "en", "ja", or "" for the one of the environment
 * (LANGUAGE, LC_ALL, LC_MESSAGES, LANG). Numbers stay as they are everywhere. */
void kg_language_use(const char *code);

#endif
