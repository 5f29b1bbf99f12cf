#pragma once

#include "cli/commands.h"

#include <utility>

// Options' values from text. Each throws UsageError with the option, what was given and what is allowed.

namespace normalscope {

glm::ivec2 parse_size(const std::string& option, const std::string& text);
int parse_samples(const std::string& option, const std::string& text);
float parse_scale(const std::string& option, const std::string& text);
Ground parse_ground(const std::string& option, const std::string& text);
ContextChoice parse_context(const std::string& option, const std::string& text);
HandoutCommand::Answers parse_answers(const std::string& option, const std::string& text);
ExplainFormat parse_format(const std::string& option, const std::string& text);
int parse_tolerance(const std::string& option, const std::string& text);
double parse_share(const std::string& option, const std::string& text);
int parse_count(const std::string& option, const std::string& text, int most);
/// Where `count` pictures go of which `varying` things vary, one or two: a video's name, or a picture's with a place for one
/// number, or for one each; a folder gets frame-%03d.png.
std::string parse_numbered_output(const std::string& option, const std::string& text, std::size_t count,
                                  std::size_t varying);
/// A picture's name, which may end in .svg.
Output parse_picture_output(const std::string& option, const std::string& text);
enum class Written { Picture, Page, Xml, Json, Subtitles };
/// "-" is standard output, and so is "/dev/stdout": the stream itself, which a rename would miss. A name may end in anything but
/// what says that it holds something else.
Output parse_output(const std::string& option, const std::string& text, Written what);
/// What cannot go to standard output, where results are printed.
std::filesystem::path parse_file_output(const std::string& option, const std::string& text, Written what);
/// What ends in .vtt or .srt.
std::filesystem::path parse_subtitles_output(const std::string& option, const std::string& text);
/// "2/5"
std::pair<std::size_t, std::size_t> parse_shard(const std::string& option, const std::string& text);

}  // namespace normalscope
