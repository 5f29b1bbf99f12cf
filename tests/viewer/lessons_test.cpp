// Lessons, exercises and presenting, by keyboard alone.

#include "core/base/file.h"
#include "viewer/hosted.h"

namespace normalscope {
namespace {

constexpr const char* kLesson = "3-when-naive-is-right";
using Kinds = std::vector<ArrowKind>;
const Kinds kAsked{ArrowKind::Object}, kTold{ArrowKind::Object, ArrowKind::Naive, ArrowKind::InverseTranspose};

class LessonsTest : public ViewerTest {
protected:
    void start_lesson(const std::string& name, Remembered remembered = {}) {
        start(light(), name, std::move(remembered));
    }
    std::size_t step() const { return lecture().player.number(); }
    std::vector<StackEntry> stack_of(std::size_t step) const { return lesson_.steps.at(step).scene.stack; }
    const Lesson lesson_ = load_lesson(kLesson);
};

TEST_F(LessonsTest, ByTheKeysOfARemoteControl) {
    start_lesson(kLesson);
    EXPECT_EQ(named(), kLesson);
    EXPECT_EQ(scene().stack, stack_of(0));
    key(ImGuiKey_PageDown);
    EXPECT_EQ(scene().stack, stack_of(1));
    for (const ImGuiKey next : {ImGuiKey_RightArrow, ImGuiKey_Space, ImGuiKey_Enter}) {
        key(next);
        EXPECT_EQ(scene().stack, stack_of(2));
        key(ImGuiKey_PageUp);
        EXPECT_EQ(scene().stack, stack_of(1));
    }
    key(ImGuiKey_R);  // play, and come back
    EXPECT_EQ(scene().stack, std::vector<StackEntry>{Scale{}});
    key(ImGuiKey_Home);
    EXPECT_EQ(scene().stack, stack_of(1));
    EXPECT_EQ(viewer().remembered().lessons, (std::map<std::string, std::size_t>{{kLesson, 1}}));
}

TEST_F(LessonsTest, AStepMovesRatherThanJumps) {
    start_lesson(kLesson);
    viewer().press(KeyPress{ImGuiKey_PageDown});
    host_.time += 0.1;
    viewer().step();
    EXPECT_TRUE(viewer().interface().playing());
    EXPECT_NE(scene().stack, stack_of(0));
    EXPECT_NE(scene().stack, stack_of(1));
    EXPECT_EQ(viewer().due(), 0.0);
    settle();
    EXPECT_EQ(scene().stack, stack_of(1));
}

TEST_F(LessonsTest, AHeldKeyIsOneStep) {
    start_lesson(kLesson);
    hold(ImGuiKey_PageDown);
    EXPECT_EQ(step(), 1u);
}

TEST_F(LessonsTest, ProgressIsKept) {
    start_lesson(kLesson, {.scale = {}, .lessons = {{kLesson, 3}}});
    EXPECT_EQ(step(), 3u);
    start_lesson(std::string(kLesson) + "#2", {.scale = {}, .lessons = {{kLesson, 3}}});
    EXPECT_EQ(step(), 1u);
}

TEST_F(LessonsTest, AfterALessonTheNextIfAskedTwice) {
    start_lesson(std::string(kLesson) + "#" + std::to_string(lesson_.steps.size()));
    keys({ImGuiKey_PageDown, ImGuiKey_PageDown});  // what it asks is answered first
    EXPECT_EQ(named(), kLesson);
    key(ImGuiKey_PageDown);
    EXPECT_EQ(named(), "4-derivation");
}

TEST_F(LessonsTest, BeforeALessonTheOneBeforeIfAskedTwice) {
    start_lesson("4-derivation#1");
    key(ImGuiKey_PageUp);
    EXPECT_EQ(named(), "4-derivation");
    key(ImGuiKey_PageDown);  // rather not
    EXPECT_EQ(step(), 0u);
    keys({ImGuiKey_PageUp, ImGuiKey_PageUp});
    EXPECT_EQ(named(), kLesson);
    EXPECT_EQ(step(), lesson_.steps.size() - 1);
    start_lesson(built_in_lessons().front().name + "#1");
    keys({ImGuiKey_PageUp, ImGuiKey_PageUp});
    EXPECT_EQ(named(), built_in_lessons().front().name);
}

TEST_F(LessonsTest, EndIsTheLastStep) {
    start_lesson(kLesson);
    key(ImGuiKey_End);
    EXPECT_EQ(step(), lesson_.steps.size() - 1);
}

// Tab and arrows otherwise go from button to button, and on from there.
TEST_F(LessonsTest, WhilePresentingNoKeyTakesTheRemotesKeysAway) {
    start_lesson(kLesson);
    key(ImGuiKey_F5);
    for (const ImGuiKey other : {ImGuiKey_Tab, ImGuiKey_UpArrow, ImGuiKey_DownArrow, ImGuiKey_Home}) {
        keys({other, other});
        const std::size_t before = step();
        key(ImGuiKey_PageDown);
        EXPECT_EQ(step(), before + 1) << ImGui::GetKeyName(other);
        key(ImGuiKey_PageUp);
        EXPECT_EQ(step(), before) << ImGui::GetKeyName(other);
    }
    key(ImGuiKey_End);
    key(ImGuiKey_PageUp);
    EXPECT_EQ(step(), lesson_.steps.size() - 2);
}

TEST_F(LessonsTest, EscapeLeavesPresentingAndOnlyLaterAsksAboutTheLesson) {
    start_lesson(kLesson);
    keys({ImGuiKey_F5, ImGuiKey_Escape, ImGuiKey_Escape});
    EXPECT_FALSE(lecture().presenting);
    EXPECT_TRUE(lecture().player.running());
    EXPECT_FALSE(asked());
    wait(1.5);
    key(ImGuiKey_Escape);
    EXPECT_TRUE(asked());
    EXPECT_TRUE(lecture().player.running());
}

TEST_F(LessonsTest, EscapeLeavesALessonAndItsStepStays) {
    start_lesson(kLesson);
    keys({ImGuiKey_Escape, ImGuiKey_Escape});
    EXPECT_TRUE(lecture().player.running()) << "asked, and rather not";
    key(ImGuiKey_Escape);
    EXPECT_TRUE(asked());
    key(ImGuiKey_Enter);
    EXPECT_FALSE(lecture().player.running());
    EXPECT_EQ(scene().stack, stack_of(0));
    key(ImGuiKey_PageDown);
    EXPECT_EQ(scene().stack, stack_of(0));
}

TEST_F(LessonsTest, ALessonsOwnFileIsNotOverwritten) {
    const std::string lesson =
        R"({"normalscope": 1, "lesson": "L", "about": "l", "steps": [{"caption": "A sphere.", "scene": {"stack": []}}]})";
    write("lesson.json", lesson);
    start_lesson(path("lesson.json"));
    EXPECT_EQ(named(), "lesson.json");
    key(ImGuiMod_Ctrl | ImGuiKey_S);
    type(path("scene.json"));
    key(ImGuiKey_Enter);
    EXPECT_EQ(load_scene(path("scene.json")).stack, scene().stack);
    EXPECT_EQ(read_file(path("lesson.json"), 1 << 16), lesson);
}

std::string lesson_text(const std::string& title, std::initializer_list<double> heights) {
    std::string steps;
    for (const double height : heights)
        steps += (steps.empty() ? "" : ", ") +
                 std::string(R"({"caption": "A step.", "scene": {"stack": [{"scale": [1, )") + std::to_string(height) +
                 ", 1]}]}}";
    return R"({"normalscope": 1, "lesson": ")" + title + R"(", "steps": [)" + steps + "]}";
}

TEST_F(LessonsTest, AFileIsReadAgainWhereOneStands) {
    const auto file = write("mine.json", lesson_text("L", {1, 2, 3}));
    start_lesson(file.string() + "#2");
    const auto shown = [&] { return std::get<Scale>(scene().stack.at(0)).factors.y; };
    wait(3);
    EXPECT_EQ(message(), "");
    const std::size_t drawn = host_.drawn.size();
    wait(10);
    EXPECT_EQ(host_.drawn.size(), drawn) << "nothing has changed";

    write("mine.json", lesson_text("L", {1, 2.5, 3, 4}));
    wait(3);
    EXPECT_EQ(shown(), 2.5);
    EXPECT_EQ(step(), 1u);
    EXPECT_EQ(lecture().player.lesson().steps.size(), 4u);

    write("mine.json", R"({"normalscope": 1, "lesson": "L",
        "steps": [{"caption": "A step.", "scene": {"colour": 1}}]})");
    wait(3);
    EXPECT_EQ(shown(), 2.5);
    EXPECT_NE(message().find("mine.json, line 2, step 1: scene.colour: unknown key"), std::string::npos) << message();
    EXPECT_NE(message().find("what you see is the lesson as it was"), std::string::npos) << message();

    write("mine.json", lesson_text("L", {5}));  // the step is gone
    wait(3);
    EXPECT_EQ(shown(), 5.0);
    EXPECT_EQ(message(), "Read mine.json again");
}

TEST_F(LessonsTest, AnyPressEndsWhatAStepShowsByItself) {
    start_lesson(write("mine.json", R"({"lesson": "L", "steps": [{"caption": "a"}, {"caption": "b"},
        {"caption": "c", "path": {"power": [1, -1]}}, {"caption": "d"}]})")
                     .string() +
                 "#2");
    const auto begin = [&] {
        viewer().press(KeyPress{ImGuiKey_PageDown});
        viewer().release(KeyPress{ImGuiKey_PageDown});
        for (int i = 0; i < 150; ++i) host_.time += 1.0 / 60.0, viewer().step();
        EXPECT_TRUE(lecture().player.on_path());
        EXPECT_NE(scene().power, -1.0);
    };
    begin();
    key(ImGuiKey_PageDown);
    EXPECT_EQ(scene().power, -1.0);
    EXPECT_EQ(step(), 2u) << "and does nothing else";
    key(ImGuiKey_PageDown);
    EXPECT_EQ(step(), 3u);
    keys({ImGuiKey_PageUp, ImGuiKey_PageUp});
    begin();
    press();
    release();
    EXPECT_EQ(scene().power, -1.0);
}

TEST_F(LessonsTest, LessonsOfOnesOwnLeadToOneAnother) {
    write("own/a.json", lesson_text("A", {1}));
    write("own/b.json", "{");
    write("own/c.json", lesson_text("C", {1, 2}));
    write("own/scene.json", "{\"normalscope\": 1}");
    start_lesson("8-bug-gallery#1");
    viewer().take_lessons_from({folder_.path() / "own"});
    settle();
    EXPECT_NE(message().find("b.json: not valid JSON"), std::string::npos) << message();
    EXPECT_EQ(lecture().shelf.lessons.size(), built_in_lessons().size() + 2);
    keys({ImGuiKey_End, ImGuiKey_A, ImGuiKey_PageDown, ImGuiKey_PageDown});
    EXPECT_EQ(named(), "a.json");
    keys({ImGuiKey_PageDown, ImGuiKey_PageDown});
    EXPECT_EQ(named(), "c.json");
    keys({ImGuiKey_PageUp, ImGuiKey_PageUp});
    EXPECT_EQ(named(), "a.json");
    keys({ImGuiKey_PageUp, ImGuiKey_PageUp});
    EXPECT_EQ(named(), "8-bug-gallery");
}

TEST_F(LessonsTest, TheMenuListsWhatThereIsByNow) {
    start();
    viewer().take_lessons_from({folder_.path()});
    write("late.json", lesson_text("Late", {1, 2}));
    click(Item("##panel/##always") / "Learn");
    EXPECT_EQ(lecture().shelf.lessons.back().title, "Late");
    click(Item("##Popup") / path("late.json").c_str() / "Late");
    EXPECT_EQ(named(), "late.json");
}

TEST_F(LessonsTest, KeysAreAMenusWhileItIsOpen) {
    start_lesson(kLesson);
    click(Item("##panel/##always") / "Learn");
    key(ImGuiKey_PageDown);
    EXPECT_EQ(step(), 0u);
    key(ImGuiKey_Escape);
    EXPECT_FALSE(asked()) << "that closed the menu";
    key(ImGuiKey_Escape);
    EXPECT_TRUE(asked());
}

TEST_F(LessonsTest, Presenting) {
    start();
    const Scene before = scene();
    key(ImGuiKey_F5);
    EXPECT_TRUE(host_.full);
    EXPECT_TRUE(lecture().presenting);
    EXPECT_TRUE(has_contrast(viewer().frame()->theme));
    const glm::ivec2 picture = viewer().frame()->rect.size;
    EXPECT_TRUE(picture.x < host_.size.x || picture.y < host_.size.y);  // words beside it or below
    keys({ImGuiKey_N, ImGuiKey_B, ImGuiKey_I});  // whatever it is otherwise, it ends the black screen, and no more
    EXPECT_EQ(scene().rule, Rule::Naive);
    keys({ImGuiKey_Period, ImGuiKey_C, ImGuiKey_W, ImGuiKey_C, ImGuiKey_M});
    EXPECT_EQ(scene().rule, Rule::Naive);
    EXPECT_EQ(host_.monitor, 1);
    keys({ImGuiMod_Ctrl | ImGuiKey_Equal, ImGuiMod_Ctrl | ImGuiKey_Equal, ImGuiKey_F5});
    EXPECT_FALSE(host_.full);
    EXPECT_FALSE(lecture().presenting);
    EXPECT_EQ(scene().theme, before.theme);
    EXPECT_NEAR(viewer().remembered().scale.presenter, 1.21, 1e-9);
    EXPECT_EQ(viewer().remembered().scale.interface, 1.0);
    keys({ImGuiKey_F5, ImGuiKey_Escape});
    EXPECT_FALSE(host_.full);
    key(ImGuiKey_M);
    EXPECT_EQ(host_.monitor, 1);
}

TEST_F(LessonsTest, AnExercise) {
    start_lesson("exercises:42");
    EXPECT_EQ(named(), "exercises:42");
    const Scene asked = scene();
    EXPECT_EQ(asked.arrows.show, kAsked);
    keys({ImGuiKey_LeftArrow, ImGuiKey_LeftArrow, ImGuiKey_UpArrow, ImGuiKey_Enter});
    EXPECT_EQ(scene().arrows.show, kTold);
    key(ImGuiKey_PageDown);
    EXPECT_EQ(scene().arrows.show, kAsked);
    EXPECT_NE(scene().stack, asked.stack);
}

TEST_F(LessonsTest, AnExercisesArrowIsDragged) {
    start_lesson("exercises:42");
    const glm::dvec3 before = lecture().exercises.arrow().xyz;
    const auto& probe = viewer().frame()->probe;
    ASSERT_TRUE(probe);
    // Somewhere along the way from its foot is its tip.
    const glm::dvec3 foot = probe->point.xyz;
    for (double along = 0.02; along < 2.0 && lecture().exercises.arrow().xyz == before; along += 0.04) {
        const glm::dvec2 at = pixel(foot + along * glm::normalize(before));
        drag({at, at + glm::dvec2(40, 5)});
    }
    EXPECT_NE(lecture().exercises.arrow().xyz, before);
    EXPECT_FALSE(lecture().exercises.dragging());
}

TEST_F(LessonsTest, WhatIsAskedStaysWhatItIs) {
    start_lesson("exercises:42");
    const Scene asked = scene();
    for (const ImGuiKeyChord chord : {+ImGuiKey_N, +ImGuiKey_I, +ImGuiKey_C, +ImGuiKey_V, +ImGuiKey_R, +ImGuiKey_E,
                                      ImGuiMod_Ctrl | ImGuiKey_Z, ImGuiMod_Ctrl | ImGuiKey_F})
        key(chord);
    EXPECT_EQ(scene(), asked);
    key(ImGuiKey_T);
    EXPECT_EQ(scene().theme, Theme::Dark);
}

TEST_F(LessonsTest, ExercisesGiveTheSceneBack) {
    start_lesson("exercises:42");
    key(ImGuiKey_Enter);  // the arrow has not been moved: asked once, that is no answer
    EXPECT_EQ(scene().arrows.show, kAsked);
    key(ImGuiKey_Enter);
    EXPECT_EQ(scene().arrows.show, kTold);
    key(ImGuiKey_Escape);
    EXPECT_TRUE(asked()) << "points are lost";
    key(ImGuiKey_Enter);
    EXPECT_EQ(named(), "");
    EXPECT_EQ(scene(), light());
    keys({ImGuiKey_N, ImGuiMod_Ctrl | ImGuiKey_Z});
    EXPECT_EQ(scene(), light());
}

TEST_F(LessonsTest, AMeshOpenedInAnExerciseHasTheEarlierScene) {
    write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    start_lesson("exercises:42");
    open(path("a.obj"));
    EXPECT_EQ(named(), "a.obj");
    EXPECT_EQ(scene().arrows.limit, 12);
    EXPECT_EQ(scene().surface, SurfaceSource(MeshSurface{path("a.obj")}));
    const Scene opened = scene();
    keys({ImGuiKey_Enter, ImGuiKey_Enter});
    EXPECT_EQ(scene(), opened);
    key(ImGuiMod_Ctrl | ImGuiKey_Z);
    EXPECT_EQ(scene(), light());
}

TEST_F(LessonsTest, WordsThatFitHaveNoScrollBar) {
    host_.size = {1280, 720};
    for (const char* lesson : {"4-derivation", "8-bug-gallery"}) {
        start(light(), lesson);
        key(ImGuiKey_F5);
        for (std::size_t i = 0; i < lecture().player.lesson().steps.size(); ++i) {
            const ImGuiWindow* words = Item("##captions/##words").window();
            // Half of the window is as much as the strip ever takes.
            if (words->ParentWindow->Size.y < 355.0f) {
                EXPECT_FALSE(words->ScrollbarY) << lesson << "#" << i + 1;
            }
            keys({ImGuiKey_PageDown});
            if (lecture().player.number() == i) key(ImGuiKey_PageDown);  // after the answer
        }
    }
}

}  // namespace
}  // namespace normalscope
