/* Preferences of the user, and where the app keeps its files. */
#ifndef KG_APP_SETTINGS_H
#define KG_APP_SETTINGS_H

#include "app/pane.h"
#include "app/ui/ui.h"

enum { KG_RECENT_COUNT = 10, KG_PATH_SIZE = 4096 };

/* How files were exported last. */
typedef struct kg_export_choice {
    char format[8]; /* ending without the dot */
    bool separate, mirrored, perforate;
    double dash, gap; /* of perforated folds, mm */
    double width;     /* of pictures, pixels */
} kg_export_choice;

typedef struct kg_settings {
    bool transient;    /* never written: a script's */
    char language[16]; /* "" as the system, "en", "ja" */
    kg_navigation navigation;
    kg_ui_theme theme;
    double scale;            /* of the whole user interface, 1 is normal */
    double autosave_minutes; /* 0: never */
    bool net_view;           /* beside the model */
    double net_share;        /* of the width that both have, 0.2 to 0.8 */
    kg_export_choice export;
    double lift;                   /* mm, how far new patches lie off the reference */
    double step;                   /* mm, to which Ctrl rounds movements */
    char *recent[KG_RECENT_COUNT]; /* the latest first, NULL behind the last */
} kg_settings;

void kg_settings_default(kg_settings *settings);
void kg_settings_clear(kg_settings *settings);
kg_status kg_settings_copy(const kg_settings *from, kg_settings *to) KG_CHECKED;

/* From $XDG_CONFIG_HOME/katagami/settings.json; what is missing or wrong there stays as it was. */
void kg_settings_read(kg_settings *settings);
kg_status kg_settings_write(const kg_settings *settings, kg_error *error) KG_CHECKED;

/* Puts a file (an absolute path) first in the list of recent ones. */
void kg_settings_add_recent(kg_settings *settings, const char *path);

/* $XDG_CONFIG_HOME/katagami/NAME and $XDG_STATE_HOME/katagami/NAME, the folders made; false when
 * there is no home or no room in `out`. */
bool kg_config_path(const char *name, char out[KG_PATH_SIZE]);
bool kg_state_path(const char *name, char out[KG_PATH_SIZE]);

#endif
