// No work is lost: what is unsaved is said, asked about, and offered again.

#include "core/scene/scene_json.h"
#include "viewer/hosted.h"

namespace normalscope {
namespace {

constexpr ImGuiKeyChord kCtrl = ImGuiMod_Ctrl;

class WorkTest : public ViewerTest {
protected:
    void start_from_file() {
        save_scene(light(), path("s.json"));
        start(load_scene(path("s.json")), path("s.json"));
    }
    void close() {
        viewer().close();
        settle();
    }
    /// What the host was last asked to keep, of which there is one.
    Scene kept() const {
        const auto works = parse_unsaved(host_.kept, "kept");
        return works.size() == 1 ? works.front().scene : Scene{};
    }
    std::vector<std::string> kept_files() const {
        std::vector<std::string> files;
        for (const UnsavedWork& work : parse_unsaved(host_.kept, "kept")) files.push_back(work.file);
        return files;
    }
};

TEST_F(WorkTest, ADotInTheTitleWhileUnsaved) {
    start_from_file();
    EXPECT_EQ(host_.title, "s.json \u2013 Normalscope");
    key(ImGuiKey_C);
    EXPECT_EQ(host_.title, "\u2022 s.json \u2013 Normalscope");
    key(kCtrl | ImGuiKey_Z);
    EXPECT_FALSE(is_unsaved());
    keys({ImGuiKey_C, kCtrl | ImGuiKey_S});
    EXPECT_FALSE(is_unsaved());
    key(kCtrl | ImGuiKey_Z);
    EXPECT_TRUE(is_unsaved()) << "the file holds what was undone";
    key(kCtrl | ImGuiKey_Y);
    EXPECT_FALSE(is_unsaved());
}

TEST_F(WorkTest, LookingAroundIsNoWorkWhereThereIsNoFile) {
    start();
    keys({ImGuiKey_2, ImGuiKey_T});
    EXPECT_FALSE(is_unsaved());
    key(ImGuiKey_C);
    EXPECT_TRUE(is_unsaved());
    start_from_file();
    key(ImGuiKey_T);
    EXPECT_FALSE(is_unsaved());
    key(ImGuiKey_2);
    EXPECT_TRUE(is_unsaved()) << "the file holds the camera";
}

TEST_F(WorkTest, UndoBringsBackTheName) {
    start_from_file();
    open("shear");
    EXPECT_EQ(named(), "shear");
    key(ImGuiKey_C);
    keys({kCtrl | ImGuiKey_Z, kCtrl | ImGuiKey_Z});
    EXPECT_EQ(named(), "s.json");
    EXPECT_FALSE(is_unsaved());
    key(kCtrl | ImGuiKey_Y);
    EXPECT_EQ(named(), "shear");
}

TEST_F(WorkTest, AnUndoKeepsTheNameThatTheSceneWasSavedBy) {
    start();
    key(ImGuiKey_C);
    answer_dialog(ImGuiKey_S, path("new.json"));
    key(kCtrl | ImGuiKey_Z);
    EXPECT_EQ(named(), "new.json");
    EXPECT_TRUE(is_unsaved());
}

TEST_F(WorkTest, ClosingAsksAndStays) {
    start_from_file();
    key(ImGuiKey_C);
    close();
    EXPECT_TRUE(asked());
    const Scene before = scene();
    keys({ImGuiKey_N, ImGuiKey_I});  // nothing else goes on
    EXPECT_EQ(scene(), before);
    key(ImGuiKey_Escape);
    EXPECT_FALSE(asked());
    EXPECT_FALSE(host_.closed);
    close();
    click(Item("##question") / "Stay");
    EXPECT_FALSE(asked());
    EXPECT_FALSE(host_.closed);
}

TEST_F(WorkTest, ClosingDiscards) {
    start_from_file();
    keys({ImGuiKey_C, kCtrl | ImGuiKey_Q, ImGuiKey_D});
    EXPECT_TRUE(host_.closed);
    EXPECT_EQ(load_scene(path("s.json")), light());
    EXPECT_EQ(host_.kept, "");
}

TEST_F(WorkTest, ClosingSaves) {
    start_from_file();
    keys({ImGuiKey_C, kCtrl | ImGuiKey_Q, ImGuiKey_Enter});
    EXPECT_TRUE(host_.closed);
    EXPECT_EQ(load_scene(path("s.json")).rule, Rule::Cofactor);
    EXPECT_EQ(host_.kept, "");
}

TEST_F(WorkTest, ClosingSavesWhatHasNoNameYet) {
    start();
    keys({ImGuiKey_C, kCtrl | ImGuiKey_Q});
    click(Item("##question") / "Save");
    EXPECT_FALSE(host_.closed);
    EXPECT_TRUE(viewer().interface().dialog_shown());
    key(ImGuiKey_Escape);  // rather not
    answer_dialog(ImGuiKey_S, path("a.json"));
    EXPECT_FALSE(host_.closed);
    keys({ImGuiKey_N, kCtrl | ImGuiKey_Q, ImGuiKey_Enter});
    EXPECT_TRUE(host_.closed);
    EXPECT_EQ(load_scene(path("a.json")).rule, Rule::Naive);
}

TEST_F(WorkTest, WhereSavingFailsItStays) {
    start_from_file();
    key(ImGuiKey_C);
    std::filesystem::remove(path("s.json"));
    std::filesystem::create_directory(path("s.json"));
    keys({kCtrl | ImGuiKey_Q, ImGuiKey_Enter});
    EXPECT_FALSE(host_.closed);
    EXPECT_NE(message(), "");
}

TEST_F(WorkTest, LessonsAndExercisesArePlay) {
    start(light(), "3-when-naive-is-right");
    keys({ImGuiKey_PageDown, ImGuiKey_C});
    EXPECT_FALSE(is_unsaved());
    keys({ImGuiKey_Escape, ImGuiKey_Enter});  // yes, leave it
    EXPECT_FALSE(is_unsaved());
    key(ImGuiKey_N);
    EXPECT_TRUE(is_unsaved());
    start(light(), "exercises:42");
    keys({ImGuiKey_LeftArrow, ImGuiKey_Enter});
    EXPECT_FALSE(is_unsaved());
    key(ImGuiKey_Escape);
    EXPECT_FALSE(is_unsaved());
    close();
    EXPECT_TRUE(host_.closed);
}

TEST_F(WorkTest, ClosingInAnExerciseAsksAboutTheSceneBefore) {
    start();
    key(ImGuiKey_C);
    const Scene work = scene();
    open("exercises:42");
    EXPECT_EQ(kept(), work);
    close();
    EXPECT_TRUE(asked());
    EXPECT_EQ(scene(), work);
}

TEST_F(WorkTest, AMeshOpenedIntoUnsavedWorkIsUnsaved) {
    write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    start();
    open(path("a.obj"));
    EXPECT_FALSE(is_unsaved());
    start();
    key(ImGuiKey_C);
    open(path("a.obj"));
    EXPECT_TRUE(is_unsaved());
}

TEST_F(WorkTest, WhatIsUnsavedIsKeptOnceAChangeIsDone) {
    start_from_file();
    key(ImGuiKey_C);
    EXPECT_EQ(kept(), scene());
    point(ground());
    press();
    point(ground() + glm::dvec2(30, 0));
    EXPECT_NE(kept(), scene());
    release();
    EXPECT_EQ(kept(), scene());
    key(kCtrl | ImGuiKey_S);
    EXPECT_EQ(host_.kept, "");
}

TEST_F(WorkTest, WhatASceneSaysOfItselfIsKeptAsLongAsItHolds) {
    start(light("shear"), "shear");
    ASSERT_NE(scene().about, "");
    key(ImGuiKey_R);  // no shear any more
    EXPECT_EQ(kept().stack, scene().stack);
    EXPECT_EQ(kept().about, "");
    key(kCtrl | ImGuiKey_Z);
    EXPECT_NE(scene().about, "");
}

TEST_F(WorkTest, WhatAnEarlierSessionLeftIsOffered) {
    Scene left = light();
    left.rule = Rule::Cofactor;
    start(light(), "", {.scale = {}, .lessons = {}, .unsaved = {{"", left}}});
    EXPECT_TRUE(asked());
    EXPECT_EQ(scene(), light());
    key(ImGuiKey_Enter);
    EXPECT_EQ(scene(), left);
    EXPECT_TRUE(is_unsaved());
    expect_undo({light(), left});
    start(light(), "", {.scale = {}, .lessons = {}, .unsaved = {{"", left}}});
    key(ImGuiKey_Escape);
    EXPECT_EQ(scene(), light());
    EXPECT_FALSE(asked());
}

TEST_F(WorkTest, AnObjectThatGrewOutOfThePictureIsFoundAgain) {
    start();
    Scene tall = light();
    tall.stack = {Scale{{1.0, 1e6, 1.0}}};
    save_scene(tall, path("tall.json"));
    open(path("tall.json"));
    EXPECT_EQ(message(), "Press F to see the whole object");
    key(ImGuiKey_F);
    EXPECT_EQ(message(), "");
    key(ImGuiKey_F);
    EXPECT_EQ(message(), "");
}

TEST_F(WorkTest, WhatAnEarlierSessionLeftComesBackOutOfExercises) {
    Scene left = light();
    left.rule = Rule::Cofactor;
    start(light(), "", {.scale = {}, .lessons = {}, .unsaved = {{"", left}}});
    open("exercises:42");
    EXPECT_TRUE(asked());
    key(ImGuiKey_Enter);
    EXPECT_FALSE(lecture().exercises.running());
    EXPECT_EQ(scene(), left);
    EXPECT_TRUE(is_unsaved());
    EXPECT_EQ(kept(), left);
    expect_undo({light(), left});
}

TEST_F(WorkTest, WhatWasLeftUnsavedIsAskedAboutInTheEnd) {
    start_from_file();
    key(ImGuiKey_C);
    const Scene work = scene();
    open("shear");
    EXPECT_EQ(message(), "Ctrl+Z goes back to s.json, which is not saved");
    EXPECT_EQ(kept(), work);
    close();
    EXPECT_TRUE(asked());
    EXPECT_EQ(scene(), work) << "what is asked about is seen";
    EXPECT_EQ(named(), "s.json");
    key(ImGuiKey_Enter);
    EXPECT_TRUE(host_.closed);
    EXPECT_EQ(load_scene(path("s.json")), work);
}

TEST_F(WorkTest, SeveralScenesAreSavedOneAfterTheOther) {
    start();
    key(ImGuiKey_C);
    const Scene first = scene();
    open("shear");
    key(ImGuiKey_C);
    open("exercises:7");
    EXPECT_EQ(kept_files(), (std::vector<std::string>{"", "shear"}));
    close();
    EXPECT_EQ(named(), "shear");
    key(ImGuiKey_Enter);
    type(path("a.json"));
    key(ImGuiKey_Enter);
    EXPECT_FALSE(host_.closed);
    EXPECT_TRUE(asked());
    EXPECT_EQ(scene(), first);
    keys({ImGuiKey_S});
    type(path("b.json"));
    key(ImGuiKey_Enter);
    EXPECT_TRUE(host_.closed);
    EXPECT_EQ(load_scene(path("b.json")), first);
    EXPECT_EQ(host_.kept, "");
}

TEST_F(WorkTest, SeveralScenesAreDiscardedAtOnce) {
    start();
    key(ImGuiKey_C);
    open("shear");
    key(ImGuiKey_C);
    close();
    click(Item("##question") / "Discard all");
    EXPECT_TRUE(host_.closed);
    EXPECT_EQ(host_.kept, "");
}

TEST_F(WorkTest, WhatHasBeenSavedOrUndoneIsNotAskedAbout) {
    start_from_file();
    keys({ImGuiKey_C, kCtrl | ImGuiKey_S});
    open("shear");
    key(ImGuiKey_C);
    key(kCtrl | ImGuiKey_Z);
    open("rotation");
    close();
    EXPECT_TRUE(host_.closed);
}

TEST_F(WorkTest, AMeshGoesOnWithWorkThatHasNoFile) {
    write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    start();
    key(ImGuiKey_C);
    open(path("a.obj"));
    EXPECT_EQ(kept_files(), std::vector<std::string>{path("a.obj")});
    answer_dialog(ImGuiKey_S, path("b.json"));
    close();
    EXPECT_TRUE(host_.closed);
}

TEST_F(WorkTest, WhatCannotBeDrawnAnyMoreIsPassedOverByUndo) {
    write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    start();
    const Scene first = scene();
    open(path("a.obj"));
    open("shear");
    const Scene last = scene();
    std::filesystem::remove(path("a.obj"));
    key(kCtrl | ImGuiKey_Z);
    EXPECT_NE(message().find("a.obj"), std::string::npos) << message();
    EXPECT_EQ(scene(), first);
    key(kCtrl | ImGuiKey_Y);
    EXPECT_EQ(scene(), last);

    write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    Scene gone = light();
    gone.surface = MeshSurface{path("gone.obj")};
    start(load_scene(path("a.obj")), path("a.obj"), {.scale = {}, .lessons = {}, .unsaved = {{"", gone}, {"", gone}}});
    const Scene before = scene();
    key(ImGuiKey_Enter);
    EXPECT_NE(message().find("gone.obj"), std::string::npos) << message();
    EXPECT_EQ(scene(), before);
    close();
    EXPECT_TRUE(host_.closed);
}

TEST_F(WorkTest, ALessonThatGoesOnLeavesAFilesSceneAlone) {
    save_scene(light(), path("s.json"));
    start(light(), "3-when-naive-is-right");
    open(path("s.json"));
    EXPECT_EQ(named(), "s.json");
    key(ImGuiKey_PageDown);
    EXPECT_EQ(named(), "3-when-naive-is-right");
    EXPECT_FALSE(is_unsaved());
    key(kCtrl | ImGuiKey_S);
    EXPECT_TRUE(viewer().interface().dialog_shown());
    EXPECT_EQ(load_scene(path("s.json")), light());
}

TEST_F(WorkTest, AfterExercisesWithinALessonThereIsWorkAgain) {
    start(light(), "3-when-naive-is-right");
    open("exercises:42");
    key(ImGuiKey_Escape);
    EXPECT_FALSE(is_unsaved());
    key(ImGuiKey_C);
    EXPECT_TRUE(is_unsaved());
}

TEST_F(WorkTest, WhatIsOfferedHasItsNameAndIsKeptUntilItIsAnswered) {
    save_scene(light(), path("s.json"));
    Scene left = light();
    left.rule = Rule::Cofactor;
    const Remembered remembered{.scale = {}, .lessons = {}, .unsaved = {{"", light("shear")}, {path("s.json"), left}}};
    start(light(), "", remembered);
    EXPECT_EQ(kept_files(), (std::vector<std::string>{"", path("s.json")}));
    close();
    EXPECT_TRUE(host_.closed);
    EXPECT_EQ(kept_files(), (std::vector<std::string>{"", path("s.json")})) << "there was no answer";

    start(light(), "", remembered);
    key(ImGuiKey_Enter);
    EXPECT_EQ(scene(), left);
    EXPECT_EQ(named(), "s.json");
    EXPECT_TRUE(is_unsaved());
    key(kCtrl | ImGuiKey_S);
    EXPECT_EQ(load_scene(path("s.json")), left);
    expect_undo({light(), light("shear"), left});

    start(light(), "", remembered);
    keys({ImGuiKey_Escape, ImGuiKey_C});
    EXPECT_EQ(kept_files(), (std::vector<std::string>{"", path("s.json"), ""})) << "not now: the next start asks again";
    start(light(), "", remembered);
    click(Item("##question") / "Discard");
    EXPECT_EQ(host_.kept, "");
}

TEST_F(WorkTest, WhatALinkHoldsGoesOnAndOnlyTheRestIsOffered) {
    Scene left = light();
    left.rule = Rule::Cofactor;
    Scene linked = left;
    linked.theme = Theme::Dark;  // another room
    start(linked, "", {.scale = {}, .lessons = {}, .unsaved = {{path("s.json"), left}}});
    EXPECT_FALSE(asked());
    EXPECT_EQ(scene(), linked);
    EXPECT_EQ(named(), "s.json");
    EXPECT_TRUE(is_unsaved());
    EXPECT_EQ(kept(), linked);

    const auto lesson = std::make_shared<const Lesson>(new_lesson(left));
    start(linked, "", {.scale = {}, .lessons = {}, .unsaved = {{"mine", left, {lesson, 0}}}});
    EXPECT_TRUE(asked()) << "the scene is not the lesson";
    keys({ImGuiKey_Escape, ImGuiKey_I});
    EXPECT_EQ(parse_unsaved(host_.kept, "kept").front().draft.lesson->title, lesson->title);
}

}  // namespace
}  // namespace normalscope
