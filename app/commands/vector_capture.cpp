#include "commands/vector_capture.h"

#include "commands/studio.h"
#include "core/frame/display_scale.h"
#include "core/picture/make_frame.h"
#include "core/picture/svg.h"
#include "core/scene/scene_json.h"

namespace normalscope {

VectorCapture vector_capture(const Scene& scene, const PictureArguments& arguments) {
    const float scale = arguments.scale.value_or(usual_scale(arguments.size));
    SurfaceCache surfaces;
    const Frame frame = make_frame(scene, surfaces.get(scene),
                                   {.rect = {{0, 0}, arguments.size}, .pixel_scale = scale, .handles = false});
    VectorCapture result{svg_text(scene, frame, scale, arguments.ground), frame.notes};
    if (scene.color != SurfaceColor::Lit)
        result.notes.push_back("an SVG's surfaces are flat, so that color=" + std::string(name(scene.color)) +
                               " is not in it; a PNG has it");
    return result;
}

}  // namespace normalscope
