#pragma once

#include "core/frame/frame.h"
#include "core/scene/scene.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace normalscope {

/// What `--numbers` says of where the picture was drawn.
struct Drawn {
    std::string program;     ///< its version
    std::string renderer;    ///< as GL has it
    std::string gl_version;  ///< as GL has it
    std::string context;     ///< "osmesa" or "egl"
};

/// What the picture means, as JSON (docs/commands.md): matrices as arrays of rows, null for what does not exist.
std::string numbers_text(const Scene& scene, const Frame& frame, const Drawn& drawn);

/// The same as JSON to add to; without `drawn`, where no picture was made, their keys are null.
nlohmann::ordered_json numbers_json(const Scene& scene, const Frame& frame, const std::optional<Drawn>& drawn);

}  // namespace normalscope
