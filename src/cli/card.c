#include "cli/card.h"

#include <stdio.h>
#include <stdlib.h>

typedef struct figures {
    size_t windows, omitted;
    double length[4]; /* mm of lines, by kg_oa_edge */
    int degrees;
} figures;

static kg_status measure(kg_document *d, figures *out, kg_error *error) {
    const kg_oa *oa = kg_document_oa(d);
    kg_oa_line *lines;
    size_t count;
    *out = (figures){0};
    for (int x = 0; x < oa->width; x++)
        for (int z = 0; z <= oa->height; z++) {
            out->windows += z < oa->height && kg_oa_window(oa, x, z);
            out->omitted += kg_oa_omitted(oa, x, z);
        }
    kg_status status = kg_oa_lines(kg_document_sheet(d), &lines, &count, error);
    if (status)
        return status;
    for (size_t i = 0; i < count; i++)
        out->length[lines[i].kind] +=
            oa->cell_mm * hypot(lines[i].x1 - lines[i].x0, lines[i].row1 - lines[i].row0);
    free(lines);
    return kg_oa_mobility(kg_document_stability(d), &out->degrees, error);
}

kg_status kg_card_print(kg_document *d, const kg_document_net *net, kg_error *error) {
    const kg_oa *oa = kg_document_oa(d);
    const kg_oa_sheet *sheet = kg_document_sheet(d);
    const kg_oa_stability *s = kg_document_stability(d);
    figures f;
    kg_status status = measure(d, &f, error);
    if (status)
        return status;
    printf("%s: pop-up card of %d x %d x %d cells of %g mm, sheet %g x %g mm\n", oa->title,
           oa->width, oa->depth_limit, oa->height, oa->cell_mm, sheet->width * oa->cell_mm,
           sheet->rows * oa->cell_mm);
    printf("cuts %.1f mm, mountain folds %.1f mm, valley folds %.1f mm\n", f.length[KG_OA_CUT],
           f.length[KG_OA_MOUNTAIN], f.length[KG_OA_VALLEY]);
    printf("%zu windows, %zu tops left out, %zu pyramids\n", f.windows, f.omitted,
           sheet->pyramid_count);
    printf("%zu patches, %zu hinges, %zu patches loose", s->patch_count, s->hinge_count,
           s->loose_count);
    if (f.degrees >= 0)
        printf(", %d degree%s of freedom", f.degrees, f.degrees == 1 ? "" : "s");
    putchar('\n');
    for (size_t i = 0; i < net->remark_count; i++)
        printf("warning: %s\n", net->remarks[i].message);
    return KG_OK;
}

json_t *kg_card_json(kg_document *d, kg_error *error) {
    const kg_oa *oa = kg_document_oa(d);
    const kg_oa_sheet *sheet = kg_document_sheet(d);
    const kg_oa_stability *s = kg_document_stability(d);
    figures f;
    if (measure(d, &f, error))
        return NULL;
    json_t *card = json_pack(
        "{s:[i,i,i], s:f, s:[f,f], s:f, s:f, s:f, s:I, s:I, s:I, s:I, s:I, s:I, s:o, s:b}", "size",
        oa->width, oa->depth_limit, oa->height, "cell_mm", oa->cell_mm, "sheet_mm",
        sheet->width * oa->cell_mm, sheet->rows * oa->cell_mm, "cut_mm", f.length[KG_OA_CUT],
        "mountain_mm", f.length[KG_OA_MOUNTAIN], "valley_mm", f.length[KG_OA_VALLEY], "windows",
        (json_int_t)f.windows, "omitted", (json_int_t)f.omitted, "pyramids",
        (json_int_t)sheet->pyramid_count, "patches", (json_int_t)s->patch_count, "hinges",
        (json_int_t)s->hinge_count, "loose", (json_int_t)s->loose_count, "degrees_of_freedom",
        f.degrees >= 0 ? json_integer(f.degrees) : json_null(), "valid",
        kg_document_check(d, NULL) == KG_OK);
    if (!card)
        kg_fail(error, KG_ERR_MEMORY, "out of memory");
    return card;
}

void kg_card_warn(const kg_document *d, const char *command) {
    for (size_t i = 0; kg_document_remarks(d) && i < kg_document_issue_count(d); i++)
        if (kg_document_issue(d, i)->severity == KG_FAULT)
            fprintf(stderr, "katagami %s: warning: %s\n", command,
                    kg_document_issue(d, i)->message);
}
