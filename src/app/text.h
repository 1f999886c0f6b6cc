/* Texts of the user interface: `_` translates, `N_` marks texts that are translated later. */
#ifndef KG_APP_TEXT_H
#define KG_APP_TEXT_H

#include "base/phrase.h"

#include <libintl.h>

#define _(text) gettext(text)

#endif
