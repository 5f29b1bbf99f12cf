#include "ui/interface.h"
#include "core/picture/make_frame.h"
#include "ui/kit/folder.h"
#include "ui/kit/number_text.h"

#include "core/lessons/lesson.h"
#include "core/lessons/open.h"
#include "core/lessons/tabs.h"
#include "core/scene/scene_fields.h"
#include "core/scene/scene_json.h"
#include "core/surface/surface.h"

#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>  // ImTextCharFromUtf8

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace normalscope {
namespace {

TEST(UiNumbers, HaveAFixedFormAndARealMinus) {
    EXPECT_EQ(fixed(0.5), "0.500");
    EXPECT_EQ(fixed(-0.5), "\u22120.500");
    EXPECT_EQ(fixed(-0.0), "0.000");
    EXPECT_EQ(fixed(-1e-9), "0.000");
    EXPECT_EQ(fixed(12345678.0), "1.2e7");
    EXPECT_EQ(fixed(-1e60), "\u22121.0e60");
    EXPECT_EQ(fixed(std::numeric_limits<double>::quiet_NaN()), "\u2014");
    EXPECT_EQ(fixed(std::nullopt), "\u2014");
    EXPECT_EQ(fixed_unless_small(-2.1e-7), "\u22122.1e\u22127");
    EXPECT_EQ(fixed_unless_small(0.0), "0.000");
    EXPECT_EQ(in_degrees(36.8699), "36.870°");
    EXPECT_EQ(brief(-1.250), "\u22121.25");
    EXPECT_EQ(brief(2.0), "2");
    EXPECT_EQ(grouped(1234567), "1,234,567");
}

TEST(UiFolder, ListsFoldersFirstAndOnlyTheEndingsAskedFor) {
    const auto folder = std::filesystem::temp_directory_path() / "normalscope_ui_folder";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder / "zoo");
    for (const char* name : {"b.OBJ", "a.json", "c.txt", ".hidden.obj"}) std::ofstream(folder / name) << "x";
    constexpr std::array<std::string_view, 2> kEndings{".obj", ".json"};
    const Folder found = read_folder(folder, kEndings);
    ASSERT_EQ(found.entries.size(), 3u);
    EXPECT_EQ(found.entries[0].name, "zoo");
    EXPECT_EQ(found.entries[1].name, "a.json");
    EXPECT_EQ(found.entries[2].name, "b.OBJ");
    EXPECT_FALSE(read_folder(folder / "nowhere", kEndings).error.empty());
    std::filesystem::remove_all(folder);
}

// The interface without a window: Dear ImGui lays everything out, nobody draws it.
class InterfaceTest : public testing::Test {
protected:
    InterfaceTest() { ImGui::CreateContext(); }
    ~InterfaceTest() override { ImGui::DestroyContext(); }

    void step() {
        interface_.prepare(scene_.theme, 1.0f);
        ImGuiIO& io = ImGui::GetIO();
        io.DisplaySize = {1280, 720};
        io.DeltaTime = 1.0f / 60.0f;
        const Frame frame = make_frame(scene_, surfaces_.get(scene_), {.rect = interface_.picture({1280, 720})});
        ImGui::NewFrame();
        interface_.draw(scene_, frame, {.can_undo = true, .can_redo = true, .errors = std::nullopt, .file = "test"});
        ImGui::Render();
    }

    Scene scene_;
    SurfaceCache surfaces_;
    Interface interface_;
};

TEST_F(InterfaceTest, ChangesNothingByItselfAndThenRests) {
    for (const BuiltInScene& built_in : built_in_scenes()) {
        const Scene before = scene_ = load_scene(built_in.name);
        for (int i = 0; i < 5; ++i) step();
        EXPECT_EQ(scene_, before) << built_in.name;
        EXPECT_TRUE(std::isinf(interface_.redraw_after())) << built_in.name;
    }
}

TEST_F(InterfaceTest, TabsChangeNothingByThemselvesAndRest) {
    for (const std::string& tab : tab_names()) {
        ASSERT_TRUE(interface_.show_tab(tab));
        for (const BuiltInScene& built_in : built_in_scenes()) {
            const Scene before = scene_ = load_scene(built_in.name);
            for (int i = 0; i < 3; ++i) step();
            EXPECT_EQ(scene_, before) << tab << ", " << built_in.name;
            EXPECT_TRUE(std::isinf(interface_.redraw_after())) << tab << ", " << built_in.name;
        }
    }
    const int with_tab = interface_.picture({1280, 720}).size.x;
    EXPECT_TRUE(interface_.show_tab(""));
    EXPECT_GT(interface_.picture({1280, 720}).size.x, with_tab);
    EXPECT_FALSE(interface_.show_tab("no such tab"));
}

// Stacks that leave nothing to invert, or nothing to show.
TEST_F(InterfaceTest, TabsTakeAnyStack) {
    const glm::dmat4 projective(1, 0, 0, 0, 0, 1, 0, 0.5, 0, 0, 1, 0, 0, 0, 0, 1);
    const std::array<std::vector<StackEntry>, 7> stacks{
        {{},
         {Scale{{0, 0, 0}}},
         {Scale{{1, 0, 0}}, Rotate{{1, 2, 3}, 40}},
         {Scale{{-1, 2, 0.5}}},
         {Scale{{1e-8, 1, 1e8}}, Shear{.xy = 1e8}},
         {Matrix{projective}},
         std::vector<StackEntry>(kMostStackEntries, Scale{{1.1, 1, 0.9}})}};
    for (const std::string& tab : tab_names())
        for (const auto& stack : stacks)
            for (const Mistake mistake : {Mistake::Naive, Mistake::WOne, Mistake::NotInverted})
                for (const std::optional<double> position :
                     {std::optional<double>{}, std::optional(0.0), std::optional(0.5)}) {
                    scene_.stack = stack;
                    scene_.mistake = mistake;
                    scene_.stack_position = position;
                    const Scene before = scene_;
                    interface_.show_tab(tab);
                    step();
                    step();
                    EXPECT_EQ(scene_, before) << tab << ", " << stack.size() << " entries";
                }
}

TEST_F(InterfaceTest, PlaysTheStackOnceAndEndsWithAllOfIt) {
    scene_.stack = {Scale{{0.5, 2, 1}}, Rotate{{0, 0, 1}, 30}};
    const Scene before = scene_;
    interface_.show_tab("stack");
    ImGuiIO& io = ImGui::GetIO();
    io.AddMousePosEvent(1280 - 460 + 16 + 15, 44 + 15);  // the play button
    step();
    step();
    io.AddMouseButtonEvent(ImGuiMouseButton_Left, true);
    step();
    io.AddMouseButtonEvent(ImGuiMouseButton_Left, false);
    step();
    ASSERT_TRUE(interface_.playing());
    double last = scene_.stack_position.value_or(-1.0);
    int frames = 0;
    while (interface_.playing() && ++frames < 1000) {
        EXPECT_EQ(interface_.redraw_after(), 0.0);
        step();
        const double now = scene_.stack_position.value_or(2.0);
        EXPECT_GE(now, last);
        EXPECT_LT(now - last, 0.05);
        last = now;
    }
    EXPECT_NEAR(frames / 60.0, 2 * 1.6, 0.1);
    EXPECT_EQ(scene_, before);
    for (int i = 0; i < 60; ++i) step();
    EXPECT_TRUE(std::isinf(interface_.redraw_after()));
}

// Beside the panel, and in a lecture hall: words that need more than half of the window would be cut off and scroll.
TEST_F(InterfaceTest, ALessonsWordsFitTheirStrip) {
    for (const glm::ivec2 size : {glm::ivec2(1024, 768), glm::ivec2(1280, 720), glm::ivec2(1920, 1080)})
        for (const bool presenting : {false, true}) {
            const float share = std::min(static_cast<float>(size.x) / 1920.0f, static_cast<float>(size.y) / 1080.0f);
            for (const ListedLesson& listed : built_in_lessons()) {
                interface_.lecture().present(presenting);
                const auto lesson = std::make_shared<const Lesson>(load_lesson(listed.name));
                for (std::size_t i = 0; i < lesson->steps.size(); ++i) {
                    interface_.open_lesson(lesson, scene_, i);
                    interface_.lecture().player.arrive(scene_);
                    interface_.prepare(Theme::Light, presenting ? 36.0f / 15.0f * share : 1.0f);
                    const PixelRect picture = interface_.picture(size);
                    const glm::ivec2 words = size - picture.origin - picture.size;
                    EXPECT_GT(std::max(words.x, words.y), 0) << listed.name << i;
                    EXPECT_LT(words.y, size.y / 2) << listed.name << i << ", " << size.x << " wide, " << presenting;
                }
            }
        }
}

// Also those of a lecturer's own script: whatever one of the fonts has.
TEST_F(InterfaceTest, EveryLetterOfALessonIsThere) {
    Lesson lesson{.name = "mine", .title = "Ж", .about = {}, .steps = {}};
    lesson.steps.push_back({.scene = {}, .caption = "Ψ∮", .look_at = "ł", .equations = {"o′ = Ω"}});
    lesson.steps.back().labels = {{.text = "Ю ∂f", .at = Point<World>{}}};
    std::vector<Lesson> lessons{lesson};
    for (const ListedLesson& built_in : built_in_lessons()) lessons.push_back(load_lesson(built_in.name));
    for (const Lesson& each : lessons) {
        interface_.open_lesson(std::make_shared<const Lesson>(each), Scene{}, 0);
        interface_.prepare(Theme::Light, 1.0f);
        std::string all = each.title;
        for (const LessonStep& step : each.steps) {
            all += step.caption + step.look_at;
            for (const std::string& line : step.equations) all += line;
            for (const PointLabel& label : step.labels) all += label.text;
        }
        for (const char* at = all.data(); at < all.data() + all.size();) {
            unsigned letter = 0;
            at += ImTextCharFromUtf8(&letter, at, all.data() + all.size());
            for (const ImFont* font : {ImGui::GetIO().FontDefault, ImGui::GetIO().Fonts->Fonts.back()})
                EXPECT_TRUE(font->FindGlyphNoFallback(static_cast<ImWchar>(letter))) << each.name << std::hex << letter;
        }
    }
}

TEST_F(InterfaceTest, NotesGoAndErrorsStay) {
    interface_.show_note("Saved");
    EXPECT_EQ(interface_.redraw_after(), 0.0);
    for (int i = 0; i < 60 * 4; ++i) step();
    EXPECT_TRUE(std::isinf(interface_.redraw_after()));
    interface_.show_error("x.obj: no such file");
    step();
    EXPECT_TRUE(std::isinf(interface_.redraw_after()));
}

// Whatever is clicked, dragged and typed, the scene can be written and read back.
TEST_F(InterfaceTest, KeepsTheSceneValid) {
    std::mt19937 random(1);
    const auto below = [&](unsigned n) { return static_cast<int>(random() % n); };
    ImGuiIO& io = ImGui::GetIO();
    const auto move = [&] {
        // One of the two panels.
        const int x = below(3) > 0 ? below(388) : 1280 - below(460);
        io.AddMousePosEvent(static_cast<float>(x), static_cast<float>(below(720)));
        step();
    };
    const auto button = [&](bool down) {
        io.AddMouseButtonEvent(ImGuiMouseButton_Left, down);
        step();
    };
    const auto press = [&](ImGuiKey key) {
        io.AddKeyEvent(key, true);
        step();
        io.AddKeyEvent(key, false);
        step();
    };
    scene_.surface = ShapeSurface{.shape = Shape::Sphere, .resolution = 8};
    int changes = 0;
    for (int i = 0; i < 300; ++i) {
        if (i % 12 == 0) interface_.show_tab(kTabs[random() % kTabs.size()].name);
        if (i % 100 == 0) scene_.surface = ShapeSurface{.shape = Shape::Sphere, .resolution = 8};
        if (i % 100 == 60) scene_.surface = FormulaSurface{.formula = "a x^2 + y^2 + b z^2 = 1"};
        const Scene before = scene_;
        move();
        for (int clicks = 1 + below(2); clicks > 0; --clicks) {
            button(true);
            if (below(3) == 0) move();
            button(false);
        }
        if (below(2) == 0) {
            io.AddInputCharactersUTF8(std::array{"-1e999", "nan", "0", "1e9", "7", " + y^"}[random() % 6]);
            step();
            press(ImGuiKey_Enter);
        }
        if (below(4) != 0) press(ImGuiKey_Escape);
        if (below(2) == 0) io.AddMouseWheelEvent(0.0f, static_cast<float>(below(9) - 4));
        if (auto* shape = std::get_if<ShapeSurface>(&scene_.surface))
            shape->resolution = std::min(shape->resolution, 8);
        if (scene_ == before) continue;
        ++changes;
        ASSERT_EQ(parse_scene(scene_text(scene_), "scene"), scene_) << "step " << i;
    }
    EXPECT_GT(changes, 15);
}

}  // namespace
}  // namespace normalscope
