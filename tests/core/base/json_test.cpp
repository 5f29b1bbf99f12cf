#include "core/base/json_object.h"
#include "core/base/json_reading.h"

#include <gtest/gtest.h>

namespace normalscope {
namespace {

template <class F>
std::string message_of(F&& f) {
    try {
        f();
    } catch (const JsonError& e) {
        return e.what();
    }
    return "no error";
}

TEST(ReadJson, IsWhatTheLibraryReads) {
    for (const char* text : {R"({"a": [1, -2, 2.5, true, null, "x\u0000é"], "b": {}, "": []})", "[]", "3", "\"x\"",
                             "-0.0", R"([[], [{}], {"a": {"a": {"a": 18446744073709551615}}}])"})
        EXPECT_EQ(read_json(text).dump(), nlohmann::ordered_json::parse(text).dump()) << text;
}

TEST(ReadJson, SaysWhereAndWhy) {
    const std::vector<std::pair<std::string, std::string>> bad{
        {R"({"a": {"b": 1, "c": 2, "b": 3}})", "a.b: is there twice; keep one"},
        {R"([0, {"a": [1, 1e999]}])", "1.a.1: 1e999 is too large for a number"},
        {R"([NaN])", "0: NaN is not a number in JSON"},
        {R"({"a": [1, -Infinity]})", "a.1: -Infinity is not a number in JSON"},
        {std::string(41, '['), "nested more than 40 levels deep"},
        {std::string(100'000, '['), "nested more than 40 levels deep"},
        {"", "not valid JSON: it is empty"},
        {" \n", "not valid JSON: it is empty"},
        {"[1,", "not valid JSON: "},
        {"\"\xff\"", "not valid JSON: "}};
    for (const auto& [text, says] : bad) {
        const std::string message = message_of([&, t = text] { (void)read_json(t); });
        EXPECT_NE(message.find(says), std::string::npos) << text.substr(0, 60) << "\n" << message;
    }
    const std::string quoted = message_of([] { (void)read_json(std::string(1'000'000, 'x')); });
    EXPECT_LT(quoted.size(), 300u) << "what cannot be read is not repeated as a whole";
}

TEST(ReadJson, TellsNoJsonFromJsonWithAFault) {
    EXPECT_FALSE(read_json_or_nothing("naive"));
    EXPECT_EQ(read_json_or_nothing("[1]")->dump(), "[1]");
    EXPECT_THROW(read_json_or_nothing("1e999"), JsonError);
    EXPECT_THROW(read_json_or_nothing(R"({"a": 1, "a": 1})"), JsonError);
}

TEST(ReadJson, TakesLinearTime) {
    std::string text = "{";
    for (int i = 0; i < 200'000; ++i) text += (i ? ",\"" : "\"") + std::to_string(i) + "\":[]";
    EXPECT_EQ(read_json(text + "}").size(), 200'000u);  // in the time of a test, and not of an hour
}

TEST(JsonObject, KnowsWhatItWasAskedFor) {
    const auto json = read_json(R"({"on": true, "word": "w", "many": 3, "part": 0.5, "more": 0})");
    JsonObject object(json, {"here"});
    bool on = false;
    std::string word;
    int many = 0;
    double part = 0.0, missing = 7.0;
    object.read("on", on);
    object.read("word", word);
    object.read("many", many, Range{0, 9});
    object.read("part", part, kAnyNumber);
    object.read("missing", missing, kAnyNumber);
    object.read("on", on);  // is named once nevertheless
    EXPECT_TRUE(on && word == "w" && many == 3 && part == 0.5 && missing == 7.0);
    EXPECT_EQ(message_of([&] { object.no_other_keys(); }),
              "here.more: unknown key; known here: on, word, many, part, missing");
    EXPECT_EQ(message_of([&] { object.read("part", on); }), "here.part: expected true or false, found 0.5");
    EXPECT_EQ(message_of([&] { object.read("part", many, Range{0, 9}); }),
              "here.part: expected a whole number, found 0.5");
    EXPECT_EQ(message_of([&] { object.read("many", many, Range{4, 9}); }),
              "here.many: 3 is out of range; it must be from 4 to 9");
    EXPECT_EQ(message_of([&] { object.read("part", missing, Range{0.001, 1e-2}); }),
              "here.part: 0.5 is out of range; it must be from 0.001 to 0.01");
    EXPECT_EQ(message_of([&] { object.read("many", missing, Range{1e9, kAnyNumber.high}); }),
              "here.many: 3 is out of range; it must be at least 1000000000");
    EXPECT_EQ(message_of([&] { (void)object.need("size"); }),
              "here: lacks the key size; it has on, word, many, part, more");
    EXPECT_EQ(message_of([&] { JsonObject(json["word"], {"here", "word"}, "an object with words"); }),
              "here.word: expected an object with words, found \"w\"");
}

}  // namespace
}  // namespace normalscope
