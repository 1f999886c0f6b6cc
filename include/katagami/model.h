/*
 * katagami: patch models, the document of the patch mode, and their solution.
 *
 * A kg_model is what the file says: patches, and trims as operations. A kg_solution is what
 * follows from it: prepared patches, crossings, trimmed regions, and everything wrong with them.
 * Moving a control point changes the model; solving again recomputes what depends on it and
 * keeps the rest.
 */
#ifndef KATAGAMI_MODEL_H
#define KATAGAMI_MODEL_H

#include "katagami/net.h"
#include "katagami/trim.h"

#ifdef __cplusplus
extern "C" {
#endif

struct json_t;

typedef enum kg_trim_kind {
    KG_TRIM_BY,     /* single surface: by[0] */
    KG_TRIM_INSIDE, /* several surfaces: the piece they enclose */
    KG_TRIM_CONTOUR /* drawn by hand */
} kg_trim_kind;

typedef struct kg_trim_op {
    kg_trim_kind kind;
    bool off;          /* switched off by the user, kept in the list */
    bool bounded;      /* cut only with the cutters' trimmed regions */
    bool trim_cutters; /* INSIDE: also cut the cutters by this patch */
    bool outside;      /* CONTOUR: keep what is outside */
    size_t by_count;
    int64_t *by;
    size_t keep_count;
    kg_vec3 *keep;
    size_t contour_count;
    kg_vec2 *contour;    /* x: u in mm, y: v */
    struct json_t *json; /* the object as read, for its unknown keys; may be NULL */
} kg_trim_op;

typedef struct kg_model_patch {
    int64_t id;
    char *name; /* UTF-8, never NULL */
    kg_patch_input input;
    bool hidden, construction;
    size_t trim_count;
    kg_trim_op *trims;
    struct json_t *json;
} kg_model_patch;

typedef struct kg_reference {
    char *file;     /* as written: relative to the model file; NULL: none */
    double size_mm; /* 0: the mesh's own units */
    bool has_matrix;
    double matrix[16]; /* row-major, applied after size_mm */
    bool up_y;
    bool visible;
    double opacity;
    struct json_t *json;
} kg_reference;

/* What the user wishes for all joins between two patches, or for one of them, which comes before
 * that. One is named by a place near it in the coordinates of the first patch: they move along with
 * the patch, and so does the join. */
typedef struct kg_model_join {
    int64_t patches[2];
    bool has_at;         /* only the join nearest to `at` */
    kg_vec2 at;          /* x: u in mm, y: v, of patches[0] */
    kg_net_tab_side tab; /* THIS: on the part of patches[0] */
    double width;        /* mm; 0: the net's */
    kg_net_tab_shape shape;
    bool merge; /* fold there instead of glue, where the parts are flat enough */
    struct json_t *json;
} kg_model_join;

/* Perpendicular to an axis (0: x, 1: y, 2: z), `at` mm from the origin along it. */
typedef struct kg_mirror_plane {
    int axis;
    double at; /* at most KG_MAX_COORDINATE from 0 */
} kg_mirror_plane;

typedef struct kg_model {
    char *title;            /* never NULL */
    kg_mirror_plane mirror; /* that copies are mirrored across; y = 0 in a new model */
    kg_reference reference;
    kg_net_settings net;
    size_t join_count;
    kg_model_join *joins; /* of the net */
    size_t patch_count;
    kg_model_patch *patches;
    struct json_t *json;
} kg_model;

/* A model without patches, or NULL when memory runs out; destroying NULL is fine. */
KG_API kg_model *kg_model_create(void);
KG_API void kg_model_destroy(kg_model *model);

/* A deep copy, or NULL when memory runs out. */
KG_API kg_model *kg_model_copy(const kg_model *model);

/* Reads NAME.katagami ("-": standard input). KG_ERR_PARSE and KG_ERR_INPUT messages name the file,
 * the line and the patch. */
KG_API kg_status kg_model_read(const char *path, kg_model **out_model, kg_error *error) KG_CHECKED;
KG_API kg_status kg_model_read_memory(const char *data, size_t size, const char *name,
                                      kg_model **out_model, kg_error *error) KG_CHECKED;

/* Writes the whole file or nothing. Unknown keys survive. */
KG_API kg_status kg_model_write(const kg_model *model, const char *path,
                                kg_error *error) KG_CHECKED;
/* The file's text, zero-terminated; free() it. */
KG_API kg_status kg_model_write_memory(const kg_model *model, char **out_text, size_t *out_size,
                                       kg_error *error) KG_CHECKED;

/* The patch with an id; NULL: none. */
KG_API kg_model_patch *kg_model_find(const kg_model *model, int64_t id);

/* The wish for all joins between two patches, in either order; NULL: none. */
KG_API const kg_model_join *kg_model_find_join(const kg_model *model, int64_t a, int64_t b);
/* The wish for the one of them that is named by just this place of the first; NULL: none. */
KG_API const kg_model_join *kg_model_find_join_at(const kg_model *model, const int64_t patches[2],
                                                  kg_vec2 at);

/* ---- solution --------------------------------------------------------------------------- */

typedef enum kg_severity { KG_WARNING, KG_FAULT } kg_severity;

/* Something the user should know. Codes are short fixed words ("extent-clamped"). */
typedef struct kg_issue {
    kg_severity severity;
    int64_t patch;
    const char *code; /* static */
    char message[KG_ERROR_SIZE / 2];
} kg_issue;

typedef struct kg_solved_patch {
    int64_t id;
    bool valid;     /* false: the patch or its trims have a fault; regions are empty */
    kg_patch patch; /* meaningful when `prepared` */
    bool prepared;
    bool construction;
    kg_regions regions;
    kg_trim_notes notes;
    uint64_t signature; /* of all that the regions depend on */
} kg_solved_patch;

typedef struct kg_solution kg_solution;

/* Solves a model. `previous` (may be NULL, is consumed) lends what did not change.
 * Faults of the model are no failure: they are issues. KG_ERR_MEMORY only. */
KG_API kg_status kg_solution_create(const kg_model *model, double tolerance, kg_solution *previous,
                                    kg_solution **out_solution, kg_error *error) KG_CHECKED;
KG_API void kg_solution_destroy(kg_solution *solution);

/* In the order of the model's patches. */
KG_API size_t kg_solution_count(const kg_solution *solution);
KG_API const kg_solved_patch *kg_solution_patch(const kg_solution *solution, size_t index);
/* NULL: no such id. */
KG_API const kg_solved_patch *kg_solution_find(const kg_solution *solution, int64_t id);
KG_API double kg_solution_tolerance(const kg_solution *solution);

KG_API size_t kg_solution_issue_count(const kg_solution *solution);
KG_API const kg_issue *kg_solution_issue(const kg_solution *solution, size_t index);
/* KG_OK, or KG_ERR_INPUT with the first fault as the message. */
KG_API kg_status kg_solution_check(const kg_solution *solution, kg_error *error) KG_CHECKED;

/* Finds prepared patches by id, for the calls of trim.h. */
KG_API kg_patch_finder kg_solution_finder(const kg_solution *solution);

#ifdef __cplusplus
}
#endif
#endif
