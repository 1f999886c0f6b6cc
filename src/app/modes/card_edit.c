#include "app/modes/card_edit.h"

#include "app/text.h"

#include <stdlib.h>
#include <string.h>

static int mirrored(const kg_oa *oa, int x) {
    return oa->width - 1 - x;
}

/* Of a card of the same size. */
static void copy_cells(kg_oa *to, const kg_oa *from) {
    size_t columns = (size_t)to->width, levels = (size_t)to->height;
    memcpy(to->depth, from->depth, columns * levels * sizeof *to->depth);
    memcpy(to->window, from->window, columns * levels);
    memcpy(to->omitted, from->omitted, columns * (levels + 1));
}

static bool is_symmetric(const kg_editor *e) {
    return kg_card_state_of(e)->symmetric;
}

/* ---- voxels ----------------------------------------------------------------------------- */

/* A column of the box needs one call a row or level: what lies behind and below comes along. */
static bool put_column(kg_oa *oa, int x, kg_spots box, bool remove) {
    return remove ? kg_oa_remove(oa, x, box.lo.y, box.lo.z) : kg_oa_add(oa, x, box.hi.y, box.hi.z);
}

bool kg_card_put(kg_editor *e, kg_spots box, bool remove) {
    kg_oa *oa = kg_editor_oa(e);
    bool changed = false;
    for (int x = box.lo.x; x <= box.hi.x; x++) {
        changed |= put_column(oa, x, box, remove);
        if (is_symmetric(e))
            changed |= put_column(oa, mirrored(oa, x), box, remove);
    }
    if (changed)
        kg_editor_touch(e);
    return changed;
}

/* ---- windows and tops ------------------------------------------------------------------- */

static bool set_one(kg_oa *oa, kg_face f, bool on) {
    return f.top ? kg_oa_set_omitted(oa, f.x, f.z, on) : kg_oa_set_window(oa, f.x, f.z, on);
}

bool kg_card_set_face(kg_editor *e, kg_face face, bool on) {
    kg_oa *oa = kg_editor_oa(e);
    bool changed = set_one(oa, face, on);
    if (is_symmetric(e)) {
        face.x = mirrored(oa, face.x);
        changed |= set_one(oa, face, on);
    }
    if (changed)
        kg_editor_touch(e);
    return changed;
}

bool kg_card_face_is_set(const kg_editor *e, kg_face f) {
    const kg_oa *oa = kg_editor_oa(e);
    return f.top ? kg_oa_omitted(oa, f.x, f.z) : kg_oa_window(oa, f.x, f.z);
}

static bool exists(const kg_oa *oa, kg_face f) {
    return f.top ? kg_oa_top(oa, f.x, f.z) > 0 : kg_oa_depth(oa, f.x, f.z) > 0;
}

bool kg_card_set_faces(kg_editor *e, kg_spots box, bool top, bool on) {
    bool changed = false;
    for (int x = box.lo.x; x <= box.hi.x; x++)
        for (int z = box.lo.z; z <= box.hi.z; z++)
            changed |= kg_card_set_face(e, (kg_face){top, x, z + top}, on);
    return changed;
}

bool kg_card_all_set(const kg_editor *e, kg_spots box, bool top) {
    bool any = false;
    for (int x = box.lo.x; x <= box.hi.x; x++)
        for (int z = box.lo.z; z <= box.hi.z; z++) {
            kg_face face = {top, x, z + top};
            if (!exists(kg_editor_oa(e), face))
                continue;
            if (!kg_card_face_is_set(e, face))
                return false;
            any = true;
        }
    return any;
}

/* ---- pulling ---------------------------------------------------------------------------- */

/* Voxels of column x that are filled from the back at level `v`, or from the base at depth `v`. */
static int reach(const kg_oa *oa, bool level, int x, int v) {
    if (!level)
        return kg_oa_depth(oa, x, v);
    int height = 0;
    while (height < oa->height && kg_oa_depth(oa, x, height) > v)
        height++;
    return height;
}

/* Flood over places of one reach. `stack` has room for all. */
static void flood(const kg_oa *oa, kg_pulled *p, int x, int v, int *stack) {
    static const int steps[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
    size_t count = 0;
    p->inside[x * p->rows + v] = 1;
    stack[count++] = x * p->rows + v;
    while (count > 0) {
        int at = stack[--count];
        for (int i = 0; i < 4; i++) {
            int nx = at / p->rows + steps[i][0], nv = at % p->rows + steps[i][1];
            if (nx < 0 || nx >= p->columns || nv < 0 || nv >= p->rows ||
                p->inside[nx * p->rows + nv] || reach(oa, p->level, nx, nv) != p->at)
                continue;
            p->inside[nx * p->rows + nv] = 1;
            stack[count++] = nx * p->rows + nv;
        }
    }
}

/* Leaves what lies in the selected box. */
static void cut_to(kg_pulled *p, const kg_spots *box) {
    int lo = p->level ? box->lo.y : box->lo.z, hi = p->level ? box->hi.y : box->hi.z;
    for (int x = 0; x < p->columns; x++)
        for (int v = 0; v < p->rows; v++)
            if (x < box->lo.x || x > box->hi.x || v < lo || v > hi)
                p->inside[x * p->rows + v] = 0;
}

kg_status kg_pulled_create(const kg_editor *e, kg_spot spot, bool level, kg_pulled *out,
                           kg_error *error) {
    const kg_card_state *s = kg_card_state_of(e);
    const kg_oa *oa = kg_editor_oa(e);
    int v = level ? spot.y : spot.z;
    const kg_spots *b = &s->box;
    bool boxed = s->boxed && spot.x >= b->lo.x && spot.x <= b->hi.x &&
                 (level ? v >= b->lo.y && v <= b->hi.y : v >= b->lo.z && v <= b->hi.z);
    kg_pulled p = {level, reach(oa, level, spot.x, v), oa->width,
                   level ? oa->depth_limit : oa->height, NULL};
    if (p.at == 0 && !boxed)
        return kg_fail(error, KG_ERR_INPUT,
                       level ? N_("there is no block here; select a box of the base first")
                             : N_("there is no block here; select a box of the back sheet first"));
    size_t places = (size_t)p.columns * (size_t)p.rows;
    int *stack = malloc(places * sizeof *stack);
    p.inside = calloc(places, 1);
    if (!stack || !p.inside) {
        free(stack);
        free(p.inside);
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    }
    flood(oa, &p, spot.x, v, stack);
    free(stack);
    if (boxed)
        cut_to(&p, b);
    *out = p;
    return KG_OK;
}

void kg_pulled_clear(kg_pulled *p) {
    free(p->inside);
    *p = (kg_pulled){0};
}

static void pull_place(kg_oa *oa, const kg_pulled *p, int x, int v, int to) {
    kg_spot last = p->level ? (kg_spot){x, v, to - 1} : (kg_spot){x, to - 1, v};
    kg_spot next = p->level ? (kg_spot){x, v, to} : (kg_spot){x, to, v};
    if (to > p->at)
        kg_oa_add(oa, last.x, last.y, last.z);
    else if (to < p->at)
        kg_oa_remove(oa, next.x, next.y, next.z);
}

bool kg_card_pull(kg_editor *e, const kg_oa *from, const kg_pulled *p, int to) {
    kg_oa *oa = kg_editor_oa(e);
    int limit = p->level ? oa->height : oa->depth_limit;
    to = to < 0 ? 0 : to > limit ? limit : to;
    copy_cells(oa, from);
    for (int x = 0; x < p->columns; x++)
        for (int v = 0; v < p->rows; v++)
            if (p->inside[x * p->rows + v]) {
                pull_place(oa, p, x, v, to);
                if (is_symmetric(e))
                    pull_place(oa, p, mirrored(oa, x), v, to);
            }
    kg_editor_touch(e);
    return to != p->at;
}

/* ---- standing --------------------------------------------------------------------------- */

kg_status kg_card_stand(kg_editor *e, const kg_oa *after, const kg_oa_mended *mended,
                        kg_error *error) {
    kg_status status = kg_editor_begin(e, N_("Make it stand"), error);
    if (status)
        return status;
    if (mended->cells > 0) {
        copy_cells(kg_editor_oa(e), after);
        kg_editor_touch(e);
    }
    kg_editor_commit(e);
    if (mended->loose + mended->missing > 0)
        kg_editor_say(
            e, KG_WARNING,
            _("Changed %zu cells, but %zu patches are still loose; no small change helps."),
            mended->cells, mended->loose);
    else if (mended->cells > 0)
        kg_editor_say(e, KG_WARNING, _("The card stands: %zu cells were changed."), mended->cells);
    else
        kg_editor_say(e, KG_WARNING, "%s", _("The card stands already."));
    return KG_OK;
}
