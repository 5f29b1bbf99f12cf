#pragma once

#include "core/image/image.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace normalscope {

/// The picture as a PNG: the same bytes for the same pixels, without alpha where all of it is opaque. Made to be
/// written quickly, not to be small.
std::string png_bytes(const Image& image);

/// Writes png_bytes as write_file does: whole or not at all. Throws InputError.
void write_png(const std::filesystem::path& file, const Image& image);

/// Reads a PNG of any kind: grey, palette, 16 bits, interlaced. Throws InputError for what cannot be read, is no PNG,
/// is cut short, or is larger than kLongestSide and kMostPixels.
Image read_png(const std::filesystem::path& file);
/// The same of a file's bytes; `name` names them in errors.
Image decoded_png(std::string_view bytes, const std::string& name);
/// What a file's head says, for whoever needs no pixels; empty where it is no plain file, or has no head of a
/// picture that is read.
std::optional<glm::ivec2> png_size(const std::filesystem::path& file);

}  // namespace normalscope
