#pragma once

#include <cstddef>
#include <string>

namespace normalscope {

/// Makes the folders that so many pictures are to be in, by a pattern as numbered() takes it.
void make_folders(const std::string& pattern, std::size_t count, std::size_t columns = 1);

/// "3 pictures: frame-0.png to frame-2.png"; of a video, whose name has no place for a number, or of one picture its name.
std::string pictures_written(const std::string& pattern, std::size_t count, std::size_t columns = 1);

}  // namespace normalscope
