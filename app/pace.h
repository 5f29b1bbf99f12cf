#pragma once

#include <chrono>

namespace normalscope {

/// Keeps what moves smooth: where a frame with all of its samples takes longer than a thirtieth of a second, the rest of the
/// movement is drawn with one sample a pixel, which takes about half as long.
class Pace {
public:
    /// Before a frame. Whether it should be drawn with one sample.
    bool rough(bool moving) {
        moving_ = moving;
        if (!moving) slow_ = 0;
        return slow_ >= kEnough;
    }
    /// What the frame took, to the last pixel.
    void took(std::chrono::duration<double> seconds) {
        if (!moving_ || slow_ >= kEnough) return;
        slow_ = seconds.count() > 1.0 / 30.0 ? slow_ + 1 : 0;
    }

private:
    static constexpr int kEnough = 2;  // one alone made a surface or compiled a shader
    bool moving_ = false;
    int slow_ = 0;  // so many in a row
};

}  // namespace normalscope
