#include "commands/verdict.h"

#include <nlohmann/json.hpp>
#include "core/base/decimal.h"

namespace normalscope {

namespace {

using Json = nlohmann::ordered_json;

std::string text_of(glm::ivec2 size) { return std::to_string(size.x) + "x" + std::to_string(size.y); }

std::string by_channel(const auto& values, const auto& text) {
    std::string line;
    for (const auto value : values) line += " " + text(value);
    return line;
}

// Rounded, but never so far that it could read as the very limit that it is beyond.
std::string share_text(double share, double limit) {
    for (int digits = 3;; ++digits) {
        const std::string text = with_digits(share, digits);
        if (digits == 17 || (*decimal(text) > limit) == (share > limit)) return text;
    }
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
               share_text(share, tolerance.share) +
               (decides ? ", " + with_digits(tolerance.share, 9) + " allowed" : "") + ")";
    };
    const std::string more = " by more than " + std::to_string(tolerance.channel) + " of 255";
    const std::string channels = counted(d.pixels_beyond, d.share_beyond, !tolerance.perceived) + " are off" + more;
    const std::string seen = counted(d.seen_beyond, d.share_seen, tolerance.perceived) + " look off" + more + ", and " +
                             std::to_string(d.edges_forgiven) + " that smooth an edge " +
                             (tolerance.perceived ? "are" : "would be") + " forgiven";
    return (tolerance.perceived ? seen + "; " + channels : channels) + "; most " + std::to_string(d.worst_by) + " at " +
           std::to_string(d.worst.x) + "," + std::to_string(d.worst.y) + "; most by channel" +
           by_channel(d.most, [](int v) { return std::to_string(v); }) + ", mean" +
           by_channel(d.mean, [](double v) { return with_decimals(v, 4); }) +
           (tolerance.perceived || !d.looked_at ? "" : "; with --perceptual " + seen);
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
    j["perceived"] = nullptr;
    if (d.looked_at)
        j["perceived"] = {{"beyond", d.seen_beyond},
                          {"share", d.share_seen},
                          {"most", d.most_seen},
                          {"edges_forgiven", d.edges_forgiven}};
    return j;
}

}  // namespace normalscope
