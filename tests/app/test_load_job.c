/* Reading in the background tells how far it is, and ends at whatever step it is given up. */
#include "app/load_job.h"
#include "tests/check.h"

#include <stdlib.h>
#include <unistd.h>

enum { VERTICES = 9000, PLEATS = 30, MOST_STEPS = 200 };

static char folder[] = "/tmp/katagami-load-XXXXXX";
static char mesh_path[64], model_path[64], pattern_path[64];

static int write_files(void **state) {
    (void)state;
    assert_non_null(mkdtemp(folder));
    snprintf(mesh_path, sizeof mesh_path, "%s/strip.obj", folder);
    snprintf(model_path, sizeof model_path, "%s/m.katagami", folder);
    snprintf(pattern_path, sizeof pattern_path, "%s/pleats.cp", folder);
    FILE *f = fopen(mesh_path, "w");
    assert_non_null(f);
    for (int i = 0; i < VERTICES; i++)
        fprintf(f, "v %.6f %d %.6f\n", 0.01 * i, 10 * (i % 2), sin(0.01 * i));
    for (int i = 1; i + 2 <= VERTICES; i++)
        fprintf(f, "f %d %d %d\n", i, i + 1 + i % 2, i + 2 - i % 2);
    assert_int_equal(fclose(f), 0);
    f = fopen(model_path, "w");
    assert_non_null(f);
    fprintf(f, "{\"katagami\": 1, \"kind\": \"patches\", \"patches\": [{\"id\": 1, \"extent\": "
               "[-9, 9], \"points\": [[0,-40,0],[0,-20,30],[0,20,30],[0,40,0]]}], "
               "\"reference\": {\"file\": \"strip.obj\"}}");
    assert_int_equal(fclose(f), 0);
    f = fopen(pattern_path, "w");
    assert_non_null(f);
    for (int i = 0; i <= PLEATS; i++) /* mountains and valleys in turn, ends are borders */
        fprintf(f, "%d %d 0 %d 9\n", i % PLEATS == 0 ? 1 : 2 + i % 2, i, i);
    fprintf(f, "1 0 0 %d 0\n1 0 9 %d 9\n", PLEATS, PLEATS);
    assert_int_equal(fclose(f), 0);
    return 0;
}

static int remove_files(void **state) {
    (void)state;
    unlink(mesh_path);
    unlink(model_path);
    unlink(pattern_path);
    return rmdir(folder);
}

typedef struct result {
    kg_document *document;
    kg_backdrop backdrop;
    kg_error reference_error, error;
} result;

/* Goes `most` steps at the utmost, then gives the job up if it is not done; how many it went. */
static int run(const char *path, int most, kg_status wanted, result *r) {
    kg_gate gate;
    kg_load_job *job;
    double before = 0;
    int steps = 0, moves = 0;
    kg_gate_init(&gate);
    kg_gate_set_closed(&gate, true);
    assert_int_equal(kg_load_job_document(path, 0.5, &gate, &job, &r->error), KG_OK);
    for (; steps < most && !kg_load_job_is_done(job); steps++) {
        kg_gate_step(&gate);
        double now = kg_load_job_fraction(job);
        assert_true(now >= before && now <= 1);
        moves += now > before;
        before = now;
    }
    assert_true(moves >= steps / 2); /* of the bar */
    if (!kg_load_job_is_done(job))
        kg_load_job_cancel(job);
    kg_status status =
        kg_load_job_finish(job, &r->document, &r->backdrop, &r->reference_error, &r->error);
    assert_int_equal(status, wanted);
    kg_gate_clear(&gate);
    return steps;
}

static void a_model_and_its_reference_come_whole_or_not_at_all(void **state) {
    (void)state;
    result whole = {0};
    int steps = run(model_path, MOST_STEPS, KG_OK, &whole);
    assert_in_range(steps, 8, MOST_STEPS - 1);
    assert_non_null(whole.document);
    assert_int_equal(whole.backdrop.mesh->vertex_count, VERTICES);
    assert_string_equal(whole.reference_error.message, "");
    kg_backdrop_clear(&whole.backdrop);
    kg_document_destroy(whole.document);
    for (int n = 0; n < steps; n++) {
        result given_up = {0};
        assert_int_equal(run(model_path, n, KG_ERR_CANCELLED, &given_up), n);
        assert_null(given_up.document);
        assert_null(given_up.backdrop.mesh);
    }
}

static void a_pattern_is_given_up_while_its_layers_are_looked_for(void **state) {
    (void)state;
    result whole = {0};
    int steps = run(pattern_path, MOST_STEPS, KG_OK, &whole);
    assert_in_range(steps, 30, MOST_STEPS - 1);
    const kg_origami *o = kg_document_origami(whole.document);
    assert_int_equal(kg_origami_pair_count(kg_origami_state_at(o, 0)), PLEATS * (PLEATS - 1) / 2);
    kg_document_destroy(whole.document);
    for (int n = 0; n < steps; n++) {
        result given_up = {0};
        assert_int_equal(run(pattern_path, n, KG_ERR_CANCELLED, &given_up), n);
        assert_null(given_up.document);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_model_and_its_reference_come_whole_or_not_at_all),
        cmocka_unit_test(a_pattern_is_given_up_while_its_layers_are_looked_for),
    };
    return cmocka_run_group_tests(tests, write_files, remove_files);
}
