#pragma once

#include "core/image/image.h"

namespace normalscope {

/// How far apart two pictures of one size look at a pixel, as two greys so many steps of 255 apart do: the distance in
/// NTSC's YIQ, whose axes are weighted as the eye sees them (Kotsarenko and Ramos, "Measuring perceived color difference
/// using YIQ NTSC transmission color space in mobile applications", 2010). Transparent pixels are seen on white and on
/// black, whichever shows more.
double perceived_difference(const Image& a, const Image& b, glm::ivec2 p);

/// The pixel smooths an edge in one of the pictures: it lies between a darker and a brighter neighbour, one of which
/// belongs to a plain area in both pictures. Where it lies exactly is up to the rasteriser (after Vyšniauskas,
/// "Anti-aliased Pixel and Intensity Slope Detector", 2009).
bool smooths_an_edge(const Image& a, const Image& b, glm::ivec2 p);

}  // namespace normalscope
