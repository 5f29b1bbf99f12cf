#include "platform/shared_library.h"

#include "core/base/windows_text.h"

#include <windows.h>

namespace normalscope {

SharedLibrary::SharedLibrary(const std::vector<std::string>& names) {
    for (const std::string& name : names) {
        handle_ = reinterpret_cast<void*>(::LoadLibraryW(wide(name).c_str()));
        name_ = name;
        if (handle_) return;
    }
    throw MissingLibrary(names.front() + ": there is none");
}

void* SharedLibrary::symbol(const char* name) const {
    if (const FARPROC found = ::GetProcAddress(reinterpret_cast<HMODULE>(handle_), name))
        return reinterpret_cast<void*>(found);
    throw MissingLibrary(name_ + ": has no " + name);
}

}  // namespace normalscope
