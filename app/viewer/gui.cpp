#include "viewer/gui.h"

#include <imgui_internal.h>  // InputEventsQueue, windows and how far they are scrolled

#include <algorithm>
#include <cfloat>

namespace normalscope {

namespace {

constexpr double kShortestRound = 1e-5;  // Dear ImGui's time must go on

}  // namespace

Gui::Gui(Host& host) : host_(host), time_(host.now() - 1.0 / 60.0) {
    ImGui::CreateContext();
    interface.find_fonts_by([this](std::span<const char32_t> letters) { return host_.fonts_for(letters); });
    interface.draw_letters_by([this](char32_t letter, float em) { return host_.draw_letter(letter, em); });
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;  // what is worth remembering, the host remembers
    io.ClipboardUserData = this;
    io.SetClipboardTextFn = [](void* gui, const char* text) { static_cast<Gui*>(gui)->host_.set_clipboard(text); };
    io.GetClipboardTextFn = [](void* user) {
        auto& gui = *static_cast<Gui*>(user);
        gui.clipboard_ = gui.host_.clipboard();
        return gui.clipboard_.c_str();
    };
}

Gui::~Gui() { ImGui::DestroyContext(); }

void Gui::layout(Theme theme, float scale, const std::function<void()>& content) {
    if (interface.prepare(theme, scale)) host_.upload_fonts();
    ImGuiIO& io = ImGui::GetIO();
    const double now = std::max(host_.now(), time_ + kShortestRound);
    io.DeltaTime = static_cast<float>(now - time_);
    time_ = now;
    // The interface counts in framebuffer pixels, as the picture does, so that text is sharp on every screen.
    const glm::ivec2 framebuffer = host_.framebuffer_size();
    io.DisplaySize = ImVec2(static_cast<float>(framebuffer.x), static_cast<float>(framebuffer.y));
    io.DisplayFramebufferScale = ImVec2(1.0f, 1.0f);
    ImGui::NewFrame();
    content();
    ImGui::Render();
}

void Gui::modifiers(ImGuiKeyChord held) {
    for (const ImGuiKey modifier : {ImGuiMod_Ctrl, ImGuiMod_Shift, ImGuiMod_Alt, ImGuiMod_Super})
        ImGui::GetIO().AddKeyEvent(modifier, (held & modifier) != 0);
}

void Gui::key(ImGuiKey key, bool down, ImGuiKeyChord held) {
    // A modifier's own event comes before it is among those held.
    const auto own = [key](ImGuiKey left, ImGuiKey right, ImGuiKey modifier) {
        return key == left || key == right ? static_cast<ImGuiKeyChord>(modifier) : 0;
    };
    const ImGuiKeyChord itself = own(ImGuiKey_LeftCtrl, ImGuiKey_RightCtrl, ImGuiMod_Ctrl) |
                                 own(ImGuiKey_LeftShift, ImGuiKey_RightShift, ImGuiMod_Shift) |
                                 own(ImGuiKey_LeftAlt, ImGuiKey_RightAlt, ImGuiMod_Alt) |
                                 own(ImGuiKey_LeftSuper, ImGuiKey_RightSuper, ImGuiMod_Super);
    modifiers(down ? held | itself : held & ~itself);
    ImGui::GetIO().AddKeyEvent(key, down);
}

void Gui::button(int button, bool down, ImGuiKeyChord held) {
    modifiers(held);
    if (button < ImGuiMouseButton_COUNT) ImGui::GetIO().AddMouseButtonEvent(button, down);
}

void Gui::point(std::optional<glm::dvec2> at) {
    if (at)
        ImGui::GetIO().AddMousePosEvent(static_cast<float>(at->x), static_cast<float>(at->y));
    else
        ImGui::GetIO().AddMousePosEvent(-FLT_MAX, -FLT_MAX);
}

bool Gui::grab_to_scroll() {
    ImGuiWindow* window = ImGui::GetCurrentContext()->HoveredWindow;
    while (window && window->ScrollMax.y <= 0.0f && (window->Flags & ImGuiWindowFlags_ChildWindow))
        window = window->ParentWindow;
    if (!window || window->ScrollMax.y <= 0.0f) return false;
    if (ImGui::GetHoveredID() == ImGui::GetWindowScrollbarID(window, ImGuiAxis_Y)) return false;
    grabbed_ = {window->ID, window->Scroll.y};
    return true;
}

void Gui::scroll_grabbed(float pixels) {
    ImGuiWindow* window = ImGui::FindWindowByID(grabbed_.window);
    if (!window) return;
    grabbed_.scrolled = std::clamp(grabbed_.scrolled - pixels, 0.0f, window->ScrollMax.y);
    ImGui::SetScrollY(window, grabbed_.scrolled);
}

bool Gui::holds_what_follows() const {
    const ImGuiContext& imgui = *ImGui::GetCurrentContext();
    // The arrow keys are a slider's and a field's while it is held, and not a button's.
    return imgui.DragDropActive || (imgui.ActiveId != 0 && imgui.ActiveIdUsingNavDirMask != 0);
}

bool Gui::wants_mouse() const { return ImGui::GetIO().WantCaptureMouse; }
bool Gui::wants_keyboard() const { return ImGui::GetIO().WantTextInput; }
void Gui::finish_typing() { ImGui::ClearActiveID(); }
bool Gui::editing() const { return ImGui::IsAnyItemActive() || interface.playing(); }
bool Gui::moving() const {
    return interface.playing() || (ImGui::IsAnyItemActive() && ImGui::IsMouseDown(ImGuiMouseButton_Left));
}
bool Gui::has_more_input() const { return !ImGui::GetCurrentContext()->InputEventsQueue.empty(); }

}  // namespace normalscope
