#pragma once

namespace normalscope {

/// Draws Dear ImGui's rounds by GL. Both contexts are current, and outlive this.
class GlGui {
public:
    GlGui();
    ~GlGui();
    GlGui(const GlGui&) = delete;
    GlGui& operator=(const GlGui&) = delete;

    /// The font atlas is another: before the next round.
    void upload_fonts();
    /// Draws the last round into the bound framebuffer.
    void draw() const;
};

}  // namespace normalscope
