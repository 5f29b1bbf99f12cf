#include "platform/osmesa_context.h"

#include "core/base/error.h"
#include "platform/gl_debug.h"
#include "platform/shared_library.h"

#include <glad/gl.h>

#include <array>
#include <cstdlib>

namespace normalscope {

namespace {

// OSMesa's interface, of which these few are used; its header is not asked for, since the library is optional.
using OsmesaContext = struct osmesa_context*;
constexpr int kFormat = 0x22, kDepthBits = 0x30, kStencilBits = 0x31, kProfile = 0x33, kCoreProfile = 0x34;
constexpr int kMajorVersion = 0x36, kMinorVersion = 0x37, kRgba = GL_RGBA;

std::vector<std::string> library_names() {
    if (const char* name = std::getenv("NORMALSCOPE_OSMESA_LIBRARY")) return {name};
    return {"libOSMesa.so.8", "libOSMesa.so", "osmesa.dll"};
}

class Osmesa final : public Context {
public:
    Osmesa() : library_(library_names()) {
        const auto create = library_.function<OsmesaContext(const int*, OsmesaContext)>("OSMesaCreateContextAttribs");
        constexpr std::array kAttributes{kFormat,  kRgba,        kDepthBits,    0, kStencilBits,  0,
                                         kProfile, kCoreProfile, kMajorVersion, 3, kMinorVersion, 3,
                                         0};
        context_ = create(kAttributes.data(), nullptr);
        if (!context_) throw ContextError("it cannot make an OpenGL 3.3 context");
        loader_ = library_.function<Function(const char*)>("OSMesaGetProcAddress");
    }
    ~Osmesa() override { library_.function<void(OsmesaContext)>("OSMesaDestroyContext")(context_); }
    Osmesa(const Osmesa&) = delete;
    Osmesa& operator=(const Osmesa&) = delete;

    void make_current() override {
        // Its own framebuffer is a formality: the renderer draws into one of its own.
        const auto current =
            library_.function<unsigned char(OsmesaContext, void*, GLenum, int, int)>("OSMesaMakeCurrent");
        if (!current(context_, pixels_.data(), GL_UNSIGNED_BYTE, kSide, kSide) || !gladLoadGL(loader_))
            throw ContextError("OSMesa: its OpenGL 3.3 context cannot be used");
        watch_for_gl_errors();
    }
    std::string_view name() const override { return "osmesa"; }

private:
    static constexpr int kSide = 8;
    SharedLibrary library_;
    OsmesaContext context_ = nullptr;
    Loader loader_ = nullptr;
    std::array<unsigned char, std::size_t{4} * kSide * kSide> pixels_{};
};

}  // namespace

std::unique_ptr<Context> make_osmesa_context() { return std::make_unique<Osmesa>(); }

}  // namespace normalscope
