#pragma once

#include "core/image/image.h"

#include <cstddef>
#include <functional>

namespace normalscope {

/// Pictures of one size in rows and columns, shrunk by a whole number where the sheet would be too large to look at.
/// `picture(i)` gives the i-th, row by row.
Image contact_sheet(std::size_t count, std::size_t columns, const std::function<Image(std::size_t i)>& picture);

}  // namespace normalscope
