/*
 * What the files of the adapter to Dear ImGui share. Dear ImGui keeps one context per process, and
 * so the adapter keeps one state.
 */
#ifndef KG_APP_UI_STATE_HPP
#define KG_APP_UI_STATE_HPP

#include "app/ui/ui.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cfloat>
#include <cstring>
#include <string>
#include <vector>

namespace kg {

constexpr float ROUNDING = 4;
constexpr unsigned GLYPH_COUNT = 0x10000;

struct found_widget {
    std::string label;
    kg_area area;
};

struct adapter {
    kg_ui_theme theme = KG_UI_DARK;
    double scale = 1;
    bool look_changed = true;
    std::vector<bool> glyphs; /* asked for so far */
    bool glyphs_added = false;
    std::vector<found_widget> widgets, last_widgets;
    ImDrawList *canvas = nullptr;
    bool entered = false;
    int unsettled = 0;
    int escaped = -1; /* the frame in which a list took Escape */
    void *clipboard_user = nullptr;
    const char *(*clipboard_get)(void *) = nullptr;
    void (*clipboard_set)(void *, const char *) = nullptr;
    std::string clipboard;
};

extern adapter ui;

/* Deletes pictures that no frame shows any more. */
void delete_pictures();

/* Notes the characters of a text. A whole Japanese font takes a second to draw, so the font holds
 * those that were seen and grows when others come. */
const char *see(const char *text);

inline ImVec4 rgb(unsigned hex, float alpha = 1) {
    return ImVec4((float)(hex >> 16 & 255) / 255, (float)(hex >> 8 & 255) / 255,
                  (float)(hex & 255) / 255, alpha);
}

inline float px(double length) {
    return (float)(length * ui.scale);
}
inline ImVec2 vec(kg_vec2 v) {
    return ImVec2((float)v.x, (float)v.y);
}
inline ImVec4 rgba(kg_color c) {
    return ImVec4(c.r, c.g, c.b, c.a);
}
inline ImU32 packed(kg_color c) {
    return ImGui::ColorConvertFloat4ToU32(rgba(c));
}
inline kg_area item_area() {
    ImVec2 lo = ImGui::GetItemRectMin(), hi = ImGui::GetItemRectMax();
    return kg_area{lo.x, lo.y, hi.x - lo.x, hi.y - lo.y};
}
inline kg_color text_color() {
    ImVec4 c = ImGui::GetStyleColorVec4(ImGuiCol_Text);
    return kg_color{c.x, c.y, c.z, c.w * ImGui::GetStyle().Alpha};
}

/* Remembers where the widget just shown is. */
template <class T>
T shown(const char *label, T result) {
    const char *end = std::strstr(label, "##");
    std::string name = end == label ? std::string(label + 2)
                       : end        ? std::string(label, end)
                                    : std::string(label);
    if (ImGui::IsItemVisible())
        ui.widgets.push_back({name, item_area()});
    return result;
}

} // namespace kg

#endif
