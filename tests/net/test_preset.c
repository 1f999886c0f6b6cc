#include "tests/net/leaks.h"
#include "tests/net/sample.h"

#include "base/file.h"
#include "net/badge.h"
#include "net/drawing.h"
#include "net/layout.h"
#include "net/perforation.h"
#include "net/sheet.h"
#include "net/space.h"
#include "net/text.h"

#include <unistd.h>

static char *written(const kg_net *net, const kg_net_options *options, const char *name) {
    char *text;
    size_t size;
    kg_error error;
    if (kg_net_write(net, options, NULL, sample_path(name), NULL, &error))
        fail_msg("%s", error.message);
    if (access(sample_path(name), F_OK) != 0)
        return NULL;
    assert_int_equal(kg_file_read(sample_path(name), &text, &size, NULL), KG_OK);
    return text;
}

static void cutters_get_text_as_filled_paths(void **state) {
    (void)state;
    kg_net *net = sample_net(2);
    for (int preset = KG_PRESET_LASER; preset <= KG_PRESET_CRICUT; preset++) {
        kg_net_options options = kg_net_options_default();
        kg_net_options_preset(&options, (kg_net_preset)preset);
        options.paper = kg_v2(297, 420);
        char *text = written(net, &options, "preset.svg");
        assert_non_null(text);
        assert_null(strstr(text, "<text"));
        assert_non_null(strstr(text, "id=\"label\""));
        assert_true((strstr(text, "stroke=\"#ff0000\"") != NULL) == (preset == KG_PRESET_LASER));
        assert_true((strstr(text, "id=\"guide\"") != NULL) == (preset == KG_PRESET_SILHOUETTE));
        free(text);
    }
    kg_net_destroy(net);
}

static void print_and_cut_go_to_files_of_their_own(void **state) {
    (void)state;
    kg_net *net = sample_net(2);
    kg_net_options options = kg_net_options_default();
    options.separate = true;
    assert_null(written(net, &options, "two.svg"));
    char *text;
    size_t size;
    assert_int_equal(kg_file_read(sample_path("two-print.svg"), &text, &size, NULL), KG_OK);
    assert_null(strstr(text, "id=\"cut\""));
    assert_non_null(strstr(text, "id=\"mountain\""));
    free(text);
    assert_int_equal(kg_file_read(sample_path("two-cut.svg"), &text, &size, NULL), KG_OK);
    assert_non_null(strstr(text, "id=\"cut\""));
    assert_null(strstr(text, "id=\"mark\""));
    free(text);
    kg_net_destroy(net);
}

static kg_drawing *drawn(const kg_net *net, const kg_net_options *options) {
    kg_net_layout *layout;
    kg_drawing *drawing;
    assert_int_equal(kg_net_layout_create(net, options, NULL, &layout, NULL), KG_OK);
    assert_int_equal(kg_drawing_create(net, layout, options, true, &drawing, NULL), KG_OK);
    kg_net_layout_destroy(layout);
    return drawing;
}

/* Registration marks lie in the corners; nothing of a part comes nearer to them than the gap. */
static void parts_keep_clear_of_registration_marks(void **state) {
    (void)state;
    kg_net *net = sample_net(12);
    for (int kind = 0; kind < 4; kind++) {
        kg_net_options options = kg_net_options_default();
        kg_net_options_preset(&options, KG_PRESET_SILHOUETTE);
        options.mirrored = kind % 2 == 1;
        options.nest = kind >= 2;
        kg_drawing *d = drawn(net, &options);
        for (size_t i = 0; i < d->page_count; i++) {
            kg_space space;
            assert_true(kg_space_create(&d->pages[i], (kg_box2){{0, 0}, d->size}, &space));
            /* Corners of the marks' boxes: square, angle's legs. */
            const double w = 210, h = 297, m = 8;
            const kg_block marks[] = {{{m + 2.5, m + 2.5}, {2.5, 2.5}, 0},
                                      {{w - m - 10, m + 0.25}, {10, 0.25}, 0},
                                      {{w - m - 0.25, m + 10}, {0.25, 10}, 0},
                                      {{m + 0.25, h - m - 10}, {0.25, 10}, 0},
                                      {{m + 10, h - m - 0.25}, {10, 0.25}, 0}};
            for (size_t k = 0; k < sizeof marks / sizeof *marks; k++) {
                assert_true(kg_space_blocked(&space, 0, &marks[k])); /* the mark itself */
                for (size_t p = 0; p < net->part_count; p++)
                    assert_false(kg_space_blocked(&space, net->parts[p].number, &marks[k]));
            }
            kg_space_clear(&space);
        }
        kg_drawing_destroy(d);
    }
    kg_net_destroy(net);
}

static void mirrored_pages_exchange_folds_and_keep_text_readable(void **state) {
    (void)state;
    kg_net *net = sample_net(3);
    kg_net_options options = kg_net_options_default();
    kg_drawing *front = drawn(net, &options);
    options.mirrored = true;
    kg_drawing *back = drawn(net, &options);
    const kg_page *a = &front->pages[0], *b = &back->pages[0];
    assert_int_equal(a->strokes.count, b->strokes.count);
    for (size_t i = 0; i < a->strokes.count; i++) {
        const kg_stroke *s = &a->strokes.items[i], *t = &b->strokes.items[i];
        if (s->layer == KG_LAYER_GUIDE)
            continue;
        if (s->layer == KG_LAYER_MOUNTAIN)
            assert_int_equal(t->layer, KG_LAYER_VALLEY);
        assert_near(s->path.items[0].p[0].x + t->path.items[0].p[0].x, 210, 1e-9);
        assert_near(s->path.items[0].p[0].y, t->path.items[0].p[0].y, 1e-9);
    }
    for (size_t i = 0; i < b->captions.count; i++)
        assert_true(fabs(b->captions.items[i].angle) <= KG_PI / 2 + 1e-6);
    kg_drawing_destroy(front);
    kg_drawing_destroy(back);
    kg_net_destroy(net);
}

/* With its frame and underline. */
static kg_block block_of(const kg_caption *caption) {
    return (kg_block){caption->center, kg_badge_half(caption), caption->angle};
}

/* The space between all lines of a page but the labels' own frames, underlines and leaders. */
static void space_without_labels(const kg_page *page, kg_vec2 size, kg_space *out_space) {
    kg_page bare = {.strokes.items = calloc(page->strokes.count + 1, sizeof(kg_stroke))};
    assert_non_null(bare.strokes.items);
    for (size_t i = 0; i < page->strokes.count; i++)
        if (page->strokes.items[i].layer != KG_LAYER_LABEL)
            bare.strokes.items[bare.strokes.count++] = page->strokes.items[i];
    assert_true(kg_space_create(&bare, (kg_box2){{0, 0}, size}, out_space));
    free(bare.strokes.items);
}

/* Every part has its number in a box, every join shows in a ring on both sides, and no label with
 * its frame lies on a line of the part or on another label, no text on any line at all. */
static void labels_are_complete_and_lie_on_nothing(void **state) {
    (void)state;
    for (int extra = 0; extra < 12; extra++) {
        kg_net *net = sample_net(extra);
        for (int i = 0; i + 1 < extra; i++) {
            kg_net_join join = {
                .sides = {{.part = 2 + i, .loop = 0, .first = 0, .count = 121, .line = -1},
                          {.part = 3 + i, .loop = 0, .first = 120, .count = 121, .line = -1}}};
            assert_int_equal(kg_net_add_join(net, &join, NULL, NULL), KG_OK);
        }
        kg_net_options options = kg_net_options_default();
        options.labels = extra % 3 == 2 ? KG_LABELS_OUTSIDE : KG_LABELS_INSIDE;
        options.nest = extra % 2 == 1;
        options.scale = 1 - 0.04 * extra;
        kg_drawing *d = drawn(net, &options);
        size_t boxes = 0, rings = 0, names = 0;
        for (size_t i = 0; i < d->page_count; i++) {
            const kg_captions *all = &d->pages[i].captions;
            kg_space space, lines;
            assert_true(kg_space_create(&d->pages[i], (kg_box2){{0, 0}, d->size}, &space));
            space_without_labels(&d->pages[i], d->size, &lines);
            for (size_t k = 0; k < all->count; k++) {
                const kg_caption *c = &all->items[k];
                kg_block block = block_of(c), text = {c->center, kg_caption_half(c), c->angle};
                boxes += c->frame == KG_FRAME_BOX;
                rings += c->frame == KG_FRAME_RING;
                names += c->layer == KG_LAYER_LABEL && c->frame == KG_FRAME_NONE;
                assert_true(kg_space_holds(&space, &block));
                assert_false(kg_space_blocked(&lines, 0, &block));
                assert_false(kg_space_blocked(&space, 0, &text));
                for (size_t j = 0; j < k; j++) {
                    kg_block other = block_of(&all->items[j]);
                    assert_false(kg_blocks_overlap(&block, &other));
                }
                assert_true(all->items[k].capital >= 1.7);
            }
            kg_space_clear(&space);
            kg_space_clear(&lines);
        }
        assert_int_equal(boxes, net->part_count);
        assert_int_equal(rings, 2 * net->join_count);
        assert_true(names <= net->part_count);
        kg_drawing_destroy(d);
        kg_net_destroy(net);
    }
}

/* A box, a ring of one digit and one of three: each lies around its number, closed, as far out as
 * kg_badge_half says, and leaders end on it. */
static void frames_lie_around_their_numbers(void **state) {
    (void)state;
    char *texts[] = {"8", "8", "187", "6", "12 尾 y"};
    const kg_frame frames[] = {KG_FRAME_BOX, KG_FRAME_RING, KG_FRAME_RING, KG_FRAME_RING,
                               KG_FRAME_BOX};
    for (int n = 0; n < 5; n++) {
        kg_page page = {0};
        kg_caption caption = {KG_LAYER_LABEL, frames[n], 1, 1, {30, 40}, 0.7, 2.2, 0, texts[n]};
        kg_net_part part = {.number = 1};
        assert_true(kg_badge_draw(&page, &caption, &part));
        assert_int_equal(page.captions.count, n == 4 ? 2 : 1);
        const kg_caption *c = &page.captions.items[0];
        kg_vec2 half = kg_badge_half(c), text = kg_caption_half(c), along = {cos(0.7), sin(0.7)};
        const kg_path *path = &page.strokes.items[0].path;
        assert_int_equal(page.strokes.items[0].part, 1);
        assert_int_equal(path->items[path->count - 1].verb, KG_PATH_CLOSE);
        double far_x = 0, far_y = 0;
        kg_vec2 at = {0, 0};
        for (size_t i = 0; i + 1 < path->count; i++) {
            const kg_path_step *s = &path->items[i];
            kg_vec2 b[4] = {at, s->p[0], s->p[1], s->p[2]};
            for (int k = 1; k <= 64; k++) {
                kg_vec2 q = s->verb == KG_PATH_CURVE  ? kg_bezier2(b, k / 64.0)
                            : s->verb == KG_PATH_LINE ? kg_lerp2(at, s->p[0], k / 64.0)
                                                      : s->p[0];
                kg_vec2 d = kg_sub2(q, c->center);
                kg_vec2 own = kg_v2(kg_dot2(d, along), kg_cross2(along, d));
                far_x = fmax(far_x, fabs(own.x));
                far_y = fmax(far_y, fabs(own.y));
                /* The digits themselves: their box is on the generous side. */
                assert_true(fabs(own.x) > 0.86 * text.x + 0.1 || fabs(own.y) > text.y + 0.1);
                double reach = kg_badge_reach(c, kg_scale2(own, 1 / kg_len2(own)));
                assert_near(kg_len2(own), reach, 0.002);
            }
            at = kg_path_end(s);
        }
        assert_near(far_x, half.x, 0.002);
        assert_near(far_y, half.y, 0.002);
        if (n == 4) {
            const kg_caption *name = &page.captions.items[1];
            kg_block box = block_of(c), beside = block_of(name);
            assert_string_equal(c->text, "12");
            assert_string_equal(name->text, "尾 y");
            assert_int_equal(name->align, KG_CAPTION_START);
            assert_false(kg_blocks_overlap(&box, &beside));
            kg_vec2 whole = kg_badge_half(&caption), to = kg_caption_anchor(name);
            assert_near(kg_dist2(c->center, caption.center), whole.x - half.x, 1e-9);
            assert_near(kg_dist2(to, c->center), half.x + 0.8, 1e-9);
        }
        for (size_t i = 0; i < page.strokes.count; i++)
            kg_path_clear(&page.strokes.items[i].path);
        for (size_t i = 0; i < page.captions.count; i++)
            free(page.captions.items[i].text);
        free(page.strokes.items);
        free(page.captions.items);
    }
}

/* What is cut along the edge of the usable area is no part of the page frame, nor it of a cut. */
static void the_page_frame_keeps_off_the_parts(void **state) {
    (void)state;
    const double margins[] = {8, 1, 0.4};
    kg_net *net = sample_net(0);
    for (int n = 0; n < 3; n++) {
        kg_net_options options = kg_net_options_default();
        options.margin = margins[n];
        kg_drawing *d = drawn(net, &options);
        const kg_stroke *frame = NULL;
        for (size_t i = 0; i < d->pages[0].strokes.count && !frame; i++)
            if (d->pages[0].strokes.items[i].layer == KG_LAYER_GUIDE)
                frame = &d->pages[0].strokes.items[i];
        assert_non_null(frame);
        kg_vec2 corner = frame->path.items[0].p[0];
        double outside = n == 0 ? 1 : margins[n] / 2;
        assert_near(corner.x, margins[n] - outside, 1e-12);
        assert_near(corner.y, margins[n] - outside, 1e-12);
        kg_drawing_destroy(d);
    }
    kg_net_destroy(net);
}

/* Open strokes of the label layer on the page of a small sheet whose part has this number. */
static int underlines(int number) {
    kg_net *net = kg_net_create();
    size_t part;
    const kg_vec2 sheet[] = {{0, 0}, {30, 0}, {30, 20}, {0, 20}};
    assert_int_equal(kg_net_add_part(net, 1, "", &part, NULL), KG_OK);
    assert_int_equal(kg_net_add_loop(net, part, sheet, NULL, 4, NULL), KG_OK);
    net->parts[0].number = number;
    kg_net_options options = kg_net_options_default();
    kg_drawing *d = drawn(net, &options);
    int count = 0;
    for (size_t i = 0; i < d->pages[0].strokes.count; i++) {
        const kg_stroke *s = &d->pages[0].strokes.items[i];
        count +=
            s->layer == KG_LAYER_LABEL && s->path.items[s->path.count - 1].verb != KG_PATH_CLOSE;
    }
    kg_drawing_destroy(d);
    kg_net_destroy(net);
    return count;
}

static void numbers_that_read_upside_down_are_underlined(void **state) {
    (void)state;
    const int doubtful[] = {6, 9, 16, 91, 99, 106}, plain[] = {1, 8, 10, 26, 39, 67};
    for (int i = 0; i < 6; i++) {
        assert_int_equal(underlines(doubtful[i]), 1);
        assert_int_equal(underlines(plain[i]), 0);
    }
}

static void a_part_too_small_for_its_number_gets_a_leader(void **state) {
    (void)state;
    kg_net *net = kg_net_create();
    size_t part;
    const kg_vec2 sliver[] = {{0, 0}, {60, 0}, {60, 1.5}, {0, 1.5}};
    assert_int_equal(kg_net_add_part(net, 1, "尾", &part, NULL), KG_OK);
    assert_int_equal(kg_net_add_loop(net, part, sliver, NULL, 4, NULL), KG_OK);
    kg_net_options options = kg_net_options_default();
    options.frame = false;
    kg_drawing *d = drawn(net, &options);
    const kg_page *page = &d->pages[0];
    assert_int_equal(page->captions.count, 2);
    assert_string_equal(page->captions.items[0].text, "1");
    assert_string_equal(page->captions.items[1].text, "尾");
    assert_int_equal(page->strokes.count, 3); /* the sliver, the box, the leader */
    assert_int_equal(page->strokes.items[2].layer, KG_LAYER_LABEL);
    kg_drawing_destroy(d);
    kg_net_destroy(net);
}

/* Length of a path by flattening. */
static double path_length(const kg_path *path, int *out_pieces) {
    double sum = 0;
    kg_vec2 at = {0, 0};
    for (size_t i = 0; i < path->count; i++) {
        const kg_path_step *s = &path->items[i];
        *out_pieces += s->verb == KG_PATH_MOVE;
        kg_vec2 b[4] = {at, s->p[0], s->p[1], s->p[2]};
        kg_vec2 from = at;
        for (int k = 1; s->verb == KG_PATH_CURVE && k <= 500; k++) {
            kg_vec2 q = kg_bezier2(b, k / 500.0);
            sum += kg_dist2(from, q);
            from = q;
        }
        if (s->verb == KG_PATH_LINE)
            sum += kg_dist2(at, s->p[0]);
        at = kg_path_end(s);
    }
    return sum;
}

static void dashes_and_gaps_add_up(void **state) {
    (void)state;
    kg_random random = {5};
    for (int n = 0; n < 200; n++) {
        kg_path path = {0}, dashes = {0};
        kg_vec2 p[4];
        for (int i = 0; i < 4; i++)
            p[i] = kg_v2(15 * i + kg_random_in(&random, -4, 4), kg_random_in(&random, -12, 12));
        assert_true(kg_path_move(&path, p[0]) && kg_path_curve(&path, p[1], p[2], p[3]) &&
                    kg_path_line(&path, kg_v2(60, 60)));
        double dash = kg_random_in(&random, 0.5, 8), gap = kg_random_in(&random, 0.3, 4);
        assert_true(kg_path_dashes(&path, dash, gap, &dashes));
        int whole = 0, pieces = 0;
        double total = path_length(&path, &whole), inked = path_length(&dashes, &pieces);
        assert_near(total - inked, gap * (pieces - 1), 1e-3);
        assert_true(kg_dist2(dashes.items[0].p[0], p[0]) < 1e-6);
        assert_true(kg_dist2(kg_path_end(&dashes.items[dashes.count - 1]), kg_v2(60, 60)) < 1e-6);
        kg_path_clear(&path);
        kg_path_clear(&dashes);
    }
}

static void presets_and_words_are_parsed(void **state) {
    (void)state;
    kg_net_preset preset;
    assert_int_equal(kg_net_preset_parse("cricut", &preset, NULL), KG_OK);
    assert_int_equal(preset, KG_PRESET_CRICUT);
    kg_error error;
    assert_int_equal(kg_net_preset_parse("plotter", &preset, &error), KG_ERR_INPUT);
    assert_non_null(strstr(error.message, "silhouette"));
    kg_net_options options = kg_net_options_default();
    kg_net_options_preset(&options, KG_PRESET_CRICUT);
    assert_near(options.paper.x, 171.45, 1e-9);
    assert_near(options.paper.y, 234.95, 1e-9);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cutters_get_text_as_filled_paths),
        cmocka_unit_test(print_and_cut_go_to_files_of_their_own),
        cmocka_unit_test(parts_keep_clear_of_registration_marks),
        cmocka_unit_test(mirrored_pages_exchange_folds_and_keep_text_readable),
        cmocka_unit_test(labels_are_complete_and_lie_on_nothing),
        cmocka_unit_test(frames_lie_around_their_numbers),
        cmocka_unit_test(the_page_frame_keeps_off_the_parts),
        cmocka_unit_test(numbers_that_read_upside_down_are_underlined),
        cmocka_unit_test(a_part_too_small_for_its_number_gets_a_leader),
        cmocka_unit_test(dashes_and_gaps_add_up),
        cmocka_unit_test(presets_and_words_are_parsed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
