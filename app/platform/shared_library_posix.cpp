#include "platform/shared_library.h"

#include <dlfcn.h>

namespace normalscope {

SharedLibrary::SharedLibrary(const std::vector<std::string>& names) {
    std::string reason;
    for (const std::string& name : names) {
        handle_ = ::dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL);
        name_ = name;
        if (handle_) return;
        if (reason.empty()) reason = ::dlerror();
    }
    throw MissingLibrary(reason);
}

void* SharedLibrary::symbol(const char* name) const {
    if (void* found = ::dlsym(handle_, name)) return found;
    throw MissingLibrary(name_ + ": has no " + name);
}

}  // namespace normalscope
