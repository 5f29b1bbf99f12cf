// Opening, saving, copying and pasting.

#include "core/base/file.h"
#include "core/image/png.h"
#include "core/lessons/link.h"
#include "core/scene/scene_json.h"
#include "viewer/hosted.h"

#include <algorithm>

namespace normalscope {
namespace {

namespace fs = std::filesystem;

constexpr ImGuiKeyChord kCtrl = ImGuiMod_Ctrl, kShift = ImGuiMod_Shift;
constexpr const char* kTetrahedron = "v 1 1 1\nv 1 -1 -1\nv -1 1 -1\nv -1 -1 1\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n";

class FilesTest : public ViewerTest {
protected:
    std::string text(const std::string& name) const { return read_file(folder_.path() / name, 1 << 20); }
};

TEST_F(FilesTest, TheTitleNamesTheFile) {
    start();
    EXPECT_EQ(host_.title, "Normalscope");
    fs::create_directories(folder_.path() / "deep");
    write("deep/shear.json", R"({"normalscope": 1, "stack": [{"shear": {"xy": 1}}]})");
    start(light("shear"), path("deep/shear.json"));
    EXPECT_EQ(host_.title, "shear.json \u2013 Normalscope");
}

TEST_F(FilesTest, AMeshIsOpenedIntoTheScene) {
    write("t.obj", kTetrahedron);
    start();
    const Scene before = scene();
    answer_dialog(ImGuiKey_O, path("t.obj"));
    EXPECT_EQ(named(), "t.obj");
    Scene with_mesh = before;
    with_mesh.surface = MeshSurface{path("t.obj")};
    with_mesh.camera = scene().camera;
    with_mesh.probe.reset();  // it lay on the shape
    with_mesh.about = "";     // it told of the shape
    EXPECT_EQ(scene(), with_mesh);
    expect_undo({before, scene()});
}

TEST_F(FilesTest, AMeshThatIsOpenedIsInThePicture) {
    write("t.obj", kTetrahedron);
    Scene far = light();
    far.camera.zoom = 0.01;
    start(far);
    answer_dialog(ImGuiKey_O, path("t.obj"));
    EXPECT_GT(scene().camera.magnification(), 0.3);
}

TEST_F(FilesTest, WhatASceneSaysOfItselfIsSavedAsLongAsItHolds) {
    start();
    const std::string about = scene().about;
    ASSERT_NE(about, "");
    answer_dialog(ImGuiKey_S, path("a.json"));
    EXPECT_EQ(load_scene(path("a.json")).about, about);
    keys({ImGuiKey_R, ImGuiMod_Ctrl | ImGuiKey_S});  // nothing is stretched any more
    EXPECT_EQ(scene().about, "");
    EXPECT_EQ(load_scene(path("a.json")).about, "");
}

TEST_F(FilesTest, ASceneIsOpened) {
    Scene saved = light("shear");
    save_scene(saved, path("s.json"));
    start();
    key(ImGuiKey_T);
    open(path("s.json"));
    EXPECT_EQ(named(), "s.json");
    saved.theme = Theme::Dark;  // the room's light does not change with the scene
    EXPECT_EQ(scene(), saved);
}

TEST_F(FilesTest, RecentFilesAreOfferedAndOutliveTheSession) {
    write("t.obj", kTetrahedron);
    write("broken.obj", "v 1\n");
    start();
    open(path("t.obj"));
    open("shear");  // no file
    answer_dialog(ImGuiKey_S, path("s.json"));
    open(path("broken.obj"));
    const std::vector<std::string> newest_first{path("s.json"), path("t.obj")};
    const Remembered later = remembered_of(remembered_text(viewer().remembered()));
    EXPECT_EQ(later.recent_files, newest_first);

    fs::remove(path("s.json"));
    start(light(), "", later);
    key(kCtrl | ImGuiKey_O);
    click(Item("##files") / "Recent");
    click(Item("##files/##list") / 0 / "##entry");  // the only one that is still there
    key(ImGuiKey_Enter);
    EXPECT_EQ(named(), "t.obj");
}

TEST_F(FilesTest, WhatCannotBeOpenedSaysWhyAndChangesNothing) {
    write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99\n");
    write("b.stl", "no triangles");
    write("c.json", R"({"normalscope": 1, "colour": "red"})");
    write("d.json", R"({"normalscope": 1, "surface": {"mesh": "none.obj"}})");
    write("e.json", R"({"lesson": "Bad", "steps": [{"caption": "a", "scene": {"colour": 1}}]})");
    start();
    const Scene before = scene();
    for (const char* name : {"a.obj", "b.stl", "c.json", "d.json", "e.json"}) {
        open(path(name));
        EXPECT_NE(message().find(std::string(name) == "d.json" ? "none.obj" : name), std::string::npos) << message();
        EXPECT_EQ(scene(), before) << name;
        EXPECT_EQ(named(), "") << name;
        key(ImGuiKey_Escape);
        EXPECT_EQ(message(), "");
    }
    answer_dialog(ImGuiKey_O, path("f"));  // there is none: the dialog says so, and stays
    EXPECT_TRUE(viewer().interface().dialog_shown());
    key(ImGuiKey_Escape);
    EXPECT_EQ(scene(), before);
    write("g.json", R"({"normalscope": 1, "rule": "naive"})");
    open(path("g.json"));
    EXPECT_EQ(scene().rule, Rule::Naive);
}

TEST_F(FilesTest, WhatIsOpenedTakesAnErrorAway) {
    start();
    open("nosuch");
    EXPECT_NE(message().find("nosuch"), std::string::npos);
    open("shear");
    EXPECT_EQ(message(), "");
}

TEST_F(FilesTest, SavingByAPath) {
    fs::create_directories(folder_.path() / "deep");
    start();
    answer_dialog(ImGuiKey_S, path("deep/one.json"));
    EXPECT_EQ(load_scene(path("deep/one.json")), scene());
    EXPECT_EQ(named(), "one.json");
    EXPECT_EQ(message(), "Saved " + fs::path(path("deep/one.json")).make_preferred().string());
}

TEST_F(FilesTest, ANameWithoutAnEndingGetsOne) {
    start();
    answer_dialog(ImGuiKey_S, path("two"));
    EXPECT_TRUE(fs::exists(path("two.json")));
}

TEST_F(FilesTest, NothingIsOverwrittenUnasked) {
    write("o.json", "old");
    start();
    answer_dialog(ImGuiKey_S, path("o.json"));
    EXPECT_EQ(text("o.json"), "old");
    key(ImGuiKey_Enter);  // yes, do
    EXPECT_EQ(load_scene(path("o.json")), scene());
}

TEST_F(FilesTest, AFolderThatDoesNotExist) {
    start();
    answer_dialog(ImGuiKey_S, path("none/scene.json"));
    EXPECT_TRUE(viewer().interface().dialog_shown());
    key(ImGuiKey_Escape);
    EXPECT_FALSE(fs::exists(path("none")));
}

TEST_F(FilesTest, WhatCannotBeWrittenSaysWhy) {
    start();
    answer_dialog(ImGuiKey_S, "/proc/scene.json");
    EXPECT_NE(message().find(fs::path("proc/scene.json").make_preferred().string()), std::string::npos) << message();
    EXPECT_EQ(named(), "");
}

TEST_F(FilesTest, ASuccessTakesAnEarlierErrorAway) {
    start();
    answer_dialog(ImGuiKey_S, "/proc/x.json");
    ASSERT_NE(message().find("x.json: cannot be written"), std::string::npos) << message();
    answer_dialog(ImGuiKey_S, path("ok.json"));
    EXPECT_EQ(message(), "Saved " + path("ok.json"));
    open("nonsense.json");
    ASSERT_NE(message().find("nonsense.json"), std::string::npos) << message();
    open("shear");
    EXPECT_EQ(message().find("nonsense.json"), std::string::npos) << message();
}

TEST_F(FilesTest, SavingGoesBackToTheFile) {
    Scene naive = light();
    naive.rule = Rule::Naive;
    save_scene(naive, path("s.json"));
    start(load_scene(path("s.json")), path("s.json"));
    keys({ImGuiKey_C, kCtrl | ImGuiKey_S});
    EXPECT_FALSE(viewer().interface().dialog_shown());
    EXPECT_EQ(message(), "Saved " + path("s.json"));
    EXPECT_EQ(load_scene(path("s.json")).rule, Rule::Cofactor);
    key(kCtrl | kShift | ImGuiKey_S);
    EXPECT_TRUE(viewer().interface().dialog_shown());
    type(path("t.json"));
    key(ImGuiKey_Enter);
    EXPECT_EQ(load_scene(path("t.json")), scene());
    EXPECT_EQ(named(), "t.json");
}

TEST_F(FilesTest, ThePictureIsAsLargeAsItIsShown) {
    start();
    key(ImGuiMod_Ctrl | ImGuiKey_P);
    type(path("p.png"));
    host_.drawn.clear();
    key(ImGuiKey_Enter);
    const glm::ivec2 shown = viewer().frame()->rect.size;
    EXPECT_EQ(read_png(path("p.png")).size, shown);
    EXPECT_TRUE(std::ranges::any_of(host_.drawn, &FakeHost::Drawn::anew)) << "the samples hold what was saved";
    key(ImGuiKey_Tab);
    answer_dialog(ImGuiKey_P, path("q.png"));
    EXPECT_EQ(read_png(path("q.png")).size, host_.size);
}

TEST_F(FilesTest, ThePictureAsVectors) {
    start();
    answer_dialog(ImGuiKey_P, path("p.svg"));
    EXPECT_EQ(text("p.svg").rfind("<svg", 200), text("p.svg").find("<svg"));
    EXPECT_EQ(message(), "Saved " + path("p.svg"));
}

TEST_F(FilesTest, SavingInALessonLeavesItsFileAlone) {
    const std::string lesson = R"({"lesson": "L", "steps": [{"caption": "a"}]})";
    write("l.json", lesson);
    start();
    open(path("l.json"));
    keys({ImGuiKey_C, kCtrl | ImGuiKey_S, ImGuiKey_Escape});
    EXPECT_EQ(text("l.json"), lesson);
}

TEST_F(FilesTest, ALinkThroughTheClipboard) {
    start(light("shear"), "shear");
    const Scene first = scene();
    key(kCtrl | ImGuiKey_L);
    EXPECT_TRUE(is_link(host_.text));
    EXPECT_NE(message().find("Copied a link"), std::string::npos);
    keys({ImGuiKey_C, ImGuiKey_R, ImGuiKey_V});
    EXPECT_NE(scene(), first);
    key(kCtrl | ImGuiKey_V);
    EXPECT_EQ(scene(), first);
    EXPECT_EQ(named(), "");
}

TEST_F(FilesTest, AnAddressNamesABuiltInSceneAsLongAsItIsSeenAsItIs) {
    start(light("shear"), "shear");
    EXPECT_EQ(viewer().address(), "shear");
    key(ImGuiKey_T);
    EXPECT_EQ(viewer().address(), "shear");
    key(ImGuiKey_2);
    EXPECT_TRUE(is_link(viewer().address())) << "the camera has moved";
    EXPECT_EQ(scene_of_link(viewer().address()).camera, scene().camera);
}

TEST_F(FilesTest, ALinkToAMeshSaysWhatItDoesNotHold) {
    write("t.obj", kTetrahedron);
    start();
    open(path("t.obj"));
    key(kCtrl | ImGuiKey_L);
    EXPECT_NE(message().find("t.obj but does not hold it"), std::string::npos) << message();
}

TEST_F(FilesTest, PastingWhatIsNoLinkSaysSo) {
    start();
    const Scene before = scene();
    host_.text = "hello";
    key(kCtrl | ImGuiKey_V);
    EXPECT_EQ(message(), "There is no link on the clipboard; a link begins with normalscope:");
    host_.text = "normalscope:1:damaged";
    key(kCtrl | ImGuiKey_V);
    EXPECT_EQ(scene(), before);
}

TEST_F(FilesTest, EquationsAndCommandAreCopied) {
    start(light("shear"), "shear");
    key(ImGuiKey_N);
    key(kCtrl | kShift | ImGuiKey_L);
    EXPECT_NE(host_.text.find("\\begin{align"), std::string::npos) << host_.text;
    key(kCtrl | ImGuiKey_C);
    const glm::ivec2 size = viewer().frame()->rect.size;
    EXPECT_EQ(host_.text.rfind("normalscope capture shear -o picture.png --size " + std::to_string(size.x) + "x" +
                                   std::to_string(size.y),
                               0),
              0u)
        << host_.text;
    EXPECT_NE(host_.text.find(" --set arrows.limit=12"), std::string::npos) << host_.text;
}

TEST_F(FilesTest, SeveralFilesAtOnceComeOneAfterTheOther) {
    write("a.json", R"({"normalscope": 1, "rule": "naive"})");
    start();
    viewer().open(path("a.json"));
    viewer().open(path("a.json"));
    EXPECT_EQ(message(), "Still reading a file");
    settle();
    EXPECT_EQ(named(), "a.json");
}

}  // namespace
}  // namespace normalscope
