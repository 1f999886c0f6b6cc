#include "app/ui/state.hpp"

#include <cmath>

using namespace kg;

/* Of the height of a font, its capitals. */
static constexpr float CAPITAL = 0.72f;

/* Below this many pixels text is a smudge. */
static constexpr float LEAST_SIZE = 2.5f;

void kg_ui_canvas_text_turned(kg_vec2 at, double angle, double share, double capital_px,
                              kg_color color, const char *text) {
    ImFont *font = ImGui::GetFont();
    float size = (float)capital_px / CAPITAL;
    if (size < LEAST_SIZE)
        return;
    see(text);
    /* Letters outside of the clipping are left out before they are turned: so they are set in the
     * middle of it, then turned and moved. */
    ImVec4 clip = ui.canvas->_ClipRectStack.back();
    ImVec2 middle((clip.x + clip.z) / 2, (clip.y + clip.w) / 2);
    float width = font->CalcTextSizeA(size, FLT_MAX, 0, text).x;
    float baseline = font->Ascent * size / font->FontSize;
    int first = ui.canvas->VtxBuffer.Size;
    ui.canvas->AddText(
        font, size,
        ImVec2(middle.x - width * (float)share, middle.y - baseline + (float)capital_px / 2),
        packed(color), text);
    float c = (float)std::cos(angle), s = (float)std::sin(angle);
    for (int i = first; i < ui.canvas->VtxBuffer.Size; i++) {
        ImVec2 &p = ui.canvas->VtxBuffer[i].pos;
        float x = p.x - middle.x, y = p.y - middle.y;
        p = ImVec2((float)at.x + c * x - s * y, (float)at.y + s * x + c * y);
    }
}

void kg_ui_name(const char *label, kg_area area) {
    ui.widgets.push_back({label, area});
}
