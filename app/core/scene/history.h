#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace normalscope {

/// Undo and redo by value: a scene is small.
template <class State>
class History {
public:
    explicit History(State first) : states_{std::move(first)} {}

    /// Remembers a finished change; the same again is no change. What had been undone is forgotten.
    void commit(const State& state) {
        if (state == states_[now_]) return;
        states_.resize(now_ + 1);
        states_.push_back(state);
        if (states_.size() > kMost) states_.erase(states_.begin());
        now_ = states_.size() - 1;
    }
    /// What undoing goes back through; the present state is the last.
    std::span<const State> done() const { return {states_.data(), now_ + 1}; }
    const State& current() const { return states_[now_]; }
    bool can_undo() const { return now_ > 0; }
    bool can_redo() const { return now_ + 1 < states_.size(); }
    const State& undo() { return states_[now_ -= can_undo() ? 1 : 0]; }
    const State& redo() { return states_[now_ += can_redo() ? 1 : 0]; }

private:
    static constexpr std::size_t kMost = 500;
    std::vector<State> states_;
    std::size_t now_ = 0;
};

}  // namespace normalscope
