#include "guide/guide.h"

#include "guide/callout.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const kg_text heading = {KG_BOOK_HEADING, KG_INK, KG_ALIGN_LEFT, 1};
static const kg_text plain = {KG_BOOK_TEXT, KG_INK, KG_ALIGN_LEFT, 0};

/* Sizes of pictures, mm: how the part is glued, and what stands afterwards. */
#define PICTURE_HEIGHT 83.0
#define HEADING_GAP 1.5
#define LEFT_SHARE 0.6
#define ROW_INDENT 10.0
#define ROW_GAP 1.2
#define STEP_GAP 5.0

/* A part is bent to both sides when the wider bend is not this many times wider than the other. */
#define MUCH_WIDER 3.0

enum { FRAME = 0xccd3d9 }; /* colour */

typedef struct walk {
    kg_guide *guide;
    unsigned char *roles;
    bool *standing, *shaped; /* per part */
} walk;

/* ---- words ------------------------------------------------------------------------------ */

/* A line of a step's text, with a join's number in front of it or 0. */
typedef struct row {
    int number;
    char text[KG_SENTENCE];
} row;

typedef struct rows {
    row *items;
    size_t count;
} rows;

static row *add_row(rows *r, int number) {
    row *last = &r->items[r->count++];
    last->number = number;
    last->text[0] = 0;
    return last;
}

/* Which part, if any, bears a join's tabs. */
static int tabs_on(const kg_net *net, int join) {
    for (int side = 0; side < 2; side++) {
        const kg_net_part *part = &net->parts[net->joins[join].sides[side].part];
        for (size_t i = 0; i < part->line_count; i++)
            if (part->lines[i].tab > 0 && part->lines[i].join == join)
                return net->joins[join].sides[side].part;
    }
    return -1;
}

static void describe_join(const kg_guide *g, const kg_guide_step *step, int index, row *out) {
    char a[KG_SENTENCE / 2], b[KG_SENTENCE / 2], what[KG_SENTENCE], tabs[KG_SENTENCE];
    const kg_net_join *join = &g->net->joins[index];
    double length = join->sides[0].length * g->layout->scale;
    int p = join->sides[0].part, q = join->sides[1].part;
    kg_guide_part_name(g, p, a, sizeof a);
    kg_guide_part_name(g, q, b, sizeof b);
    if (p == q)
        kg_words(what, sizeof what, KG_WORD_OWN_SEAM, length);
    else if (join->kind == KG_JOIN_SEAM)
        kg_words(what, sizeof what, KG_WORD_SEAM, p == step->part ? b : a, length);
    else
        kg_words(what, sizeof what,
                 g->assembly->joins[index].inside ? KG_WORD_CONTACT_INSIDE : KG_WORD_CONTACT, a, b,
                 length);
    int bearer = tabs_on(g->net, index);
    if (bearer >= 0)
        kg_words(tabs, sizeof tabs, KG_WORD_TABS_ON,
                 kg_words(a, sizeof a, KG_WORD_PART, g->net->parts[bearer].number));
    else
        kg_words(tabs, sizeof tabs, KG_WORD_NO_TABS);
    kg_words(out->text, sizeof out->text, KG_WORD_AND, what, tabs);
}

static size_t count_folds(const kg_net_part *part) {
    size_t count = 0;
    for (size_t i = 0; i < part->line_count; i++)
        count += part->lines[i].tab == 0 &&
                 (part->lines[i].kind == KG_NET_MOUNTAIN || part->lines[i].kind == KG_NET_VALLEY);
    return count;
}

/* How the part is brought into shape before it is glued. */
static void describe_shape(const kg_guide *g, int part, rows *out) {
    const kg_assembly_part *shape = &g->assembly->parts[part];
    int page = g->layout->placements[part].page + 1;
    double inner = shape->radius_in * g->layout->scale,
           outer = shape->radius_out * g->layout->scale;
    double radius = fmax(fmin(inner, outer), 1);
    row *r = add_row(out, 0);
    /* mirrored pages are printed on the back */
    bool outwards = (outer <= inner) != g->options->mirrored;
    if (!isfinite(radius))
        kg_words(r->text, sizeof r->text, KG_WORD_FLAT, page);
    else if (fmax(inner, outer) < MUCH_WIDER * radius)
        kg_words(r->text, sizeof r->text, KG_WORD_ROLL_BOTH, radius, page);
    else
        kg_words(r->text, sizeof r->text, outwards ? KG_WORD_ROLL_OUT : KG_WORD_ROLL_IN, radius,
                 page);
    size_t folds = count_folds(&g->net->parts[part]);
    if (folds > 0) {
        r = add_row(out, 0);
        kg_words(r->text, sizeof r->text, KG_WORD_FOLDS, (int)folds);
    }
}

static void describe(walk *w, const kg_guide_step *step, rows *out) {
    const kg_guide *g = w->guide;
    if (step->kind == KG_STEP_PLACE)
        kg_words(add_row(out, 0)->text, KG_SENTENCE, KG_WORD_PLACE_TEXT);
    if (step->kind == KG_STEP_START && step->component > 0)
        kg_words(add_row(out, 0)->text, KG_SENTENCE, KG_WORD_SUBASSEMBLY);
    if (!w->shaped[step->part])
        describe_shape(g, step->part, out);
    w->shaped[step->part] = true;
    for (size_t i = 0; i < step->join_count; i++)
        describe_join(g, step, step->joins[i], add_row(out, g->net->joins[step->joins[i]].number));
    if (step->closing && step->join_count > 0) {
        int last = g->net->joins[step->joins[step->join_count - 1]].number;
        kg_words(add_row(out, 0)->text, KG_SENTENCE, step->seals ? KG_WORD_SEALS : KG_WORD_CLOSING,
                 last);
    }
}

static void print_heading(const kg_guide *g, const kg_guide_step *step, size_t index, char *out,
                          size_t size) {
    static const kg_word words[] = {[KG_STEP_START] = KG_WORD_START,
                                    [KG_STEP_OWN] = KG_WORD_OWN,
                                    [KG_STEP_ATTACH] = KG_WORD_ATTACH,
                                    [KG_STEP_CLOSE] = KG_WORD_CLOSE,
                                    [KG_STEP_PLACE] = KG_WORD_PLACE};
    char name[KG_SENTENCE / 2];
    kg_words(out, size, words[step->kind], (int)index + 1,
             kg_guide_part_name(g, step->part, name, sizeof name));
}

/* ---- pictures --------------------------------------------------------------------------- */

static void set_role(walk *w, const kg_guide_step *step, kg_role others) {
    const kg_guide *g = w->guide;
    for (size_t i = 0; i < g->net->part_count; i++) {
        int component = g->order->components[i];
        bool placed = step->kind == KG_STEP_PLACE;
        bool new = placed ? component == step->component : (int)i == step->part;
        bool stands =
            placed ? component < step->component : w->standing[i] && component == step->component;
        w->roles[i] = (unsigned char)(new ? KG_ROLE_NEW : stands ? KG_ROLE_STANDING : others);
    }
}

/* What the picture of gluing is about: the new part and its joins with some of what is around. */
static kg_box3 focus_of(const kg_guide *g, const kg_view_of *view) {
    kg_box3 all = kg_view_box(g->assembly, view, KG_ROLE_ABSENT);
    kg_box3 focus = kg_view_box(g->assembly, view, KG_ROLE_NEW);
    for (size_t i = 0; i < view->join_count; i++) {
        const kg_assembly_join *join = &g->assembly->joins[view->joins[i]];
        for (size_t k = 0; k < join->count; k++)
            kg_box3_add(&focus, join->points[k]);
    }
    double more = 0.35 * kg_box_size(focus);
    kg_vec3 grow = kg_v3(more, more, more);
    focus.lo = kg_sub(focus.lo, grow);
    focus.hi = kg_add(focus.hi, grow);
    return (kg_box3){
        kg_v3(fmax(focus.lo.x, all.lo.x), fmax(focus.lo.y, all.lo.y), fmax(focus.lo.z, all.lo.z)),
        kg_v3(fmin(focus.hi.x, all.hi.x), fmin(focus.hi.y, all.hi.y), fmin(focus.hi.z, all.hi.z))};
}

static kg_status add_pictures(walk *w, const kg_guide_step *step, kg_error *error) {
    kg_guide *g = w->guide;
    kg_book *paper = g->paper;
    double width = kg_book_width(paper);
    kg_vec2 at = kg_v2(KG_BOOK_MARGIN, paper->y);
    kg_vec2 size = kg_v2(LEFT_SHARE * width - 2, PICTURE_HEIGHT);
    kg_sight *sight;
    set_role(w, step, KG_ROLE_ABSENT);
    kg_view_of view = {.roles = w->roles, .joins = step->joins, .join_count = step->join_count};
    if (step->kind == KG_STEP_ATTACH)
        view.offset = kg_view_offset(g->assembly, step->part, step->joins, step->join_count);
    kg_status status = kg_sight_create(g->assembly, &view, &sight, error);
    if (status)
        return status;
    kg_camera camera = kg_camera_default();
    camera.ortho = true;
    kg_sight_aim(sight, &camera);
    kg_camera_fit(&camera, focus_of(g, &view), size.x / size.y);
    status = kg_guide_picture(g, &view, KG_LOOK_STEP, &camera, at, size, error);
    if (!status) {
        kg_callouts_draw(g, &view, sight, &camera, at, size);
        cairo_rectangle(paper->cr, at.x, at.y, size.x, size.y);
        kg_book_color(paper, FRAME);
        cairo_set_line_width(paper->cr, 0.2);
        cairo_stroke(paper->cr);
    }
    kg_sight_destroy(sight);
    if (status)
        return status;

    /* beside it the place in the whole, or what stands now */
    bool alone = step->kind == KG_STEP_START || step->kind == KG_STEP_OWN;
    set_role(w, step, alone ? KG_ROLE_STANDING : KG_ROLE_ABSENT);
    kg_view_of result = {.roles = w->roles};
    at.x += size.x + 4;
    size.x = width - size.x - 4;
    kg_camera_fit(&camera, kg_view_box(g->assembly, &result, KG_ROLE_ABSENT), size.x / size.y);
    return kg_guide_picture(g, &result, KG_LOOK_STEP, &camera, at, size, error);
}

/* ---- steps ------------------------------------------------------------------------------ */

static double row_width(const kg_book *paper, const row *r) {
    return kg_book_width(paper) - (r->number > 0 ? ROW_INDENT : 0);
}

/* With the gap behind it; badges of rows on each other do not touch. */
static double row_height(const kg_book *paper, const row *r) {
    double height = kg_book_text_height(paper, &plain, row_width(paper, r), r->text) + ROW_GAP;
    return r->number > 0 ? fmax(height, 2 * kg_book_badge_half(r->number).y + 0.6) : height;
}

static kg_status add_step(walk *w, size_t index, rows *text, kg_error *error) {
    kg_book *paper = w->guide->paper;
    const kg_guide_step *step = &w->guide->order->steps[index];
    char title[KG_SENTENCE];
    text->count = 0;
    describe(w, step, text);
    print_heading(w->guide, step, index, title, sizeof title);
    double height = KG_BOOK_HEADING * 1.4 + HEADING_GAP + PICTURE_HEIGHT + 1;
    for (size_t i = 0; i < text->count; i++)
        height += row_height(paper, &text->items[i]);
    kg_book_need(paper, fmin(height, kg_book_bottom(paper) - KG_BOOK_MARGIN));
    kg_book_write(paper, &heading, title);
    paper->y += HEADING_GAP;
    kg_status status = add_pictures(w, step, error);
    paper->y += PICTURE_HEIGHT + 1;
    for (size_t i = 0; i < text->count; i++) {
        const row *r = &text->items[i];
        double wide = row_width(paper, r), x = KG_BOOK_MARGIN + kg_book_width(paper) - wide;
        kg_book_need(paper, row_height(paper, r));
        if (r->number > 0)
            kg_book_join_badge(paper, KG_BOOK_MARGIN + 4, paper->y + 2.6, r->number);
        kg_book_text(paper, &plain, x, paper->y, wide, r->text);
        paper->y += row_height(paper, r);
    }
    paper->y += STEP_GAP;
    if (step->kind == KG_STEP_START || step->kind == KG_STEP_ATTACH)
        w->standing[step->part] = true;
    return status;
}

kg_status kg_guide_steps(kg_guide *g, kg_error *error) {
    size_t parts = g->net->part_count + 1;
    walk w = {.guide = g,
              .roles = calloc(parts, sizeof *w.roles),
              .standing = calloc(parts, sizeof *w.standing),
              .shaped = calloc(parts, sizeof *w.shaped)};
    /* a row for each join; sub-assembly, shape, folds, advice */
    rows text = {.items = calloc(g->net->join_count + 4, sizeof *text.items)};
    kg_status status = KG_OK;
    if (!w.roles || !w.standing || !w.shaped || !text.items)
        status = kg_fail(error, KG_ERR_MEMORY, "out of memory");
    for (size_t i = 0; i < g->order->step_count && !status; i++) {
        status = add_step(&w, i, &text, error);
        if (!status)
            status = kg_guide_tick(g, (double)(i + 1) / (double)g->order->step_count, error);
    }
    free(w.roles);
    free(w.standing);
    free(w.shaped);
    free(text.items);
    return status;
}
