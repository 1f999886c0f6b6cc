#include "app/ui/state.hpp"

#include <backends/imgui_impl_opengl3.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include <unistd.h>

using namespace kg;

kg::adapter kg::ui;

const char *kg::see(const char *text) {
    const char *p = text;
    while (p && *p) {
        unsigned c = 0;
        if ((unsigned char)*p < 0x80) {
            p++;
            continue;
        }
        p += ImTextCharFromUtf8(&c, p, nullptr);
        if (c > 0xff && c < GLYPH_COUNT && !ui.glyphs[c]) {
            ui.glyphs[c] = true;
            ui.glyphs_added = true;
        }
    }
    return text;
}

namespace {

constexpr float FONT_SIZE = 15;

/* ---- fonts ------------------------------------------------------------------------------ */

const char *const fonts[] = {
    "/usr/share/fonts/opentype/ipaexfont-gothic/ipaexg.ttf",
    "/usr/share/fonts/truetype/fonts-japanese-gothic.ttf",
    "/usr/share/fonts/truetype/vlgothic/VL-PGothic-Regular.ttf",
    "/usr/share/fonts/opentype/noto/NotoSansCJK-Regular.ttc",
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
    "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf",
};

void build_font() {
    ImGuiIO &io = ImGui::GetIO();
    static ImVector<ImWchar> ranges; /* has to live as long as the font */
    ImFontGlyphRangesBuilder builder;
    builder.AddRanges(io.Fonts->GetGlyphRangesDefault());
    for (unsigned c = 0x100; c < GLYPH_COUNT; c++)
        if (ui.glyphs[c])
            builder.AddChar((ImWchar)c);
    ranges.clear();
    builder.BuildRanges(&ranges);
    io.Fonts->Clear();
    ImFontConfig config;
    config.OversampleH = 2;
    config.PixelSnapH = true;
    float size = std::round(FONT_SIZE * (float)ui.scale);
    ImFont *font = nullptr;
    for (const char *path : fonts)
        if (!font && access(path, R_OK) == 0)
            font = io.Fonts->AddFontFromFileTTF(path, size, &config, ranges.Data);
    if (!font) {
        config.SizePixels = size;
        io.Fonts->AddFontDefault(&config);
    }
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
    ui.glyphs_added = false;
}

/* ---- look ------------------------------------------------------------------------------- */

void build_style() {
    ImGuiStyle style;
    bool dark = ui.theme == KG_UI_DARK;
    if (dark)
        ImGui::StyleColorsDark(&style);
    else
        ImGui::StyleColorsLight(&style);
    style.WindowRounding = style.ChildRounding = 0;
    style.FrameRounding = style.PopupRounding = style.GrabRounding = ROUNDING;
    style.ScrollbarRounding = ROUNDING;
    style.WindowBorderSize = 0;
    style.PopupBorderSize = 1;
    style.FrameBorderSize = dark ? 0 : 1;
    style.WindowPadding = ImVec2(10, 8);
    style.FramePadding = ImVec2(7, 4);
    style.ItemSpacing = ImVec2(7, 5);
    style.ItemInnerSpacing = ImVec2(6, 4);
    style.CellPadding = ImVec2(3, 2);
    style.IndentSpacing = 14;
    style.ScrollbarSize = 12;
    style.GrabMinSize = 10;
    style.DisabledAlpha = 0.42f;
    ImVec4 *c = style.Colors;
    ImVec4 accent = rgb(dark ? 0x3d7fc4 : 0x2f74bd), lit = rgb(dark ? 0x4d93dc : 0x4189d4);
    ImVec4 field = rgb(dark ? 0x1f2226 : 0xffffff), face = rgb(dark ? 0x3b4047 : 0xe2e5e9);
    c[ImGuiCol_Text] = rgb(dark ? 0xe3e6ea : 0x1d2126);
    c[ImGuiCol_TextDisabled] = rgb(dark ? 0x8f969f : 0x6a727c);
    c[ImGuiCol_WindowBg] = rgb(dark ? 0x2a2d32 : 0xf3f4f6);
    c[ImGuiCol_PopupBg] = rgb(dark ? 0x2f3338 : 0xfbfcfd);
    c[ImGuiCol_MenuBarBg] = rgb(dark ? 0x24272b : 0xe9ebee);
    c[ImGuiCol_Border] = rgb(dark ? 0x43484f : 0xc6cbd1);
    c[ImGuiCol_Separator] = rgb(dark ? 0x3d4248 : 0xd3d7dc);
    c[ImGuiCol_FrameBg] = field;
    c[ImGuiCol_FrameBgHovered] = rgb(dark ? 0x2b3036 : 0xf0f6fd);
    c[ImGuiCol_FrameBgActive] = rgb(dark ? 0x30363d : 0xe4effa);
    c[ImGuiCol_Button] = face;
    c[ImGuiCol_ButtonHovered] = rgb(dark ? 0x4a5059 : 0xd3d8de);
    c[ImGuiCol_ButtonActive] = accent;
    c[ImGuiCol_Header] = rgb(dark ? 0x34506e : 0xcfe2f5);
    c[ImGuiCol_HeaderHovered] = rgb(dark ? 0x3c5e82 : 0xdceaf8);
    c[ImGuiCol_HeaderActive] = accent;
    c[ImGuiCol_CheckMark] = c[ImGuiCol_SliderGrab] = lit;
    c[ImGuiCol_SliderGrabActive] = accent;
    c[ImGuiCol_TitleBg] = c[ImGuiCol_TitleBgActive] = c[ImGuiCol_MenuBarBg];
    c[ImGuiCol_ScrollbarBg] = ImVec4(0, 0, 0, 0);
    c[ImGuiCol_ScrollbarGrab] = rgb(dark ? 0x4a5058 : 0xc3c8ce);
    c[ImGuiCol_PlotHistogram] = accent;
    c[ImGuiCol_TextSelectedBg] = rgb(dark ? 0x3d7fc4 : 0x9cc6ef, 0.6f);
    c[ImGuiCol_ModalWindowDimBg] = ImVec4(0, 0, 0, 0.35f);
    c[ImGuiCol_TableRowBgAlt] = rgb(dark ? 0xffffff : 0x000000, 0.025f);
    style.ScaleAllSizes((float)ui.scale);
    ImGui::GetStyle() = style;
    ui.look_changed = false;
}

const char *get_clipboard(void *) {
    if (ui.clipboard_get) {
        const char *text = ui.clipboard_get(ui.clipboard_user);
        return text ? see(text) : "";
    }
    return ui.clipboard.c_str();
}

void set_clipboard(void *, const char *text) {
    ui.clipboard = text;
    if (ui.clipboard_set)
        ui.clipboard_set(ui.clipboard_user, text);
}

void feed(const kg_event *e) {
    ImGuiIO &io = ImGui::GetIO();
    io.KeyCtrl = e->mods & KG_MOD_CTRL;
    io.KeyShift = e->mods & KG_MOD_SHIFT;
    io.KeyAlt = e->mods & KG_MOD_ALT;
    switch (e->type) {
    case KG_EVENT_PRESS:
    case KG_EVENT_RELEASE:
        io.MouseDown[e->button] = e->type == KG_EVENT_PRESS;
        io.MousePos = vec(e->position);
        break;
    case KG_EVENT_WHEEL:
        io.MouseWheel += (float)e->wheel;
        io.MousePos = vec(e->position);
        break;
    case KG_EVENT_MOVE:
        io.MousePos = vec(e->position);
        break;
    case KG_EVENT_KEY:
    case KG_EVENT_KEY_UP:
        if (e->key >= 0 && e->key < KG_KEY_COUNT)
            io.KeysDown[e->key] = e->type == KG_EVENT_KEY;
        break;
    case KG_EVENT_TEXT:
        io.AddInputCharacter(e->codepoint);
        if (e->codepoint > 0xff && e->codepoint < GLYPH_COUNT && !ui.glyphs[e->codepoint])
            ui.glyphs[e->codepoint] = ui.glyphs_added = true;
        break;
    default:
        break;
    }
}

} // namespace

/* ---- life ------------------------------------------------------------------------------- */

kg_status kg_ui_create(kg_error *error) {
    ui.glyphs.assign(GLYPH_COUNT, false);
    for (unsigned c = 0x3000; c < 0x3100; c++) /* kana and punctuation, nearly always wanted */
        ui.glyphs[c] = true;
    ImGui::CreateContext();
    ImGuiIO &io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    io.ConfigInputTextCursorBlink = false; /* an idle window draws nothing */
    io.BackendFlags |= ImGuiBackendFlags_HasMouseCursors;
    io.SetClipboardTextFn = set_clipboard;
    io.GetClipboardTextFn = get_clipboard;
    static const int keys[][2] = {{ImGuiKey_Tab, KG_KEY_TAB},
                                  {ImGuiKey_LeftArrow, KG_KEY_LEFT},
                                  {ImGuiKey_RightArrow, KG_KEY_RIGHT},
                                  {ImGuiKey_UpArrow, KG_KEY_UP},
                                  {ImGuiKey_DownArrow, KG_KEY_DOWN},
                                  {ImGuiKey_PageUp, KG_KEY_PAGE_UP},
                                  {ImGuiKey_PageDown, KG_KEY_PAGE_DOWN},
                                  {ImGuiKey_Home, KG_KEY_HOME},
                                  {ImGuiKey_End, KG_KEY_END},
                                  {ImGuiKey_Insert, KG_KEY_INSERT},
                                  {ImGuiKey_Delete, KG_KEY_DELETE},
                                  {ImGuiKey_Backspace, KG_KEY_BACKSPACE},
                                  {ImGuiKey_Space, ' '},
                                  {ImGuiKey_Enter, KG_KEY_ENTER},
                                  {ImGuiKey_KeyPadEnter, KG_KEY_PAD_ENTER},
                                  {ImGuiKey_Escape, KG_KEY_ESCAPE},
                                  {ImGuiKey_A, 'A'},
                                  {ImGuiKey_C, 'C'},
                                  {ImGuiKey_V, 'V'},
                                  {ImGuiKey_X, 'X'},
                                  {ImGuiKey_Y, 'Y'},
                                  {ImGuiKey_Z, 'Z'}};
    for (auto &key : keys)
        io.KeyMap[key[0]] = key[1];
    if (!ImGui_ImplOpenGL3_Init("#version 330 core")) {
        ImGui::DestroyContext();
        return kg_fail(error, KG_ERR_SYSTEM, "the user interface cannot draw with OpenGL 3.3");
    }
    ui.unsettled = 2;
    return KG_OK;
}

void kg_ui_destroy(void) {
    if (!ImGui::GetCurrentContext())
        return;
    delete_pictures();
    ImGui_ImplOpenGL3_Shutdown();
    ImGui::DestroyContext();
    ui = adapter();
}

void kg_ui_set_look(kg_ui_theme theme, double scale) {
    ui.look_changed = ui.look_changed || theme != ui.theme || scale != ui.scale;
    ui.glyphs_added = ui.glyphs_added || scale != ui.scale;
    ui.theme = theme;
    ui.scale = scale;
}

void kg_ui_set_clipboard(void *user, const char *(*get)(void *),
                         void (*set)(void *, const char *)) {
    ui.clipboard_user = user;
    ui.clipboard_get = get;
    ui.clipboard_set = set;
}

/* ---- frames ----------------------------------------------------------------------------- */

void kg_ui_begin(const kg_event *event, int width_px, int height_px, double seconds) {
    ImGuiIO &io = ImGui::GetIO();
    delete_pictures();
    io.DisplaySize = ImVec2((float)width_px, (float)height_px);
    io.DeltaTime = seconds > 1e-4 ? (float)seconds : 1e-4f;
    feed(event);
    if (event->type != KG_EVENT_NONE)
        ui.unsettled = 2; /* windows take their size one frame late, menus two */
    else if (ui.unsettled > 0)
        ui.unsettled--;
    if (ui.look_changed)
        build_style();
    if (ui.glyphs_added || io.Fonts->Fonts.empty())
        build_font();
    ImGui_ImplOpenGL3_NewFrame();
    ImGui::NewFrame();
    ui.last_widgets.swap(ui.widgets);
    ui.widgets.clear();
    ui.canvas = ImGui::GetBackgroundDrawList();
}

bool kg_ui_has_mouse(void) {
    return ImGui::GetIO().WantCaptureMouse;
}
bool kg_ui_has_keys(void) {
    return ImGui::GetIO().WantTextInput || kg_ui_any_popup();
}

void kg_ui_end(void) {
    ImGui::Render();
}

void kg_ui_draw(void) {
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

bool kg_ui_unsettled(void) {
    return ui.unsettled > 0 || ui.glyphs_added || ui.look_changed;
}

kg_ui_cursor kg_ui_get_cursor(void) {
    switch (ImGui::GetMouseCursor()) {
    case ImGuiMouseCursor_TextInput:
        return KG_CURSOR_TEXT;
    case ImGuiMouseCursor_ResizeAll:
        return KG_CURSOR_MOVE;
    case ImGuiMouseCursor_ResizeEW:
        return KG_CURSOR_RESIZE_X;
    case ImGuiMouseCursor_ResizeNS:
        return KG_CURSOR_RESIZE_Y;
    case ImGuiMouseCursor_Hand:
        return KG_CURSOR_HAND;
    default:
        return KG_CURSOR_ARROW;
    }
}

bool kg_ui_find(const char *label, kg_area *out_area) {
    for (auto *list : {&ui.widgets, &ui.last_widgets})
        for (size_t i = list->size(); i-- > 0;) /* what is on top was shown last */
            if ((*list)[i].label == label) {
                *out_area = (*list)[i].area;
                return true;
            }
    return false;
}

/* ---- windows ---------------------------------------------------------------------------- */

void kg_ui_panel_begin(const char *id, const char *title, kg_area area, unsigned flags) {
    ImGui::SetNextWindowPos(ImVec2((float)area.x, (float)area.y));
    ImGui::SetNextWindowSize(ImVec2((float)area.width, (float)area.height));
    ImGuiWindowFlags f = ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                         ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                         ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoTitleBar |
                         ImGuiWindowFlags_NoNav;
    if (flags & KG_PANEL_NO_SCROLL)
        f |= ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse;
    if (flags & KG_PANEL_SEE_THROUGH)
        ImGui::SetNextWindowBgAlpha(0.85f);
    if (flags & KG_PANEL_PLAIN)
        ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(px(4), px(4)));
    ImGui::Begin(id, nullptr, f);
    if (flags & KG_PANEL_PLAIN)
        ImGui::PopStyleVar();
    if (title) {
        ImGui::TextDisabled("%s", see(title));
        ImGui::Separator();
    }
}
void kg_ui_panel_end(void) {
    ImGui::End();
}

void kg_ui_child_begin(const char *id, double height) {
    ImGui::BeginChild(id, ImVec2(0, px(height)), false, ImGuiWindowFlags_NoNav);
}
void kg_ui_child_end(void) {
    ImGui::EndChild();
}

void kg_ui_popup_open(const char *id) {
    ImGui::OpenPopup(id);
    ui.unsettled = 2;
}
/* Escape closes what it would close elsewhere; Dear ImGui alone leaves it open. */
static bool closed_by_escape(bool open) {
    if (open && kg_ui_key_pressed(KG_KEY_ESCAPE))
        ImGui::CloseCurrentPopup();
    return open;
}
bool kg_ui_popup_begin(const char *id) {
    return closed_by_escape(ImGui::BeginPopup(id));
}
bool kg_ui_modal_begin(const char *id, double width) {
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Always,
                            ImVec2(0.5f, 0.5f));
    ImGui::SetNextWindowSize(ImVec2(px(width), 0));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(px(16), px(12)));
    bool open = ImGui::BeginPopupModal(see(id), nullptr,
                                       ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                                           ImGuiWindowFlags_NoSavedSettings);
    ImGui::PopStyleVar();
    return open;
}
bool kg_ui_palette_begin(const char *id, double width) {
    ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(size.x / 2, size.y * 0.12f), ImGuiCond_Always, ImVec2(0.5f, 0));
    ImGui::SetNextWindowSize(ImVec2(px(width), 0));
    return ImGui::BeginPopup(id, ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav);
}
void kg_ui_popup_end(void) {
    ImGui::EndPopup();
}
void kg_ui_popup_close(void) {
    ImGui::CloseCurrentPopup();
}
bool kg_ui_any_popup(void) {
    return ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
}

bool kg_ui_menu_bar_begin(void) {
    return ImGui::BeginMainMenuBar();
}
double kg_ui_menu_bar_end(void) {
    double height = ImGui::GetWindowHeight();
    ImGui::EndMainMenuBar();
    return height;
}
bool kg_ui_menu_begin(const char *label) {
    bool open = ImGui::BeginMenu(see(label));
    if (!open)
        shown(label, true);
    return closed_by_escape(open);
}
void kg_ui_menu_end(void) {
    ImGui::EndMenu();
}
bool kg_ui_menu_item(const char *label, const char *shortcut, bool checked, bool enabled) {
    return shown(label, ImGui::MenuItem(see(label), see(shortcut), checked, enabled));
}
