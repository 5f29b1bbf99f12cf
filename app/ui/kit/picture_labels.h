#pragma once

#include "core/frame/frame.h"
#include "ui/kit/style.h"

#include <vector>

namespace normalscope {

/// The words on the picture, behind everything else: labels, pane titles, the legend, the error map's key.
void draw_words(const Look& look, const Frame& frame);

/// What they cover, in pixels of the framebuffer.
std::vector<PixelRect> word_boxes(const Look& look, const Frame& frame);

/// How far down from the picture's top the titles reach, in physical pixels.
float titles_height(const Look& look, const Frame& frame);

}  // namespace normalscope
