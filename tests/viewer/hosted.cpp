#include "viewer/hosted.h"

#include "core/base/file.h"
#include "core/scene/scene_json.h"

#include <cmath>
#include <ostream>
#include <thread>

namespace normalscope {

namespace {

constexpr double kFrame = 1.0 / 60.0;
constexpr std::string_view kUnsaved = "\u2022 ";

KeyPress pressed(ImGuiKeyChord chord) {
    return {static_cast<ImGuiKey>(chord & ~ImGuiMod_Mask_), chord & ImGuiMod_Mask_, false};
}

}  // namespace

void PrintTo(const Scene& scene, std::ostream* out) { *out << scene_text(scene); }

Item::Item(std::string_view name) {
    for (ImGuiWindow* window : ImGui::GetCurrentContext()->Windows)
        if (std::string_view(window->Name).starts_with(name) && window->Active) {
            window_ = window;
            id_ = window->ID;
            return;
        }
    ADD_FAILURE() << "there is no window " << name;
}

Item Item::operator/(const char* id) const {
    Item item = *this;
    item.id_ = ImHashStr(id, 0, id_);
    return item;
}

Item Item::operator/(int id) const {
    Item item = *this;
    item.id_ = ImHashData(&id, sizeof id, id_);
    return item;
}

Scene ViewerTest::light(const std::string& name) {
    Scene scene = load_scene(name);
    if (auto* shape = std::get_if<ShapeSurface>(&scene.surface)) shape->resolution = 24;
    scene.view = ViewMode::Single;
    scene.arrows.limit = 12;
    scene.show.grid = scene.show.ghost = false;
    if (!scene.camera.zoom) scene.camera.zoom = 1.0;  // so that nothing is framed
    return scene;
}

void ViewerTest::start(Scene scene, const std::string& file, Remembered remembered) {
    viewer_.reset();  // there is just one Dear ImGui
    Opened first;
    if (!file.empty()) first = open_file(file, scene);
    if (!first.lesson) first.scene = std::move(scene);  // as --set may have changed it
    viewer_.emplace(host_, std::move(first), std::move(remembered));
    viewer_->step();
    settle();
}

std::string ViewerTest::named() const {
    const auto dash = host_.title.find(" \u2013 ");
    if (dash == std::string::npos) return "";
    const std::string name = host_.title.substr(0, dash);
    return name.starts_with(kUnsaved) ? name.substr(kUnsaved.size()) : name;
}

bool ViewerTest::is_unsaved() const { return host_.title.starts_with(kUnsaved); }

bool ViewerTest::asked() {
    const ImGuiWindow* question = ImGui::FindWindowByName("##question");
    return question && question->Active;
}

void ViewerTest::settle() {
    for (int i = 0; i < 100'000 && viewer_->due() < 0.2; ++i) {
        if (viewer_->opening() || viewer_->making_surface()) std::this_thread::yield();
        host_.time += std::max(kFrame, viewer_->due());
        viewer_->step();
    }
}

void ViewerTest::wait(double seconds) {
    for (const double end = host_.time + seconds; host_.time < end;) {
        host_.time = std::min(end, host_.time + std::max(kFrame, viewer_->due()));
        viewer_->step();
    }
    settle();
}

void ViewerTest::key(ImGuiKeyChord chord) {
    viewer_->press(pressed(chord));
    viewer_->release(pressed(chord));
    viewer_->release({ImGuiKey_None});
    settle();
}

void ViewerTest::hold(ImGuiKey key) {
    viewer_->press(KeyPress{key});
    viewer_->press(KeyPress{key, 0, true});
    viewer_->release(KeyPress{key});
    settle();
}

void ViewerTest::type(std::string_view text) {
    for (const char letter : text) viewer_->type(static_cast<char32_t>(letter));
    settle();
}

void ViewerTest::point(glm::dvec2 at) {
    viewer_->pointer_to(at);
    settle();
}

void ViewerTest::press(int button, ImGuiKeyChord modifiers) {
    viewer_->press(button, modifiers);
    settle();
}

void ViewerTest::release(int button, ImGuiKeyChord modifiers) {
    viewer_->release(button, modifiers);
    settle();
}

void ViewerTest::click(glm::dvec2 at) {
    point(at);
    press();
    release();
}

void ViewerTest::drag(std::initializer_list<glm::dvec2> way, int button, ImGuiKeyChord modifiers) {
    point(*way.begin());
    press(button, modifiers);
    for (const glm::dvec2 at : way) point(at);
    release(button, modifiers);
}

void ViewerTest::wheel(double steps) {
    viewer_->scroll({0.0, steps});
    settle();
}

void ViewerTest::answer_dialog(ImGuiKey letter, const std::string& name) {
    key(ImGuiMod_Ctrl | letter);
    type(name);
    key(ImGuiKey_Enter);
}

void ViewerTest::open(const std::string& name) {
    viewer_->open(name);
    settle();
}

// Dear ImGui knows where the item is that the keyboard would go on from.
glm::dvec2 ViewerTest::middle(const Item& item) {
    ImGuiContext& imgui = *ImGui::GetCurrentContext();
    ImGuiWindow* const window_before = imgui.NavWindow;
    const ImGuiID before = imgui.NavId;
    item.window()->NavRectRel[0] = {};
    imgui.NavWindow = item.window();
    imgui.NavId = item.id();
    viewer_->expose();
    viewer_->step();
    const ImRect rect = ImGui::WindowRectRelToAbs(item.window(), item.window()->NavRectRel[0]);
    EXPECT_TRUE(imgui.NavIdIsAlive) << "there is no such item in " << item.window()->Name;
    EXPECT_GT(rect.GetWidth(), 0.0f) << "there is no such item in " << item.window()->Name;
    imgui.NavWindow = window_before;
    imgui.NavId = before;
    settle();
    return {rect.GetCenter().x, rect.GetCenter().y};
}

glm::dvec2 ViewerTest::pixel(glm::dvec3 at, std::size_t pane) const {
    const Pane& seen = viewer_->frame()->panes.at(pane);
    return glm::dvec2(seen.rect.origin) + glm::dvec2(seen.view.pixel({at}));
}

glm::dvec2 ViewerTest::ground() const {
    const PixelRect& rect = viewer_->frame()->rect;
    return glm::dvec2(rect.origin) + glm::dvec2(rect.size.x / 2, rect.size.y - 15);
}

std::filesystem::path ViewerTest::write(const std::string& name, std::string_view content) const {
    std::filesystem::path file = folder_.path() / name;
    std::filesystem::create_directories(file.parent_path());
    write_file(file, content);
    return file;
}

void ViewerTest::expect_undo(std::initializer_list<Scene> scenes) {
    for (auto it = std::rbegin(scenes) + 1; it != std::rend(scenes); ++it) {
        key(ImGuiMod_Ctrl | ImGuiKey_Z);
        EXPECT_EQ(scene(), *it);
    }
}

}  // namespace normalscope
