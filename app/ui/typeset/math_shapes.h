#pragma once

#include "ui/typeset/math_box.h"

namespace normalscope {

/// What strokes are drawn with: an em's length and their weight in physical pixels.
struct Pen {
    float em, weight;
    Ink ink = Ink::Plain;
};
MathBox fraction_box(const Pen& pen, const MathBox& over, const MathBox& under);
MathBox root_box(const Pen& pen, const MathBox& inside);
MathBox::Stroke straight(const Pen& pen, ImVec2 a, ImVec2 b);

}  // namespace normalscope
