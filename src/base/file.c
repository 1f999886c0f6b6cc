/* realpath is an extension of POSIX */
#undef _POSIX_C_SOURCE
#define _XOPEN_SOURCE 700

#include "base/file.h"
#include "base/phrase.h"
#include "base/progress.h"
#include "base/signals.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>

/* Bytes that are read at once, between two looks at the progress. */
enum { FIRST_PIECE = 1 << 16, MOST_PIECE = 1 << 22 };

/* How large a stream says it is, bytes; 0: a pipe, or empty. */
static double size_of(FILE *f) {
    struct stat info;
    return fstat(fileno(f), &info) == 0 && S_ISREG(info.st_mode) ? (double)info.st_size : 0;
}

static kg_status read_stream(FILE *f, const kg_progress *progress, char **out_data,
                             size_t *out_size, kg_error *error) {
    size_t capacity = FIRST_PIECE, size = 0;
    double whole = size_of(f);
    char *data = malloc(capacity);
    kg_status status = data ? KG_OK : KG_ERR_MEMORY;
    while (!status) {
        size_t room = capacity - 1 - size, wanted = room < MOST_PIECE ? room : MOST_PIECE;
        size_t got = fread(data + size, 1, wanted, f);
        size += got;
        if (got < wanted)
            break;
        status = kg_progress_tell(progress, whole > 0 ? fmin((double)size / whole, 1) : 0,
                                  "reading", error);
        if (status || got < room)
            continue;
        char *more = capacity > SIZE_MAX / 2 ? NULL : realloc(data, capacity * 2);
        if (more) {
            data = more;
            capacity *= 2;
        } else {
            status = KG_ERR_MEMORY;
        }
    }
    if (!status && ferror(f))
        status = KG_ERR_IO;
    if (status) {
        free(data);
        return status;
    }
    data[size] = '\0';
    *out_data = data;
    *out_size = size;
    return KG_OK;
}

kg_status kg_file_read_telling(const char *path, const kg_progress *progress, char **out_data,
                               size_t *out_size, kg_error *error) {
    FILE *f = strcmp(path, "-") == 0 ? stdin : fopen(path, "rb");
    if (!f)
        return kg_fail(error, KG_ERR_IO, "%s: cannot open: %s", path, kg_phrase_of_errno(errno));
    kg_status status = read_stream(f, progress, out_data, out_size, error);
    int saved = errno;
    if (f != stdin)
        fclose(f);
    if (status == KG_ERR_MEMORY)
        return kg_fail(error, status, "%s: out of memory", path);
    if (status == KG_ERR_IO)
        return kg_fail(error, status, "%s: cannot read: %s", path, kg_phrase_of_errno(saved));
    return status;
}

kg_status kg_file_read(const char *path, char **out_data, size_t *out_size, kg_error *error) {
    return kg_file_read_telling(path, NULL, out_data, out_size, error);
}

/* The file that `path` means in the end: a rename onto a symbolic link would put a file in the
 * link's place. What is not there yet, or cannot be looked up, stays as it is named. free() it. */
static char *target_of(const char *path) {
    char *target = realpath(path, NULL);
    return target ? target : strdup(path);
}

kg_status kg_file_temporary(const char *path, char **out_temporary, kg_error *error) {
    char *target = target_of(path);
    size_t n = target ? strlen(target) : 0;
    char *name = target ? realloc(target, n + 8) : NULL;
    if (!name) {
        free(target);
        return kg_fail(error, KG_ERR_MEMORY, "%s: out of memory", path);
    }
    memcpy(name + n, ".XXXXXX", 8);
    int fd = mkstemp(name);
    if (fd < 0) {
        kg_fail(error, KG_ERR_IO, "%s: cannot write here: %s", path, kg_phrase_of_errno(errno));
        free(name);
        return KG_ERR_IO;
    }
    /* mkstemp makes files private; what replaces a user's file keeps that file's mode, and a new
     * one is made anew, so that it gets the mode every other program would give it. */
    struct stat old;
    if (stat(path, &old) == 0) {
        (void)!fchmod(fd, old.st_mode & 0777);
    } else {
        int unshared = fd;
        fd = unlink(name) == 0 ? open(name, O_CREAT | O_EXCL | O_WRONLY, 0666) : -1;
        close(unshared);
    }
    if (fd < 0) {
        kg_fail(error, KG_ERR_IO, "%s: cannot write here: %s", path, kg_phrase_of_errno(errno));
        free(name);
        return KG_ERR_IO;
    }
    close(fd);
    *out_temporary = name;
    return KG_OK;
}

kg_status kg_file_commit(const char *temporary, const char *path, kg_error *error) {
    char *target = target_of(path);
    int fd = target ? open(temporary, O_RDONLY) : -1;
    bool done = fd >= 0 && fsync(fd) == 0 && rename(temporary, target) == 0;
    int saved = errno;
    free(target);
    if (fd >= 0)
        close(fd);
    if (!done) {
        kg_fail(error, KG_ERR_IO, "%s: cannot write: %s", path, kg_phrase_of_errno(saved));
        unlink(temporary);
        return KG_ERR_IO;
    }
    return KG_OK;
}

void kg_file_discard(const char *temporary) {
    if (temporary)
        unlink(temporary);
}

static kg_status replace(const char *path, const void *data, size_t size, kg_error *error) {
    char *temporary;
    kg_status status = kg_file_temporary(path, &temporary, error);
    if (status)
        return status;
    FILE *f = fopen(temporary, "wb");
    bool ok = f && fwrite(data, 1, size, f) == size;
    if (f && fclose(f) != 0)
        ok = false;
    if (ok) {
        status = kg_file_commit(temporary, path, error);
    } else {
        status = kg_fail(error, KG_ERR_IO, "%s: cannot write: %s", path, kg_phrase_of_errno(errno));
        kg_file_discard(temporary);
    }
    free(temporary);
    return status;
}

kg_status kg_file_write(const char *path, const void *data, size_t size, kg_error *error) {
    if (strcmp(path, "-") == 0) {
        if (fwrite(data, 1, size, stdout) != size || fflush(stdout) != 0)
            return kg_fail(error, KG_ERR_IO, "standard output: cannot write: %s",
                           kg_phrase_of_errno(errno));
        return KG_OK;
    }
    sigset_t before;
    kg_signals_hold(&before);
    kg_status status = replace(path, data, size, error);
    kg_signals_release(&before);
    return status;
}

bool kg_file_ends_in(const char *path, const char *ending) {
    size_t n = strlen(path), m = strlen(ending);
    return n >= m && strcasecmp(path + n - m, ending) == 0;
}

char *kg_file_stem(const char *path) {
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
    const char *dot = strrchr(name, '.');
    return strndup(name, dot ? (size_t)(dot - name) : strlen(name));
}
