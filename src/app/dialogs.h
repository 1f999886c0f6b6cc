/* Which dialogs are open, and what they hold. panels/ shows them. */
#ifndef KG_APP_DIALOGS_H
#define KG_APP_DIALOGS_H

#include "app/settings.h"
#include "katagami/oa.h"

/* What is to be done with the file that is being chosen, or once the changes are dealt with. */
typedef enum kg_purpose {
    KG_FOR_NOTHING,
    KG_FOR_NEW,
    KG_FOR_NEW_CARD,
    KG_FOR_NEW_SHEETS,
    KG_FOR_CONVERSION, /* a mesh is to be chosen first */
    KG_FOR_CARD_OF_MESH,
    KG_FOR_CARD_OF_PATH,  /* of a certain mesh: dialogs.path */
    KG_FOR_NEW_REFERENCE, /* a patch model over it */
    KG_FOR_OPEN,
    KG_FOR_OPEN_PATH, /* a certain file: dialogs.path */
    KG_FOR_SAVE,
    KG_FOR_REFERENCE,
    KG_FOR_NET,
    KG_FOR_MESH,
    KG_FOR_GUIDE,
    KG_FOR_PICTURE,
    KG_FOR_QUIT
} kg_purpose;

typedef struct kg_browser_entry {
    char *name;
    bool is_folder;
} kg_browser_entry;

typedef struct kg_new_card {
    double size[3]; /* cells: width, depth, height */
    double cell;    /* mm */
} kg_new_card;

typedef struct kg_new_sheet {
    kg_vec2 size; /* mm */
    kg_color front, back;
} kg_new_sheet;

/* What was begun last. */
typedef struct kg_creation {
    kg_new_card card;
    kg_new_sheet sheet;
    kg_oa_options conversion;
} kg_creation;

kg_creation kg_creation_default(void);

typedef struct kg_dialogs {
    bool open_new_card, open_new_sheets, open_conversion, open_mesh;
    kg_creation creation;
    bool open_export, open_progress, open_loading, open_stand;
    bool open_palette, open_help, open_settings, open_rename, open_unsaved, open_browser,
        open_error, open_recovery, open_overwrite, open_menu; /* to be opened in this frame */
    kg_purpose purpose;                                       /* of the browser */
    kg_purpose after_unsaved; /* goes on when the changes are saved or given up */
    char error[KG_ERROR_SIZE];

    char path[KG_PATH_SIZE];   /* see KG_FOR_OPEN_PATH */
    char folder[KG_PATH_SIZE]; /* that the browser shows */
    char file[256];
    struct {
        kg_browser_entry *items;
        size_t count, capacity;
    } entries;

    char search[128]; /* of the palette */
    size_t chosen;
    char name[256]; /* of rename */
    bool focus;     /* the first field takes the keyboard */

    double scale; /* being chosen in the preferences; 0: not */

    char recovery[KG_PATH_SIZE]; /* an autosaved file; empty: none */
} kg_dialogs;

#endif
