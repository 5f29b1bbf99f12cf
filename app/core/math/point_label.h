#pragma once

#include "core/math/space.h"

#include <string>
#include <variant>

namespace normalscope {

/// A word at a place: one of the world, or one of the object, which M carries along.
struct PointLabel {
    std::string text;
    std::variant<Point<World>, Point<Object>> at;
    friend bool operator==(const PointLabel&, const PointLabel&) = default;
};

}  // namespace normalscope
