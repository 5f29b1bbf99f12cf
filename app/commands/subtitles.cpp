#include "commands/subtitles.h"

#include "core/base/html.h"
#include "core/base/math_text.h"
#include "core/base/text.h"
#include "core/base/utf8.h"

#include <cmath>
#include <cstdio>
#include <string_view>

namespace normalscope {

namespace {

// "Halve x. What now?" is two. A dot within a number ends nothing.
std::vector<std::string> sentences(const std::string& words) {
    std::vector<std::string> all;
    std::size_t begin = 0;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const bool ends = std::string_view(".?!").find(words[i]) != std::string_view::npos;
        if (!ends || (i + 1 < words.size() && words[i + 1] != ' ')) continue;
        all.push_back(words.substr(begin, i + 1 - begin));
        begin = i + 2;
    }
    if (begin < words.size()) all.push_back(words.substr(begin));
    return all;
}

// 00:01:02.345
std::string time_text(double seconds, char before_thousandths) {
    const long all = std::lround(1000.0 * seconds);
    char text[32];
    std::snprintf(text, sizeof text, "%02ld:%02ld:%02ld%c%03ld", all / 3'600'000, all / 60'000 % 60, all / 1000 % 60,
                  before_thousandths, all % 1000);
    return text;
}

}  // namespace

void Subtitles::say(const std::string& words, double seconds) {
    const auto all = static_cast<double>(columns(words));
    const double end = now_ + seconds;
    for (const std::string& written : sentences(words)) {
        const std::string sentence = plain_math(written);
        const double to = now_ + seconds * static_cast<double>(columns(written)) / all;
        cues_.push_back({now_, to, sentence});
        now_ = to;
    }
    if (!cues_.empty()) cues_.back().to = end;
    now_ = end;
}

std::string Subtitles::text(const std::filesystem::path& file) const {
    const bool srt = has_ending(file.string(), ".srt");
    std::string text = srt ? "" : "WEBVTT\n\n";
    for (std::size_t i = 0; i < cues_.size(); ++i) {
        const Cue& cue = cues_[i];
        const char point = srt ? ',' : '.';
        text += std::to_string(i + 1) + "\n" + time_text(cue.from, point) + " --> " + time_text(cue.to, point) + "\n" +
                (srt ? cue.words : html_text(cue.words)) + "\n\n";
    }
    return text;
}

}  // namespace normalscope
