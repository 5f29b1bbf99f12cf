#pragma once

#include "core/base/font_file.h"
#include "core/base/letter_picture.h"
#include "core/frame/frame.h"
#include "core/image/image.h"

#include <glm/vec2.hpp>

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace normalscope {

/// What is to be drawn, with Dear ImGui's last round over it.
struct Picture {
    const Frame& frame;
    bool anew = true;     ///< false: the samples of the picture before still hold this frame
    bool rough = false;   ///< one sample a pixel will do
    bool coarse = false;  ///< fewer rays will do
    bool timed = false;   ///< how long it takes is measured: the draw returns when it is done
};

/// What a viewer asks of whatever shows it: a window, a page, or nothing at all in a test. Sizes are in physical pixels.
class Host {
public:
    virtual ~Host() = default;

    /// Seconds, on a clock that only goes forward.
    virtual double now() const = 0;
    /// What there is to draw on; 0 where there is nothing, as in a minimised window.
    virtual glm::ivec2 framebuffer_size() const = 0;
    /// Physical pixels per logical one, as the desktop has it.
    virtual float content_scale() const = 0;

    /// Dear ImGui's font atlas is another: its texture must be made before the next round.
    virtual void upload_fonts() = 0;
    virtual void draw(const Picture& picture) = 0;
    /// What was drawn comes onto the screen.
    virtual void show() = 0;
    /// The pixels of the whole framebuffer, which is not shown, as it would be drawn.
    virtual Image image_of(const Frame& frame) = 0;

    /// Fonts that have these letters, which the program's own lack.
    virtual std::vector<FontFile> fonts_for(std::span<const char32_t> /*letters*/) { return {}; }
    /// Or such a letter as pixels, where there are fonts, but none as a file.
    virtual std::optional<LetterPicture> draw_letter(char32_t /*letter*/, float /*em*/) { return std::nullopt; }

    virtual std::string clipboard() = 0;
    virtual void set_clipboard(const std::string& text) = 0;
    virtual void set_title(const std::string& title) = 0;
    virtual bool full_screen() const = 0;
    virtual void toggle_full_screen() = 0;
    virtual void to_next_monitor() = 0;
    virtual void close() = 0;
    /// Asks for a file in a way of its own, and opens what is chosen; false: it has none.
    virtual bool choose_file() { return false; }
    /// A file has been written, which the user cannot reach where there are no files.
    virtual void saved(const std::filesystem::path&) {}
    /// What a link is handed on as: with a page's own address before it, it opens there by itself.
    virtual std::string address_of(const std::string& link) const { return link; }
    /// Work that no file holds, as unsaved_text() writes it: to be offered next time. Empty: nothing.
    virtual void keep(const std::string& unsaved) = 0;
};

}  // namespace normalscope
