#pragma once

#include <filesystem>
#include <string>

namespace normalscope {

/// The pattern with the picture's number in the place of "%03d"; where there are two such places, its row's and its
/// column's.
std::filesystem::path numbered(const std::string& pattern, std::size_t i, std::size_t columns = 1);

/// Makes the folders that so many pictures are to be in.
void make_folders(const std::string& pattern, std::size_t count, std::size_t columns = 1);

/// "3 pictures: frame-0.png to frame-2.png"; of a video, whose name has no place for a number, or of one picture its name.
std::string pictures_written(const std::string& pattern, std::size_t count, std::size_t columns = 1);

}  // namespace normalscope
