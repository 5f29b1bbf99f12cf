#pragma once

#include "screen/screen.h"
#include "viewer/viewer.h"

#include <emscripten/html5_webgl.h>

#include <memory>
#include <optional>
#include <string>

namespace normalscope {

/// The viewer in a page, on its canvas. What happens there comes by exports.cpp, and what it asks for goes by browser.h.
class Page final : public Host {
public:
    /// Throws ContextError without WebGL 2.
    Page(glm::ivec2 size, float scale, Opened first, Remembered remembered);
    ~Page() override;
    Page(const Page&) = delete;
    Page& operator=(const Page&) = delete;

    Viewer& viewer() { return *viewer_; }
    void resize(glm::ivec2 size, float scale);
    void set_pasted(std::string text) { clipboard_ = std::move(text); }
    /// The canvas has lost all that was drawn and made, or can be drawn to again.
    void lose();
    void restore();
    /// Keeps what one session leaves to the next, where it has changed.
    void remember();

    double now() const override;
    glm::ivec2 framebuffer_size() const override { return screen_ ? size_ : glm::ivec2(0); }
    float content_scale() const override { return scale_; }
    void upload_fonts() override;
    void draw(const Picture& picture) override;
    void show() override;
    Image image_of(const Frame& frame) override;
    std::optional<LetterPicture> draw_letter(char32_t letter, float em) override;
    std::string clipboard() override { return clipboard_; }
    void set_clipboard(const std::string& text) override;
    void set_title(const std::string& title) override;
    bool full_screen() const override;
    void toggle_full_screen() override;
    void to_next_monitor() override {}
    void close() override {}
    bool choose_file() override;
    void saved(const std::filesystem::path& file) override;
    std::string address_of(const std::string& link) const override;
    void keep(const std::string& scene) override;

private:
    glm::ivec2 size_;
    float scale_;
    EMSCRIPTEN_WEBGL_CONTEXT_HANDLE context_;
    std::string clipboard_, remembered_;
    std::unique_ptr<Screen> screen_;  // all that lives in the canvas' context
    std::unique_ptr<Viewer> viewer_;
};

}  // namespace normalscope
