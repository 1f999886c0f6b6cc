#include "app/modes/sheet_thumbs.h"

#include "app/modes/sheet_scene.h"
#include "base/array.h"

#include <stdlib.h>

enum { MOST_A_FRAME = 2 };

/* From above and a little from the front, so that raised parts show. */
#define YAW (-0.25)
#define PITCH 1.05

typedef struct thumb {
    const kg_origami_state *state; /* of the origami shown, which keeps it alive */
    uint32_t picture;
} thumb;

struct kg_sheet_thumbs {
    struct {
        thumb *items;
        size_t count, capacity;
    } made;
    int width, height; /* pixels */
    uint64_t colors;   /* of all sheets */
    int made_now;      /* in this frame */
    bool wanting;
};

static void drop_all(struct kg_sheet_thumbs *t) {
    for (size_t i = 0; i < t->made.count; i++)
        kg_ui_picture_destroy(t->made.items[i].picture);
    t->made.count = 0;
}

void kg_sheet_thumbs_destroy(struct kg_sheet_thumbs *t) {
    if (!t)
        return;
    drop_all(t);
    free(t->made.items);
    free(t);
}

static uint64_t colors_of(const kg_origami *o) {
    uint64_t hash = kg_origami_sheet_count(o);
    for (size_t i = 0; i < kg_origami_sheet_count(o); i++) {
        const kg_paper_sheet *s = kg_origami_sheet(o, i);
        hash = (hash ^ s->front) * 1099511628211u;
        hash = (hash ^ s->back) * 1099511628211u;
    }
    return hash;
}

static bool has_state(const kg_origami *o, const kg_origami_state *state) {
    for (size_t i = 0; i <= kg_origami_fold_count(o); i++)
        if (kg_origami_state_at(o, i) == state)
            return true;
    return false;
}

void kg_sheet_thumbs_follow(kg_sheets *s) {
    struct kg_sheet_thumbs *t = s->thumbs;
    size_t kept = 0;
    if (!t)
        return;
    if (t->colors != colors_of(s->origami))
        drop_all(t);
    t->colors = colors_of(s->origami);
    for (size_t i = 0; i < t->made.count; i++) {
        if (has_state(s->origami, t->made.items[i].state))
            t->made.items[kept++] = t->made.items[i];
        else
            kg_ui_picture_destroy(t->made.items[i].picture);
    }
    t->made.count = kept;
}

bool kg_sheet_thumbs_tick(kg_sheets *s) {
    struct kg_sheet_thumbs *t = s->thumbs;
    bool wanting = t && t->wanting;
    if (t) {
        t->made_now = 0;
        t->wanting = false;
    }
    return wanting;
}

/* 0 when it cannot be drawn. */
static uint32_t make(const kg_sheets *s, kg_scenery *stage, size_t step, int width, int height) {
    kg_sheets shown;
    kg_overlay overlay = {0};
    kg_image image;
    uint32_t picture = 0;
    kg_camera camera = kg_camera_default();
    if (kg_sheets_snapshot(s, step, &shown)) {
        kg_box3 box = kg_box3_empty();
        for (size_t h = 0; h < shown.state->halves.count; h++)
            if (shown.state->halves.items[h].loop >= 0)
                kg_box3_add(&box, shown.drawn[h]);
        camera.yaw = YAW;
        camera.pitch = PITCH;
        camera.ortho = true;
        kg_camera_fit(&camera, box, (double)width / height);
        kg_sheet_scene_plain(&shown, &overlay);
        if (!kg_scenery_thumbnail(stage, &overlay, &camera, width, height, &image, NULL)) {
            picture = kg_ui_picture_create(&image);
            kg_image_destroy(&image);
        }
    }
    kg_overlay_clear(&overlay);
    kg_sheets_snapshot_clear(&shown);
    return picture;
}

uint32_t kg_sheet_thumb(kg_sheets *s, kg_scenery *stage, size_t step, int width, int height) {
    if (!s->thumbs && !(s->thumbs = calloc(1, sizeof *s->thumbs)))
        return 0;
    struct kg_sheet_thumbs *t = s->thumbs;
    if (t->width != width || t->height != height)
        drop_all(t);
    t->width = width;
    t->height = height;
    t->colors = colors_of(s->origami);
    thumb fresh = {kg_origami_state_at(s->origami, step), 0};
    for (size_t i = 0; i < t->made.count; i++)
        if (t->made.items[i].state == fresh.state)
            return t->made.items[i].picture;
    if (t->made_now >= MOST_A_FRAME) {
        t->wanting = true;
        return 0;
    }
    t->made_now++;
    fresh.picture = make(s, stage, step, width, height);
    if (!kg_push(&t->made, fresh)) {
        kg_ui_picture_destroy(fresh.picture);
        return 0;
    }
    t->wanting = true; /* to be shown */
    return fresh.picture;
}
