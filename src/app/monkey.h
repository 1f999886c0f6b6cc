/* Random input, to find what breaks under it. */
#ifndef KG_APP_MONKEY_H
#define KG_APP_MONKEY_H

#include "app/app.h"

/* The next event of a repeatable sequence; `pointer`: where the last one was. */
kg_event kg_monkey_event(uint64_t *state, int width, int height, kg_vec2 pointer);

/* KG_ERR_INPUT when the model cannot be written and read again as what it is. */
kg_status kg_monkey_check(const kg_app *app, kg_error *error) KG_CHECKED;

#endif
