#pragma once

#include "core/image/image.h"
#include "core/lessons/lesson.h"

#include <string>
#include <vector>

namespace normalscope {

/// What each question of a Moodle quiz has. Words are HTML.
struct MoodleItem {
    std::string name;  ///< in plain words, for the list of questions
    std::string html;
    Image picture;
    std::string picture_says;  ///< in plain words, for whoever does not see it
    std::string why;           ///< said to all, once they have answered; may be empty
};

/// A number to be filled in, and what a wrong one that is known is answered with.
struct MoodleNumber {
    double right = 0.0;
    double tolerance = 0.0;
    double known_wrong = 0.0;  ///< as good as `right`: none is known
    std::string because;       ///< in plain words
};

/// Questions as Moodle XML, which Moodle and others import; pictures are within it.
class MoodleQuiz {
public:
    /// Into which those that follow are sorted.
    void category(const std::string& name);
    void choices(const MoodleItem& item, const Question& question);
    /// The numbers are filled in behind the item's words: (☐, ☐, ☐).
    void numbers(const MoodleItem& item, const std::vector<MoodleNumber>& numbers);

    std::string text() const;

private:
    std::string questions_;
};

}  // namespace normalscope
