/*
 * katagami: pop-up cards (voxel origamic architecture): one sheet, cut and folded only, that stands
 * up when it is opened to 90° and lies flat when it is closed.
 *
 * After J. Mitani, H. Suzuki, H. Uno, "Computer aided design for origamic architecture models with
 * voxel data structure", IPSJ Journal 44 (2003). Cells are counted along x (the fold line), y
 * (from the back sheet to the front) and z (up). The whole theory is one number: where a cell of
 * the sheet stands, z - y is its place down the sheet, so every cell may be placed anew along its
 * own diagonal and the sheet still folds flat.
 */
#ifndef KATAGAMI_OA_H
#define KATAGAMI_OA_H

#include "katagami/mesh.h"
#include "katagami/net.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Cells along one side of a card, and plain cells around it, at most. */
enum { KG_OA_MAX_SIZE = 2048, KG_OA_MAX_MARGIN = 512 };

/* Side of a cell, mm, at most. */
#define KG_OA_MAX_CELL 1000.0

/* Paper narrower than this tears when it is folded or lifted, mm; of cards that do not say. */
#define KG_OA_TINY 2.0

/* ---- cards ------------------------------------------------------------------------------ */

/* A card as it is kept in a file. Level z of column x is entry x * height + z of `depth` and
 * `window`; the top face at height z, entry x * (height + 1) + z of `omitted`. */
typedef struct kg_oa {
    int width, depth_limit, height; /* W, D, H */
    double cell_mm;
    int *depth;             /* filled voxels from the back, in [0, D], never growing with z */
    unsigned char *window;  /* 1: the front cell is pushed back; only where depth > 0 */
    unsigned char *omitted; /* 1: the top face is left out; only where there is one */
    bool diagonals;         /* 45° folds wherever they hold */
    int margin_cells;       /* plain sheet on each side of the drawn net */
    char *title;
    kg_net_settings net;
    double tiny_mm;      /* folds and strips narrower than this on paper are remarked on */
    struct json_t *json; /* the file's object as it was read: keeps unknown keys; may be NULL */
} kg_oa;

/* A plain card: nothing filled. KG_ERR_INPUT for sizes and cells out of range. */
KG_API kg_status kg_oa_create(int width, int depth, int height, double cell_mm, kg_oa **out_oa,
                              kg_error *error) KG_CHECKED;
/* NULL when memory runs out. */
KG_API kg_oa *kg_oa_copy(const kg_oa *oa);
KG_API void kg_oa_destroy(kg_oa *oa);
/* Is all the same that a file holds? Unknown keys of files are compared as they were read. */
KG_API bool kg_oa_equal(const kg_oa *a, const kg_oa *b);

static inline int kg_oa_depth(const kg_oa *oa, int x, int z) {
    return oa->depth[x * oa->height + z];
}
static inline bool kg_oa_window(const kg_oa *oa, int x, int z) {
    return oa->window[x * oa->height + z] != 0;
}
static inline bool kg_oa_omitted(const kg_oa *oa, int x, int z) {
    return oa->omitted[x * (oa->height + 1) + z] != 0;
}
/* Cells of the top face at height z in [1, H] of column x; 0: there is none. It begins at
 * y = kg_oa_depth(x, z), 0 when z is H. */
KG_API int kg_oa_top(const kg_oa *oa, int x, int z);

/* KG_ERR_INPUT naming the column and level where the staircase rule (eq. 4) or a range is broken,
 * or a window or an omitted top has nothing to be cut from. */
KG_API kg_status kg_oa_check(const kg_oa *oa, kg_error *error) KG_CHECKED;

/* Adding voxel (x,y,z) fills all that the staircase rule needs below and behind it; removing it
 * clears all above and in front of it. Windows and omitted tops that lose their face go. Voxels
 * outside the card change nothing. Return whether anything changed. */
KG_API bool kg_oa_add(kg_oa *oa, int x, int y, int z);
KG_API bool kg_oa_remove(kg_oa *oa, int x, int y, int z);

/* Sets a front cell's window, a top's omission. False where there is no such face, or no change. */
KG_API bool kg_oa_set_window(kg_oa *oa, int x, int z, bool on);
KG_API bool kg_oa_set_omitted(kg_oa *oa, int x, int z, bool on);

/* Another size, in cells; what fits stays at the corner of the first column, the back sheet and the
 * base. KG_ERR_INPUT: out of range. */
KG_API kg_status kg_oa_resize(kg_oa *oa, int width, int depth, int height,
                              kg_error *error) KG_CHECKED;
typedef enum kg_oa_half { KG_OA_LEFT_HALF, KG_OA_RIGHT_HALF } kg_oa_half;

/* Makes the other half the mirror of this one; a middle column stays. Returns whether anything
 * changed. */
KG_API bool kg_oa_mirror(kg_oa *oa, kg_oa_half half);

/* ---- files ------------------------------------------------------------------------------ */

/* Reads NAME.katagami of kind "oa" ("-": standard input). KG_ERR_PARSE: the message names file,
 * line and place. */
KG_API kg_status kg_oa_read(const char *path, kg_oa **out_oa, kg_error *error) KG_CHECKED;
KG_API kg_status kg_oa_read_memory(const char *data, size_t size, const char *name, kg_oa **out_oa,
                                   kg_error *error) KG_CHECKED;

/* Writes the whole file or nothing. Unknown keys survive. */
KG_API kg_status kg_oa_write(const kg_oa *oa, const char *path, kg_error *error) KG_CHECKED;
/* The file's text, zero-terminated; free() it. */
KG_API kg_status kg_oa_write_memory(const kg_oa *oa, char **out_text, size_t *out_size,
                                    kg_error *error) KG_CHECKED;

/* ---- the sheet -------------------------------------------------------------------------- */

/* The planes cells lie in: those of the back sheet and of the base, and the four of pyramids
 * (T and S about the vector s, T' and S' about r). */
typedef enum kg_oa_class {
    KG_OA_BACK,  /* B: vertical, faces the reader */
    KG_OA_FLOOR, /* F: horizontal, faces up */
    KG_OA_T,
    KG_OA_S,
    KG_OA_T2,
    KG_OA_S2,
    KG_OA_CLASS_COUNT
} kg_oa_class;

/* A point as whole multiples of e1, f, b, s and r: exact at every angle at once. */
typedef struct kg_oa_tuple {
    int v[5];
} kg_oa_tuple;

/* A cell or half a cell of the sheet, placed by an affine map: the point dx to the right of the
 * cell's upper left corner and dt upwards on the sheet lies at  corner + dx X + dt T,  with the
 * vectors of its class. */
typedef struct kg_oa_piece {
    kg_oa_class plane;
    kg_oa_tuple corner;
} kg_oa_piece;

/* How a cell is divided: '/' or '\'. The left piece has the left edge, and of '/' also the upper
 * one, of '\' the lower one. */
typedef enum kg_oa_shape { KG_OA_WHOLE, KG_OA_SLASH, KG_OA_BACKSLASH } kg_oa_shape;

enum {                   /* what a cell of the sheet is */
       KG_OA_FRONT = 1,  /* stands before the back sheet, so that something must hold it */
       KG_OA_PUSHED = 2, /* placed anew by a window */
       KG_OA_FALLEN = 4  /* placed anew by an omitted top */
};

/* A square pyramid in a stepped block: two 45° folds mirrored about the fold between them. */
typedef struct kg_oa_pyramid {
    bool notch;       /* a mountain notch; else a valley block */
    int y, z;         /* y0, z0 of its blocks */
    int apex;         /* x of the (perhaps virtual) apex */
    int side;         /* +1: apex at the left, -1: at the right */
    int first, last;  /* columns */
    int small, large; /* k of the blocks at its ends */
} kg_oa_pyramid;

/* Where every cell of the sheet stands. Row 0 is at the top of the back sheet; the cell of row r
 * reaches from H - r - 1 to H - r on the diagonal z - y. Margins are part of the sheet: x counts
 * from its left edge. */
typedef struct kg_oa_sheet {
    int width, height, depth; /* with margins */
    int rows;                 /* height + depth */
    int margin;
    int32_t *place;       /* [row * width + x]: 2 y, plus 1 when horizontal; y of the upper edge */
    unsigned char *marks; /* the same way, KG_OA_FRONT … */
    size_t pyramid_count;
    kg_oa_pyramid *pyramids;
    int32_t *bent;     /* per cell: index of its pieces, -1: an ordinary cell; NULL: none is bent */
    size_t bent_count; /* cells */
    kg_oa_piece *pieces;   /* left and right piece of each bent cell */
    unsigned char *shapes; /* kg_oa_shape of each bent cell */
} kg_oa_sheet;

/* Lays the sheet out; the card must pass kg_oa_check. Errors: KG_ERR_MEMORY. */
KG_API kg_status kg_oa_sheet_create(const kg_oa *oa, kg_oa_sheet **out_sheet,
                                    kg_error *error) KG_CHECKED;
KG_API void kg_oa_sheet_destroy(kg_oa_sheet *sheet);

/* Of cell (x, row): how it is divided, its left (0) or right (1) piece. */
KG_API kg_oa_shape kg_oa_cell_shape(const kg_oa_sheet *sheet, int x, int row);
KG_API kg_oa_piece kg_oa_cell_piece(const kg_oa_sheet *sheet, int x, int row, int side);

/* Where a piece puts a point of the sheet's lattice. */
KG_API kg_oa_tuple kg_oa_piece_point(const kg_oa_piece *piece, int dx, int dt);

/* What lies between neighbours: nothing, a cut or a fold. */
typedef enum kg_oa_edge { KG_OA_NONE, KG_OA_CUT, KG_OA_MOUNTAIN, KG_OA_VALLEY } kg_oa_edge;

/* Between (x, row) and (x, row + 1); between (x, row) and (x + 1, row); inside a divided cell. */
KG_API kg_oa_edge kg_oa_edge_below(const kg_oa_sheet *sheet, int x, int row);
KG_API kg_oa_edge kg_oa_edge_right(const kg_oa_sheet *sheet, int x, int row);
KG_API kg_oa_edge kg_oa_edge_inside(const kg_oa_sheet *sheet, int x, int row);

/* A straight line of the net, unit lines joined, from the left or upper end. */
typedef struct kg_oa_line {
    kg_oa_edge kind;
    int x0, row0, x1, row1;
} kg_oa_line;

/* All lines but the outline: horizontal ones by rows, vertical ones by columns, then oblique ones.
 * The caller frees them. */
KG_API kg_status kg_oa_lines(const kg_oa_sheet *sheet, kg_oa_line **out_lines, size_t *out_count,
                             kg_error *error) KG_CHECKED;

/* The net: one part with the sheet's outline, its first cell at the origin. */
KG_API kg_status kg_oa_net(const kg_oa *oa, const kg_oa_sheet *sheet, kg_net **out_net,
                           kg_error *error) KG_CHECKED;

/* The net as FOLD 1.2 text (a crease pattern in mm, y upwards; cuts are "C"); free() it. */
KG_API kg_status kg_oa_fold(const kg_oa *oa, const kg_oa_sheet *sheet, char **out_text,
                            kg_error *error) KG_CHECKED;

/* ---- does it work? ---------------------------------------------------------------------- */

enum {                      /* which floods reach a cell */
       KG_OA_FROM_BACK = 1, /* from the top left cell going left, right and down */
       KG_OA_FROM_BASE = 2  /* from the bottom left cell going left, right and up */
};

/* Section 2.6: floods the sheet both ways over all edges that are no cuts. `out_reached` (one per
 * cell) gets the floods that reach it; `out_missing` the number of cells that something must hold
 * (kg_oa_must_hold) and that one of them misses: 0 makes the card valid. */
KG_API kg_status kg_oa_flood(const kg_oa_sheet *sheet, unsigned char *out_reached,
                             size_t *out_missing, kg_error *error) KG_CHECKED;

/* Front cells that are not pushed back, and all cells of pyramids. */
static inline bool kg_oa_must_hold(const kg_oa_sheet *sheet, size_t cell) {
    return (sheet->marks[cell] & KG_OA_FRONT) || (sheet->bent && sheet->bent[cell] >= 0);
}

/* A patch of paper: pieces joined in one plane. */
typedef struct kg_oa_patch {
    int x0, x1, row0, row1; /* the cells around it: [x0, x1) x [row0, row1) */
    int cells;
    kg_oa_class plane;
    int plane_id; /* equal for patches in one plane */
    bool front;   /* holds a cell that is neither pushed back nor fallen */
    bool stable;  /* follows from the opening of the card */
    bool flap;    /* hangs on the rest by a single patch */
} kg_oa_patch;

/* A fold line between two patches. */
typedef struct kg_oa_hinge {
    int patches[2]; /* the smaller index first */
    kg_oa_tuple ends[2];
} kg_oa_hinge;

/* Stability: patches, hinges, and which patches stay loose when the card is open. Linear time; see
 * src/oa/stability.c for the rule. A flap is a patch outside the biconnected part of the graph of
 * patches (with a hinge from back to base added) that holds both. */
typedef struct kg_oa_stability {
    size_t patch_count;
    kg_oa_patch *patches;
    int32_t *patch_of; /* two per cell of the sheet: left and right piece */
    size_t hinge_count;
    kg_oa_hinge *hinges; /* sorted; one for each pair of patches */
    int back, base;      /* patches */
    size_t loose_count;
} kg_oa_stability;

KG_API kg_status kg_oa_stability_create(const kg_oa_sheet *sheet, kg_oa_stability **out_stability,
                                        kg_error *error) KG_CHECKED;
KG_API void kg_oa_stability_destroy(kg_oa_stability *stability);

/* Hinges up to which degrees of freedom are counted: the time grows with their cube, to about a
 * tenth of a second (300 hinges take some 3 ms). */
enum { KG_OA_MOBILITY_HINGES = 1000 };

/* Degrees of freedom of the open card, exact: hinges less the rank of the loop equations (for
 * every closed chain of patches, the turns about its hinges add up to no motion); 1 is the opening
 * itself. Pieces that hang on nothing count six more each. -1 in `out_degrees` when there are more
 * than KG_OA_MOBILITY_HINGES hinges. */
KG_API kg_status kg_oa_mobility(const kg_oa_stability *stability, int *out_degrees,
                                kg_error *error) KG_CHECKED;

/* By how many cells the model sticks out of the card when it is closed, 0: not at all. The sheets
 * then lie on each other, and a point y before the back sheet and z above the base lies y + z away
 * from the fold, that is outside when y + z is more than both sheets with their margins are long.
 * Sideways nothing ever sticks out. So many more cells of margin cover it. */
KG_API int kg_oa_overhang(const kg_oa_sheet *sheet);

/* What came of making a card stand. */
typedef struct kg_oa_mended {
    size_t cells; /* front cells of another depth or window than before, or with their top put back
                   */
    size_t loose; /* patches that are loose still: 0, unless nothing helped */
    size_t missing; /* cells that nothing holds */
} kg_oa_mended;

/* Makes a card stand: changes as few cells as it finds until no patch is loose and everything is
 * held, by closing windows, putting tops back, and moving fronts and tops to those beside them. A
 * card that stands already stays as it is; the same card always comes out the same. See
 * src/oa/mend.c for the search. Errors, which leave the card as it is: KG_ERR_CANCELLED,
 * KG_ERR_MEMORY. */
KG_API kg_status kg_oa_stabilize(kg_oa *oa, const kg_progress *progress, kg_oa_mended *out_mended,
                                 kg_error *error) KG_CHECKED;

/* ---- what is wrong, and where ----------------------------------------------------------- */

typedef enum kg_oa_trouble {
    /* faults: fronts that fall off or stay behind */
    KG_OA_FLOATING,    /* neither flood reaches it */
    KG_OA_NOT_LIFTED,  /* the one from the back sheet does not */
    KG_OA_NOT_CARRIED, /* the one from the base does not */
    /* warnings */
    KG_OA_BARE_EDGE, /* the model reaches the sheet's edge: nothing to hold the card by */
    KG_OA_OVERHANG,  /* sticks out of the card when it is closed */
    KG_OA_LOOSE,     /* a patch that does not follow from the opening of the card */
    KG_OA_FLAP,      /* the same, and it hangs on a single patch */
    KG_OA_TINY_FOLD, /* shorter than tiny_mm on paper */
    KG_OA_TINY_NECK, /* a strip between cuts narrower than that */
    KG_OA_TROUBLE_COUNT
} kg_oa_trouble;

static inline bool kg_oa_is_fault(kg_oa_trouble trouble) {
    return trouble <= KG_OA_NOT_CARRIED;
}

/* Something that is wrong at one place. */
typedef struct kg_oa_remark {
    kg_oa_trouble trouble;
    int x0, x1, row0, row1;   /* the cells around it: [x0, x1) x [row0, row1) of the sheet */
    size_t first_cell, cells; /* they are kg_oa_remarks.cells[first_cell] … */
    kg_oa_class plane;        /* of the first of them */
    int lo[3], hi[3];         /* the voxels that it is the paper of, both included, as kg_oa_faced
                                 says; without margins */
    int patch;                /* of the stability; -1: it is no patch */
    double mm;                /* of a tiny one: its width on paper; of an overhang: its length */
} kg_oa_remark;

/* All remarks, troubles in their order, each from the top of the sheet down, overhangs from the
 * left. */
typedef struct kg_oa_remarks {
    size_t count;
    kg_oa_remark *items;
    int32_t *cells; /* row * width + x of the sheet */
    size_t faults;  /* remarks that are; 0: the card is valid */
} kg_oa_remarks;

/* Errors: KG_ERR_MEMORY. */
KG_API kg_status kg_oa_remarks_create(const kg_oa *oa, const kg_oa_sheet *sheet,
                                      const kg_oa_stability *stability, kg_oa_remarks **out_remarks,
                                      kg_error *error) KG_CHECKED;
KG_API void kg_oa_remarks_destroy(kg_oa_remarks *remarks);

/* "not-lifted" and the like; what it means and what helps, in the user's language. Static. */
KG_API const char *kg_oa_trouble_code(kg_oa_trouble trouble);
KG_API const char *kg_oa_trouble_reason(kg_oa_trouble trouble);
KG_API const char *kg_oa_trouble_advice(kg_oa_trouble trouble);

/* "front y 3, columns 2-5, levels 1-4": where it is, in at most `size` bytes. */
KG_API void kg_oa_remark_place(const kg_oa_remark *remark, char *out_text, size_t size);
/* The whole sentence: place, reason, advice. */
KG_API void kg_oa_remark_say(const kg_oa_remark *remark, char *out_text, size_t size);

/* ---- opening and closing ---------------------------------------------------------------- */

/* Where e1, f, b, s, r point when the sheets stand `open` apart (0 closed, π/2 standing, π flat),
 * as eq. 6 with θ = π - open: x, y - z cos θ, z sin θ. Unit length. */
KG_API void kg_oa_axes(double open, kg_vec3 out_axes[5]);

/* The card at one opening, mm, in the world of models: (X, -Y, Z) of eq. 6, so that the front view
 * sees its front. One face per piece with its printed side in front; groups "card" and "loose",
 * the latter the patches that are not stable (`stability` NULL: all in one). */
KG_API kg_status kg_oa_pose(const kg_oa *oa, const kg_oa_sheet *sheet,
                            const kg_oa_stability *stability, double open, kg_mesh **out_mesh,
                            kg_error *error) KG_CHECKED;

/* Which side of which voxel a cell of the sheet is. Omitted tops and cells pushed back count as
 * what they are in space; the two halves of a divided cell as what it was before. */
typedef struct kg_oa_voxel {
    bool top; /* its top, else its front */
    int x;
    int y, z; /* of the filled voxel behind the paper; y is -1 behind the back sheet, z is -1
                 below the base. The free one before it: y + 1 of a front, z + 1 of a top */
} kg_oa_voxel;

/* Of cell (x, row), without margins: the card's cells, which may lie outside it. */
KG_API kg_oa_voxel kg_oa_faced(const kg_oa_sheet *sheet, int x, int row);

typedef struct kg_oa_hit {
    int x, row, side;  /* the cell and its piece */
    kg_oa_class plane; /* of the piece */
    bool printed;      /* from the side that faces the reader */
    kg_oa_voxel voxel; /* kg_oa_faced */
    int level;         /* of the front that the cell is part of, pushed back or not; -1: none. What
                          kg_oa_set_window takes */
    double distance;   /* in lengths of the ray's direction */
} kg_oa_hit;

/* The first cell that a ray meets on the card as kg_oa_pose puts it: false when it meets none.
 * Takes one look-up for each plane, a few microseconds. Of sheets that lie on each other the one
 * on the ray's side is met. */
KG_API bool kg_oa_pick(const kg_oa *oa, const kg_oa_sheet *sheet, double open, kg_vec3 origin,
                       kg_vec3 direction, kg_oa_hit *out_hit);

/* The mesh of kg_oa_pose with its whole motion, from flat open to closed and back in steps of two
 * degrees. Exact at every key: eq. 6 is linear in cos θ and sin θ, pyramids add three terms more.
 */
KG_API kg_status kg_oa_motion(const kg_oa *oa, const kg_oa_sheet *sheet,
                              const kg_oa_stability *stability, double open, kg_mesh **out_mesh,
                              kg_mesh_motion **out_motion, kg_error *error) KG_CHECKED;

/* ---- from meshes ------------------------------------------------------------------------ */

typedef struct kg_oa_options {
    int width, depth, height; /* cells */
    double cell_mm;
    kg_vec3 up, front; /* of the mesh: unit, perpendicular; right is up x front */
    bool stretch;      /* fill the card in all three directions; else one scale for all */
    int smooth;        /* side of the square of opening and closing, odd; 0: none */
    bool windows;
    int thin_top; /* tops at most so many cells deep may be left out; 0: none */
    bool diagonals;
    bool stable;    /* kg_oa_stabilize */
    int margin;     /* plain cells on each side, at least */
    bool covering;  /* more of them, so that nothing sticks out when the card is closed */
    double tiny_mm; /* of the card */
} kg_oa_options;

/* 80 x 40 x 40 cells of 2.5 mm, up +y, front +z, one scale, smooth 3, windows, no thin tops, no
 * margin. */
KG_API kg_oa_options kg_oa_options_default(void);

/* "x", "-y" and the like; false for other words. */
KG_API bool kg_oa_axis_parse(const char *text, kg_vec3 *out_axis);

/* Makes a card of a mesh (section 3): the depth of its front half seen from the front, smoothed,
 * made a staircase, opened by windows, thin tops left out, and made to stand. The first and last
 * column, the top row and the front row of the base stay plain. KG_ERR_INPUT (sizes; a mesh without
 * any extent across the view), KG_ERR_CANCELLED, KG_ERR_MEMORY. `progress` may be NULL. */
KG_API kg_status kg_oa_convert(const kg_mesh *mesh, const kg_oa_options *options,
                               const kg_progress *progress, kg_oa **out_oa,
                               kg_error *error) KG_CHECKED;

/* The steps of it. `out_depth` (x * height + z): where rays through the centres of cells meet the
 * front half, rounded to cells. */
KG_API kg_status kg_oa_depth_map(const kg_mesh *mesh, const kg_oa_options *options,
                                 const kg_progress *progress, int *out_depth,
                                 kg_error *error) KG_CHECKED;
/* Opening, then closing of every yz section with a square of `size` cells. */
KG_API kg_status kg_oa_smooth(int *depth, int width, int height, int size,
                              kg_error *error) KG_CHECKED;
/* The staircase: depth[z] = max(depth[z], depth[z + 1]) from the top; `out_raised` marks levels
 * that grew. */
KG_API void kg_oa_staircase(int *depth, int width, int height, unsigned char *out_raised);

/* Windows in the order z descending, x ascending: each candidate (x * height + z; others are left
 * as they are) becomes a window when the card is valid with it. The outcome is that of testing
 * every one by kg_oa_flood; see src/oa/reach.h for how. */
KG_API kg_status kg_oa_open_windows(kg_oa *oa, const unsigned char *candidates,
                                    const kg_progress *progress, kg_error *error) KG_CHECKED;
/* Omits tops at most `limit` cells deep, from below upwards, where the card stays valid; of the
 * tops above one front the tallest stay. */
KG_API kg_status kg_oa_thin_tops(kg_oa *oa, int limit, kg_error *error) KG_CHECKED;

#ifdef __cplusplus
}
#endif
#endif
