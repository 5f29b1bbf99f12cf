#pragma once

#include "measure.h"
#include "screen/screen.h"
#include "viewer/gui.h"
#include "viewer/host.h"

#include <functional>
#include <optional>

namespace normalscope {

/// What the benchmarks draw on: a size and a clock, no window. A context of GL's is current.
class BenchHost final : public Host {
public:
    explicit BenchHost(glm::ivec2 size) : size_(size) {}

    double now() const override { return clock_.seconds().count(); }
    glm::ivec2 framebuffer_size() const override { return size_; }
    float content_scale() const override { return 1.0f; }
    /// Dear ImGui has a context by now.
    void upload_fonts() override {
        if (!screen_) screen_.emplace();
        screen_->upload_fonts();
    }
    /// Before Dear ImGui's context goes.
    void release() { screen_.reset(); }

    void draw(const Picture& picture) override { screen_->draw(picture, size_); }
    void show() override {}
    Image image_of(const Frame&) override { return make_image(size_); }
    std::string clipboard() override { return {}; }
    void set_clipboard(const std::string&) override {}
    void set_title(const std::string&) override {}
    bool full_screen() const override { return false; }
    void toggle_full_screen() override {}
    void to_next_monitor() override {}
    void close() override {}
    void keep(const std::string&) override {}

private:
    Stopwatch clock_;
    glm::ivec2 size_;
    std::optional<Screen> screen_;
};

/// Dear ImGui around an Interface, and a picture under it, drawn by GL.
class BenchGui {
public:
    explicit BenchGui(glm::ivec2 size) : host_(size), gui_(host_) {}
    ~BenchGui() { host_.release(); }
    BenchGui(const BenchGui&) = delete;
    BenchGui& operator=(const BenchGui&) = delete;

    void layout(Theme theme, float scale, const std::function<void()>& content) { gui_.layout(theme, scale, content); }
    void draw(const Picture& picture) { host_.draw(picture); }
    Interface& interface() { return gui_.interface; }

private:
    BenchHost host_;
    Gui gui_;
};

}  // namespace normalscope
