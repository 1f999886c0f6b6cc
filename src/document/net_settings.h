/*
 * How the net is drawn, as the model's "net" object says beside paper, margin, scale and tab_width:
 *
 *     "landscape": bool, "labels": "none|inside|outside", "preset": "print|laser|…",
 *     "nest": bool (true), "grain": bool, "gap": mm, "merge": bool
 */
#ifndef KG_DOCUMENT_NET_SETTINGS_H
#define KG_DOCUMENT_NET_SETTINGS_H

#include "katagami/document.h"

/* Net options as the model asks for them. KG_ERR_INPUT: an unknown word or a wrong kind of value.
 */
kg_status kg_net_settings_read(const kg_model_net *net, kg_net_options *out_options,
                               kg_error *error) KG_CHECKED;

/* What the parts have to be at scale 1 so that they are as wished on the page. `net` may be NULL.
 */
kg_parts_options kg_net_settings_parts(const kg_model_net *net, const kg_net_options *options,
                                       double tab_width);

/* Chord error to solve with before the net is drawn: a fifth of the tolerance at the written size,
 * mm. */
double kg_net_settings_chord(const kg_net_options *options);

/* Sets a key of the "net" object, or removes it (`value` NULL); takes over `value`, also on
 * failure. KG_ERR_MEMORY. */
kg_status kg_net_settings_set(kg_model_net *net, const char *key, struct json_t *value,
                              kg_error *error) KG_CHECKED;

/* The preset that the model names, KG_PRESET_PRINT when it names none that is known. */
kg_net_preset kg_net_settings_preset(const kg_model_net *net);

/* "none", "inside", "outside"; NULL behind the last. And the same of presets. */
extern const char *const kg_net_label_names[];
extern const char *const kg_net_preset_names[];

#endif
