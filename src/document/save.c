/* Writing documents, and how their files name others. */

/* realpath is an extension of POSIX */
#undef _POSIX_C_SOURCE
#define _XOPEN_SOURCE 700

#include "document/document.h"

#include <stdlib.h>
#include <string.h>

const char *kg_document_path(const kg_document *d) {
    return d->path;
}

char *kg_document_relative(const char *model_path, const char *file) {
    char *folder = strdup(model_path), *result = NULL;
    char *slash = folder ? strrchr(folder, '/') : NULL;
    if (slash)
        slash[slash == folder] = '\0';
    char *from = folder ? realpath(slash ? folder : ".", NULL) : NULL, *to = realpath(file, NULL);
    if (from && to) {
        size_t common = 0, ups = 0;
        for (size_t i = 0;; i++) {
            bool end_from = from[i] == '\0', end_to = to[i] == '\0';
            if ((end_from || from[i] == '/') && (end_to || to[i] == '/'))
                common = i;
            if (end_from || end_to || from[i] != to[i])
                break;
        }
        for (const char *p = from + common; *p; p++)
            ups += *p == '/' && p[1] != '\0';
        const char *tail = to + common + (to[common] == '/');
        result = malloc(3 * ups + strlen(tail) + 1);
        if (result) {
            result[0] = '\0';
            for (size_t i = 0; i < ups; i++)
                strcat(result, "../");
            strcat(result, tail);
        }
    }
    free(folder);
    free(from);
    free(to);
    return result;
}

/* Where the reference lies now, seen from the new place; unchanged when it cannot be found. */
static char *moved_reference(const kg_document *d, const char *path) {
    char *now = kg_document_reference_path(d);
    char *moved = now ? kg_document_relative(path, now) : NULL;
    free(now);
    return moved;
}

/* Cards and sheets name no other files. */
static kg_status save_alone(kg_document *d, const char *path, kg_error *error) {
    char *copy = strdup(path);
    kg_status status = !copy       ? kg_fail(error, KG_ERR_MEMORY, "out of memory")
                       : d->folded ? kg_origami_write(d->folded->origami, path, error)
                                   : kg_oa_write(d->card->oa, path, error);
    if (status) {
        free(copy);
        return status;
    }
    free(d->path);
    d->path = copy;
    return KG_OK;
}

kg_status kg_document_save(kg_document *d, const char *path, kg_error *error) {
    if (d->card || d->folded)
        return save_alone(d, path, error);
    char *copy = strdup(path), **file = &d->model->reference.file, *old = *file;
    if (!copy)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    bool stays = d->path && strcmp(d->path, path) == 0;
    /* an absolute name stays, but for one that had no model file to be relative to */
    bool follows = *file && !stays && ((*file)[0] != '/' || !d->path);
    char *moved = follows ? moved_reference(d, path) : NULL;
    if (moved)
        *file = moved;
    kg_status status = kg_model_write(d->model, path, error);
    if (status) {
        *file = old;
        free(moved);
        free(copy);
        return status;
    }
    if (moved)
        free(old);
    free(d->path);
    d->path = copy;
    return KG_OK;
}
