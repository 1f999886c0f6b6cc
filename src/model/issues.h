/* What the user should know about a model, in words. */
#ifndef KG_MODEL_ISSUES_H
#define KG_MODEL_ISSUES_H

#include "katagami/model.h"
#include "model/lookup.h"

typedef struct kg_issues {
    kg_issue *items;
    size_t count, capacity;
} kg_issues;

kg_status kg_issues_add(kg_issues *issues, kg_severity severity, int64_t patch, const char *code,
                        const char *format, ...) KG_PRINTF(5, 6) KG_CHECKED;

/* Warnings of a patch itself, and of its trims. */
kg_status kg_issues_of_patch(kg_issues *issues, const kg_solved_patch *patch) KG_CHECKED;
kg_status kg_issues_of_notes(kg_issues *issues, const kg_solved_patch *patch) KG_CHECKED;

/* Faults first, then in the order of the model; a patch's own order stays. */
kg_status kg_issues_sort(kg_issues *issues, const kg_lookup *places) KG_CHECKED;

#endif
