/*
 * Looking at the pages of a net and arranging its parts: which part of the window shows them, what
 * lies under the pointer, and what the mouse does there.
 *
 * Pages lie on a board, in rows; board coordinates are mm from the upper left corner of the first.
 */
#ifndef KG_APP_NET_VIEW_H
#define KG_APP_NET_VIEW_H

#include "app/net_state.h"

/* Between pages on the board, mm. */
#define KG_BOARD_GAP 12.0

typedef enum kg_net_gesture {
    KG_NET_IDLE,
    KG_NET_PRESSED,
    KG_NET_PANNING,
    KG_NET_MOVING, /* a part */
    KG_NET_TURNING,
    KG_NET_EDITING, /* as the mode does */
    KG_NET_DIVIDING /* the width between the model and the net */
} kg_net_gesture;

typedef struct kg_net_view {
    kg_net_state *state;
    kg_area area;        /* pixels; empty: not shown */
    double scale;        /* pixels per layout unit */
    double zoom;         /* pixels per mm */
    kg_vec2 pan;         /* pixel of the board's origin */
    int columns;         /* of pages */
    bool fitted;         /* all pages are shown, and will be when there are others */
    size_t fitted_pages; /* these and of this size */
    kg_vec2 fitted_size;
    uint64_t revision; /* of the picture that the indices below are about */

    int hover_part, hover_join, active_part; /* -1: none. The active one shows its handle. */
    kg_net_gesture gesture;
    bool on_divider; /* the pointer is over it */
    bool foreign;    /* a button is held that was pressed elsewhere */
    int button;
    kg_vec2 pressed, last;
    int moved_part; /* -1: none; lies at `moved` until the next picture */
    kg_net_placement moved, before;
    unsigned *clashes; /* with the moved part where it is; NULL: those of the picture */
    bool open_menu;    /* of menu_part and menu_join, -1: none */
    int menu_part, menu_join;
    double menu_width; /* of tabs, while it is being chosen */
    bool menu_all;     /* the menu is about all joins of the two patches */
    size_t listed;     /* warnings below the pages */
} kg_net_view;

kg_status kg_net_view_init(kg_net_view *view, kg_gate *gate, kg_error *error) KG_CHECKED;
void kg_net_view_clear(kg_net_view *view);

/* Follows the editor; true when there is something new to show. `area`: of the pages. */
bool kg_net_view_follow(kg_net_view *view, const kg_editor *editor, kg_area area, double scale);
/* True: the event is used up. */
bool kg_net_view_event(kg_net_view *view, kg_editor *editor, const kg_event *event);
void kg_net_view_fit(kg_net_view *view);
/* Brings a part into sight and makes it the active one. */
void kg_net_view_show_part(kg_net_view *view, size_t part);

/* ---- places ----------------------------------------------------------------------------- */

kg_vec2 kg_net_view_to_px(const kg_net_view *view, kg_vec2 board);
kg_vec2 kg_net_view_to_board(const kg_net_view *view, kg_vec2 px);
/* The upper left corner of a page on the board. */
kg_vec2 kg_net_view_page_origin(const kg_net_view *view, int page);
/* Pages shown: one more than there are while a part is moved. */
size_t kg_net_view_page_count(const kg_net_view *view);
kg_net_placement kg_net_view_placement(const kg_net_view *view, size_t part);
/* That placement turned about the part's middle. */
kg_net_placement kg_net_view_turned(const kg_net_view *view, size_t part, double angle);
/* Takes points of a part, in its own coordinates, to pixels: turned, scaled, moved. */
typedef struct kg_net_map {
    double c, s;
    kg_vec2 offset;
} kg_net_map;
kg_net_map kg_net_view_map(const kg_net_view *view, size_t part);
static inline kg_vec2 kg_net_map_apply(const kg_net_map *map, kg_vec2 p) {
    return kg_v2(map->c * p.x - map->s * p.y + map->offset.x,
                 map->s * p.x + map->c * p.y + map->offset.y);
}
/* The box of a part, pixels. */
kg_box2 kg_net_view_part_box(const kg_net_view *view, size_t part);
/* Where the handle that turns the active part is; false when there is none. */
bool kg_net_view_handle(const kg_net_view *view, kg_vec2 *out_center, kg_vec2 *out_handle);
/* The point of a part, in its own coordinates, at a pixel. */
kg_vec2 kg_net_view_part_point(const kg_net_view *view, size_t part, kg_vec2 px);
/* What is wrong with where a part lies: see net/clash.h. */
unsigned kg_net_view_clash(const kg_net_view *view, size_t part);

/* ---- what lies under a pixel ------------------------------------------------------------ */

int kg_net_view_part_at(const kg_net_view *view, kg_vec2 px);
/* The join whose edge or number is there, the nearest first. */
int kg_net_view_join_at(const kg_net_view *view, kg_vec2 px);
/* The join under the pointer, be it here or in the model; -1: none. */
int kg_net_view_lit_join(const kg_net_view *view, const kg_editor *editor);

/* The points of a side of a join, in the coordinates of its part; false for a side in no part. */
bool kg_net_side_points(const kg_net *net, const kg_net_side *side, size_t index, kg_vec2 *out);

#endif
