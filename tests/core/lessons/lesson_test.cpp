#include "core/lessons/lesson.h"

#include "core/base/error.h"
#include "core/lessons/lesson_board.h"
#include "core/lessons/lesson_player.h"
#include "core/lessons/open.h"
#include "core/scene/scene_blend.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <algorithm>

namespace normalscope {
namespace {

std::string error_of(const std::string& text) {
    try {
        (void)parse_lesson({text, "my.json", {}});
    } catch (const InputError& e) {
        return e.what();
    }
    return "no error";
}

std::string lesson(const std::string& steps) {
    return "{\n  \"normalscope\": 1,\n  \"lesson\": \"Mine\",\n  \"steps\": [\n" + steps + "\n  ]\n}\n";
}

TEST(Lesson, StepsChangeTheSceneOneAfterTheOther) {
    const Lesson mine = parse_lesson({lesson(R"(
        {"caption": "a", "scene": {"stack": [{"scale": [1, 2, 1]}], "camera": {"zoom": 2}}},
        {"caption": "b", "scene": {"rule": "naive", "camera": {"azimuth": 5}, "surface": {"shape": "torus"}}},
        {"caption": "c", "scene": {"surface": {"formula": "x^2+a*y^2=1", "parameters": {"a": 2}}}},
        {"caption": "d", "scene": {"surface": {"parameters": {"a": 3}}}})"),
                                      "my.json",
                                      {}});
    ASSERT_EQ(mine.steps.size(), 4u);
    EXPECT_EQ(mine.steps[1].scene.camera.zoom, 2.0);
    EXPECT_EQ(mine.steps[1].scene.camera.azimuth, 5.0);
    EXPECT_EQ(std::get<Scale>(mine.steps[1].scene.stack[0]).factors.y, 2.0);
    EXPECT_EQ(std::get<ShapeSurface>(mine.steps[1].scene.surface).shape, Shape::Torus);
    EXPECT_EQ(std::get<FormulaSurface>(mine.steps[3].scene.surface).parameters[0], 3.0);
}

TEST(Lesson, ErrorsNameLineAndStep) {
    EXPECT_EQ(
        error_of(lesson("{\"caption\": \"a\"},\n{\"caption\": \"b\",\n \"scene\": {\"colour\": 1}}")).substr(0, 50),
        "my.json, line 7, step 2: scene.colour: unknown key");
    EXPECT_EQ(
        error_of(lesson("{\"caption\": \"a\"},\n{\"caption\": \"b\",\n \"scene\": {\"stack\": [\n  {\"scale\": [1, "
                        "\"x\", 1]}]}}")),
        "my.json, line 8, step 2: scene.stack.0.scale.1: expected a number, found \"x\"");
    EXPECT_EQ(error_of(lesson("{\n\"caption\": 7}")), "my.json, line 6, step 1: caption: expected words, in quotes");
    EXPECT_EQ(error_of(lesson("{}")), "my.json, line 5, step 1: lacks the key caption");
    EXPECT_NE(error_of(lesson("{\"caption\": \"a\",}")).find("line 5"), std::string::npos);
    EXPECT_NE(error_of(lesson("")).find("at least one step"), std::string::npos);
}

TEST(Lesson, RefusesWhatNobodyCanShow) {
    std::string many;
    for (int i = 0; i < 10000; ++i) many += (i ? "," : "") + std::string("{\"caption\": \"a\"}");
    EXPECT_NE(error_of(lesson(many)).find("has 10000 steps; at most 200"), std::string::npos);
    EXPECT_NE(error_of(lesson("{\"caption\": \"" + std::string(5000, 'x') + "\"}")).find("5000 characters"),
              std::string::npos);
    EXPECT_NE(error_of(lesson("{\"caption\": \"a\", \"scene\": " + std::string(100000, '['))).find("levels deep"),
              std::string::npos);
    EXPECT_NE(error_of(lesson("{\"caption\": \"a\", \"question\": {\"ask\": \"?\", \"choices\": [{\"text\": \"1\", "
                              "\"because\": \"x\"}, {\"text\": \"2\", \"because\": \"y\"}]}}"))
                  .find("exactly one"),
              std::string::npos);
}

TEST(Lesson, AStepMayShowALineOfTheDerivationAndHaveNotes) {
    const Lesson mine = parse_lesson(
        {lesson(R"({"caption": "a", "derivation": 3, "notes": "Ask first."}, {"caption": "b"})"), "my.json", {}});
    EXPECT_EQ(mine.steps[0].line, 2u);
    EXPECT_EQ(mine.steps[0].notes, "Ask first.");
    EXPECT_EQ(mine.steps[1].line, std::nullopt);
    for (const char* line : {"0", "11", "1.5", "\"3\"", "null"})
        EXPECT_NE(error_of(lesson("{\"caption\": \"a\", \"derivation\": " + std::string(line) + "}"))
                      .find("step 1: derivation"),
                  std::string::npos)
            << line;
}

TEST(Lesson, AStepMayPutWordsIntoItsPicture) {
    const Lesson mine = parse_lesson({lesson(R"({"caption": "a", "label": {"text": "here", "on": [1, 0, 0]}},
        {"caption": "b", "highlight": "n_naive", "label": [{"text": "p", "at": [0, 1, 0]}, {"text": "q", "at": [0, 0, 0]}]})"),
                                      "my.json",
                                      {}});
    EXPECT_EQ(mine.steps[0].labels, (std::vector<PointLabel>{{"here", Point<Object>{{1, 0, 0}}}}));
    EXPECT_EQ(mine.steps[1].labels.at(0), (PointLabel{"p", Point<World>{{0, 1, 0}}}));
    EXPECT_EQ(mine.steps[1].highlight, (Highlight{.symbol = Symbol::NWorld, .naive = true}));
    EXPECT_FALSE(mine.steps[0].highlight);
    for (const char* wrong :
         {R"("highlight": "n")", R"("label": {"text": "p"})", R"("label": {"text": "p", "at": [1, 2]})",
          R"("label": {"text": "p", "at": [1, 2, 3], "on": [1, 2, 3]})", R"("board": true)"})
        EXPECT_NE(error_of(lesson("{\"caption\": \"a\", " + std::string(wrong) + "}")).find("step 1: "),
                  std::string::npos)
            << wrong;
}

TEST(Lesson, EquationsStayOnTheBoard) {
    const Lesson mine = parse_lesson({lesson(R"({"caption": "a", "equations": ["1", "2"]}, {"caption": "b"},
        {"caption": "c", "equations": ["1"]}, {"caption": "d", "equations": ["3"], "board": "wipe"},
        {"caption": "e", "equations": ["3"]}, {"caption": "f", "board": "wipe"})"),
                                      "my.json",
                                      {}});
    const auto board = [&](std::size_t step) { return board_at(mine, step); };
    EXPECT_EQ(board(0), (Board{{}, {"1", "2"}}));
    EXPECT_EQ(board(1), (Board{{"1", "2"}, {}}));
    EXPECT_EQ(board(2), (Board{{"2"}, {"1"}})) << "each once, where it was said last";
    EXPECT_EQ(board(3), (Board{{}, {"3"}}));
    EXPECT_EQ(board(4), (Board{{}, {"3"}}));
    EXPECT_EQ(board(5), Board{});
}

// Whoever is asked about one surface would take another one's equation for its own.
TEST(Lesson, NoQuestionStandsAboveWhatIsTrueOfAnotherSurface) {
    for (const ListedLesson& listed : built_in_lessons()) {
        const Lesson lesson = built_in_lesson(listed.name);
        for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
            const auto* asked = std::get_if<FormulaSurface>(&lesson.steps[i].scene.surface);
            if (!asked || !lesson.steps[i].question) continue;
            for (const std::string& line : board_at(lesson, i).earlier)
                for (std::size_t k = 0; k < i; ++k) {
                    const auto* written = std::get_if<FormulaSurface>(&lesson.steps[k].scene.surface);
                    const bool here = std::ranges::count(lesson.steps[k].equations, line) > 0;
                    EXPECT_TRUE(!here || (written && written->formula == asked->formula))
                        << listed.name << ": " << line;
                }
        }
    }
}

// People write in any script.
TEST(Lesson, LimitsCountCharacters) {
    std::string chinese;
    for (int i = 0; i < 400; ++i) chinese += "法";
    EXPECT_EQ(error_of(lesson("{\"caption\": \"" + chinese + "\"}")), "no error");
    EXPECT_NE(error_of(lesson("{\"caption\": \"" + chinese + "线\"}")).find("401 characters"), std::string::npos);
}

// A step on, a step back, and play in between: the scene is the step's again.
TEST(LessonPlayer, ComesBackToTheStepFromAnywhere) {
    const auto lesson = std::make_shared<const Lesson>(load_lesson("1-normal-as-a-point"));
    LessonPlayer player;
    Scene scene = load_scene("reflection");
    scene.theme = Theme::Dark;
    player.start(lesson, 0, scene);
    const auto arrive = [&] {
        for (int i = 0; i < 100 && player.moving(); ++i) player.advance(1.0 / 60.0, scene);
        ASSERT_FALSE(player.moving());
        Scene expected = player.step().scene;
        expected.theme = Theme::Dark;  // the room's
        EXPECT_EQ(scene, expected);
        EXPECT_FALSE(player.strayed(scene));
    };
    arrive();
    player.go_to(1, scene);
    player.advance(0.2, scene);
    player.go_to(2, scene);  // in a hurry
    arrive();
    scene.stack = {Rotate{{1, 0, 0}, 40}};
    EXPECT_TRUE(player.strayed(scene));
    player.go_to(2, scene);
    arrive();
    // Whoever drags meanwhile has the object.
    player.go_to(3, scene);
    player.advance(0.2, scene);
    scene.camera.azimuth += 10;
    const Scene dragged = scene;
    player.advance(0.2, scene);
    EXPECT_FALSE(player.moving());
    EXPECT_EQ(scene, dragged);
}

TEST(LessonPlayer, AStepMayLeadSomewhereByItself) {
    const auto parsed = [](const std::string& path) {
        return parse_lesson({R"({"lesson": "L", "steps": [{"caption": "a", "scene": {"stack": [{"scale": [1, 1, 1]}]}},
            {"caption": "b", "path": )" +
                                 path + "}]}",
                             "mine.json",
                             {}});
    };
    const auto lesson = std::make_shared<const Lesson>(
        parsed(R"({"stack.0.scale.1": [1, 3, 2], "probe": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]})"));
    const Scene& end = lesson->steps[1].scene;
    EXPECT_EQ(std::get<Scale>(end.stack[0]).factors.y, 2.0);
    EXPECT_EQ(end.probe->xyz, glm::dvec3(0, 0, 1));

    LessonPlayer player;
    Scene scene = lesson->steps[0].scene;
    player.start(lesson, 0, scene);
    player.arrive(scene);
    player.go_to(1, scene);
    double highest = 0.0;
    bool shown = false;
    for (int i = 0; i < 600 && player.moving(); ++i) {
        player.advance(1.0 / 60.0, scene);
        shown |= player.on_path();
        EXPECT_TRUE(i >= 50 || !player.on_path());
        highest = std::max(highest, std::get<Scale>(scene.stack[0]).factors.y);
    }
    EXPECT_TRUE(shown);
    EXPECT_NEAR(highest, 3.0, 0.05);
    EXPECT_EQ(scene, end);
    EXPECT_FALSE(player.moving());

    player.moves = false;
    player.go_to(1, scene);
    player.advance(0.01, scene);
    EXPECT_FALSE(player.moving());

    for (const auto& [path, reason] : std::initializer_list<std::pair<const char*, const char*>>{
             {R"({"nope": [1, 2]})", "step 2: path.nope.0: nope: unknown key"},
             {R"({"power": [1]})", "step 2: path.power: expected an array of 2 to 100 values"},
             {R"({"power": [1, [1, 2]]})", "step 2: path.power: expected an array of 2 to 100 values"},
             {R"({"power": [1, 7]})", "step 2: path.power.1: power: "},
             {R"({"power": [1, "x"]})", "step 2: path.power.1: expected a number"},
             {"[]", "step 2: path: expected an object of 1 to 4 keys"}}) {
        try {
            parsed(path);
            ADD_FAILURE() << path;
        } catch (const InputError& e) {
            EXPECT_NE(std::string(e.what()).find(reason), std::string::npos) << e.what();
        }
    }
}

// Between two steps nothing jumps: M changes by little from frame to frame.
TEST(SceneBlend, MovesEvenly) {
    for (const ListedLesson& built_in : built_in_lessons()) {
        const Lesson lesson = load_lesson(built_in.name);
        for (std::size_t i = 0; i + 1 < lesson.steps.size(); ++i) {
            const Scene &from = lesson.steps[i].scene, &to = lesson.steps[i + 1].scene;
            EXPECT_EQ(blend(from, to, 1.0), to);
            if (from.stack_position || to.stack_position) continue;
            glm::dmat4 before = world_from_object(from).matrix();
            for (int k = 0; k <= 60; ++k) {
                const glm::dmat4 now = world_from_object(blend(from, to, k / 60.0)).matrix();
                for (int c = 0; c < 4; ++c)
                    EXPECT_LT(glm::length(now[c] - before[c]), 0.15) << built_in.name << " " << i << " " << k;
                before = now;
            }
        }
    }
}

TEST(SceneBlend, TurnsTheShorterWay) {
    Scene from, to;
    from.camera.azimuth = 170;
    to.camera.azimuth = -170;
    to.power = -1.0;
    EXPECT_NEAR(blend(from, to, 0.5).camera.azimuth, 180, 1e-9);
    EXPECT_NEAR(blend(from, to, 0.5).power, 0.0, 1e-9);
}

}  // namespace
}  // namespace normalscope
