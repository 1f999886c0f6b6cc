#include "app/ui/state.hpp"

#include "app/ui/icons.h"
#include "app/ui/wrap.h"

#include <cmath>
#include <cstdio>
#include <cstring>

using namespace kg;

namespace {

unsigned field_result(bool changed) {
    unsigned result = changed ? (unsigned)KG_FIELD_CHANGED : 0;
    if (ImGui::IsItemActivated())
        result |= KG_FIELD_BEGAN;
    if (ImGui::IsItemDeactivatedAfterEdit())
        result |= KG_FIELD_ENDED;
    else if (ImGui::IsItemDeactivated())
        result |= KG_FIELD_LEFT;
    return result;
}

} // namespace

/* ---- layout ----------------------------------------------------------------------------- */

void kg_ui_same_line(void) {
    ImGui::SameLine();
}
void kg_ui_right(double width) {
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - px(width));
}
void kg_ui_separator(void) {
    ImGui::Separator();
}
void kg_ui_space(void) {
    ImGui::Dummy(ImVec2(0, px(4)));
}
void kg_ui_indent(void) {
    ImGui::Indent();
}
void kg_ui_unindent(void) {
    ImGui::Unindent();
}
void kg_ui_width(double width) {
    ImGui::SetNextItemWidth(width < 0 ? -FLT_MIN : px(width));
}
double kg_ui_available(void) {
    return ImGui::GetContentRegionAvail().x / ui.scale;
}
double kg_ui_text_width(const char *text) {
    return ImGui::CalcTextSize(see(text)).x / ui.scale;
}
double kg_ui_line_height_px(void) {
    return ImGui::GetFrameHeight();
}
void kg_ui_id_push(int64_t id) {
    ImGui::PushID((void *)(intptr_t)id);
}
void kg_ui_id_pop(void) {
    ImGui::PopID();
}
void kg_ui_disabled_begin(bool disabled) {
    ImGui::BeginDisabled(disabled);
}
void kg_ui_disabled_end(void) {
    ImGui::EndDisabled();
}
bool kg_ui_section(const char *label, bool open) {
    ImGui::Spacing();
    return shown(label,
                 ImGui::CollapsingHeader(see(label), open ? ImGuiTreeNodeFlags_DefaultOpen : 0));
}

bool kg_ui_table_begin(const char *id, int columns, const double *widths) {
    if (!ImGui::BeginTable(id, columns, ImGuiTableFlags_NoSavedSettings))
        return false;
    for (int i = 0; i < columns; i++)
        if (widths[i] > 0)
            ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, px(widths[i]));
        else
            ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch);
    return true;
}
void kg_ui_table_row(void) {
    ImGui::TableNextRow();
}
void kg_ui_table_next(void) {
    ImGui::TableNextColumn();
}
void kg_ui_table_end(void) {
    ImGui::EndTable();
}

/* ---- widgets ---------------------------------------------------------------------------- */

void kg_ui_text(const char *text) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(see(text));
}
void kg_ui_text_dim(const char *text) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", see(text));
}
static double width_between(const char *begin, const char *end) {
    return ImGui::CalcTextSize(begin, end).x;
}
static void text_in_lines(const char *text, double width) {
    char lines[2048];
    kg_ui_wrap(see(text), width, width_between, lines, sizeof lines);
    ImGui::TextUnformatted(lines);
}
void kg_ui_text_wrapped(const char *text) {
    text_in_lines(text, ImGui::GetContentRegionAvail().x);
}
void kg_ui_text_color(kg_color color, const char *text) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextColored(rgba(color), "%s", see(text));
}
bool kg_ui_link(kg_color color, const char *text) {
    kg_ui_text_color(color, text);
    if (ImGui::IsItemHovered())
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    return shown(text, ImGui::IsItemClicked());
}

bool kg_ui_button(const char *label) {
    return shown(label, ImGui::Button(see(label)));
}
bool kg_ui_primary_button(const char *label) {
    ImGui::PushStyleColor(ImGuiCol_Button, rgb(0x3d7fc4));
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, rgb(0x4d93dc));
    ImGui::PushStyleColor(ImGuiCol_Text, rgb(0xffffff));
    bool pressed = shown(label, ImGui::Button(see(label)));
    ImGui::PopStyleColor(3);
    /* the Enter that opened this window was for another one */
    return pressed ||
           (!ImGui::IsWindowAppearing() && ImGui::IsWindowFocused(ImGuiFocusedFlags_ChildWindows) &&
            (kg_ui_key_pressed(KG_KEY_ENTER) || kg_ui_key_pressed(KG_KEY_PAD_ENTER)));
}
bool kg_ui_small_button(const char *label) {
    return shown(label, ImGui::SmallButton(see(label)));
}
bool kg_ui_check(const char *label, bool *value) {
    return shown(label, ImGui::Checkbox(see(label), value));
}
bool kg_ui_radio(const char *label, bool on) {
    return shown(label, ImGui::RadioButton(see(label), on));
}
bool kg_ui_choice(const char *label, const char *const *items, int count, int *index) {
    bool changed = false;
    bool open =
        ImGui::BeginCombo(see(label), *index >= 0 && *index < count ? see(items[*index]) : "");
    shown(label, true);
    if (!open)
        return false;
    for (int i = 0; i < count; i++)
        if (shown(items[i], ImGui::Selectable(see(items[i]), i == *index))) {
            changed = i != *index;
            *index = i;
        }
    if (ImGui::IsKeyPressed(KG_KEY_ESCAPE)) {
        ImGui::CloseCurrentPopup();
        ui.escaped = ImGui::GetFrameCount();
        ui.unsettled = 2;
    }
    ImGui::EndCombo();
    return changed;
}
bool kg_ui_selectable(const char *label, bool selected) {
    ImGui::AlignTextToFramePadding(); /* as texts and icons beside it */
    return shown(label,
                 ImGui::Selectable(see(label), selected, ImGuiSelectableFlags_DontClosePopups));
}
bool kg_ui_selectable_lines(const char *label, bool selected) {
    char lines[2048];
    ImGui::AlignTextToFramePadding();
    kg_ui_wrap(see(label), ImGui::GetContentRegionAvail().x, width_between, lines, sizeof lines);
    return shown(label, ImGui::Selectable(lines, selected, ImGuiSelectableFlags_DontClosePopups));
}
size_t kg_ui_line_count(const char *text, double width) {
    char lines[2048];
    size_t count = 1;
    kg_ui_wrap(see(text), px(width), width_between, lines, sizeof lines);
    for (const char *c = lines; *c != '\0'; c++)
        count += *c == '\n';
    return count;
}
bool kg_ui_row(const char *label, bool selected, double height, kg_area *out_area) {
    bool pressed = ImGui::Selectable(see(label), selected,
                                     ImGuiSelectableFlags_DontClosePopups |
                                         ImGuiSelectableFlags_AllowItemOverlap,
                                     ImVec2(0, px(height)));
    *out_area = item_area();
    ui.canvas = ImGui::GetWindowDrawList();
    return shown(label, pressed);
}
void kg_ui_progress(double fraction, const char *text) {
    ImGui::ProgressBar((float)fraction, ImVec2(-FLT_MIN, 0), see(text));
}
void kg_ui_tooltip(const char *text) {
    if (text && *text && ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) {
        ImGui::BeginTooltip();
        text_in_lines(text, px(300));
        ImGui::EndTooltip();
    }
}

unsigned kg_ui_number(const char *label, double *value, double speed, double lo, double hi,
                      const char *format) {
    char text[64];
    snprintf(text, sizeof text, format, *value);
    if (*value < 0 &&
        std::strpbrk(text, "123456789") == nullptr) /* "-0.00"; a caller keeps its own */
        *value = 0;
    bool changed = ImGui::DragScalar(see(label), ImGuiDataType_Double, value, (float)speed, &lo,
                                     &hi, format, ImGuiSliderFlags_AlwaysClamp);
    return shown(label, field_result(changed));
}
unsigned kg_ui_slider(const char *label, double *value, double lo, double hi, const char *format) {
    bool changed = ImGui::SliderScalar(see(label), ImGuiDataType_Double, value, &lo, &hi,
                                       see(format), ImGuiSliderFlags_AlwaysClamp);
    return shown(label, field_result(changed));
}
unsigned kg_ui_color_field(const char *label, kg_color *color) {
    bool changed = ImGui::ColorEdit3(see(label), &color->r, ImGuiColorEditFlags_NoInputs);
    return shown(label, field_result(changed));
}
unsigned kg_ui_text_field(const char *label, char *text, size_t size, const char *hint,
                          bool focus) {
    if (focus)
        ImGui::SetKeyboardFocusHere();
    see(text);
    ui.entered = ImGui::InputTextWithHint(see(label), see(hint ? hint : ""), text, size,
                                          ImGuiInputTextFlags_EnterReturnsTrue |
                                              ImGuiInputTextFlags_AutoSelectAll);
    unsigned result = field_result(ImGui::IsItemEdited());
    return shown(label, result);
}
bool kg_ui_field_entered(void) {
    return ui.entered;
}

bool kg_ui_icon_button(const char *label, kg_icon icon, bool on, double size) {
    float side = size > 0 ? px(size) : ImGui::GetFrameHeight();
    bool pressed = ImGui::InvisibleButton(label, ImVec2(side, side));
    kg_area area = item_area();
    ImDrawList *before = ui.canvas;
    ui.canvas = ImGui::GetWindowDrawList();
    ImVec4 back = on                       ? rgb(0x3d7fc4)
                  : ImGui::IsItemHovered() ? ImGui::GetStyleColorVec4(ImGuiCol_ButtonHovered)
                                           : ImVec4(0, 0, 0, 0);
    kg_ui_canvas_rect(area, kg_color{back.x, back.y, back.z, back.w}, px(ROUNDING));
    kg_icon_draw(icon, area, on ? kg_color{1, 1, 1, 1} : text_color());
    ui.canvas = before;
    return shown(label, pressed);
}
void kg_ui_icon(kg_icon icon, kg_color color) {
    float side = ImGui::GetFrameHeight();
    ImGui::Dummy(ImVec2(side, side));
    ImDrawList *before = ui.canvas;
    ui.canvas = ImGui::GetWindowDrawList();
    kg_icon_draw(icon, item_area(), color.a > 0 ? color : text_color());
    ui.canvas = before;
}

void kg_ui_mark(kg_color color) {
    ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddRectFilled(
        ImVec2(at.x - px(4), at.y), ImVec2(at.x - px(1), at.y + ImGui::GetTextLineHeight()),
        packed(color));
}

bool kg_ui_item_hovered(void) {
    return ImGui::IsItemHovered();
}
bool kg_ui_item_double_clicked(void) {
    return ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0);
}
void kg_ui_scroll_here(void) {
    ImGui::SetScrollHereY();
}
void kg_ui_subject(int64_t subject) {
    ImGuiStorage *storage = ImGui::GetStateStorage();
    ImGuiID key = ImGui::GetID("subject");
    if (storage->GetInt(key) == (int)subject)
        return;
    storage->SetInt(key, (int)subject);
    ImGui::SetScrollY(0);
}
bool kg_ui_mouse_held(void) {
    return ImGui::IsMouseDown(0);
}
/* An open list takes Escape from the dialog that it belongs to. */
bool kg_ui_key_pressed(int key) {
    bool taken = key == KG_KEY_ESCAPE && (ui.escaped == ImGui::GetFrameCount() ||
                                          ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId));
    return ImGui::IsKeyPressed(key) && !taken;
}

/* ---- canvas ----------------------------------------------------------------------------- */

void kg_ui_canvas(kg_canvas canvas) {
    ui.canvas = canvas == KG_CANVAS_BEHIND  ? ImGui::GetBackgroundDrawList()
                : canvas == KG_CANVAS_ABOVE ? ImGui::GetForegroundDrawList()
                                            : ImGui::GetWindowDrawList();
}
void kg_ui_canvas_clip(kg_area a) {
    ui.canvas->PushClipRect(ImVec2((float)a.x, (float)a.y),
                            ImVec2((float)(a.x + a.width), (float)(a.y + a.height)), true);
}
void kg_ui_canvas_unclip(void) {
    ui.canvas->PopClipRect();
}
void kg_ui_canvas_line(kg_vec2 a, kg_vec2 b, kg_color color, double width_px) {
    ui.canvas->AddLine(vec(a), vec(b), packed(color), (float)width_px);
}
void kg_ui_canvas_polyline(const kg_vec2 *points, size_t count, bool closed, kg_color color,
                           double width_px) {
    for (size_t i = 0; i < count; i++)
        ui.canvas->PathLineTo(vec(points[i]));
    ui.canvas->PathStroke(packed(color), closed ? ImDrawFlags_Closed : 0, (float)width_px);
}
void kg_ui_canvas_polygon(const kg_vec2 *points, size_t count, kg_color color) {
    for (size_t i = 0; i < count; i++)
        ui.canvas->PathLineTo(vec(points[i]));
    ui.canvas->PathFillConvex(packed(color));
}
void kg_ui_canvas_circle(kg_vec2 center, double radius_px, kg_color color, double width_px) {
    ui.canvas->AddCircle(vec(center), (float)radius_px, packed(color), 0, (float)width_px);
}
void kg_ui_canvas_disc(kg_vec2 center, double radius_px, kg_color color) {
    ui.canvas->AddCircleFilled(vec(center), (float)radius_px, packed(color));
}
void kg_ui_canvas_rect(kg_area a, kg_color color, double rounding_px) {
    ui.canvas->AddRectFilled(ImVec2((float)a.x, (float)a.y),
                             ImVec2((float)(a.x + a.width), (float)(a.y + a.height)), packed(color),
                             (float)rounding_px);
}
void kg_ui_canvas_frame(kg_area a, kg_color color, double width_px, double rounding_px) {
    ui.canvas->AddRect(ImVec2((float)a.x, (float)a.y),
                       ImVec2((float)(a.x + a.width), (float)(a.y + a.height)), packed(color),
                       (float)rounding_px, 0, (float)width_px);
}
void kg_ui_canvas_text(kg_vec2 at, kg_color color, const char *text) {
    ImVec2 size = ImGui::CalcTextSize(see(text));
    ui.canvas->AddText(ImVec2((float)at.x - size.x / 2, (float)at.y - size.y / 2), packed(color),
                       text);
}
void kg_ui_canvas_label(kg_vec2 at, kg_color color, const char *text) {
    ui.canvas->AddText(vec(at), packed(color), see(text));
}
kg_color kg_ui_text_ink(void) {
    return text_color();
}
kg_area kg_ui_canvas_area(const char *label, double width, double height) {
    ImVec2 left = ImGui::GetContentRegionAvail();
    ImVec2 size(width > 0 ? px(width) : std::fmax(left.x, 1),
                height > 0 ? px(height) : std::fmax(left.y, 1));
    ImGui::InvisibleButton(label, size);
    ui.canvas = ImGui::GetWindowDrawList();
    return shown(label, item_area());
}
