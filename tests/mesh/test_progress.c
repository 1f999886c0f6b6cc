/* Reading and the search tree tell how far they are, and end when they are told to. */
#include "tests/mesh/samples.h"

#include <stdlib.h>
#include <unistd.h>

/* Enough for several words about the progress in every format. */
enum { TRIANGLES = 4000, MOST_CALLS = 200 };

static char folder[] = "/tmp/katagami-progress-XXXXXX";

/* A watch that says stop at its `stop_at`-th call. */
typedef struct watch {
    int calls, stop_at;
    double last;
} watch;

static bool look(void *user, double fraction, const char *what) {
    watch *w = user;
    assert_true(fraction >= w->last && fraction <= 1);
    assert_true(what && what[0]);
    w->last = fraction;
    return ++w->calls != w->stop_at;
}

static kg_mesh *soup(void) {
    kg_random random = {5};
    return kg_sample_soup(&random, TRIANGLES);
}

static void assert_same(const kg_mesh *a, const kg_mesh *b) {
    assert_int_equal(a->vertex_count, b->vertex_count);
    assert_int_equal(a->face_count, b->face_count);
    assert_memory_equal(a->positions, b->positions, a->vertex_count * sizeof *a->positions);
    assert_memory_equal(a->face_corners, b->face_corners,
                        a->face_starts[a->face_count] * sizeof *a->face_corners);
}

static void reading_tells_how_far_it_is_and_ends_at_any_word(void **state) {
    static const char *const endings[] = {"obj", "ply", "stl", "off", "gltf", "glb"};
    (void)state;
    assert_non_null(mkdtemp(folder));
    kg_mesh *mesh = soup();
    for (size_t i = 0; i < sizeof endings / sizeof *endings; i++) {
        char path[64];
        snprintf(path, sizeof path, "%s/soup.%s", folder, endings[i]);
        assert_int_equal(kg_mesh_write(path, mesh, NULL), KG_OK);
        kg_mesh *plain, *told, *none = NULL;
        kg_error error;
        watch whole = {0};
        kg_progress progress = {look, &whole};
        assert_int_equal(kg_mesh_read(path, &plain, NULL), KG_OK);
        assert_int_equal(kg_mesh_read_reporting(path, &progress, &told, NULL), KG_OK);
        assert_same(plain, told);
        assert_in_range(whole.calls, 4, MOST_CALLS);
        assert_true(whole.last > 0.9);
        for (int n = 1; n <= whole.calls; n++) {
            watch w = {.stop_at = n};
            kg_progress stopped = {look, &w};
            assert_int_equal(kg_mesh_read_reporting(path, &stopped, &none, &error),
                             KG_ERR_CANCELLED);
            assert_int_equal(error.status, KG_ERR_CANCELLED);
            assert_int_equal(w.calls, n); /* it asks no more */
            assert_null(none);
        }
        kg_mesh_destroy(plain);
        kg_mesh_destroy(told);
        unlink(path);
    }
    kg_mesh_destroy(mesh);
    rmdir(folder);
}

static void the_search_tree_tells_how_far_it_is_and_ends_at_any_word(void **state) {
    (void)state;
    kg_mesh *mesh = soup();
    kg_mesh_query *query, *none = NULL;
    watch whole = {0};
    kg_progress progress = {look, &whole};
    assert_int_equal(kg_mesh_query_create(mesh, &progress, &query, NULL), KG_OK);
    assert_in_range(whole.calls, 2, MOST_CALLS);
    kg_mesh_query_destroy(query);
    for (int n = 1; n <= whole.calls; n++) {
        watch w = {.stop_at = n};
        kg_progress stopped = {look, &w};
        kg_error error;
        assert_int_equal(kg_mesh_query_create(mesh, &stopped, &none, &error), KG_ERR_CANCELLED);
        assert_int_equal(error.status, KG_ERR_CANCELLED);
        assert_int_equal(w.calls, n);
        assert_null(none);
    }
    kg_mesh_destroy(mesh);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reading_tells_how_far_it_is_and_ends_at_any_word),
        cmocka_unit_test(the_search_tree_tells_how_far_it_is_and_ends_at_any_word),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
