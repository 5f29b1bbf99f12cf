#include "commands/vector_capture.h"

#include "commands/studio.h"
#include "core/picture/display_scale.h"
#include "core/picture/make_frame.h"
#include "core/picture/svg.h"

namespace normalscope {

std::string vector_capture(const Scene& scene, const PictureArguments& arguments) {
    const float scale = arguments.scale.value_or(usual_scale(arguments.size));
    SurfaceCache surfaces;
    const Frame frame = make_frame(scene, surfaces.get(scene),
                                   {.rect = {{0, 0}, arguments.size}, .pixel_scale = scale, .handles = false});
    return svg_text(scene, frame, scale, arguments.ground);
}

}  // namespace normalscope
