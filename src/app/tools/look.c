/* Looking only: what is left of the mouse when a document cannot be edited by it. */
#include "app/text.h"
#include "app/tools/tool.h"

static bool look_event(kg_editor *e, const kg_event *event) {
    (void)e, (void)event;
    return false;
}

const kg_tool kg_tool_look = {.id = "look",
                              .title = N_("Look"),
                              .hint = N_("Right drag turns the view."),
                              .event = look_event};
