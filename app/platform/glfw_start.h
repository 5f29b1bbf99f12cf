#pragma once

#include <string>

namespace normalscope {

/// Why GLFW's last call failed.
std::string glfw_error();

/// Starts GLFW, unless it has been started, for a window that is shown or for one that never is. Throws ContextError.
enum class GlfwFor { Window, HiddenWindow };
void start_glfw(GlfwFor what);

/// The next window is to have OpenGL 3.3, and is not shown as it is made.
void ask_for_opengl();

/// What is wrong where it has none, and what helps: "…; install …, or open normalscope.html in a browser".
std::string without_opengl(const std::string& reason);

}  // namespace normalscope
