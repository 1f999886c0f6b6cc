/* Whole guides: these draw, and leave with 77, "skipped", where the machine cannot. */
#include "base/file.h"
#include "katagami/guide.h"
#include "katagami/render.h"
#include "tests/guide/model.h"

#include <stdlib.h>
#include <unistd.h>

static const char *path_of(const char *name) {
    static char folder[64], path[256];
    if (!*folder) {
        strcpy(folder, "/tmp/katagami-guide-XXXXXX");
        assert_non_null(mkdtemp(folder));
    }
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return path;
}

static kg_status write_guide(kg_document *document, const char *path, const kg_progress *progress,
                             kg_error *error) {
    kg_document_net net;
    kg_net_options options = kg_net_options_default();
    kg_net_layout *layout;
    assert_int_equal(kg_document_unroll(document, 5, &net, NULL), KG_OK);
    assert_int_equal(kg_net_layout_create(net.net, &options, NULL, &layout, NULL), KG_OK);
    kg_status status = kg_guide_write(document, &net, layout, &options, path, progress, error);
    kg_net_layout_destroy(layout);
    kg_document_net_clear(&net);
    return status;
}

static void two_runs_write_the_same_bytes(void **state) {
    (void)state;
    char *data[2];
    size_t sizes[2];
    for (int i = 0; i < 2; i++) {
        kg_document *document = box_document(false);
        const char *path = path_of("box.pdf");
        assert_int_equal(write_guide(document, path, NULL, NULL), KG_OK);
        assert_int_equal(kg_file_read(path, &data[i], &sizes[i], NULL), KG_OK);
        unlink(path);
        kg_document_destroy(document);
    }
    assert_int_equal(sizes[0], sizes[1]);
    assert_memory_equal(data[0], data[1], sizes[0]);
    assert_memory_equal(data[0], "%PDF", 4);
    assert_in_range(sizes[0], 20000, 3000000);
    free(data[0]);
    free(data[1]);
}

static bool refuse(void *user, double fraction, const char *what) {
    (void)what;
    *(double *)user = fraction;
    return fraction < 0.5;
}

static void a_cancelled_guide_leaves_no_file(void **state) {
    (void)state;
    double reached = 0;
    kg_progress progress = {refuse, &reached};
    kg_document *document = box_document(true);
    const char *path = path_of("cancelled.pdf");
    assert_int_equal(write_guide(document, path, &progress, NULL), KG_ERR_CANCELLED);
    assert_in_range((int)(100 * reached), 50, 99);
    assert_int_not_equal(access(path, F_OK), 0);
    kg_document_destroy(document);
}

int main(void) {
    kg_offscreen *offscreen;
    if (kg_offscreen_create(&offscreen, NULL))
        return 77;
    kg_offscreen_destroy(offscreen);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(two_runs_write_the_same_bytes),
        cmocka_unit_test(a_cancelled_guide_leaves_no_file),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
