#include "compare.h"

#include "core/file.h"
#include "core/image_difference.h"
#include "core/png.h"

#include <cstdio>

namespace normalscope {

namespace {

std::string text_of(glm::ivec2 size) { return std::to_string(size.x) + "x" + std::to_string(size.y); }

template <class... Values>
std::string formatted(const char* format, Values... values) {
    char line[256];
    std::snprintf(line, sizeof line, format, values...);
    return line;
}

struct Verdict {
    bool agree;
    std::string line;
};

Verdict judge(const Image& actual, const Image& expected, const CompareCommand& command) {
    if (actual.size != expected.size)
        return {false, "the size is " + text_of(actual.size) + ", expected " + text_of(expected.size)};
    const ImageDifference d = image_difference(actual, expected, command.tolerance);
    if (d.worst_by == 0) return {true, text_of(actual.size) + ", every pixel is the same"};
    // A share in full: rounded, it could read as the very limit that it is beyond.
    return {d.share_beyond <= command.share,
            std::to_string(d.pixels_beyond) + " of " + text_of(actual.size) +
                formatted(" pixels (a share of %.9g, %.9g allowed) are off by more than %d of 255", d.share_beyond,
                          command.share, command.tolerance) +
                formatted("; most %d at %d,%d", d.worst_by, d.worst.x, d.worst.y) +
                formatted("; most by channel %d %d %d %d", d.most[0], d.most[1], d.most[2], d.most[3]) +
                formatted(", mean %.4f %.4f %.4f %.4f", d.mean[0], d.mean[1], d.mean[2], d.mean[3])};
}

}  // namespace

int compare(const CompareCommand& command) {
    const Image actual = read_png(command.actual), expected = read_png(command.expected);
    const Verdict verdict = judge(actual, expected, command);
    const std::string line = (verdict.agree ? "agree: " : "differ: ") + verdict.line + "\n";
    if (command.diff) write_png(*command.diff, difference_picture(actual, expected, command.tolerance));
    if (command.diff == "/dev/stdout")
        std::fputs(line.c_str(), stderr);  // not into the picture
    else
        write_file("/dev/stdout", line);
    return verdict.agree ? 0 : 1;
}

}  // namespace normalscope
