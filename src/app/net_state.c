#include "app/net_state.h"

#include "app/export.h"
#include "app/task.h"
#include "app/text.h"
#include "document/pin.h"
#include "net/clash.h"
#include "net/sheet.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Where a part lay in the picture before. */
typedef struct seat {
    int64_t source;
    size_t piece;
    kg_net_placement place;
} seat;

/* What the thread works on. It owns everything in here until it is joined. */
typedef struct job {
    kg_task task;
    kg_document *document;
    uint64_t number; /* of the solution it was started for */
    bool rough;
    size_t seat_count;
    seat *seats;
    size_t page_count; /* of the seats */
    atomic_bool superseded;
    kg_net_picture picture;
    kg_status status;
    kg_error error;
} job;

struct kg_net_state {
    kg_gate *gate;
    kg_net_picture picture;
    bool has_picture;
    uint64_t number; /* of the solution shown, or that failed */
    bool rough;      /* only made for the duration of a gesture */
    uint64_t revision;
    char error[KG_ERROR_SIZE];
    job *job;
};

void kg_net_picture_clear(kg_net_picture *p) {
    kg_drawing_destroy(p->drawing);
    kg_net_layout_destroy(p->layout);
    kg_document_net_clear(&p->net);
    free(p->clashes);
    *p = (kg_net_picture){0};
}

/* ---- on the thread ----------------------------------------------------------------------- */

/* A layout with the places of the picture before; NULL when there are other parts now. */
static kg_net_layout *keep_places(const job *j, const kg_net_picture *p) {
    const kg_net *net = p->net.net;
    kg_sheet sheet;
    kg_net_layout *layout = calloc(1, sizeof *layout);
    bool ok = layout && !kg_sheet_from_options(&p->options, &sheet, NULL) && !sheet.endless &&
              (layout->placements = calloc(net->part_count + 1, sizeof *layout->placements));
    for (size_t i = 0; ok && i < net->part_count; i++) {
        size_t piece = kg_pin_piece(net, i), k = 0;
        while (k < j->seat_count &&
               (j->seats[k].source != net->parts[i].source || j->seats[k].piece != piece))
            k++;
        if ((ok = k < j->seat_count))
            layout->placements[i] = j->seats[k].place;
    }
    if (!ok) {
        kg_net_layout_destroy(layout);
        return NULL;
    }
    layout->part_count = net->part_count;
    layout->page_count = j->page_count;
    layout->page_size = sheet.size;
    layout->scale = p->options.scale;
    return layout;
}

static kg_status lay_out(job *j, kg_net_picture *p, kg_error *error) {
    kg_net_options rows = p->options;
    const kg_progress progress = kg_task_progress(&j->task);
    rows.nest = false;
    if (j->rough && (p->layout = keep_places(j, p)))
        return KG_OK;
    if (j->rough)
        return kg_net_layout_create(p->net.net, &rows, NULL, &p->layout, error);
    kg_status status = kg_net_layout_create(p->net.net, &p->options, &progress, &p->layout, error);
    if (status != KG_ERR_CANCELLED || atomic_load(&j->superseded))
        return status;
    p->rough = true;
    return kg_net_layout_create(p->net.net, &rows, NULL, &p->layout, error);
}

static kg_status unroll(kg_document *document, const kg_net_options *options, double tab_width,
                        kg_document_net *out_net, kg_error *error) {
    kg_parts_options parts = kg_document_parts_options(document, options, tab_width);
    return kg_document_unroll_to_fit(document, &parts, out_net, error);
}

static kg_status make(job *j, kg_net_picture *p, kg_error *error) {
    double tab_width;
    kg_status status = kg_document_net_options(j->document, &p->options, &tab_width, error);
    if (status)
        return status;
    double chord = j->rough ? KG_EDITOR_CHORD : kg_document_net_chord(&p->options);
    p->rough = j->rough;
    if (!(status = kg_document_solve(j->document, chord, error)))
        status = unroll(j->document, &p->options, tab_width, &p->net, error);
    if (status || p->net.net->part_count == 0)
        return status;
    if (!(status = lay_out(j, p, error)))
        status = kg_drawing_create(p->net.net, p->layout, &p->options, true, &p->drawing, error);
    if (status)
        return status;
    p->clashes = calloc(p->net.net->part_count, sizeof *p->clashes);
    if (!p->clashes)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    return kg_net_clashes(p->net.net, p->layout, &p->options, p->clashes, error);
}

static void work(void *user) {
    job *j = user;
    j->status = make(j, &j->picture, &j->error);
}

/* ---- jobs -------------------------------------------------------------------------------- */

static void destroy_job(job *j) {
    if (!j)
        return;
    kg_net_picture_clear(&j->picture);
    kg_document_destroy(j->document);
    free(j->seats);
    free(j);
}

static bool take_seats(const kg_net_state *s, job *j) {
    if (!s->has_picture)
        return true;
    const kg_net *net = s->picture.net.net;
    j->seats = calloc(net->part_count + 1, sizeof *j->seats);
    if (!j->seats)
        return false;
    j->seat_count = net->part_count;
    j->page_count = s->picture.layout->page_count;
    for (size_t i = 0; i < net->part_count; i++)
        j->seats[i] =
            (seat){net->parts[i].source, kg_pin_piece(net, i), s->picture.layout->placements[i]};
    return true;
}

static void fail(kg_net_state *s, const char *message) {
    snprintf(s->error, sizeof s->error, "%s", message);
    s->revision++;
}

static void start(kg_net_state *s, const kg_editor *e) {
    job *j = calloc(1, sizeof *j);
    kg_error error;
    s->number = e->solved;
    s->rough = e->before != NULL;
    if (!j) {
        fail(s, _("out of memory"));
        return;
    }
    j->number = e->solved;
    j->rough = s->rough;
    if (kg_document_copy(e->document, &j->document, &error)) {
        fail(s, error.message);
        destroy_job(j);
    } else if (!take_seats(s, j) || !kg_task_start(&j->task, s->gate, work, j)) {
        fail(s, _("no memory for another thread"));
        destroy_job(j);
    } else {
        s->job = j;
    }
}

/* Takes over what a finished job made. */
static void finish(kg_net_state *s) {
    job *j = s->job;
    kg_task_join(&j->task);
    s->job = NULL;
    if (j->status) {
        if (j->status != KG_ERR_CANCELLED)
            fail(s, j->error.message);
        destroy_job(j);
        return;
    }
    kg_net_picture_clear(&s->picture);
    s->picture = j->picture;
    s->has_picture = s->picture.layout != NULL;
    if (!s->has_picture)
        kg_net_picture_clear(&s->picture);
    j->picture = (kg_net_picture){0};
    s->error[0] = '\0';
    s->revision++;
    destroy_job(j);
}

/* Nobody wants what the job makes any more. */
static void supersede(job *j) {
    atomic_store(&j->superseded, true);
    kg_task_cancel(&j->task);
}

bool kg_net_state_follow(kg_net_state *s, const kg_editor *e) {
    uint64_t before = s->revision;
    if (s->job && kg_task_is_done(&s->job->task))
        finish(s);
    bool current = s->number == e->solved && (!s->rough || e->before);
    if (!current && s->job)
        supersede(s->job);
    else if (!current)
        start(s, e);
    return s->revision != before;
}

/* ---- questions --------------------------------------------------------------------------- */

bool kg_net_state_busy(const kg_net_state *s, double *out_fraction) {
    if (out_fraction)
        *out_fraction = s->job ? kg_task_fraction(&s->job->task) : 0;
    return s->job != NULL;
}

void kg_net_state_cancel(kg_net_state *s) {
    if (s->job)
        kg_task_cancel(&s->job->task);
}

const kg_net_picture *kg_net_state_picture(const kg_net_state *s) {
    return s->has_picture ? &s->picture : NULL;
}

const char *kg_net_state_error(const kg_net_state *s) {
    return s->error;
}

uint64_t kg_net_state_revision(const kg_net_state *s) {
    return s->revision;
}

kg_net_state *kg_net_state_create(kg_gate *gate) {
    kg_net_state *s = calloc(1, sizeof *s);
    if (!s)
        return NULL;
    s->gate = gate;
    s->number = UINT64_MAX; /* nothing was made */
    return s;
}

void kg_net_state_destroy(kg_net_state *s) {
    if (!s)
        return;
    if (s->job) {
        supersede(s->job);
        kg_task_join(&s->job->task);
        destroy_job(s->job);
    }
    kg_net_picture_clear(&s->picture);
    free(s);
}
