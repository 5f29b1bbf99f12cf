#pragma once

#include "core/frame/frame.h"
#include "ui/kit/style.h"

#include <string>
#include <string_view>

namespace normalscope {

/// The bar at the picture's top: one error that stays until it is dismissed, or one note that goes by itself.
class Messages {
public:
    void show_error(std::string_view line);
    void show_note(std::string_view line);
    /// A note that is so no more.
    void take_back(std::string_view note);

    void draw(const Look& look, const Frame& frame);
    /// Takes an error away; false if there was none.
    bool dismiss();
    /// Seconds until the bar looks different; infinite if never.
    double redraw_after() const;
    const std::string& text() const { return text_; }

private:
    std::string text_;
    bool error_ = false;
    bool fresh_ = false;  ///< shown since the last draw: the time counts from when it is first seen
    double since_ = 0.0;  ///< ImGui::GetTime
    double now_ = 0.0;
};

}  // namespace normalscope
