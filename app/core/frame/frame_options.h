#pragma once

#include "core/frame/carried_arrows.h"
#include "core/frame/frame.h"
#include "core/frame/step_marks.h"
#include "core/math/highlight.h"
#include "core/surface/level_sets.h"

#include <memory>
#include <optional>

namespace normalscope {

struct FrameOptions {
    PixelRect rect;
    float pixel_scale = 1.0f;              ///< physical pixels per logical one
    std::optional<int> hot_axis{};         ///< the axis handle under the pointer
    std::optional<Highlight> highlight{};  ///< what is pointed at in the equations
    bool handles = true;                   ///< knobs on the axes, to be dragged
    Quality quality = Quality::Fine;
    /// The scene's (LevelSetsCache); null: they are made anew.
    std::shared_ptr<const LevelSets> level_sets{};
    StepMarks marks{};
    /// The surface's (FlatCutCache); null: it is made anew.
    std::shared_ptr<const FlatCut> flat_cut{};
    double right_power = -1.0;  ///< of the inverse transpose's arrows and light, as of normal_map
    double unit = 1.0;          ///< as Frame::unit; make_frame finds it
};

}  // namespace normalscope
