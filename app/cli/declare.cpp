#include "cli/declare.h"

#include "cli/values.h"
#include "core/base/text.h"
#include "core/lessons/tabs.h"
#include "core/mesh/mesh_file.h"

#include <config.h>

#include <sstream>

namespace normalscope {

std::string version_text() { return "normalscope " NORMALSCOPE_VERSION; }

std::string text_of(glm::ivec2 size) { return std::to_string(size.x) + "x" + std::to_string(size.y); }
std::string text_of(double number) {
    std::ostringstream text;
    text << number;
    return text.str();
}

void set_up(CLI::App& app, const std::string& examples) {
    app.set_help_flag("-h,--help", "Print this help");
    app.set_version_flag("--version", version_text(), "Print the version");
    app.footer("Examples:\n" + examples);
    app.allow_extras();  // they are answered by refuse_extras
    app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
}

CLI::Option& add(CLI::App& app, const std::string& name, std::string& value, const std::string& word,
                 const std::string& help) {
    CLI::Option& option = *app.add_option(name, value, help)->type_name(word);
    if (!value.empty()) option.capture_default_str();
    return option;
}

CLI::Option& add_file(CLI::App& app, std::string& value) {
    return add(app, "FILE", value, "",
               "A scene (.json), a mesh (" + mesh_endings_in_words() +
                   "), a link (normalscope:…), a lesson or its n-th step (NAME#n), the name of a built-in scene (see "
                   "normalscope scenes, normalscope lessons), or - for standard input");
}

CLI::Option& add_list(CLI::App& app, const std::string& name, std::vector<std::string>& value, const std::string& word,
                      const std::string& help) {
    return *app.add_option(name, value, help)
                ->type_name(word)
                ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
                ->allow_extra_args(false);  // one value each, or it would eat the FILE after it
}

void add_settings(CLI::App& app, std::vector<std::string>& value) {
    add_list(
        app, "--set", value, "PATH=VALUE",
        "Change the scene: a dotted path and a JSON value, where a bare word is a string; may be given more than once");
}

void add_lesson_folders(CLI::App& app, std::vector<std::string>& value) {
    add_list(app, "--lessons", value, "FOLDER",
             "Your own lessons, listed with the others; may be given more than once");
}

void add_context(CLI::App& app, std::string& value) {
    add(app, "--context", value, "KIND",
        "What draws: osmesa (software), egl (a graphics processor, or software), or auto: osmesa where it is "
        "installed, else egl");
}

void add_jobs(CLI::App& app, std::string& value) { add(app, "--jobs", value, "N", "Processes that draw at once"); }
int parse_jobs(const std::string& text) { return parse_count("--jobs", text, 256); }

void add_fail_on_note(CLI::App& app, bool& value) {
    app.add_flag(
        "--fail-on-note", value,
        "Exit code 1 where there is something to note, such as normals that a mesh lacks or a part of a surface "
        "that is not drawn");
}

void GivenPicture::add_to(CLI::App& app, PictureArguments& arguments) {
    add(app, "--size", size, "WIDTHxHEIGHT", "In pixels");
    add(app, "--samples", samples, "N", "Samples per pixel, against jagged edges: 1, 2 or 4");
    add(app, "--scale", scale, "FACTOR", "Size of words and lines, 0.5 to 8 [chosen to suit the picture's size]");
    add(app, "--ground", ground, "KIND",
        "What is behind the object: scene (a ground with a grid), white, or transparent");
    add_context(app, context);
    app.add_flag("--panel", arguments.panel, "Draw the interface too");
    add(app, "--tab", arguments.tab, "NAME",
        "Draw the interface, with a tab open beside the picture: " + alternatives(tab_names()) +
            "; derivation#5 is at its fifth line");
    app.add_flag("--captions", arguments.captions, "Draw the lesson step's caption below the picture; needs NAME#n");
    add_settings(app, arguments.settings);
}

void GivenPicture::read_into(PictureArguments& arguments) const {
    arguments.size = parse_size("--size", size);
    arguments.samples = parse_samples("--samples", samples);
    if (!scale.empty()) arguments.scale = parse_scale("--scale", scale);
    arguments.ground = parse_ground("--ground", ground);
    arguments.context = parse_context("--context", context);
}

void GivenTolerance::add_to(CLI::App& app) {
    add(app, "--tolerance", channel, "N", "How far a pixel may be off in any channel, of 255");
    add(app, "--share", share, "S", "The share of pixels that may be further off, 0 to 1");
    app.add_flag(
        "--perceptual", perceived,
        "Judge colours by eye: N means as different as two greys N steps apart; and forgive pixels that only smooth "
        "an edge");
}

Tolerance GivenTolerance::read() const {
    return {parse_tolerance("--tolerance", channel), parse_share("--share", share), perceived};
}

bool GivenTolerance::given(const CLI::App& app) const {
    return app.count("--tolerance") + app.count("--share") + app.count("--perceptual") > 0;
}

}  // namespace normalscope
