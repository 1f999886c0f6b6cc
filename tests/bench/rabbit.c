/* The same tasks done by npm's rabbit-ear in this run, where node and the package are there. */
#include "bench/bench.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* Seconds after which it is stopped: its time, and the ratio, are then at least that. */
#define LIMIT 60

static const char *modules(void) {
    const char *folder = getenv("KATAGAMI_NODE_MODULES");
    char file[1024];
    if (!folder || system("node --version > /dev/null 2>&1") != 0)
        return NULL;
    snprintf(file, sizeof file, "%s/node_modules/rabbit-ear/package.json", folder);
    return access(file, R_OK) == 0 ? folder : NULL;
}

/* Runs rabbit.mjs; false when it fails. */
static bool run(const char *task, const char *file, double *out_seconds, bool *out_over) {
    char command[4096], answer[256] = "";
    snprintf(command, sizeof command, "node '%s/rabbit.mjs' '%s' %s '%s' %d 2> /dev/null",
             KATAGAMI_BENCH_SOURCE, modules(), task, file, LIMIT);
    FILE *pipe = popen(command, "r");
    if (!pipe)
        return false;
    bool read = fgets(answer, sizeof answer, pipe) != NULL;
    bool done = pclose(pipe) == 0;
    *out_over = strstr(answer, "\"over\":true") != NULL;
    return done && read && sscanf(answer, "{\"seconds\":%lf", out_seconds) == 1;
}

void bench_rabbit(const char *task, const char *fold_text, size_t size, double seconds,
                  double target) {
    if (!modules()) {
        puts("  rabbit-ear: not compared, node or npm's rabbit-ear@0.9.32 is not there");
        return;
    }
    char name[] = "/tmp/katagami-bench-XXXXXX", what[80];
    int handle = mkstemp(name);
    FILE *file = handle >= 0 ? fdopen(handle, "w") : NULL;
    bool written = file && fwrite(fold_text, 1, size, file) == size;
    written = file && fclose(file) == 0 && written;
    double time;
    bool over;
    if (!written || !run(task, name, &time, &over)) {
        printf("  rabbit-ear, %s: failed\n", task);
    } else {
        snprintf(what, sizeof what, "  rabbit-ear 0.9.32, %s%s", task,
                 over ? ", stopped after" : "");
        bench_row(what, time, "ms", 0);
        printf("%-58s %10.0f x ", over ? "  times faster, at least" : "  times faster",
               time / seconds);
        if (target > 0)
            printf("   target %g x%s", target, time >= target * seconds ? "" : "  MISSED");
        putchar('\n');
        fflush(stdout);
    }
    if (handle >= 0)
        unlink(name);
}
