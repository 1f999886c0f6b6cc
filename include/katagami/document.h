/*
 * katagami: documents, whatever their mode, as the commands and the app see them.
 *
 * A document is a model file in memory. It answers what every mode can answer: what is wrong with
 * it, its net, its surface as a mesh, the reference mesh behind it.
 */
#ifndef KATAGAMI_DOCUMENT_H
#define KATAGAMI_DOCUMENT_H

#include "katagami/mesh.h"
#include "katagami/model.h"
#include "katagami/net.h"
#include "katagami/oa.h"
#include "katagami/origami.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Chord errors, mm: of nets (a fifth of the usual writing tolerance, as nets want it), and of
 * pictures and exported meshes, where a fiftieth of a millimetre cannot be seen. */
#define KG_NET_CHORD 0.002
#define KG_MESH_CHORD 0.02

typedef enum kg_document_kind {
    KG_DOCUMENT_PATCHES,
    KG_DOCUMENT_OA,
    KG_DOCUMENT_ORIGAMI
} kg_document_kind;

typedef struct kg_document kg_document;

/* Reads NAME.katagami of any mode, or a crease pattern (.fold, .cp), which is folded; "-" is
 * standard input (references are then looked for in the working directory). KG_ERR_IO,
 * KG_ERR_PARSE: the message names file and line; KG_ERR_INPUT, KG_ERR_CANCELLED: a pattern that
 * cannot be folded flat, or could not be in time. */
KG_API kg_status kg_document_read(const char *path, kg_document **out_document,
                                  kg_error *error) KG_CHECKED;
/* The same; `progress` (may be NULL) is told while the layers of a pattern are looked for, which
 * takes longest, and may end that: KG_ERR_CANCELLED. */
KG_API kg_status kg_document_read_reporting(const char *path, const kg_progress *progress,
                                            kg_document **out_document, kg_error *error) KG_CHECKED;

/* The same from memory, a model file of any mode; `name` is what messages call it, `path` (may be
 * NULL) where the file lies or will lie. `data` is zero-terminated behind `size`. */
KG_API kg_status kg_document_read_memory(const char *data, size_t size, const char *name,
                                         const char *path, kg_document **out_document,
                                         kg_error *error) KG_CHECKED;

/* Takes over a model, also on failure; `path` (may be NULL) is where its file lies or will lie.
 * KG_ERR_MEMORY. */
KG_API kg_status kg_document_from_model(kg_model *model, const char *path,
                                        kg_document **out_document, kg_error *error) KG_CHECKED;
KG_API kg_status kg_document_from_oa(kg_oa *oa, const char *path, kg_document **out_document,
                                     kg_error *error) KG_CHECKED;
KG_API kg_status kg_document_from_origami(kg_origami *origami, const char *path,
                                          kg_document **out_document, kg_error *error) KG_CHECKED;
KG_API void kg_document_destroy(kg_document *document);

/* Side lengths of new sheets, mm. */
#define KG_SHEET_LEAST 1.0
#define KG_SHEET_MOST 10000.0

/* An empty card of so many cells: width, depth, height. KG_ERR_INPUT: out of range. */
KG_API kg_status kg_document_new_card(const int size[3], double cell_mm, kg_document **out_document,
                                      kg_error *error) KG_CHECKED;
/* The side of a cell, mm, for such a card: at most 2.5, less where the sheet would leave an A4. */
KG_API double kg_document_card_cell(const int size[3]);
/* Makes the cells of a card so small that its sheet with its margin fits as well. */
KG_API void kg_document_card_fit(kg_oa *oa);
/* A rectangular sheet with its middle at the origin, not folded yet; colours as
 * 0xrrggbb. KG_ERR_INPUT: out of range. */
KG_API kg_status kg_document_new_sheet(kg_vec2 size, uint32_t front, uint32_t back,
                                       kg_document **out_document, kg_error *error) KG_CHECKED;

/* Writes the document's file, whole or not at all; from then on it lies there. A reference named
 * relative to the old place is named relative to the new one. */
KG_API kg_status kg_document_save(kg_document *document, const char *path,
                                  kg_error *error) KG_CHECKED;
/* Where its file lies; NULL: nowhere yet. */
KG_API const char *kg_document_path(const kg_document *document);
/* How a model file would name another file: relative to its own folder. Both must exist but for the
 * model file itself, else NULL. free() it. */
KG_API char *kg_document_relative(const char *model_path, const char *file);

KG_API kg_document_kind kg_document_get_kind(const kg_document *document);
KG_API const char *kg_document_title(const kg_document *document);
/* The model of a patch document, else NULL. */
KG_API kg_model *kg_document_model(const kg_document *document);
/* The card of a pop-up document, else NULL. */
KG_API kg_oa *kg_document_oa(const kg_document *document);
/* The sheets of an origami document, else NULL. */
KG_API kg_origami *kg_document_origami(const kg_document *document);
/* What is known of the layers of a crease pattern that was read; NULL for all others. */
KG_API const kg_layer_report *kg_document_layers(const kg_document *document);

/* ---- contents: what undo is made of ------------------------------------------------------ */

/* Another document of the same content and place, not solved. KG_ERR_MEMORY. */
KG_API kg_status kg_document_copy(const kg_document *document, kg_document **out_copy,
                                  kg_error *error) KG_CHECKED;
/* Whether two documents hold the same, wherever they lie. */
KG_API bool kg_document_equal(const kg_document *a, const kg_document *b);
/* Exchanges the contents of two documents of one kind, which then are to be solved. */
KG_API void kg_document_swap(kg_document *a, kg_document *b);
/* The text of its file, zero-terminated; free() it. */
KG_API kg_status kg_document_write_memory(const kg_document *document, char **out_text,
                                          size_t *out_size, kg_error *error) KG_CHECKED;
/* The file's object as it was read (NULL for none), whose unknown keys are written again. */
KG_API struct json_t **kg_document_json(kg_document *document);

/* ---- what follows from them -------------------------------------------------------------- */

/* Works out everything that follows from the model, with chord errors up to `chord` mm. Needed
 * before the calls below, and again after the model was changed; then only what changed is done
 * anew. Faults of the model are issues. KG_ERR_MEMORY. */
KG_API kg_status kg_document_solve(kg_document *document, double chord, kg_error *error) KG_CHECKED;
/* What follows from patches; NULL for other documents. */
KG_API const kg_solution *kg_document_solution(const kg_document *document);
/* What follows from a card; NULL for other documents. */
KG_API const kg_oa_sheet *kg_document_sheet(const kg_document *document);
KG_API const kg_oa_stability *kg_document_stability(const kg_document *document);
/* All remarks on a card, each with its place; the issues sum them up by trouble. */
KG_API const kg_oa_remarks *kg_document_remarks(const kg_document *document);

/* How far a card stands open in meshes and exports: the angle between its sheets, in [0, π];
 * standing (π/2) at first. Documents that do not fold take no notice. */
KG_API void kg_document_set_open(kg_document *document, double angle);
/* How many folds of an origami are done in meshes and exports; all of them at first. Other
 * documents take no notice. KG_ERR_INPUT: there are not so many. */
KG_API kg_status kg_document_set_step(kg_document *document, size_t step,
                                      kg_error *error) KG_CHECKED;
/* How far the fold after these is under way, in [0, 1]; 0 at first. */
KG_API void kg_document_set_fraction(kg_document *document, double fraction);

/* What is wrong, the same every time. */
KG_API size_t kg_document_issue_count(const kg_document *document);
KG_API const kg_issue *kg_document_issue(const kg_document *document, size_t index);
/* KG_OK, or KG_ERR_INPUT with the first fault and the file's name. */
KG_API kg_status kg_document_check(const kg_document *document, kg_error *error) KG_CHECKED;

/* How a document becomes parts. */
typedef struct kg_parts_options {
    double tab_width; /* mm at scale 1; 0: without tabs */
    kg_vec2 room; /* page without margins, mm at scale 1; parts that are larger are cut in two as
                     often as needed, none is merged beyond it. (0,0): no limit */
    bool merge;   /* make one part of all neighbours that can be folded from one sheet */
} kg_parts_options;

/* A net with its remarks. */
typedef struct kg_document_net {
    kg_net *net;
    kg_vec2 room; /* it was made for */
    size_t tab_count;
    size_t remark_count;
    kg_net_warning *remarks; /* issues of the model and of the tabs; owned, with their messages */
} kg_document_net;

/* The document's net at scale 1.
 *   tab_width  mm; 0: without tabs
 * KG_ERR_INPUT: the model has a fault. Faults of cards are remarks only: their nets can be drawn.
 */
KG_API kg_status kg_document_unroll(const kg_document *document, double tab_width,
                                    kg_document_net *out_net, kg_error *error) KG_CHECKED;
/* The same with all options: parts fit the room, neighbours that the model or the options want in
 * one piece are merged. */
KG_API kg_status kg_document_unroll_to_fit(const kg_document *document,
                                           const kg_parts_options *options,
                                           kg_document_net *out_net, kg_error *error) KG_CHECKED;
KG_API void kg_document_net_clear(kg_document_net *net);

/* What the document says of its net. */
KG_API kg_net_settings *kg_document_net_settings(kg_document *document);
/* Net options as the document asks for them; cards and sheets are one part that speaks for itself,
 * without tabs and without labels but where they are asked for. KG_ERR_INPUT: an unknown paper. */
KG_API kg_status kg_document_net_options(kg_document *document, kg_net_options *out_options,
                                         double *out_tab_width, kg_error *error) KG_CHECKED;
/* What the parts have to be at scale 1 so that they are as wished on the page. */
KG_API kg_parts_options kg_document_parts_options(kg_document *document,
                                                  const kg_net_options *options, double tab_width);
/* Chord error to solve with before the net is drawn: a fifth of the tolerance at the written size,
 * mm. */
KG_API double kg_document_net_chord(const kg_net_options *options);

/* The surface: one group per patch in document order, fronts outward, in their own colours, else
 * those of `color` (linear RGBA, by the patch's id less one; of cards by group; NULL: grey).
 * Constructions are left out. A card stands as
 * kg_oa_pose puts it, sheets are folded, a group each in the colour of its front. */
typedef void (*kg_group_color)(size_t group, float out_rgba[4]);
KG_API kg_status kg_document_mesh(const kg_document *document, kg_group_color color,
                                  kg_mesh **out_mesh, kg_error *error) KG_CHECKED;

/* Writes the surface as kg_mesh_write does; cards and sheets as glTF with their folding as an
 * animation (of sheets in the middle of a fold: without); a card with the ending .fold as its
 * crease pattern; sheets as .fold with all steps, as .cp their crease
 * pattern. */
KG_API kg_status kg_document_export(const kg_document *document, const char *path,
                                    kg_group_color color, kg_error *error) KG_CHECKED;

/* The reference mesh in model coordinates; NULL when the document has none. `progress` may be NULL.
 * Errors: as kg_mesh_read_reporting; KG_ERR_INPUT where it cannot be placed. */
KG_API kg_status kg_document_reference(const kg_document *document, const kg_progress *progress,
                                       kg_mesh **out_mesh, kg_error *error) KG_CHECKED;

#ifdef __cplusplus
}
#endif
#endif
