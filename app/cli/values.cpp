#include "cli/values.h"

#include "core/base/decimal.h"
#include "core/base/error.h"
#include "core/base/output_names.h"
#include "core/base/text.h"
#include "core/image/image.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <system_error>
#include <utility>

namespace normalscope {

namespace {

[[noreturn]] void fail(const std::string& option, const std::string& text, const std::string& why) {
    throw UsageError(option + " " + text, why);
}

// The whole of the text, or nothing: no sign, no space, nothing after.
std::optional<std::int64_t> whole_number(std::string_view text) {
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || text.front() == '-') return std::nullopt;
    return value;
}

}  // namespace

glm::ivec2 parse_size(const std::string& option, const std::string& text) {
    const auto x = text.find('x');
    const auto width = whole_number(std::string_view(text).substr(0, x));
    const auto height = x == std::string::npos ? std::nullopt : whole_number(std::string_view(text).substr(x + 1));
    if (!width || !height) fail(option, text, "expected WIDTHxHEIGHT in pixels, such as 1280x720");
    if (*width < 1 || *height < 1) fail(option, text, "a picture has at least 1 pixel a side");
    if (*width > kLongestSide || *height > kLongestSide || *width * *height > kMostPixels)
        fail(option, text,
             "a picture has at most " + std::to_string(kLongestSide) + " pixels a side and " +
                 std::to_string(kMostPixels) + " in all");
    return {static_cast<int>(*width), static_cast<int>(*height)};
}

int parse_samples(const std::string& option, const std::string& text) {
    // What every driver can do; OpenGL 3.3 promises no more than 4.
    for (const int samples : {1, 2, 4})
        if (text == std::to_string(samples)) return samples;
    fail(option, text, "expected 1, 2 or 4");
}

float parse_scale(const std::string& option, const std::string& text) {
    const std::optional<double> value = decimal(text);
    if (!value || !(*value >= 0.5 && *value <= 8.0)) fail(option, text, "expected a number from 0.5 to 8, such as 1.5");
    return static_cast<float>(*value);
}

Ground parse_ground(const std::string& option, const std::string& text) {
    if (text == "scene") return Ground::Scene;
    if (text == "white") return Ground::White;
    if (text == "transparent") return Ground::Transparent;
    fail(option, text, "expected scene, white or transparent");
}

ContextChoice parse_context(const std::string& option, const std::string& text) {
    using enum ContextChoice;
    for (const auto& [name, choice] : {std::pair{"auto", Auto}, {"osmesa", Osmesa}, {"egl", Egl}})
        if (text == name) return choice;
    fail(option, text, "expected auto, osmesa or egl");
}

HandoutCommand::Answers parse_answers(const std::string& option, const std::string& text) {
    using enum HandoutCommand::Answers;
    for (const auto& [name, where] : {std::pair{"end", End}, {"inline", Inline}, {"none", None}})
        if (text == name) return where;
    fail(option, text, "expected end, inline or none");
}

ExplainFormat parse_format(const std::string& option, const std::string& text) {
    for (const ExplainFormat format : kExplainFormats)
        if (text == name(format)) return format;
    fail(option, text, "expected text, json or latex");
}

int parse_tolerance(const std::string& option, const std::string& text) {
    const auto value = whole_number(text);
    if (!value || *value > 255) fail(option, text, "expected a whole number from 0 to 255");
    return static_cast<int>(*value);
}

double parse_share(const std::string& option, const std::string& text) {
    const std::optional<double> value = decimal(text);
    if (!value || !(*value >= 0.0 && *value <= 1.0)) fail(option, text, "expected a number from 0 to 1, such as 0.001");
    return *value;
}

int parse_count(const std::string& option, const std::string& text, int most) {
    const auto value = whole_number(text);
    if (!value || *value < 1 || *value > most)
        fail(option, text, "expected a whole number from 1 to " + std::to_string(most));
    return static_cast<int>(*value);
}

std::string parse_numbered_output(const std::string& option, const std::string& text, std::size_t count,
                                  std::size_t varying) {
    constexpr std::size_t kMostPictures = 100'000;
    if (count > kMostPictures)
        throw UsageError("--vary: that makes " + std::to_string(count) + " pictures; at most " +
                         std::to_string(kMostPictures) + " are drawn at once");
    if (text == "-") fail(option, text, "several pictures cannot go to one stream; give a folder, or frame-%03d.png");
    if (is_video(text)) return text;
    std::error_code ignored;
    const std::string name = std::filesystem::path(text).filename().string();
    const bool like_a_folder = !text.empty() && name.find('.') == std::string::npos && places_for_numbers(name) == 0;
    if (like_a_folder || std::filesystem::is_directory(text, ignored))
        return (std::filesystem::path(literally(text)) / "frame-%03d.png").string();

    const std::size_t places = places_for_numbers(text);
    if (!has_ending(text, ".png") || places < 1 || places > varying)
        fail(option, text,
             varying == 2 ? "expected frame-%03d.png, frame-%d-%d.png, a folder, or a .gif, .mp4 or .webm"
                          : "expected a .png with one place for the number, as in frame-%03d.png, a folder, or a .gif, "
                            ".mp4 or .webm");
    return text;
}

Output parse_picture_output(const std::string& option, const std::string& text) {
    if (has_ending(text, ".svg")) return {text};
    return parse_output(option, text, Written::Picture);
}

Output parse_output(const std::string& option, const std::string& text, Written what) {
    struct Ending {
        std::string_view text;
        std::optional<Written> says;
    };
    static constexpr std::array kEndings{
        Ending{".png", Written::Picture},
        Ending{".html", Written::Page},
        Ending{".htm", Written::Page},
        Ending{".xml", Written::Xml},
        Ending{".json", Written::Json},
        Ending{".vtt", Written::Subtitles},
        Ending{".srt", Written::Subtitles},
        Ending{".jpg", {}},
        Ending{".jpeg", {}},
        Ending{".gif", {}},
        Ending{".bmp", {}},
        Ending{".tif", {}},
        Ending{".tiff", {}},
        Ending{".webp", {}},
        Ending{".svg", {}},
        Ending{".pdf", {}},
        Ending{".mp4", {}},
        Ending{".webm", {}},
    };
    static constexpr std::array<std::string_view, 5> kInstead{
        "only PNG is written (and by capture SVG); end the name in .png",
        "the file is written as a web page; end its name in .html", "the file is written as XML; end its name in .xml",
        "the file is written as JSON; end its name in .json", "expected a name that ends in .vtt or .srt"};
    for (const Ending& ending : kEndings)
        if (ending.says != what && has_ending(text, ending.text))
            fail(option, text, std::string(kInstead[static_cast<std::size_t>(what)]));
    return {text == "-" || text == "/dev/stdout" ? "" : text};
}

std::filesystem::path parse_file_output(const std::string& option, const std::string& text, Written what) {
    const Output output = parse_output(option, text, what);
    if (output.is_standard()) fail(option, text, "the results are printed there already; give a file's name");
    return output.file;
}

std::filesystem::path parse_subtitles_output(const std::string& option, const std::string& text) {
    if (text != "-" && !has_ending(text, ".vtt") && !has_ending(text, ".srt"))
        fail(option, text, "expected a name that ends in .vtt or .srt");
    return parse_file_output(option, text, Written::Subtitles);
}

std::pair<std::size_t, std::size_t> parse_shard(const std::string& option, const std::string& text) {
    constexpr int kMost = 10'000;
    const auto slash = text.find('/');
    const auto k = whole_number(std::string_view(text).substr(0, slash));
    const auto n = slash == std::string::npos ? std::nullopt : whole_number(std::string_view(text).substr(slash + 1));
    if (!k || !n || *k < 1 || *k > *n || *n > kMost)
        fail(option, text, "expected K/N, the K-th of N parts, such as 2/5");
    return {static_cast<std::size_t>(*k), static_cast<std::size_t>(*n)};
}

}  // namespace normalscope
