#include "platform/egl_context.h"

#include "core/base/error.h"
#include "platform/gl_debug.h"
#include "platform/shared_library.h"

// Where a system has no EGL there is nothing to build against either; captures go through OSMesa then.
#if __has_include(<EGL/egl.h>) && !defined(NORMALSCOPE_WITHOUT_EGL)
#define NORMALSCOPE_HAS_EGL
#include <EGL/egl.h>
#include <EGL/eglext.h>
#endif
#include <glad/gl.h>

#include <array>
#include <cstdlib>
#include <string>

namespace normalscope {

#ifdef NORMALSCOPE_HAS_EGL

namespace {

std::vector<std::string> library_names() {
    if (const char* name = std::getenv("NORMALSCOPE_EGL_LIBRARY")) return {name};
    return {"libEGL.so.1", "libEGL.so"};
}

class Egl final : public Context {
public:
    Egl() : library_(library_names()), get_(library_.function<Function(const char*)>("eglGetProcAddress")) {
        for (const EGLDisplay display : displays()) {
            if (display == EGL_NO_DISPLAY || !egl<decltype(eglInitialize)>("eglInitialize")(display, nullptr, nullptr))
                continue;
            display_ = display;
            if (create_context()) return;
            egl<decltype(eglTerminate)>("eglTerminate")(display);
        }
        throw ContextError("it offers no OpenGL 3.3 context without a surface");
    }
    ~Egl() override {
        egl<decltype(eglMakeCurrent)>("eglMakeCurrent")(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        egl<decltype(eglDestroyContext)>("eglDestroyContext")(display_, context_);
        egl<decltype(eglTerminate)>("eglTerminate")(display_);
    }
    Egl(const Egl&) = delete;
    Egl& operator=(const Egl&) = delete;

    void make_current() override {
        const auto current = egl<decltype(eglMakeCurrent)>("eglMakeCurrent");
        if (!current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) || !gladLoadGL(get_))
            throw ContextError("EGL: its OpenGL 3.3 context cannot be used");
        watch_for_gl_errors();
    }
    std::string_view name() const override { return "egl"; }

private:
    template <class F>
    F* egl(const char* name) const {
        return library_.function<F>(name);
    }
    template <class F>
    F extension(const char* name) const {
        return reinterpret_cast<F>(get_(name));
    }

    // Every device, graphics cards first as the driver lists them, then Mesa's surfaceless platform.
    std::vector<EGLDisplay> displays() const {
        const auto platform_display = extension<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
        const auto query_devices = extension<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
        if (!platform_display) return {};
        std::vector<EGLDisplay> found;
        std::array<EGLDeviceEXT, 16> devices{};
        EGLint count = 0;
        if (query_devices && query_devices(static_cast<EGLint>(devices.size()), devices.data(), &count))
            for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
                found.push_back(platform_display(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr));
        found.push_back(platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
        return found;
    }

    bool create_context() {
        if (!egl<decltype(eglBindAPI)>("eglBindAPI")(EGL_OPENGL_API)) return false;
        constexpr std::array kAttributes{
            EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
        const auto create = egl<decltype(eglCreateContext)>("eglCreateContext");
        context_ = create(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, kAttributes.data());
        return context_ != EGL_NO_CONTEXT;
    }

    SharedLibrary library_;
    Loader get_;
    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

std::unique_ptr<Context> make_egl_context() { return std::make_unique<Egl>(); }

#else

std::unique_ptr<Context> make_egl_context() { throw MissingLibrary("this program was built on a system without EGL"); }

#endif

}  // namespace normalscope
