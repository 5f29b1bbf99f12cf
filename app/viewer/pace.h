#pragma once

#include <chrono>

namespace normalscope {

/// Keeps what moves smooth: where a frame with all of its samples takes longer than a fiftieth of a second, the rest of the
/// movement is drawn with one sample a pixel, which takes about half as long; and where even that takes longer than a thirtieth,
/// with fewer rays.
class Pace {
public:
    /// Before a frame. Whether it should be drawn with one sample.
    bool rough(bool moving) {
        moving_ = moving;
        if (!moving) slow_ = level_ = 0;
        return level_ > 0;
    }
    /// Whether even that should be less.
    bool coarse() const { return level_ > 1; }
    /// What the frame took, to the last pixel.
    void took(std::chrono::duration<double> seconds) {
        if (!moving_) return;
        // Not a sixtieth: a driver may wait for the screen.
        slow_ = seconds.count() > (level_ == 0 ? 1.0 / 50.0 : 1.0 / 30.0) ? slow_ + 1 : 0;
        if (slow_ < kEnough) return;
        ++level_;
        slow_ = 0;
    }

private:
    static constexpr int kEnough = 2;  // one alone made a surface or compiled a shader
    bool moving_ = false;
    int slow_ = 0;   // so many in a row
    int level_ = 0;  // how much is left out
};

}  // namespace normalscope
