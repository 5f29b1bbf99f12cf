#pragma once

#include "core/base/error.h"

#include <string>
#include <vector>

namespace normalscope {

/// A library is not there, or is not what its name says.
struct MissingLibrary : ContextError {
    using ContextError::ContextError;
};

/// A library that may be missing, looked for at run time.
class SharedLibrary {
public:
    /// Tries the names in order. Throws MissingLibrary with the loader's reason where none can be opened.
    explicit SharedLibrary(const std::vector<std::string>& names);

    /// A function by name. Throws MissingLibrary where the library does not have it.
    template <class F>
    F* function(const char* name) const {
        return reinterpret_cast<F*>(symbol(name));
    }

private:
    void* symbol(const char* name) const;

    // Never closed: Mesa's worker threads may outlive a context.
    void* handle_ = nullptr;
    std::string name_;
};

}  // namespace normalscope
