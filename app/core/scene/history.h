#pragma once

#include "core/scene/scene.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace normalscope {

/// Undo and redo by value: a scene is small.
class History {
public:
    explicit History(Scene first) : states_{std::move(first)} {}

    /// Remembers a finished change; the same scene again is no change. What had been undone is forgotten.
    void commit(const Scene& scene) {
        if (scene == states_[now_]) return;
        states_.resize(now_ + 1);
        states_.push_back(scene);
        if (states_.size() > kMost) states_.erase(states_.begin());
        now_ = states_.size() - 1;
    }
    const Scene& current() const { return states_[now_]; }
    bool can_undo() const { return now_ > 0; }
    bool can_redo() const { return now_ + 1 < states_.size(); }
    const Scene& undo() { return states_[now_ -= can_undo() ? 1 : 0]; }
    const Scene& redo() { return states_[now_ += can_redo() ? 1 : 0]; }

private:
    static constexpr std::size_t kMost = 500;
    std::vector<Scene> states_;
    std::size_t now_ = 0;
};

}  // namespace normalscope
