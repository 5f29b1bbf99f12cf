#pragma once

#include "ui/kit/requests.h"
#include "ui/kit/style.h"

#include <optional>
#include <string>
#include <vector>

namespace normalscope {

/// A question in the middle of the window, before anything else goes on. Enter takes the first choice, Escape the last,
/// a letter the first choice that begins with it.
class QuestionBox {
public:
    void ask(Asked what, std::string title, std::string text, std::vector<std::string> choices);
    /// It is open, or will be in the next frame.
    bool is_open() const { return asked_.has_value(); }

    void draw(const Look& look, Requests& requests);

private:
    std::optional<std::size_t> buttons(const Look& look) const;

    std::optional<Asked> asked_;
    bool appearing_ = false;
    std::string title_, text_;
    std::vector<std::string> choices_;
};

}  // namespace normalscope
