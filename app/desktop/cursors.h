#pragma once

#include <array>

struct GLFWwindow;
struct GLFWcursor;

namespace normalscope {

/// The pointer's shapes that Dear ImGui asks for, as far as GLFW has them.
class Cursors {
public:
    Cursors();
    ~Cursors();
    Cursors(const Cursors&) = delete;
    Cursors& operator=(const Cursors&) = delete;

    /// As Dear ImGui's last round wants it.
    void show_in(GLFWwindow* window) const;

private:
    static constexpr int kCount = 9;
    std::array<GLFWcursor*, kCount> cursors_{};
};

}  // namespace normalscope
