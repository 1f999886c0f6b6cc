#include "app/modes/sheet_expect.h"

#include "app/expect.h"
#include "app/modes/sheet_edit.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static kg_status expect_number(const char *what, double is, const char *words, kg_error *error) {
    double wanted, slack = KG_EXPECT_SLACK;
    if (sscanf(words, "%lf %lf", &wanted, &slack) < 1)
        return kg_fail(error, KG_ERR_INPUT, "%s needs a number", what);
    return fabs(is - wanted) <= slack
               ? KG_OK
               : kg_fail(error, KG_ERR_INPUT, "%s: %.9g, not %.9g", what, is, wanted);
}

/* X Y Z [TOLERANCE]: a vertex of what is shown is there. */
static kg_status expect_vertex(const kg_sheets *s, const char *words, kg_error *error) {
    kg_vec3 p;
    double slack = KG_EXPECT_SLACK, nearest = INFINITY;
    if (sscanf(words, "%lf %lf %lf %lf", &p.x, &p.y, &p.z, &slack) < 3)
        return kg_fail(error, KG_ERR_INPUT, "vertex needs X Y Z [TOLERANCE]");
    for (size_t i = 0; s->state && i < s->state->vertices.count; i++)
        nearest = fmin(nearest, kg_dist(s->positions[i], p));
    return nearest <= slack
               ? KG_OK
               : kg_fail(error, KG_ERR_INPUT, "the nearest vertex is %.6g mm away", nearest);
}

/* SHEET X Y [TOLERANCE]: the middle of a sheet, numbers from 1. */
static kg_status expect_middle(const kg_sheets *s, const char *words, kg_error *error) {
    size_t number;
    kg_vec2 p;
    double slack = KG_EXPECT_SLACK;
    if (sscanf(words, "%zu %lf %lf %lf", &number, &p.x, &p.y, &slack) < 3)
        return kg_fail(error, KG_ERR_INPUT, "middle needs SHEET X Y [TOLERANCE]");
    if (number < 1 || number > kg_origami_sheet_count(s->origami))
        return kg_fail(error, KG_ERR_INPUT, "there is no sheet %zu", number);
    kg_vec2 is = kg_sheet_middle(kg_origami_sheet(s->origami, number - 1));
    return kg_dist2(is, p) <= slack
               ? KG_OK
               : kg_fail(error, KG_ERR_INPUT, "its middle is at %.9g %.9g", is.x, is.y);
}

/* SHEET #rrggbb #rrggbb */
static kg_status expect_colors(const kg_sheets *s, const char *words, kg_error *error) {
    int sheet;
    unsigned front, back;
    uint32_t is[2];
    if (sscanf(words, "%d #%6x #%6x", &sheet, &front, &back) != 3)
        return kg_fail(error, KG_ERR_INPUT, "colours needs SHEET #rrggbb #rrggbb");
    kg_origami_colors(s->origami, sheet - 1, &is[0], &is[1]);
    return is[0] == front && is[1] == back
               ? KG_OK
               : kg_fail(error, KG_ERR_INPUT, "they are #%06x #%06x", is[0], is[1]);
}

kg_status kg_sheet_expect(const kg_editor *e, const char *w, kg_error *error) {
    const kg_sheets *s = kg_sheets_of(e);
    if (kg_expect_begins(&w, "folds"))
        return kg_expect_count("folds", kg_origami_step(s->origami), w, error);
    if (kg_expect_begins(&w, "later folds"))
        return kg_expect_count("later folds",
                               kg_origami_fold_count(s->origami) - kg_origami_step(s->origami), w,
                               error);
    if (kg_expect_begins(&w, "step"))
        return kg_expect_count("step", s->step, w, error);
    if (kg_expect_begins(&w, "fraction"))
        return expect_number("fraction", s->fraction, w, error);
    if (kg_expect_begins(&w, "playing"))
        return kg_expect_yes(s->playing, strcmp(w, "no") != 0, "playing", error);
    if (kg_expect_begins(&w, "faces"))
        return kg_expect_count("faces", s->state ? s->state->loops.count : 0, w, error);
    if (kg_expect_begins(&w, "sheets"))
        return kg_expect_count("sheets", kg_sheets_count(s), w, error);
    if (kg_expect_begins(&w, "sheet"))
        return kg_expect_count("selected sheet", (size_t)(s->sheet + 1), w, error);
    if (kg_expect_begins(&w, "middle"))
        return expect_middle(s, w, error);
    if (kg_expect_begins(&w, "colours"))
        return expect_colors(s, w, error);
    if (kg_expect_begins(&w, "vertex"))
        return expect_vertex(s, w, error);
    if (kg_expect_begins(&w, "spread"))
        return expect_number("spread", s->spread, w, error);
    if (kg_expect_begins(&w, "opacity"))
        return expect_number("opacity", s->opacity, w, error);
    return kg_expect_unknown(w, error);
}
