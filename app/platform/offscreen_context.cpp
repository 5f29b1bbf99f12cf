#include "platform/offscreen_context.h"

#include "core/base/error.h"
#include "platform/egl_context.h"
#include "platform/osmesa_context.h"

#include <cstdlib>
#include <optional>
#include <string>

namespace normalscope {

namespace {

/// A variable of the environment, set while one lives unless the user has set it: Mesa can be told some things in no other
/// way, and reads them once, when a process makes its first context. Nothing that is started later shall find them.
class SetForNow {
public:
    SetForNow(const char* name, const std::string& value) : name_(std::getenv(name) ? nullptr : name) {
        if (name_) ::setenv(name_, value.c_str(), 0);
    }
    ~SetForNow() {
        if (name_) ::unsetenv(name_);
    }
    SetForNow(const SetForNow&) = delete;
    SetForNow& operator=(const SetForNow&) = delete;

private:
    const char* name_;
};

std::unique_ptr<Context> make_context(ContextChoice kind);

}  // namespace

std::unique_ptr<Context> make_offscreen_context(const ContextOptions& options) {
    const SetForNow silence("EGL_LOG_LEVEL", "fatal");  // what is wrong is said in one line, once all has been tried
    std::optional<SetForNow> shaders, threads;
    if (options.quick_shaders) shaders.emplace("GALLIVM_PERF", "nopt");
    if (options.threads > 0) threads.emplace("LP_NUM_THREADS", std::to_string(options.threads));
    return make_context(options.choice);
}

namespace {

std::unique_ptr<Context> make_context(ContextChoice kind) {
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

}  // namespace

}  // namespace normalscope
