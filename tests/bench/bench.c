/*
 * Speed and memory of the kernel and of whole commands, measured in one run so that ratios hold.
 *
 *     katagami-bench KATAGAMI MODEL    the program, and a sample for whole processes
 */
#include "bench/bench.h"

#include <fcntl.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

extern char **environ;

static double read_clock(clockid_t clock) {
    struct timespec t;
    clock_gettime(clock, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

double bench_now(void) {
    return read_clock(CLOCK_MONOTONIC);
}

double bench_work(void) {
    return read_clock(CLOCK_PROCESS_CPUTIME_ID);
}

void bench_row(const char *what, double seconds, const char *unit, double target) {
    double factor = strcmp(unit, "ns") == 0 ? 1e9 : strcmp(unit, "us") == 0 ? 1e6 : 1e3;
    printf("%-58s %10.3f %s", what, seconds * factor, unit);
    if (target > 0)
        printf("   target %g %s%s", target * factor, unit, seconds <= target ? "" : "  MISSED");
    putchar('\n');
    fflush(stdout);
}

static double median(double *values, int count) {
    for (int i = 1; i < count; i++)
        for (int k = i; k > 0 && values[k] < values[k - 1]; k--) {
            double t = values[k];
            values[k] = values[k - 1], values[k - 1] = t;
        }
    return values[count / 2];
}

static double seconds_of(struct timeval t) {
    return (double)t.tv_sec + 1e-6 * (double)t.tv_usec;
}

/* Runs a command `runs` times; medians of wall time and work, and peak memory. */
static int run_process(char *const argv[], int runs, double *out_seconds, double *out_work,
                       double *out_mb) {
    double wall[32], work[32];
    long peak = 0;
    posix_spawn_file_actions_t quiet;
    posix_spawn_file_actions_init(&quiet);
    posix_spawn_file_actions_addopen(&quiet, 1, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&quiet, 2, "/dev/null", O_WRONLY, 0);
    for (int i = 0; i < runs; i++) {
        double start = bench_now();
        pid_t pid; /* not fork: the child would count this process's memory as its own */
        if (posix_spawn(&pid, argv[0], &quiet, NULL, argv, environ))
            return -1;
        int status;
        struct rusage usage;
        if (wait4(pid, &status, 0, &usage) < 0 || status != 0)
            return -1;
        wall[i] = bench_now() - start;
        work[i] = seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
        peak = usage.ru_maxrss;
    }
    posix_spawn_file_actions_destroy(&quiet);
    *out_seconds = median(wall, runs);
    *out_work = median(work, runs);
    *out_mb = (double)peak / 1024;
    return 0;
}

static int bench_processes(char *program, char *model) {
    char folder[] = "/tmp/katagami-bench-XXXXXX", page[64], pages[64];
    if (!mkdtemp(folder))
        return 1;
    snprintf(page, sizeof page, "%s/net.svg", folder);
    snprintf(pages, sizeof pages, "%s/net.pdf", folder);
    char net[] = "net", o[] = "-o", paper[] = "--paper", none[] = "none", tabs[] = "--tabs",
         labels[] = "--labels", version[] = "version";
    char *empty[] = {program, version, NULL};
    char *plain[] = {program, net, model, o, page, paper, none, tabs, none, labels, none, NULL};
    char *whole[] = {program, net, model, o, pages, NULL};
    struct {
        const char *what;
        char **argv;
        double target, memory;
    } rows[] = {
        {"process: version (loading the libraries)", empty, 0, 0},
        {"process: net, no tabs, no labels, one page", plain, 0.060, 40},
        {"process: net, tabs, labels, nested on A4", whole, 1.5, 0},
    };
    int code = 0;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        double seconds, work, mb;
        if (run_process(rows[i].argv, 11, &seconds, &work, &mb)) {
            printf("%-58s failed\n", rows[i].what);
            code = 1;
            continue;
        }
        bench_row(rows[i].what, seconds, "ms", rows[i].target);
        bench_row("  work of the processor in it", work, "ms", 0);
        printf("%-58s %10.1f MB", "  peak memory", mb);
        if (rows[i].memory > 0)
            printf("   target %g MB%s", rows[i].memory, mb <= rows[i].memory ? "" : "  MISSED");
        putchar('\n');
    }
    unlink(page);
    unlink(pages);
    rmdir(folder);
    return code;
}

/* Until the app's window shows, on an X server of its own, where there is one. */
static void bench_window(const char *program, const char *model) {
    char command[4096];
    double seconds = 0;
    snprintf(command, sizeof command, "python3 '%s/window.py' '%s' '%s'", KATAGAMI_BENCH_SOURCE,
             program, model);
    FILE *pipe = popen(command, "r");
    bool read = pipe && fscanf(pipe, "%lf", &seconds) == 1;
    if (pipe && pclose(pipe) == 0 && read)
        bench_row("app: until its window shows", seconds, "ms", 1);
    else
        puts("app: window not measured, Xvfb, xdotool or OpenGL is not there");
}

int main(int argc, char **argv) {
    if (argc != 3) {
        fputs("usage: katagami-bench KATAGAMI MODEL\n", stderr);
        return 2;
    }
    /* first, while this process is small: a child's peak memory starts from its parent's */
    int code = bench_processes(argv[1], argv[2]);
    bench_window(argv[1], argv[2]);
    bench_patches();
    bench_crossings();
    bench_models();
    bench_cards();
    bench_origami();
    return code;
}
