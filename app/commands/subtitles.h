#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace normalscope {

/// What is said in a video, and when, as a file beside it: WebVTT, or SubRip for a name that ends in .srt.
class Subtitles {
public:
    /// From where the last words ended, or later, where `pause` seconds lie between; sentence by sentence, each for as long
    /// as its share of the letters.
    void say(const std::string& words, double seconds);
    void pause(double seconds) { now_ += seconds; }

    std::string text(const std::filesystem::path& file) const;

private:
    struct Cue {
        double from = 0.0, to = 0.0;
        std::string words;
    };
    double now_ = 0.0;
    std::vector<Cue> cues_;
};

}  // namespace normalscope
