#include "desktop/desktop.h"

#include "desktop/cursors.h"
#include "desktop/keys.h"
#include "desktop/recovery.h"
#include "desktop/settings.h"
#include "platform/system_fonts.h"
#include "screen/screen.h"
#include "viewer/viewer.h"

#define GLFW_INCLUDE_NONE  // GL's declarations come from glad
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace normalscope {

namespace {

/// The viewer in a window of GLFW's, drawn by GL.
class Desktop final : public Host {
public:
    Desktop(Opened first, std::vector<std::filesystem::path> lesson_folders)
        : viewer_(*this, std::move(first), remembered()) {
        viewer_.take_lessons_from(std::move(lesson_folders));
        window_.choose_monitor(settings_.monitor);
        connect();
    }
    ~Desktop() override { save(); }
    Desktop(const Desktop&) = delete;
    Desktop& operator=(const Desktop&) = delete;

    void run() {
        viewer_.step();  // before any event: what one means depends on what is on the screen
        while (!glfwWindowShouldClose(window_.handle())) {
            wait(viewer_.due());
            window_.watch_place();
            viewer_.step();
            // How far a course has come is not lost with what ends the program.
            if (remembered_text(viewer_.remembered()) != saved_) save();
        }
    }

    double now() const override { return glfwGetTime(); }
    glm::ivec2 framebuffer_size() const override { return window_.framebuffer_size(); }
    float content_scale() const override { return window_.content_scale(); }

    void upload_fonts() override { screen_.upload_fonts(); }
    void draw(const Picture& picture) override { screen_.draw(picture, framebuffer_size()); }
    void show() override {
        screen_.show();
        glfwSwapBuffers(window_.handle());
        cursors_.show_in(window_.handle());
    }
    Image image_of(const Frame& frame) override { return screen_.image_of(frame, framebuffer_size()); }

    std::vector<FontFile> fonts_for(std::span<const char32_t> letters) override { return system_fonts(letters); }

    std::string clipboard() override {
        const char* text = glfwGetClipboardString(window_.handle());
        return text ? text : "";
    }
    void set_clipboard(const std::string& text) override { glfwSetClipboardString(window_.handle(), text.c_str()); }
    void set_title(const std::string& title) override { glfwSetWindowTitle(window_.handle(), title.c_str()); }
    bool full_screen() const override { return window_.full_screen(); }
    void toggle_full_screen() override { window_.toggle_full_screen(); }
    void to_next_monitor() override { window_.to_next_monitor(); }
    void close() override { glfwSetWindowShouldClose(window_.handle(), GLFW_TRUE); }
    void keep(const std::string& unsaved) override { recovery_.keep(unsaved); }

private:
    void connect();
    static Viewer& viewer_of(GLFWwindow* window) {
        return static_cast<Desktop*>(glfwGetWindowUserPointer(window))->viewer_;
    }
    static void wait(double seconds) {
        if (seconds <= 0.0)
            glfwPollEvents();
        else if (std::isfinite(seconds))
            glfwWaitEventsTimeout(std::max(seconds, 0.001));
        else
            glfwWaitEvents();
    }

    void save() {
        settings_.place = window_.place();
        settings_.remembered = viewer_.remembered();
        settings_.monitor = window_.chosen_monitor();
        saved_ = remembered_text(settings_.remembered);
        save_settings(settings_);
    }

    Remembered remembered() {
        Remembered remembered = settings_.remembered;
        remembered.unsaved = recovery_.left_behind();
        return remembered;
    }

    Settings settings_ = load_settings();
    std::string saved_ = remembered_text(settings_.remembered);
    Recovery recovery_{settings_folder()};
    Window window_{"Normalscope", settings_.place};
    struct Current {  // before everything that needs GL
        explicit Current(Window& window) { window.make_current(); }
    } current_{window_};
    Cursors cursors_;
    Viewer viewer_;
    Screen screen_;  // Dear ImGui's context is the viewer's
};

void Desktop::connect() {
    GLFWwindow* w = window_.handle();
    glfwSetWindowUserPointer(w, this);
    glfwSetCursorPosCallback(w, [](GLFWwindow* window, double x, double y) {
        auto& desktop = *static_cast<Desktop*>(glfwGetWindowUserPointer(window));
        desktop.viewer_.pointer_to(glm::dvec2(x, y) * desktop.window_.pixels_per_pointer_unit());
    });
    glfwSetCursorEnterCallback(w, [](GLFWwindow* window, int entered) {
        if (!entered) viewer_of(window).pointer_left();
    });
    glfwSetMouseButtonCallback(w, [](GLFWwindow* window, int button, int action, int modifiers) {
        if (action == GLFW_PRESS)
            viewer_of(window).press(button, modifiers_of(modifiers));
        else
            viewer_of(window).release(button, modifiers_of(modifiers));
    });
    glfwSetScrollCallback(w, [](GLFWwindow* window, double x, double y) { viewer_of(window).scroll({x, y}); });
    glfwSetKeyCallback(w, [](GLFWwindow* window, int key, int code, int action, int modifiers) {
        const char* printed = glfwGetKeyName(key, code);
        const ImGuiKeyChord held = modifiers_of(modifiers);
        const KeyPress press{key_of(key, printed ? printed : "", held), held, action == GLFW_REPEAT};
        if (action == GLFW_RELEASE)
            viewer_of(window).release(press);
        else
            viewer_of(window).press(press);
    });
    glfwSetCharCallback(w, [](GLFWwindow* window, unsigned letter) { viewer_of(window).type(letter); });
    glfwSetWindowFocusCallback(w, [](GLFWwindow* window, int focused) { viewer_of(window).focus(focused != 0); });
    glfwSetWindowCloseCallback(w, [](GLFWwindow* window) {
        glfwSetWindowShouldClose(window, GLFW_FALSE);  // not yet
        viewer_of(window).close();
    });
    glfwSetDropCallback(w, [](GLFWwindow* window, int count, const char** files) {
        if (count > 0) viewer_of(window).open(files[0]);
    });
    glfwSetFramebufferSizeCallback(w, [](GLFWwindow* window, int, int) {
        viewer_of(window).expose();
        viewer_of(window).step();  // also while the frame is being dragged
    });
    glfwSetWindowRefreshCallback(w, [](GLFWwindow* window) { viewer_of(window).expose(); });
    glfwSetWindowContentScaleCallback(w, [](GLFWwindow* window, float, float) { viewer_of(window).expose(); });
}

}  // namespace

void run_viewer(Opened first, std::vector<std::filesystem::path> lesson_folders) {
    Desktop(std::move(first), std::move(lesson_folders)).run();
}

}  // namespace normalscope
