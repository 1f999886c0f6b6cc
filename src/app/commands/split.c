/* Splitting a patch in two with a plane in between. */
#include "app/commands/mend.h"
#include "app/scenery.h"
#include "app/text.h"
#include "model/divide.h"
#include "model/edit.h"

#include <stdio.h>

kg_status kg_mend_split(kg_editor *e, int64_t id, kg_error *error) {
    kg_model *m = kg_editor_model(e);
    const kg_model_patch *p = kg_model_find(m, id);
    const char *gap = p->name[0] ? " " : "";
    char plane[256], half[256], color[8]; /* as it is shown: the parts stay one thing to the eye */
    snprintf(plane, sizeof plane, "%s%s%s", p->name, gap, _("plane"));
    snprintf(half, sizeof half, "%s%s2", p->name, gap);
    kg_color_print(kg_patch_color(p), color);
    const char *const names[KG_DIVIDED] = {NULL, plane, half, _("cut 1"), _("cut 2")};
    int64_t ids[KG_DIVIDED];
    kg_status status = kg_model_divide(m, kg_editor_solution(e), id, names, ids, error);
    for (int i = KG_MIDDLE_PLANE; i <= KG_SECOND_HALF && !status; i++)
        status = kg_model_set_patch_color(kg_model_find(m, ids[i]), color, error);
    for (int i = 1; i < KG_DIVIDED && !status; i++)
        if (!kg_editor_is_selected(e, ids[i]))
            kg_editor_select(e, ids[i], true);
    return status;
}
