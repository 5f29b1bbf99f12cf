#pragma once

#include <string_view>

namespace normalscope {

/// A GL 3.3 core context and where its functions are. Everything that draws loads GL through glad from here, never from
/// a linked libGL, which would be another library than OSMesa.
class Context {
public:
    using Function = void (*)();
    using Loader = Function (*)(const char* name);

    virtual ~Context() = default;
    /// Makes the context current on the calling thread, and loads its functions.
    virtual void make_current() = 0;
    /// "window", "osmesa", "egl" or "hidden-window".
    virtual std::string_view name() const = 0;
};

}  // namespace normalscope
