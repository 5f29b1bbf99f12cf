#include "cli/options.h"

#include "cli/declare.h"
#include "cli/help.h"
#include "cli/values.h"
#include "core/base/error.h"
#include "core/base/nearest.h"
#include "core/base/text.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>
#include <system_error>

namespace normalscope {

namespace {

// ---- One function a command --------------------------------------------------------------------------------------

Declared declare_view(CLI::App& root) {
    const auto command = std::make_shared<ViewCommand>();
    const auto file = std::make_shared<std::string>();
    set_up(root,
           "  normalscope                            the window, with a scaled sphere and its normals\n"
           "  normalscope bunny.obj                  the same with your mesh\n"
           "  normalscope split --set theme=dark     a built-in scene, changed\n"
           "  normalscope capture split -o out.png   a picture, without a window");
    CLI::Option& given = add_file(root, *file);
    add_settings(root, command->settings);
    add_lesson_folders(root, command->lesson_folders);
    return {&root, [=, &given] {
                if (given.count() > 0) command->file = *file;
                return *command;
            }};
}

Declared declare_capture(CLI::App& root) {
    struct Given {
        CaptureCommand command;
        GivenPicture picture;
        GivenTolerance tolerance;
        std::string output, numbers, expected;
    };
    const auto given = std::make_shared<Given>();
    CLI::App& app = *root.add_subcommand("capture", "Draw a picture offscreen, without a display");
    set_up(app,
           "  normalscope capture -o sphere.png\n"
           "  normalscope capture bunny.obj -o bunny.png --set 'stack.0.scale=[1,2,1]' --set rule=naive\n"
           "  normalscope capture lecture.json -o lecture.png --size 1920x1080 --numbers lecture.numbers.json\n"
           "  normalscope capture wing.json -o wing.png --expect references/wing.png --tolerance 3\n"
           "  normalscope capture shear -o shear.svg --ground transparent\n"
           "  normalscope capture shear -o - | display");
    add_file(app, given->command.file).capture_default_str();
    add(app, "-o,--output", given->output, "OUT.png",
        "The picture to write; - is standard output. A name that ends in .svg gets the "
        "vector parts: outlines, arrows, axes, labels")
        .required();
    given->picture.add_to(app, given->command);
    CLI::Option& numbers =
        add(app, "--numbers", given->numbers, "OUT.json",
            "Write what the picture means as JSON: matrices, angles, the probe; - is standard output");
    CLI::Option& expected = add(app, "--expect", given->expected, "REF.png",
                                "Compare with an earlier picture: exit code 1 if they differ, and then leave "
                                "OUT.expected.png and OUT.difference.png beside OUT.png");
    given->tolerance.add_to(app);
    add_fail_on_note(app, given->command.fail_on_note);
    return {&app, [given, &app, &numbers, &expected] {
                CaptureCommand command = given->command;
                given->picture.read_into(command);
                command.output = parse_picture_output("--output", given->output);
                if (has_ending(given->output, ".svg") &&
                    (expected.count() > 0 || command.panel || command.captions || !command.tab.empty()))
                    throw UsageError("--output " + given->output +
                                     ": --expect, --panel, --tab and --captions are for pixels; end the name in .png");
                if (numbers.count() > 0) command.numbers = parse_output("--numbers", given->numbers, Written::Json);
                if (command.numbers && command.numbers->is_standard() && command.output.is_standard())
                    throw UsageError("--numbers " + given->numbers +
                                     ": the picture goes there already; write one of them elsewhere");
                if (expected.count() > 0) {
                    command.expected = given->expected;
                    if (command.output.is_standard())
                        throw UsageError("--expect " + given->expected +
                                         ": needs a file for --output, beside which to leave a difference");
                    if (command.numbers && command.numbers->is_standard())
                        throw UsageError("--expect " + given->expected +
                                         ": its result goes to standard output; write --numbers to a file");
                } else if (given->tolerance.given(app)) {
                    throw UsageError("--tolerance, --share, --perceptual: they go with --expect, which is missing");
                }
                command.tolerance = given->tolerance.read();
                return command;
            }};
}

Declared declare_explain(CLI::App& root) {
    struct Given {
        ExplainCommand command;
        std::string format{name(command.format)};
        bool fragment = false;
    };
    const auto given = std::make_shared<Given>();
    CLI::App& app =
        *root.add_subcommand("explain", "Print why normals need the inverse transpose, with the scene's numbers");
    set_up(app,
           "  normalscope explain\n"
           "  normalscope explain shear --set 'stack.0.shear.xy=2' | less\n"
           "  normalscope explain lecture.json --format latex > lecture.tex\n"
           "  normalscope explain bunny.obj --format json > bunny.numbers.json");
    add_file(app, given->command.file).capture_default_str();
    add(app, "--format", given->format, "FORMAT",
        "How: text, for a terminal of 100 columns; json, every step's values with the keys of capture --numbers; or "
        "latex, a document");
    app.add_flag("--fragment", given->fragment,
                 "With latex: the equations alone, for a document of your own that loads amsmath and color");
    add_settings(app, given->command.settings);
    return {&app, [given] {
                ExplainCommand command = given->command;
                command.format = parse_format("--format", given->format);
                if (given->fragment && command.format != ExplainFormat::Latex)
                    throw UsageError("--fragment: is for --format latex");
                if (given->fragment) command.format = ExplainFormat::LatexFragment;
                return command;
            }};
}

Declared declare_scenes(CLI::App& root) {
    CLI::App& app = *root.add_subcommand("scenes", "List the built-in scenes");
    set_up(app, "  normalscope scenes");
    return {&app, [] { return ScenesCommand{}; }};
}

// ---- What is wrong with a command line ---------------------------------------------------------------------------

std::vector<std::string> command_names(const CLI::App& root) {
    std::vector<std::string> names;
    for (const CLI::App* command : root.get_subcommands([](const CLI::App*) { return true; }))
        names.push_back(command->get_name());
    return names;
}

// A word alone is a FILE; but where there is no such thing and a command is spelt nearly so, that was meant.
void refuse_misspelt_command(const CLI::App& root, const std::string& file) {
    std::error_code ignored;
    if (file.find_first_of("./") != std::string::npos || std::filesystem::exists(file, ignored)) return;
    const std::vector<std::string> names = command_names(root);
    if (const auto meant = nearest(file, names))
        throw UsageError(file + ": no such command or file; did you mean " + *meant + "? The commands are " +
                         joined(names));
}

// What no option and no argument took.
void refuse_extras(const CLI::App& app) {
    if (!app.get_parent() && !app.remaining().empty())
        for (const CLI::Option* file : app.get_options([](const CLI::Option* o) { return o->get_positional(); }))
            for (const std::string& given : file->results()) refuse_misspelt_command(app, given);
    for (const std::string& extra : app.remaining()) {
        if (extra == "--") continue;
        if (!extra.starts_with("-") || extra == "-")
            throw UsageError(extra + ": that is one argument too many; usage: " + usage_line(app));
        std::vector<std::string> known;
        for (const CLI::Option* option : app.get_options([](const CLI::Option* o) { return !o->get_positional(); }))
            known.push_back("--" + option->get_lnames().front());
        const std::string name = extra.substr(0, extra.find('='));
        const std::string who = app.get_parent() ? app.get_parent()->get_name() + " " + app.get_name() : app.get_name();
        const auto meant = nearest(name, known);
        throw UsageError(name + ": " + who + " has no such option; " +
                         (meant ? "did you mean " + *meant + "? It" : "it") + " has " + joined(known));
    }
}

std::string name_of(const CLI::Option& option) {
    return option.get_positional() ? option.get_name(true) : "--" + option.get_lnames().front();
}

// Such as a script's variable that is not set. What an empty FILE means is said by who opens it.
void refuse_empty_values(const CLI::App& app) {
    for (const CLI::Option* option : app.get_options()) {
        if (option->get_positional() && !option->get_required()) continue;
        if (std::ranges::none_of(option->results(), &std::string::empty)) continue;
        const std::string word = option->get_type_name();
        throw UsageError(name_of(*option) + ": its value is empty" + (word.empty() ? "" : "; expected " + word));
    }
}

[[noreturn]] void refuse(const CLI::App& app, const CLI::ParseError& error) {
    refuse_extras(app);  // where a name is misspelt, that is what to say, not what is missing for it
    for (const CLI::Option* option : app.get_options())
        if (option->get_required() && option->count() == 0 && error.get_name() == "RequiredError")
            throw UsageError(name_of(*option) + " is missing; usage: " + usage_line(app));
    std::string line = error.what();
    std::ranges::replace(line, '\n', ' ');
    throw UsageError(line + "; usage: " + usage_line(app));
}

}  // namespace

CommandLine::CommandLine()
    : root_{std::make_unique<CLI::App>("Shows what a transformation does to a surface's normals.", "normalscope")},
      view{declare_view(*root_)},
      commands{declare_capture(*root_), declare_sweep(*root_),   declare_explain(*root_), declare_scenes(*root_),
               declare_lessons(*root_), declare_handout(*root_), declare_slides(*root_),  declare_quiz(*root_),
               declare_animate(*root_), declare_compare(*root_), declare_check(*root_)} {
    root_->require_subcommand(0, 1);
}
CommandLine::~CommandLine() = default;

Command parse_command_line(int argc, const char* const* argv) {
    const CommandLine line;
    CLI::App& root = *line.view.app;
    const Declared& view = line.view;
    const std::vector<Declared>& commands = line.commands;
    const auto chosen = [&]() -> const Declared& {
        for (const Declared& command : commands)
            if (command.app->parsed()) return command;
        return view;
    };

    try {
        root.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        return Printed{help_text(*chosen().app)};
    } catch (const CLI::CallForVersion&) {
        return Printed{version_text() + "\n"};
    } catch (const CLI::ParseError& error) {
        refuse(*chosen().app, error);
    }

    const Declared& command = chosen();
    refuse_extras(root);
    refuse_extras(*command.app);
    if (command.app != &root)
        for (const CLI::Option* option : root.get_options())
            if (option->count() > 0)
                throw UsageError(option->get_name() + ": belongs after the command, as in " + usage_line(*command.app));
    Command made = command.make();  // first, since it knows what is expected
    refuse_empty_values(*command.app);
    if (const ViewCommand* v = std::get_if<ViewCommand>(&made); v && v->file) refuse_misspelt_command(root, *v->file);
    return made;
}

}  // namespace normalscope
