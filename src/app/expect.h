/* What assertions of scripts are made of. */
#ifndef KG_APP_EXPECT_H
#define KG_APP_EXPECT_H

#include "app/app.h"

/* How far a number may be off when a script does not say, mm. */
#define KG_EXPECT_SLACK 1e-6

/* Whether `*words` begin with `what`, which then is taken off. */
bool kg_expect_begins(const char **words, const char *what);

/* KG_OK, or KG_ERR_INPUT saying what is so instead. */
kg_status kg_expect_count(const char *what, size_t is, const char *words,
                          kg_error *error) KG_CHECKED;
kg_status kg_expect_yes(bool is, bool wanted, const char *what, kg_error *error) KG_CHECKED;
kg_status kg_expect_text(const char *what, const char *is, const char *wanted,
                         kg_error *error) KG_CHECKED;

/* "nothing is known about …" */
kg_status kg_expect_unknown(const char *words, kg_error *error) KG_CHECKED;

#endif
