/* Exported FOLD files under the checks of npm's fold and rabbit-ear, where those are there: in the
 * folder KATAGAMI_NODE_MODULES, or build/node, where `./dev test` and `./dev bench` put them. */
#include "tests/check.h"
#include "tests/origami/samples.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { NOT_THERE = 77 }; /* meson's code for a test that is skipped */

static const char *modules;
static char folder[] = "/tmp/katagami-npm-XXXXXX";

/* Writes every step of a sample, with and without the steps before it, and checks them all. */
static void check_sample(const char *sample) {
    char path[1024], command[4096];
    kg_origami *o;
    kg_error error = {0};
    snprintf(path, sizeof path, "%s/%s", KG_SAMPLES, sample);
    kg_status status = strstr(sample, ".fold") ? kg_origami_import(path, NULL, &o, NULL, &error)
                                               : kg_origami_read(path, &o, &error);
    if (status)
        fail_msg("%s", error.message);
    for (size_t step = 0; step <= kg_origami_step(o); step++)
        for (int all = 0; all < 2; all++) {
            snprintf(path, sizeof path, "%s/%zu-%d.fold", folder, step, all);
            if (kg_origami_export(o, step, all, path, &error))
                fail_msg("%s", error.message);
        }
    kg_origami_destroy(o);
    snprintf(command, sizeof command, "node '%s/check_fold.mjs' '%s' %s/*.fold && rm %s/*.fold",
             KG_HERE, modules, folder, folder);
    if (system(command) != 0)
        fail_msg("%s: its FOLD files, in %s, do not pass", sample, folder);
}

static void test_every_step_of_the_samples_passes(void **user) {
    (void)user;
    static const char *samples[] = {"boat.katagami", "cup.katagami", "unit.katagami", "crane.fold"};
    for (size_t i = 0; i < sizeof samples / sizeof *samples; i++)
        check_sample(samples[i]);
}

int main(void) {
    char file[1024];
    modules = getenv("KATAGAMI_NODE_MODULES");
    modules = modules ? modules : KG_HERE "/../../build/node";
    snprintf(file, sizeof file, "%s/node_modules/rabbit-ear/package.json", modules);
    if (access(file, R_OK) != 0 || system("node --version > /dev/null 2>&1") != 0) {
        puts("skipped: node, or npm's fold and rabbit-ear, are not there");
        return NOT_THERE;
    }
    if (!mkdtemp(folder))
        return 1;
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_every_step_of_the_samples_passes)};
    int failed = cmocka_run_group_tests(tests, NULL, NULL);
    rmdir(folder);
    return failed;
}
