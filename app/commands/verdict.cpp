#include "commands/verdict.h"

#include "core/image/png.h"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <cstdlib>

namespace normalscope {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kExpected = ".expected.png";
constexpr const char* kDifference = ".difference.png";

std::string text_of(glm::ivec2 size) { return std::to_string(size.x) + "x" + std::to_string(size.y); }

template <class... Values>
std::string formatted(const char* format, Values... values) {
    char line[256];
    std::snprintf(line, sizeof line, format, values...);
    return line;
}

// Rounded, but never so far that it could read as the very limit that it is beyond.
std::string share_text(double share, double limit) {
    for (int digits = 3;; ++digits) {
        const std::string text = formatted("%.*g", digits, share);
        if (digits == 17 || (std::strtod(text.c_str(), nullptr) > limit) == (share > limit)) return text;
    }
}

fs::path beside(const fs::path& actual_file, const char* what) {
    fs::path file = actual_file;
    return file.replace_filename(actual_file.stem().string() + what);
}

}  // namespace

Verdict judge(const Image& actual, const Image& expected, const Tolerance& tolerance) {
    Verdict verdict{false, actual.size, expected.size, {}, tolerance};
    if (actual.size != expected.size) return verdict;
    verdict.difference = image_difference(actual, expected, tolerance);
    verdict.agree = verdict.difference->within(tolerance);
    return verdict;
}

std::string Verdict::line() const {
    if (!difference) return "the size is " + text_of(actual_size) + ", expected " + text_of(expected_size);
    const ImageDifference& d = *difference;
    if (d.worst_by == 0) return text_of(actual_size) + ", every pixel is the same";
    const auto counted = [&](std::int64_t pixels, double share, bool decides) {
        return std::to_string(pixels) + " of " + text_of(actual_size) + " pixels (a share of " +
               share_text(share, tolerance.share) + (decides ? formatted(", %.9g allowed", tolerance.share) : "") + ")";
    };
    const std::string more = formatted(" by more than %d of 255", tolerance.channel);
    const std::string channels = counted(d.pixels_beyond, d.share_beyond, !tolerance.perceived) + " are off" + more;
    const std::string seen =
        counted(d.seen_beyond, d.share_seen, tolerance.perceived) + " look off" + more +
        formatted(", and %lld that smooth an edge are forgiven", static_cast<long long>(d.edges_forgiven));
    return (tolerance.perceived ? seen + "; " + channels : channels) +
           formatted("; most %d at %d,%d", d.worst_by, d.worst.x, d.worst.y) +
           formatted("; most by channel %d %d %d %d", d.most[0], d.most[1], d.most[2], d.most[3]) +
           formatted(", mean %.4f %.4f %.4f %.4f", d.mean[0], d.mean[1], d.mean[2], d.mean[3]) +
           (tolerance.perceived ? "" : "; " + seen);
}

Json Verdict::json() const {
    const auto size = [](glm::ivec2 s) { return Json::array({s.x, s.y}); };
    Json j{{"agree", agree}, {"size", {{"actual", size(actual_size)}, {"expected", size(expected_size)}}}};
    j["tolerance"] = {{"channel", tolerance.channel}, {"share", tolerance.share}, {"perceived", tolerance.perceived}};
    if (!difference) {
        for (const char* key : {"pixels", "channels", "worst", "perceived"}) j[key] = nullptr;
        return j;
    }
    const ImageDifference& d = *difference;
    j["pixels"] = {{"beyond", d.pixels_beyond}, {"share", d.share_beyond}};
    j["channels"] = {{"most", d.most}, {"mean", d.mean}};
    j["worst"] = {{"at", size(d.worst)}, {"by", d.worst_by}};
    j["perceived"] = {{"beyond", d.seen_beyond},
                      {"share", d.share_seen},
                      {"most", d.most_seen},
                      {"edges_forgiven", d.edges_forgiven}};
    return j;
}

void leave_evidence(const fs::path& actual_file, const Image& actual, const fs::path& reference, const Image& expected,
                    const Tolerance& tolerance) {
    std::error_code ignored;
    if (fs::exists(actual_file, ignored) && !fs::is_regular_file(actual_file, ignored)) return;  // not into /dev
    const fs::path copy = beside(actual_file, kExpected);
    if (!fs::equivalent(copy, reference, ignored)) write_png(copy, expected);
    write_png(beside(actual_file, kDifference), difference_picture(actual, expected, tolerance));
}

void remove_evidence(const fs::path& actual_file, const fs::path& reference) {
    std::error_code ignored;
    if (fs::exists(actual_file, ignored) && !fs::is_regular_file(actual_file, ignored)) return;
    for (const char* what : {kExpected, kDifference}) {
        const fs::path file = beside(actual_file, what);
        if (!fs::equivalent(file, reference, ignored)) fs::remove(file, ignored);
    }
}

}  // namespace normalscope
