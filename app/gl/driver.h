#pragma once

#include <glm/vec2.hpp>

#include <span>
#include <vector>

namespace normalscope {

// What one driver can do and another cannot. OpenGL 3.3 has all of it; ES 3.0, in a page, some.

/// Where the bound framebuffer's samples lie in a pixel, from its lower left; none where it has just one.
std::vector<glm::vec2> sample_places();
/// Where four samples lie that are drawn one after the other: as most drivers have them.
std::span<const glm::vec2> usual_places();
/// A fragment can be drawn to one of its pixel's samples alone; scene.frag's `sample_mask` may have to say so besides.
bool masks_samples();
/// Draws go to the samples whose bits are set. Only where masks_samples().
void mask_samples(int bits);
/// All samples, as at first.
void unmask_samples();

/// Textures of floats can be drawn to: what rays have hit.
bool draws_floats();
/// Such a draw may blend.
bool blends_floats();
/// What a query has counted can be asked for in the frame that asked.
bool answers_at_once();
/// Whether GLSL has doubles.
bool has_doubles();
/// A triangle can carry a hundred numbers to its pixels, and it is worth while: shaders/trace.vert.
bool carries_much();

/// Waits until all that was drawn to the bound framebuffer is there.
void wait_for_pixels();

}  // namespace normalscope
