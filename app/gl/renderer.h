#pragma once

#include "core/frame/frame.h"
#include "gl/target.h"

#include <memory>

namespace normalscope {

struct Resources;

/// Draws Frames. Needs a current context, and must die before it.
class Renderer {
public:
    Renderer();
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// What becomes of the target's pixels beside the frame.
    enum class Beside { Cleared, Stays };
    /// Makes the target's picture, which stays bound for what is drawn over it, such as words.
    void draw(const Frame& frame, Target& target, Beside beside = Beside::Cleared);
    /// The same for the frame that was drawn last, from the samples that it left.
    void draw_again(const Frame& frame, Target& target, Beside beside = Beside::Cleared);
    /// From now on, drafts of a formula's surface have a ray for nine pixels rather than for four.
    void coarsen_drafts(bool more);

private:
    std::unique_ptr<Resources> resources_;
};

}  // namespace normalscope
