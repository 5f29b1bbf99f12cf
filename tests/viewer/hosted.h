#pragma once

#include "core/base/temporary_folder.h"
#include "core/lessons/open.h"
#include "viewer/viewer.h"

#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>  // its windows and the rectangles in them

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace normalscope {

/// In failures a scene is its JSON.
void PrintTo(const Scene& scene, std::ostream* out);

/// A host made of nothing, which writes down what it is asked for.
class FakeHost final : public Host {
public:
    struct Drawn {
        bool anew, rough;
        Quality quality;
    };

    double now() const override { return time; }
    glm::ivec2 framebuffer_size() const override { return size; }
    float content_scale() const override { return 1.0f; }
    void upload_fonts() override { ++uploads; }
    void draw(const Picture& picture) override {
        drawn.push_back({picture.anew, picture.rough, picture.frame.quality});
    }
    void show() override { ++shows; }
    Image image_of(const Frame&) override { return make_image(size); }
    std::string clipboard() override { return text; }
    void set_clipboard(const std::string& copied) override { text = copied; }
    void set_title(const std::string& shown) override { title = shown; }
    bool full_screen() const override { return full; }
    void toggle_full_screen() override { full = !full; }
    void to_next_monitor() override { ++monitor; }
    void close() override { closed = true; }
    void keep(const std::string& scene) override { kept = scene; }

    double time = 0.0;
    glm::ivec2 size{1000, 720};
    std::string text, title, kept;
    bool full = false, closed = false;
    int monitor = 0, uploads = 0, shows = 0;
    std::vector<Drawn> drawn;
};

/// An item of Dear ImGui's: the beginning of its window's name, and what leads to it from there, as in
/// Item("##panel/##rest") / 0 / "##x".
class Item {
public:
    explicit Item(std::string_view window);
    Item operator/(const char* id) const;
    Item operator/(int id) const;
    ImGuiWindow* window() const { return window_; }
    ImGuiID id() const { return id_; }

private:
    ImGuiWindow* window_ = nullptr;
    ImGuiID id_ = 0;
};

/// Presses keys, drags and opens without a window.
class ViewerTest : public testing::Test {
protected:
    /// A scene that is quickly made, for tests to which that makes no difference.
    static Scene light(const std::string& name = std::string(kDefaultScene));

    void start(Scene scene = light(), const std::string& file = "", Remembered remembered = {});
    Viewer& viewer() { return *viewer_; }
    const Scene& scene() const { return viewer_->scene(); }
    const Lecture& lecture() const { return viewer_->interface().lecture(); }
    std::string message() const { return std::string(viewer_->interface().message()); }
    /// The name before the dash in the title; empty without one.
    std::string named() const;
    /// The title has a dot before it.
    bool is_unsaved() const;
    /// A question waits for its answer.
    static bool asked();

    /// Steps until there is nothing to do but wait for the user, or for a note to go.
    void settle();
    void wait(double seconds);
    void key(ImGuiKeyChord chord);
    void keys(std::initializer_list<ImGuiKeyChord> chords) {
        for (const ImGuiKeyChord chord : chords) key(chord);
    }
    void hold(ImGuiKey key);  ///< repeats it once more
    void type(std::string_view text);
    void point(glm::dvec2 at);
    void press(int button = 0, ImGuiKeyChord modifiers = 0);
    void release(int button = 0, ImGuiKeyChord modifiers = 0);
    void click(glm::dvec2 at);
    void click(const Item& item) { click(middle(item)); }
    /// From the first place to the last by way of the others, each of which is drawn.
    void drag(std::initializer_list<glm::dvec2> way, int button = 0, ImGuiKeyChord modifiers = 0);
    void wheel(double steps);
    /// By the dialog that Ctrl and the letter open.
    void answer_dialog(ImGuiKey letter, const std::string& name);
    /// As if dropped onto the window.
    void open(const std::string& name);

    glm::dvec2 middle(const Item& item);
    /// Where a point of the world is in the window.
    glm::dvec2 pixel(glm::dvec3 at, std::size_t pane = 0) const;
    /// The picture's middle, at its lower edge: nothing but ground.
    glm::dvec2 ground() const;
    std::filesystem::path write(const std::string& name, std::string_view content) const;
    std::string path(const std::string& name) const { return (folder_.path() / name).string(); }

    /// Undoing goes back through these scenes, of which the last is the present one.
    void expect_undo(std::initializer_list<Scene> scenes);

    FakeHost host_;
    TemporaryFolder folder_{std::filesystem::path(testing::TempDir()) / "viewer"};
    std::optional<Viewer> viewer_;
};

}  // namespace normalscope
