#pragma once

#include "core/frame/frame.h"
#include "core/lessons/writing.h"
#include "ui/kit/requests.h"
#include "ui/kit/style.h"
#include "ui/lecture/question_fields.h"

#include <string>

namespace normalscope {

/// What it looks at.
struct EditedLesson {
    const Look& look;
    const Draft& draft;
    const Scene& scene;  ///< what is seen, which may be another than the step's
    PixelRect picture;
    bool strayed = false;  ///< it is another
    float side =
        0.0f;  ///< how much of the window's width at the right is its own; 0: none, and it lies over the picture
};

inline constexpr float kEditorWidth = 340.0f;  ///< logical pixels

/// The words of a lesson's step, to be written, and what can be done with its steps: beside the picture, or
/// over it where a tab stands there, and then it can be moved. All that it changes goes by `requests`.
class LessonEditor {
public:
    void draw(const EditedLesson& edited, Requests& requests);
    /// Its fields and buttons had it when it was drawn last.
    bool has_keyboard() const { return has_keyboard_; }

private:
    void read(const EditedLesson& edited);
    void words(const EditedLesson& edited, Requests& requests);
    void steps(const EditedLesson& edited, Requests& requests) const;
    void ending(const EditedLesson& edited, Requests& requests) const;

    Draft shown_;                              ///< whose words the fields hold
    float width_ = 0.0f;                       ///< of their lines
    float fields_ = 1000.0f, buttons_ = 0.0f;  ///< how high they were, of the window
    bool typing_ = false, has_keyboard_ = false;
    bool unfolded_ = false;  ///< the question and the notes
    ImGuiID typed_in_ = 0;   ///< the field that was changed last
    std::string title_, caption_, look_at_, equations_;
    QuestionFields question_;
};

}  // namespace normalscope
