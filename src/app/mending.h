/* Ways out of bad rulings that are offered for the patch that is shown. */
#ifndef KG_APP_MENDING_H
#define KG_APP_MENDING_H

#include <stddef.h>
#include <stdint.h>

enum { KG_MEND_MOST = 4 };

typedef struct kg_mend {
    const char *command; /* id */
    double movement;     /* the farthest that a point of the geodesic goes, mm */
    double extent[2];    /* afterwards, mm */
} kg_mend;

typedef struct kg_mends {
    int64_t patch;   /* 0: none was tried */
    uint64_t solved; /* editor->solved then */
    size_t count;
    kg_mend items[KG_MEND_MOST];
} kg_mends;

#endif
