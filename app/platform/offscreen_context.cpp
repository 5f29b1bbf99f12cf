#include "platform/offscreen_context.h"

#include "core/base/error.h"
#include "platform/egl_context.h"
#include "platform/osmesa_context.h"

#include <cstdlib>
#include <string>

namespace normalscope {

void prefer_quick_shader_compilation() { ::setenv("GALLIVM_PERF", "nopt", 0); }

std::unique_ptr<Context> make_offscreen_context(ContextChoice kind) {
    if (kind == ContextChoice::Egl) {
        try {
            return make_egl_context();
        } catch (const ContextError& e) {
            throw ContextError("no EGL context: " + std::string(e.what()) +
                               "; install libegl1 with libgl1-mesa-dri, or use --context osmesa");
        }
    }
    try {
        return make_osmesa_context();
    } catch (const ContextError& osmesa) {
        if (kind == ContextChoice::Osmesa)
            throw ContextError("no OSMesa context: " + std::string(osmesa.what()) +
                               "; install libosmesa6, or use --context egl");
        try {
            return make_egl_context();
        } catch (const ContextError& egl) {
            throw ContextError("no graphics context: OSMesa: " + std::string(osmesa.what()) + "; EGL: " + egl.what() +
                               "; install libosmesa6, or libegl1 with libgl1-mesa-dri");
        }
    }
}

}  // namespace normalscope
