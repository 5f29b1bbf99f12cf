#pragma once

#include "core/frame/frame.h"
#include "core/math/camera.h"
#include "core/surface/implicit_surface.h"
#include "gl/objects.h"
#include "gl/programs.h"
#include "gl/vertex_data.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace normalscope {

/// Meets the rays of a picture with a formula's surface, on the graphics processor: unit n_object and t for each pixel.
/// Pixels that hold more than one thing are traced again for each of their samples.
class Tracer {
public:
    /// `shifts` are the samples' places from their pixel's centre, in pixels; empty: the centres only.
    void trace(const ImplicitSurface& surface, const CameraView& view, glm::ivec2 size,
               const glm::dmat4& object_from_world, std::span<const glm::vec2> shifts);

    /// Whether the program for this surface's formula is there, which takes a software driver a fifth of a second to make.
    bool ready(const ImplicitSurface& surface) const;

    /// What the last trace found: for the centres, and for each sample in the tiles that hold an edge.
    const GlTexture& centres() const { return layers_[0].texture; }
    const GlTexture& samples(std::size_t k) const { return layers_[1 + k].texture; }

    /// Where in the picture the surface may be seen, in GL's pixels.
    const PixelRect& box() const { return box_; }

    /// What each tile holds: 0 nothing, ½ some of the surface, 1 an edge. How large they are in clip space, and a square
    /// for each.
    static constexpr int kTile = 16;  // pixels
    static constexpr float kEmpty = 0.25f, kNoEdge = 0.75f;
    const GlTexture& tiles() const { return tiles_->texture; }
    glm::vec2 tile() const;
    void draw_tiles() const { squares_.draw(tile_counts_.x * tile_counts_.y); }

private:
    struct Layer {
        Layer(glm::ivec2 size, GLenum format);
        GlTexture texture;
        GlFramebuffer framebuffer;
    };

    void hold(const ImplicitSurface& surface);
    void hold(glm::ivec2 size, std::size_t layers);
    void fill_tiles();

    formulas::Precision precision(const ImplicitSurface& surface) const;

    std::string formula_;                                          // in GLSL, that the program is made for
    formulas::Precision precision_ = formulas::Precision::Single;  // its
    bool has_doubles_ = false;
    bool asked_ = false;
    std::optional<TraceProgram> program_;
    std::optional<TilesProgram> tiles_program_;
    glm::ivec2 size_{0}, tile_counts_{0};
    PixelRect box_;
    std::optional<Layer> nothing_;  // to be bound where nothing is read
    std::vector<Layer> layers_;
    std::optional<Layer> tiles_;
    PaneVertices everywhere_;
    TileVertices squares_;
};

}  // namespace normalscope
