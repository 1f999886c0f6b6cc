/*
 * Settings of nets in model files, all in the "net" object:
 *
 *     "paper": "A4|…|WxH|none", "margin": mm, "scale": 1, "tab_width": mm,
 *     "landscape": bool, "labels": "none|inside|outside", "preset": "print|laser|…",
 *     "nest": bool (true), "grain": bool, "gap": mm, "merge": bool
 */
#ifndef KG_NET_SETTINGS_H
#define KG_NET_SETTINGS_H

#include "base/reader.h"
#include "katagami/net.h"

/* Reads the "net" object of a file, if there is one. What it says beside the first four is checked
 * when it is used. */
kg_status kg_net_settings_parse(kg_reader *r, const json_t *root,
                                kg_net_settings *settings) KG_CHECKED;
/* The object to write, empty when nothing differs from what is usual; NULL when memory runs out. */
json_t *kg_net_settings_json(const kg_net_settings *settings);

/* Sets a key of the object, or removes it (`value` NULL); takes over `value`, also on failure.
 * KG_ERR_MEMORY. */
kg_status kg_net_settings_set(kg_net_settings *settings, const char *key, json_t *value,
                              kg_error *error) KG_CHECKED;

/* Words of files in the order of kg_net_labels, kg_net_preset and so on; NULL behind the last. */
extern const char *const kg_net_label_names[];
extern const char *const kg_net_preset_names[];
extern const char *const kg_net_tab_side_names[];
extern const char *const kg_net_tab_shape_names[];

/* A wish for the side of tabs as seen from the other end of the join. */
kg_net_tab_side kg_net_tab_turned(kg_net_tab_side side);

#endif
