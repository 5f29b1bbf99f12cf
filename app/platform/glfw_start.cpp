#include "platform/glfw_start.h"

#include "core/base/error.h"
#include "core/base/own_page.h"
#include "core/base/system.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace normalscope {

namespace {

// GLFW 3.4 tries Wayland first, whose library prints an error of its own where there is none; and having tried two
// platforms it no longer says why either failed. So where no variable leads to Wayland only X11 is tried.
void choose_platform() {
#ifdef GLFW_PLATFORM
    if (variable("WAYLAND_DISPLAY").empty() && variable("WAYLAND_SOCKET").empty() &&
        glfwPlatformSupported(GLFW_PLATFORM_X11))
        glfwInitHint(GLFW_PLATFORM, GLFW_PLATFORM_X11);
#endif
}

}  // namespace

std::string glfw_error() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text ? text : "GLFW gives no reason";
}

void start_glfw(GlfwFor what) {
    choose_platform();
    // On a Mac. Files are named from where the program was started, and whoever captures has no use for a menu.
    glfwInitHint(GLFW_COCOA_CHDIR_RESOURCES, GLFW_FALSE);
    glfwInitHint(GLFW_COCOA_MENUBAR, what == GlfwFor::Window ? GLFW_TRUE : GLFW_FALSE);
    if (!glfwInit()) throw ContextError(glfw_error());
}

void ask_for_opengl() {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
}

std::string without_opengl(const std::string& reason) {
    const std::filesystem::path page = own_page();
    return reason + "; " + remedy(Missing::OpenGl) +
           (page.empty() ? "" : "; or open " + text_of(page) + " in a browser, which needs no such driver");
}

}  // namespace normalscope
