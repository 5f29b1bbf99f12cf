#pragma once

#include "core/image/image.h"

#include <cstddef>
#include <filesystem>

namespace normalscope {

/// Throws InputError, which says what to do, where ffmpeg is not installed: it is asked before any picture is drawn.
void require_ffmpeg(const std::filesystem::path& video);

/// Writes one of a video's pictures, as write_png does. An error names the video: the user knows of no other file.
void write_frame(const std::filesystem::path& file, const Image& image, const std::filesystem::path& video);

/// The pictures FOLDER/000000.png, 000001.png and so on as a video; the file is there whole or not at all. False where it
/// was cancelled (see CancelOnSignal). Throws InputError with ffmpeg's own words.
bool write_video(const std::filesystem::path& folder, std::size_t pictures, int frames_per_second,
                 const std::filesystem::path& video);

}  // namespace normalscope
