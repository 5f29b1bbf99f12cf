#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace normalscope {

/// A name that ends in .gif, .mp4 or .webm.
bool is_video(const std::filesystem::path& file);

/// How many places a pattern has for numbers: "%d", or with a width of one or two digits "%03d". Any other % is itself.
std::size_t places_for_numbers(const std::string& pattern);
/// The pattern with the picture's number in the place of "%03d"; where there are two such places, its row's and its
/// column's. "%%" becomes "%".
std::filesystem::path numbered(const std::string& pattern, std::size_t i, std::size_t columns = 1);
/// The pattern of which numbered() makes just this name.
std::string literally(const std::string& name);

}  // namespace normalscope
