#pragma once

#include "core/base/context_choice.h"
#include "core/base/output.h"
#include "core/explain/explain_format.h"
#include "core/image/ground.h"
#include "core/image/image_difference.h"
#include "core/lessons/open.h"
#include "core/scene/variation.h"

#include <glm/vec2.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace normalscope {

/// `normalscope [FILE]`: the window.
struct ViewCommand {
    std::optional<std::string> file;    ///< a scene, a mesh, a lesson, or the name of a built-in one
    std::vector<std::string> settings;  ///< PATH=VALUE, for with_setting
    std::vector<std::string> lesson_folders;
};

/// What is drawn, and how: for the commands that draw without a window.
struct PictureArguments {
    std::string file{kDefaultScene};
    glm::ivec2 size{1280, 720};
    int samples = 4;
    std::optional<float> scale;  ///< of words and lines; empty: by the size
    Ground ground = Ground::Scene;
    ContextChoice context = ContextChoice::Auto;
    bool panel = false;
    std::string tab;  ///< beside the picture, with the panel; empty: none
    bool captions = false;
    std::vector<std::string> settings;
};

/// `normalscope capture [FILE] -o OUT.png`, or OUT.svg
struct CaptureCommand : PictureArguments {
    Output output;
    std::optional<Output> numbers;
    std::optional<std::filesystem::path> expected;
    Tolerance tolerance;  ///< with `expected`
    bool fail_on_note = false;
};

/// `normalscope sweep [FILE] --vary PATH=FROM:TO[:COUNT] -o OUT`
struct SweepCommand : PictureArguments {
    std::vector<Variation> variations;  ///< one or two
    std::string output;                 ///< a video's name, or a picture's with one or two places for a number
    std::optional<Output> sheet, numbers;
    bool fail_on_note = false;
    int jobs = 1;
    int frames_per_second = 25;
};

/// `normalscope explain [FILE]`
struct ExplainCommand {
    std::string file{kDefaultScene};
    ExplainFormat format = ExplainFormat::Text;
    std::vector<std::string> settings;
};

/// `normalscope scenes`
struct ScenesCommand {};

/// `normalscope lessons [--check FILE...]`
struct LessonsCommand {
    std::vector<std::string> files;  ///< to be checked; none: all that there are are listed
    std::vector<std::string> lesson_folders;
    ContextChoice context = ContextChoice::Auto;
};

/// `normalscope handout LESSON -o OUT.html`
struct HandoutCommand {
    enum class Answers { End, Inline, None };
    std::string lesson;  ///< "all": every built-in one
    Output output;
    glm::ivec2 size{960, 600};
    ContextChoice context = ContextChoice::Auto;
    bool live = false;  ///< each picture turns into the program when it is touched
    Answers answers = Answers::End;
    bool notes = false;  ///< what only the lecturer reads
};

/// `normalscope slides LESSON -o FOLDER`
struct SlidesCommand {
    std::string lesson;
    std::filesystem::path folder;
    glm::ivec2 size{1920, 1080};
    ContextChoice context = ContextChoice::Auto;
    bool live = false;  ///< each picture turns into the program when it is touched
};

/// `normalscope quiz LESSON -o OUT.xml`
struct QuizCommand {
    std::string lesson;  ///< "all": every built-in one; or exercises, by their name
    Output output;
    glm::ivec2 size{640, 400};
    ContextChoice context = ContextChoice::Auto;
};

/// `normalscope animate LESSON -o OUT`
struct AnimateCommand {
    std::string lesson, output;  ///< a video's name, or a picture's with a place for a number
    glm::ivec2 size{1280, 720};
    ContextChoice context = ContextChoice::Auto;
    int frames_per_second = 25;
    std::optional<double> seconds;  ///< for which each step stands still; empty: by the lesson, and by its words
    std::optional<std::filesystem::path> subtitles;
};

/// `normalscope compare ACTUAL EXPECTED`
struct CompareCommand {
    std::filesystem::path actual, expected;
    Tolerance tolerance;
    bool json = false;
    std::optional<Output> diff;
};

/// `normalscope check MANIFEST.json`
struct CheckCommand {
    std::filesystem::path manifest;
    std::filesystem::path results{"check-results"};  ///< a folder for the pictures of what does not pass
    std::optional<std::filesystem::path> junit, report;
    std::string only;                   ///< run those whose name has this in it
    std::size_t shard = 1, shards = 1;  ///< of those, every shards-th from this one on, counted from 1
    bool fail_on_note = false;
    bool update = false;
    ContextChoice context = ContextChoice::Auto;
    int jobs = 1;
};

/// Help or the version was asked for: all there is to do is to print it.
struct Printed {
    std::string text;
};

using Command =
    std::variant<ViewCommand, CaptureCommand, SweepCommand, ExplainCommand, ScenesCommand, LessonsCommand,
                 HandoutCommand, SlidesCommand, QuizCommand, AnimateCommand, CompareCommand, CheckCommand, Printed>;

}  // namespace normalscope
