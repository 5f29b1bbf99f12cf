#pragma once

// One class a GL program: its shader files and its uniforms, by their names there.

#include "gl/program.h"

namespace normalscope {

struct BackdropProgram : Program {
    BackdropProgram() : Program("backdrop.vert", "backdrop.frag") {}

    Slot<glm::mat4> world_from_clip{*this, "world_from_clip"};
    Slot<glm::vec3> eye{*this, "eye"};
    Slot<glm::vec3> top_color{*this, "top_color"};
    Slot<glm::vec3> bottom_color{*this, "bottom_color"};
    Slot<glm::vec3> grid_color{*this, "grid_color"};
    Slot<float> ground{*this, "ground"};
    Slot<float> grid_amount{*this, "grid_amount"};
    Slot<glm::mat3> shadow{*this, "shadow"};
    Slot<int> samples{*this, "samples"};
    Slot<glm::ivec2> drawn_low{*this, "drawn_low"};
    Slot<glm::ivec2> drawn_size{*this, "drawn_size"};
};

/// Everything solid: the mesh, its arrows, and what is made anew every frame.
struct SceneProgram : Program {
    explicit SceneProgram(std::string_view define = {}) : Program("scene.vert", "scene.frag", define) {}

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
    Slot<glm::vec3> toward_light{*this, "toward_light"};
    Slot<glm::vec3> eye{*this, "eye"};
    Slot<float> outside{*this, "outside"};
    Slot<float> color_coded{*this, "color_coded"};
    Slot<glm::vec3> inside_color{*this, "inside_color"};
    Slot<float> ghost{*this, "ghost"};
    Slot<glm::vec4> tint{*this, "tint"};
};

/// The mesh, coloured by the naive rule's error.
struct ErrorMapProgram : SceneProgram {
    ErrorMapProgram() : SceneProgram("ERROR_MAP") {}

    Slot<glm::mat4> naive_matrix{*this, "naive_matrix"};
    Slot<float> naive_w{*this, "naive_w"};
    Slot<glm::mat3> inverse_transpose_matrix{*this, "inverse_transpose_matrix"};
    Slot<std::span<const glm::vec3>> ramp{*this, "ramp"};
};

}  // namespace normalscope
