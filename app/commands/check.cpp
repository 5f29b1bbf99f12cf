#include "commands/commands.h"

#include "batch/batch.h"
#include "batch/cancel.h"
#include "batch/progress.h"
#include "commands/manifest.h"
#include "commands/report.h"
#include "commands/scene_arguments.h"
#include "commands/verdict.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/image/png.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <optional>

namespace normalscope {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

// Where the picture of a check goes that does not pass; a name may hold what a file's name may not.
fs::path evidence_file(const CheckCommand& command, const Check& check) {
    std::string name = check.name;
    for (char& c : name)
        if (c == '/' || static_cast<unsigned char>(c) < ' ') c = '-';
    return command.results / (name + ".png");
}

void add_line(std::string& lines, const std::string& line) { lines += (lines.empty() ? "" : "; ") + line; }

/// A picture as it was drawn becomes a result. This runs beside the drawing of the next one.
class Judge {
public:
    Judge(const CheckCommand& command, const Check& check, Capture capture)
        : command_(command), check_(check), actual_(std::move(capture.image)), numbers_(Json::parse(capture.numbers)) {}

    CheckResult judge() {
        if (check_.reference) judge_picture();
        for (const std::string& line : wrong_numbers(numbers_, check_.numbers)) {
            fail(line);
            result_.numbers_wrong = true;
        }
        if (result_.line.empty()) result_.line = "the numbers are as expected";
        if (result_.state == "pass")
            remove_old_evidence();
        else
            evident([&] { write_png(evidence_file(command_, check_), actual_); });
        if (command_.report) {
            details_["pictures"]["actual"] = base64(png_bytes(actual_));
            details_["numbers"] = numbers_;
        }
        result_.name = check_.name;
        result_.details = details_.dump();
        return std::move(result_);
    }

private:
    void fail(const std::string& line) {
        if (result_.state == "pass") result_.line.clear();  // what agrees is of no interest any more
        result_.state = "fail";
        add_line(result_.line, line);
    }

    void judge_picture() {
        std::error_code ignored;
        if (!fs::exists(*check_.reference, ignored)) {
            result_.reference_differs = true;
            return fail("there is no reference " + check_.reference->string() + "; --update writes it");
        }
        const Image expected = read_png(*check_.reference);
        const Verdict verdict = ::normalscope::judge(actual_, expected, check_.tolerance);
        details_["verdict"] = verdict.json();
        if (verdict.agree)
            result_.line = verdict.line();
        else
            fail(verdict.line());
        result_.reference_differs = !verdict.agree;
        const bool same = verdict.difference && verdict.difference->worst_by == 0;
        if (command_.report && !same) {
            details_["pictures"]["expected"] = base64(png_bytes(expected));
            details_["pictures"]["difference"] = base64(png_bytes(highlighted(verdict, expected)));
        }
        if (!verdict.agree)
            evident([&] {
                leave_evidence(evidence_file(command_, check_), actual_, *check_.reference, expected, check_.tolerance);
            });
    }

    // What is found counts, even where its pictures find no room.
    template <class Write>
    void evident(Write&& write) {
        try {
            write();
        } catch (const InputError& e) {
            fail(e.what());
        }
    }

    // The last third of the difference's picture.
    Image highlighted(const Verdict& verdict, const Image& expected) const {
        const Image all = difference_picture(actual_, expected, verdict.tolerance);
        const glm::ivec2 size = glm::max(actual_.size, expected.size);
        return cropped(all, {all.size.x - size.x, 0}, size);
    }

    void remove_old_evidence() const {
        const fs::path actual = evidence_file(command_, check_), reference = check_.reference.value_or(fs::path());
        remove_evidence(actual, reference);
        std::error_code ignored;
        if (!fs::equivalent(actual, reference, ignored)) fs::remove(actual, ignored);
    }

    const CheckCommand& command_;
    const Check& check_;
    Image actual_;
    Json numbers_;
    Json details_ = Json::object();
    CheckResult result_{.state = "pass"};
};

// A result as text, since it may come from another process.
std::string packed(const CheckResult& r) {
    return Json{{"name", r.name},
                {"state", r.state},
                {"line", r.line},
                {"seconds", r.seconds},
                {"details", r.details},
                {"differs", r.reference_differs},
                {"numbers_wrong", r.numbers_wrong}}
        .dump(-1, ' ', false, Json::error_handler_t::replace);
}
CheckResult unpacked(const std::string& text) {
    const Json j = Json::parse(text);
    return {j["name"], j["state"], j["line"], j["seconds"], j["details"], j["differs"], j["numbers_wrong"]};
}

CheckResult error_result(const Check& check, const Error& error) {
    return {.name = check.name, .state = "error", .line = error.what(), .details = "{}"};
}

// False where it was cancelled.
bool run_checks(const CheckCommand& command, const std::vector<Check>& checks, std::vector<CheckResult>& results) {
    Progress progress(checks.size());
    const auto draw = [&](Studio& studio, const Check& check) -> Finish {
        const auto began = Clock::now();
        const auto timed = [began](CheckResult result) {
            result.seconds = std::chrono::duration<double>(Clock::now() - began).count();
            return packed(result);
        };
        try {
            const Scene scene = scene_for(check.picture.file, check.picture.settings);
            auto judge =
                std::make_shared<Judge>(command, check, studio.capture(scene, capture_options(check.picture, true)));
            return [judge, timed, &check] {
                try {
                    return timed(judge->judge());
                } catch (const InputError& e) {
                    return timed(error_result(check, e));
                }
            };
        } catch (const ContextError&) {
            throw;  // then none can be drawn
        } catch (const Error& e) {
            return [text = timed(error_result(check, e))] { return text; };
        }
    };
    return run_batch({.count = checks.size(),
                      .jobs = command.jobs,
                      .start =
                          [&] {
                              auto studio = std::make_shared<Studio>(
                                  command.context, checks.size() / static_cast<std::size_t>(command.jobs));
                              return [&, studio](std::size_t i) { return draw(*studio, checks[i]); };
                          },
                      .done =
                          [&](std::size_t i, const std::string& text) {
                              results[i] = unpacked(text);
                              progress.step();
                          }}) &&
           !CancelOnSignal::asked();
}

bool accepted_by_user(std::size_t count) {
    if (!::isatty(STDIN_FILENO) || !::isatty(STDERR_FILENO)) return true;
    std::fprintf(stderr, "Accept %zu new reference%s? [y/N] ", count, count == 1 ? "" : "s");
    const int answer = std::getchar();
    return answer == 'y' || answer == 'Y';
}

// What was left for people to look at becomes the reference.
void update_references(const CheckCommand& command, const std::vector<Check>& checks,
                       std::vector<CheckResult>& results) {
    std::size_t differ = 0;
    for (const CheckResult& r : results) differ += r.reference_differs ? 1 : 0;
    if (differ == 0 || !accepted_by_user(differ)) return;
    for (std::size_t i = 0; i < checks.size(); ++i) {
        if (!results[i].reference_differs) continue;
        const fs::path& reference = *checks[i].reference;
        std::error_code ignored;
        fs::create_directories(reference.parent_path(), ignored);
        write_png(reference, read_png(evidence_file(command, checks[i])));
        std::printf("updated: %s\n", reference.c_str());
        results[i].reference_differs = false;
    }
}

}  // namespace

int run(const CheckCommand& command) {
    std::vector<Check> checks = read_manifest(command.manifest);
    std::erase_if(checks, [&](const Check& c) { return c.name.find(command.only) == std::string::npos; });
    if (checks.empty()) throw UsageError("--only " + command.only + ": no check's name has that in it");
    std::error_code ignored;
    fs::create_directories(command.results, ignored);  // writing will say what is wrong

    std::vector<CheckResult> results(checks.size());
    {
        const CancelOnSignal cancel;
        if (!run_checks(command, checks, results)) {
            std::fputs("normalscope: cancelled; no report was written\n", stderr);
            return CancelOnSignal::exit_code();
        }
    }
    fs::remove(command.results, ignored);  // which removes an empty folder only

    std::string lines;
    std::size_t passed = 0;
    for (const CheckResult& r : results) {
        lines += r.state + ": " + r.name + ": " + r.line + "\n";
        passed += r.state == "pass" ? 1 : 0;
    }
    lines += std::to_string(passed) + " of " + std::to_string(results.size()) + " checks pass\n";
    write_file("/dev/stdout", lines);
    const std::string suite = command.manifest.stem().string();
    if (command.junit) write_file(*command.junit, junit_xml(suite, results));
    if (command.report) write_file(*command.report, html_report(command.manifest.filename().string(), results));
    if (!command.update) return passed == results.size() ? 0 : 1;

    update_references(command, checks, results);
    const auto good = [](const CheckResult& r) {
        return r.state != "error" && !r.reference_differs && !r.numbers_wrong;
    };
    return std::ranges::all_of(results, good) ? 0 : 1;
}

}  // namespace normalscope
