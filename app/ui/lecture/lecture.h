#pragma once

#include "core/frame/frame.h"
#include "core/lessons/lesson_player.h"
#include "core/lessons/shelf.h"
#include "core/lessons/writing.h"
#include "ui/kit/style.h"
#include "ui/lecture/caption_strip.h"
#include "ui/lecture/exercise_view.h"
#include "ui/lecture/lecture_key.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace normalscope {

/// The lesson that is gone through, and how a lecturer shows it: the strip of words below the picture, large words and
/// an empty screen in presenter mode.
class Lecture {
public:
    LessonPlayer player;
    Exercises exercises;                          ///< instead of a lesson
    LessonShelf shelf;                            ///< where the next lesson is found, and the one before
    std::map<std::string, std::size_t> progress;  ///< the step at which each lesson was left

    void start(std::shared_ptr<const Lesson> lesson, const Scene& scene, std::optional<std::size_t> step);
    /// Another version of the lesson that is gone through, at the same step or its last.
    void replace(std::shared_ptr<const Lesson> lesson, const Scene& scene);
    /// What is being written, as it is now; nothing moves.
    void follow(const Draft& draft);
    /// A lesson's step stays, to be played with; exercises give back the scene that was there before them.
    void leave(Scene& scene);
    /// Pictures are made of it, one by one: it moves by itself no more.
    bool recorded = false;

    bool presenting = false;
    void present(bool on) { presenting = on, blank_.reset(); }
    /// The screen shows nothing, so that people look at the speaker.
    bool end_blank() { return std::exchange(blank_, std::nullopt).has_value(); }

    /// Whether the key is for the lecture now. If so it has done what it asks for.
    bool press(LectureKey key, Scene& scene, const Frame* frame);
    void start_exercises(std::uint64_t seed, Scene& scene);

    /// What the words leave to the picture of a room that both share.
    PixelRect picture(const Look& look, const PixelRect& room);
    /// The words in what the picture leaves of the room, and whatever moves.
    void draw(const Look& look, Scene& scene, const PixelRect& room, const PixelRect& picture);
    /// In front of all else.
    void draw_screen(const Look& look, bool pointer_rests) const;
    /// The tab that the step wants open, or an empty name for none, once after it has been reached.
    std::optional<std::string> wanted_tab();
    /// The lesson that is gone on to, once after it has been asked for.
    std::optional<std::string> wanted_lesson() { return std::exchange(wanted_lesson_, std::nullopt); }

    /// Its × was pressed: once after that.
    bool wants_to_end() { return std::exchange(ends_, false); }

    /// A question waits for its answer.
    bool asking() const { return exercises.asking() || (player.running() && player.asking()); }
    /// There are words below the picture.
    bool talks() const { return player.running() || exercises.running() || presenting; }
    /// It wants to be drawn again at once.
    bool moving() const { return player.running() && player.moving(); }
    void forget_layout() { strip_.forget_layout(); }

private:
    void go_to(std::size_t step, const Scene& scene);
    bool press_in_lesson(LectureKey key, const Scene& scene);
    bool press_in_exercise(LectureKey key, Scene& scene, const Frame* frame);
    bool go_on(const Scene& scene);
    bool go_back(const Scene& scene);
    const char* next_does() const;  ///< in words; none: nothing
    /// The lesson on the shelf after the one that is gone through, or before it, if there is one.
    std::optional<ListedLesson> next_lesson() const { return neighbour(+1); }
    std::optional<ListedLesson> previous_lesson() const { return neighbour(-1); }
    std::optional<ListedLesson> neighbour(int places) const;
    /// All that is said in the lesson or the exercise, and what the strip is to hold now: parts of it.
    struct Said {
        std::vector<Speech> all;
        std::size_t first = 0, count = 0;
    };
    Said said() const;

    CaptionStrip strip_;
    std::optional<Theme> blank_;  ///< dark: black, light: white
    std::optional<std::string> tab_;
    bool opened_tab_ = false;  ///< so that it is closed again
    /// After the last step the next lesson is announced, before the first one the one before, and opened only when asked
    /// once more: nobody slips into it.
    enum class Announced { Nothing, Next, Previous };
    Announced announced_ = Announced::Nothing;
    std::optional<std::string> wanted_lesson_;
    bool ends_ = false;
    float takes_before_ = 0.0f, takes_ = 0.0f;  ///< of the room, below the picture: at the step before, and now
    Speech said_;  ///< of the scene, as of the last draw: in presenter mode without a lesson
};

}  // namespace normalscope
