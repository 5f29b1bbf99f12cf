// The commands that make or judge many pictures.

#include "cli/declare.h"
#include "cli/values.h"
#include "core/base/error.h"

#include <memory>
#include <tuple>

namespace normalscope {

Declared declare_sweep(CLI::App& root) {
    struct Given {
        SweepCommand command;
        GivenPicture picture;
        std::vector<std::string> vary;
        std::string output, sheet, numbers, jobs = std::to_string(command.jobs),
                                            fps = std::to_string(command.frames_per_second);
    };
    const auto given = std::make_shared<Given>();
    CLI::App& app = *root.add_subcommand("sweep", "Draw many pictures while something varies, or a video of them");
    set_up(app,
           "  normalscope sweep --vary stack.0.scale.1=1:3:100 -o frames/\n"
           "  normalscope sweep shear --vary camera.azimuth=0:360:90 -o turn.gif --size 640x360\n"
           "  normalscope sweep bunny.obj --vary stack.0.scale.0=0.2:2:5 --vary light.azimuth=-90:90:3 \\\n"
           "      -o 'bunny-%d-%d.png' --sheet bunny.png");
    add_file(app, given->command.file).capture_default_str();
    add_list(
        app, "--vary", given->vary, "PATH=FROM:TO[:COUNT]",
        "What varies: a dotted path as for --set, its first and its last value (numbers, or arrays of them), and how "
        "many values [25, or 5 each where two vary]; given twice, every value of one is combined with every value of "
        "the other")
        .required();
    add(app, "-o,--output", given->output, "OUT",
        "frame-%03d.png, where %03d becomes the picture's number from 0 on (two such places: its row's and its "
        "column's); a folder; or, with ffmpeg installed, a .gif, .mp4 or .webm")
        .required();
    CLI::Option& sheet = add(app, "--sheet", given->sheet, "OUT.png", "Write all the pictures on one sheet, too");
    given->picture.add_to(app, given->command);
    CLI::Option& numbers = add(app, "--numbers", given->numbers, "OUT.json",
                               "Write what each picture means, as an array in their order; - is standard output");
    add_fail_on_note(app, given->command.fail_on_note);
    add_jobs(app, given->jobs);
    add(app, "--fps", given->fps, "N", "Pictures per second in a video");
    return {&app, [given, &sheet, &numbers] {
                SweepCommand command = given->command;
                given->picture.read_into(command);
                if (given->vary.size() > 2) throw UsageError("--vary: at most two keys vary at once");
                for (const std::string& text : given->vary)
                    command.variations.push_back(parse_variation(text, given->vary.size() == 1 ? 25 : 5));
                if (command.variations.size() == 2 && command.variations[0].path == command.variations[1].path)
                    throw UsageError("--vary " + command.variations[0].path +
                                     ": is given twice; two --vary need two different keys");
                std::size_t pictures = 1;
                for (const Variation& v : command.variations) pictures *= v.values.size();
                command.output = parse_numbered_output("--output", given->output, pictures, given->vary.size());
                if (sheet.count() > 0) command.sheet = parse_output("--sheet", given->sheet, Written::Picture);
                if (numbers.count() > 0) command.numbers = parse_output("--numbers", given->numbers, Written::Json);
                if (command.numbers && command.numbers->is_standard() && command.sheet && command.sheet->is_standard())
                    throw UsageError("--numbers " + given->numbers +
                                     ": the sheet goes there already; write one of them elsewhere");
                command.jobs = parse_jobs(given->jobs);
                command.frames_per_second = parse_count("--fps", given->fps, 240);
                return command;
            }};
}

Declared declare_compare(CLI::App& root) {
    struct Given {
        CompareCommand command;
        GivenTolerance tolerance;
        std::string actual, expected, diff;
    };
    const auto given = std::make_shared<Given>();
    CLI::App& app = *root.add_subcommand("compare", "Compare two pictures: exit code 0 if they agree, 1 if not");
    set_up(app,
           "  normalscope compare actual.png expected.png\n"
           "  normalscope compare actual.png expected.png --tolerance 0 --share 0 --diff difference.png");
    add(app, "ACTUAL", given->actual, "", "The picture to judge (.png)").required();
    add(app, "EXPECTED", given->expected, "", "What it should look like (.png)").required();
    given->tolerance.add_to(app);
    app.add_flag("--json", given->command.json, "Print all that was measured as JSON, in place of the line");
    CLI::Option& diff = add(app, "--diff", given->diff, "OUT.png",
                            "Write a picture of both and of where they differ, side by side: red beyond the tolerance, "
                            "yellow within it, a frame about the worst spot; - is standard output");
    return {&app, [given, &diff] {
                CompareCommand command = given->command;
                command.actual = given->actual;
                command.expected = given->expected;
                command.tolerance = given->tolerance.read();
                if (diff.count() > 0) command.diff = parse_output("--diff", given->diff, Written::Picture);
                return command;
            }};
}

Declared declare_check(CLI::App& root) {
    struct Given {
        CheckCommand command;
        std::string manifest, results = command.results.string(), junit, report, shard, context = "auto",
                              jobs = std::to_string(command.jobs);
    };
    const auto given = std::make_shared<Given>();
    CLI::App& app =
        *root.add_subcommand("check", "Draw a list of scenes and judge them: exit code 0 if all pass, 1 if not");
    set_up(app,
           "  normalscope check checks.json\n"
           "  normalscope check checks.json --junit junit.xml --report report.html\n"
           "  normalscope check checks.json --shard 2/5\n"
           "  normalscope check checks.json --update --only wing");
    add(app, "MANIFEST", given->manifest, "", "Scenes with their references, tolerances and numbers (.json)")
        .required();
    add(app, "--results", given->results, "FOLDER",
        "Where to leave the pictures of failed checks: NAME.png, NAME.expected.png, NAME.difference.png");
    CLI::Option& junit = add(app, "--junit", given->junit, "OUT.xml", "Write the results as CI services read them");
    CLI::Option& report = add(app, "--report", given->report, "OUT.html",
                              "Write a page to look at: pictures with a slider, filters, numbers; all in one file");
    add(app, "--only", given->command.only, "TEXT", "Only checks with this in their name");
    CLI::Option& shard = add(app, "--shard", given->shard, "K/N",
                             "Only every N-th check from the K-th on, so that N runs share the work: 1/5 to 5/5");
    add_fail_on_note(app, given->command.fail_on_note);
    app.add_flag("--update", given->command.update,
                 "Accept pictures that differ, or are new, as the references; on a terminal, ask first");
    add_context(app, given->context);
    add_jobs(app, given->jobs);
    return {&app, [given, &junit, &report, &shard] {
                CheckCommand command = given->command;
                command.manifest = given->manifest;
                command.results = given->results;
                if (junit.count() > 0) command.junit = parse_file_output("--junit", given->junit, Written::Xml);
                if (report.count() > 0) command.report = parse_file_output("--report", given->report, Written::Page);
                if (shard.count() > 0) std::tie(command.shard, command.shards) = parse_shard("--shard", given->shard);
                command.context = parse_context("--context", given->context);
                command.jobs = parse_jobs(given->jobs);
                return command;
            }};
}

}  // namespace normalscope
