#include "screen/screen.h"

#include "gl/version.h"
#include "screen/gui_draws.h"

#include <imgui.h>
#include <imgui_impl_opengl3.h>

namespace normalscope {

namespace {

constexpr int kSamples = 4;

}  // namespace

Screen::Screen() { ImGui_ImplOpenGL3_Init(kGlslVersion); }
Screen::~Screen() { ImGui_ImplOpenGL3_Shutdown(); }

void Screen::upload_fonts() {
    // The backend's NewFrame uploads a new font atlas only where it makes everything anew.
    ImGui_ImplOpenGL3_DestroyDeviceObjects();
    ImGui_ImplOpenGL3_NewFrame();
    beside_.reset();
}

Target& Screen::target(glm::ivec2 size, bool rough) {
    if (!target_ || target_->size() != size) {
        beside_.reset();
        last_ = nullptr;
        rough_target_.reset();
        target_.reset();
        target_.emplace(size, kSamples);
    }
    if (rough && !rough_target_) rough_target_.emplace(size, 1);
    return rough ? *rough_target_ : *target_;
}

void Screen::draw(const Picture& picture, glm::ivec2 size) {
    Target& to = target(size, picture.rough);
    // The window may have been resized since the viewer looked: then nothing of before is held.
    const bool held = last_ != nullptr;
    last_ = &to;
    ImDrawData& gui = *ImGui::GetDrawData();
    const Beside now{&to, picture.frame.rect, picture.frame.theme, hash_around(gui, picture.frame.rect)};
    const Renderer::Beside beside = beside_ == now ? Renderer::Beside::Stays : Renderer::Beside::Cleared;
    beside_ = now;
    renderer_.coarsen_drafts(picture.coarse);
    if (picture.anew || !held)
        renderer_.draw(picture.frame, to, beside);
    else
        renderer_.draw_again(picture.frame, to, beside);
    if (beside == Renderer::Beside::Stays)
        draw_within(gui, picture.frame.rect);
    else
        draw_all(gui);
    if (picture.timed) Target::finish();  // to show it waits for the screen besides
}

void Screen::show() const { last_->show(); }

Image Screen::image_of(const Frame& frame, glm::ivec2 size) {
    Target& whole = target(size, false);
    beside_.reset();
    last_ = nullptr;
    renderer_.draw(frame, whole);
    draw_all(*ImGui::GetDrawData());
    return whole.read();
}

}  // namespace normalscope
