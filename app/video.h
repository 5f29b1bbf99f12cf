#pragma once

#include <filesystem>
#include <string_view>

namespace normalscope {

/// A name that ends in .gif, .mp4 or .webm.
bool is_video(const std::filesystem::path& file);

/// Throws InputError, which says what to do, where ffmpeg is not installed: it is asked before any picture is drawn.
void require_ffmpeg(const std::filesystem::path& video);

/// The pictures FOLDER/000000.png, 000001.png and so on as a video; the file is there whole or not at all.
/// Throws InputError with ffmpeg's own words.
void write_video(const std::filesystem::path& folder, int frames_per_second, const std::filesystem::path& video);

}  // namespace normalscope
