// Any bytes as a scene, and as what follows --set and --vary.

#include "core/base/error.h"
#include "core/scene/scene_json.h"
#include "core/scene/setting.h"
#include "core/scene/variation.h"
#include "fuzz.h"

namespace normalscope::fuzz {

namespace {

template <class F>
void allowed_to_refuse(F&& f) {
    try {
        f();
    } catch (const Error& e) {
        const std::string_view line = e.what();
        require(!line.empty(), "an error without a word");
    }
}

}  // namespace

void check(std::string_view bytes) {
    allowed_to_refuse([&] {
        const Scene scene = parse_scene(bytes, "scene.json");
        const std::string text = scene_text(scene);
        require(parse_scene(text, "again") == scene, "a scene that is written reads back as another one");
        Scene made;
        for (const Setting& setting : settings_between(made, scene))
            made = with_setting(made, parse_setting(setting.text()));
        made.about = scene.about;
        require(made == scene, "settings make another scene");
    });
    allowed_to_refuse([&] { (void)with_setting(Scene{}, bytes); });
    if (bytes.size() < 200) allowed_to_refuse([&] { (void)parse_variation(bytes, 3); });
}

std::vector<std::string_view> words() {
    return {"{",
            "}",
            "[",
            "]",
            ",",
            ":",
            "=",
            "null",
            "true",
            "1e999",
            "-0",
            "1e-320",
            "[[[[[[[[",
            "stack.0.scale=",
            "\"stack\":",
            "\"scale\":",
            "\"rotate\":",
            "\"axis\":",
            "\"matrix\":",
            "\"surface\":",
            "\"shape\":",
            "\"mesh\":",
            "\"formula\":",
            "\"parameters\":",
            "\"x^2+y^2+z^2-1\"",
            "\"sin(x)/y\"",
            "\"bound\":",
            "\"camera\":",
            "\"zoom\":",
            "\"rule\":",
            "\"naive\"",
            "\"arrows\":",
            "\"show\":",
            "\"probe\":",
            "[0,1,0]",
            "9007199254740993",
            "\xff",
            "\\u0000"};
}

}  // namespace normalscope::fuzz
