#pragma once

// One class a GL program: its shader files and its uniforms, by their names there.

#include "core/formula/graph.h"
#include "gl/program.h"

#include <array>

namespace normalscope {

/// Sky and ground. With RESOLVE what has been drawn lies over it, each pixel the mean of its samples: of a
/// GL_TEXTURE_2D_MULTISAMPLE, or with APART of a GL_TEXTURE_2D. SAMPLES is how many, where each pixel has them. With SKY there
/// is no ground.
struct BackdropProgram : Program {
    explicit BackdropProgram(std::string_view define) : Program("backdrop.vert", "backdrop.frag", define) {}

    Slot<glm::mat4> world_from_clip{*this, "world_from_clip"};
    Slot<float> ray_depth{*this, "ray_depth"};
    Slot<glm::vec3> eye{*this, "eye"};
    Slot<glm::vec3> top_color{*this, "top_color"};
    Slot<glm::vec3> bottom_color{*this, "bottom_color"};
    Slot<glm::vec3> grid_color{*this, "grid_color"};
    Slot<float> ground{*this, "ground"};
    Slot<float> unit{*this, "unit"};
    Slot<float> grid_amount{*this, "grid_amount"};
    Slot<float> grid_fade{*this, "grid_fade"};
    Slot<glm::mat3> shadow{*this, "shadow"};
    Slot<float> shadow_fade{*this, "shadow_fade"};
    Slot<int> samples{*this, "samples"};
    Slot<glm::ivec2> drawn_low{*this, "drawn_low"};
    Slot<glm::ivec2> drawn_size{*this, "drawn_size"};
    Slot<glm::ivec2> drawn_step{*this, "drawn_step"};
};

/// Where rays meet a formula's surface. `formula` is what trace.frag includes as formula.glsl.
struct TraceProgram : Program {
    TraceProgram(std::string_view formula, formulas::Precision precision)
        : Program("trace.vert", "trace.frag", precision == formulas::Precision::Double ? "DOUBLES" : "", formula) {}

    Slot<glm::mat4> space_from_clip{*this, "space_from_clip"};
    Slot<float> ray_depth{*this, "ray_depth"};
    Slot<glm::vec3> eye{*this, "eye"};
    Slot<glm::vec2> shift{*this, "shift"};
    Slot<glm::vec2> tile{*this, "tile"};
    Slot<int> tiles{*this, "tiles"};
    Slot<float> least{*this, "least"};
    Slot<glm::vec3> box_low{*this, "box_low"};
    Slot<glm::vec3> box_high{*this, "box_high"};
    Slot<float> ball{*this, "ball"};
    Slot<int> centres{*this, "centres"};
    Slot<float> only_edges{*this, "only_edges"};
    std::array<Slot<float>, formulas::kParameterNames.size()> parameters{
        Slot<float>{*this, "formula_a"}, Slot<float>{*this, "formula_b"}, Slot<float>{*this, "formula_c"},
        Slot<float>{*this, "formula_d"}, Slot<float>{*this, "formula_f"}, Slot<float>{*this, "formula_g"},
        Slot<float>{*this, "formula_h"}};
};

struct TilesProgram : Program {
    TilesProgram() : Program("trace.vert", "tiles.frag") {}

    Slot<int> centres{*this, "centres"};
    Slot<int> tile_size{*this, "tile_size"};
};

/// Everything solid: the mesh, its arrows, and what is made anew every frame.
struct SceneProgram : Program {
    explicit SceneProgram(std::string_view define = {}, std::string_view vertex_file = "scene.vert")
        : Program(vertex_file, "scene.frag", define) {}

    Slot<glm::mat4> clip_from_world{*this, "clip_from_world"};
    Slot<glm::mat4> world_from_object{*this, "world_from_object"};
    Slot<glm::mat4> normal_matrix{*this, "normal_matrix"};
    Slot<float> normal_w{*this, "normal_w"};
    Slot<float> unit_at_vertices{*this, "unit_at_vertices"};
    Slot<float> unit_at_pixels{*this, "unit_at_pixels"};
    Slot<float> zero_is_black{*this, "zero_is_black"};
    Slot<float> arrow_length{*this, "arrow_length"};
    Slot<float> shaft_radius{*this, "shaft_radius"};
    Slot<float> head_length{*this, "head_length"};
    Slot<glm::vec4> cleared{*this, "cleared"};
    Slot<glm::vec3> toward_light{*this, "toward_light"};
    Slot<glm::vec3> eye{*this, "eye"};
    Slot<float> outside{*this, "outside"};
    Slot<float> color_coded{*this, "color_coded"};
    Slot<glm::vec3> inside_color{*this, "inside_color"};
    Slot<float> ghost{*this, "ghost"};
    Slot<glm::vec4> tint{*this, "tint"};
    Slot<glm::vec3> paper{*this, "paper"};
};

/// Boxes in world space, to ask whether anything of them would be seen.
struct BoxProgram : Program {
    BoxProgram() : Program("box.vert", "box.frag") {}

    Slot<glm::mat4> clip_from_world{*this, "clip_from_world"};
};

/// A surface, lit; or with ERROR_MAP coloured by the naive rule's error, with NORMALS by its normals. With PROJECTIVE what
/// M does to a place is not affine.
struct SurfaceProgram : SceneProgram {
    explicit SurfaceProgram(std::string_view define, std::string_view vertex_file = "scene.vert")
        : SceneProgram(define, vertex_file) {}

    Slot<glm::mat4> naive_matrix{*this, "naive_matrix"};
    Slot<float> naive_w{*this, "naive_w"};
    Slot<glm::mat3> inverse_transpose_matrix{*this, "inverse_transpose_matrix"};
    Slot<glm::mat4> planes{*this, "planes"};
    Slot<std::span<const glm::vec3>> ramp{*this, "ramp"};
};

/// What TraceProgram found, as a SurfaceProgram. With CARRIES what all pixels share is carried to them, not uniform there.
struct TracedProgram : SurfaceProgram {
    explicit TracedProgram(std::string_view define) : SurfaceProgram(define, "trace.vert") {}

    Slot<glm::mat4> space_from_clip{*this, "space_from_clip"};
    Slot<float> ray_depth{*this, "ray_depth"};
    Slot<glm::vec2> shift{*this, "shift"};
    Slot<glm::vec2> tile{*this, "tile"};
    Slot<int> tiles{*this, "tiles"};
    Slot<float> least{*this, "least"};
    Slot<glm::ivec2> pane_origin{*this, "pane_origin"};
    Slot<int> hits{*this, "hits"};
    Slot<int> coarseness{*this, "coarseness"};
    Slot<int> edges{*this, "edges"};
    Slot<float> leave_edges{*this, "leave_edges"};
    Slot<int> sample_mask{*this, "sample_mask"};
    Slot<glm::mat3> object_from_world{*this, "object_from_world"};
    Slot<float> mirrored{*this, "mirrored"};
};

}  // namespace normalscope
