#include "commands/commands.h"

#include "batch/batch.h"
#include "batch/cancel.h"
#include "batch/progress.h"
#include "commands/evidence.h"
#include "commands/files_of_run.h"
#include "commands/judge_check.h"
#include "commands/junit.h"
#include "commands/manifest.h"
#include "commands/report.h"
#include "commands/scene_arguments.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/output.h"
#include "core/base/system.h"
#include "core/base/utf8.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <new>
#include <optional>

namespace normalscope {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// A check that is to be run: its scene is read before anything is drawn, since nothing may be written over its files.
struct Chosen {
    Check check;
    std::optional<Subject> subject;
    std::string error;  ///< why there is no scene
};

/// A run of checks on its way.
struct Run {
    const CheckCommand& command;
    std::vector<Chosen> checks;
    std::vector<CheckResult> results;
    std::size_t named = 0;  ///< how many --only names: of these, --shard chose
    std::size_t known = 0;  ///< of the results
};

// A manifest's references must not be written over by any of its checks, whether they are run this time or not.
FilesOfRun files_of(const CheckCommand& command, const std::vector<Check>& all) {
    FilesOfRun files(command.manifest.string());
    if (command.junit) files.writes(*command.junit, "--junit " + command.junit->string());
    if (command.report) files.writes(*command.report, "--report " + command.report->string());
    for (const Check& check : all) {
        const std::string of_check = " of check " + check.name + ")";
        const fs::path actual = evidence_file(command, check);
        files.manifest_writes(actual, actual.string() + " (the picture" + of_check);
        if (!check.reference) continue;
        files.manifest_writes(*check.reference, check.reference->string() + " (the reference" + of_check);
        for (const fs::path& file : evidence_files(actual, *check.reference))
            files.manifest_writes(file, file.string() + " (left by a failure" + of_check);
    }
    return files;
}

void choose(Run& run, const std::vector<Check>& all) {
    const CheckCommand& command = run.command;
    for (const Check& check : all) {
        if (check.name.find(command.only) == std::string::npos) continue;
        if (run.named++ % command.shards != command.shard - 1) continue;
        std::vector<Chosen>& chosen = run.checks;
        chosen.push_back({check, {}, {}});
        try {
            chosen.back().subject = subject_of(check.picture.file, check.picture.settings);
        } catch (const Error& e) {
            chosen.back().error = e.what();
        }
    }
    if (run.named == 0) throw UsageError("--only " + command.only + ": no check's name has that in it");
}

Finish draw(const CheckCommand& command, const Chosen& chosen, Studio& studio) {
    const Check& check = chosen.check;
    const auto timed = [began = Clock::now()](CheckResult result) {
        result.seconds = std::chrono::duration<double>(Clock::now() - began).count();
        return packed(result);
    };
    const auto failed = [&](const std::string& reason) {
        return [text = timed(error_result(check, reason))] { return text; };
    };
    if (!chosen.subject) return failed(chosen.error);
    try {
        CaptureOptions options = capture_options(check.picture, *chosen.subject);
        options.numbers = true;
        auto capture = std::make_shared<Capture>(studio.capture(chosen.subject->scene, options));
        return [&command, &check, capture, timed] {
            try {
                return timed(judge_check(command, check, std::move(*capture)));
            } catch (const InputError& e) {
                return timed(error_result(check, e.what()));
            } catch (const std::bad_alloc&) {
                return timed(error_result(check, kOutOfMemory));
            }
        };
    } catch (const ContextError&) {
        throw;  // then none can be drawn
    } catch (const Error& e) {
        return failed(e.what());
    } catch (const std::bad_alloc&) {
        return failed(kOutOfMemory);
    }
}

void print_result(const CheckResult& r) {
    print(in_one_line(std::string(name(r.state)) + ": " + r.name + ": " + r.line) + "\n");
}

// Each result is printed as it comes. False where it was cancelled.
bool run_checks(Run& run) {
    const std::size_t count = run.checks.size(),
                      jobs = std::clamp<std::size_t>(static_cast<std::size_t>(run.command.jobs), 1,
                                                     std::max<std::size_t>(count, 1));
    Progress progress(count);
    const auto start = [&] {
        auto studio = std::make_shared<Studio>(StudioOptions{run.command.context, count / jobs, jobs});
        return [&run, studio](std::size_t i) { return draw(run.command, run.checks[i], *studio); };
    };
    const auto done = [&](std::size_t i, const std::string& text) {
        run.results[i] = unpacked(text);
        ++run.known;
        progress.hide();
        print_result(run.results[i]);
        progress.step();
    };
    return run_batch({.count = count, .jobs = jobs, .apart = true, .start = start, .done = done}) &&
           !CancelOnSignal::asked();
}

std::string summary(const Run& run) {
    if (run.checks.empty())
        return "nothing was checked: shard " + std::to_string(run.command.shard) + "/" +
               std::to_string(run.command.shards) + " has none of the " + std::to_string(run.named) + " checks\n";
    const auto passed =
        std::ranges::count_if(run.results, [](const CheckResult& r) { return r.state == CheckState::Pass; });
    const std::size_t skipped = run.results.size() - run.known;
    return std::to_string(passed) + " of " + std::to_string(run.results.size()) + " checks pass" +
           (skipped > 0 ? ", " + std::to_string(skipped) + (skipped == 1 ? " was" : " were") + " not run" : "") + "\n";
}

bool accepted_by_user(std::size_t count) {
    if (!is_terminal(stdin) || !is_terminal(stderr)) return true;
    std::fprintf(stderr, "Accept %zu new reference%s? [y/N] ", count, count == 1 ? "" : "s");
    const int answer = std::getchar();
    return answer == 'y' || answer == 'Y';
}

// What this run drew, and left for people to look at, becomes the reference; no other picture may, such as one that an
// earlier run left there.
void update_references(Run& run) {
    const auto differ = static_cast<std::size_t>(
        std::ranges::count_if(run.results, [](const CheckResult& r) { return r.reference_differs; }));
    if (differ == 0 || !accepted_by_user(differ)) return;
    for (std::size_t i = 0; i < run.results.size(); ++i) {
        CheckResult& result = run.results[i];
        if (!result.reference_differs || result.drawn == 0) continue;  // the result says why there is no picture
        const Check& check = run.checks[i].check;
        const fs::path drawn = evidence_file(run.command, check);
        const std::string bytes = read_file(drawn, std::size_t{1} << 30);
        if (hash_of(bytes) != result.drawn)
            throw InputError(drawn.string() +
                             ": is no longer the picture that this run drew, so it has not become the reference; "
                             "is there another run with the same --results?");
        if (check.reference->has_parent_path()) make_folder(check.reference->parent_path());
        write_file(*check.reference, bytes);
        result.reference_differs = false;
        std::error_code ignored;
        for (const fs::path& file : result.evidence) fs::remove(file, ignored);
        print("updated: " + check.reference->string() + "\n");
    }
}

/// Does one thing after the other, whatever becomes of those before, and throws the first error in the end.
class InSpiteOfErrors {
public:
    template <class F>
    void attempt(F&& f) {
        try {
            f();
        } catch (...) {
            if (!first_) first_ = std::current_exception();
        }
    }
    void rethrow() const {
        if (first_) std::rethrow_exception(first_);
    }

private:
    std::exception_ptr first_;
};

void write_reports(const Run& run, InSpiteOfErrors& tasks) {
    const CheckCommand& command = run.command;
    tasks.attempt([&] { print(summary(run)); });
    if (command.junit)
        tasks.attempt([&] { write_file(*command.junit, junit_xml(command.manifest.stem().string(), run.results)); });
    if (command.report)
        tasks.attempt(
            [&] { write_file(*command.report, html_report(command.manifest.filename().string(), run.results)); });
}

}  // namespace

int run(const CheckCommand& command) {
    const std::vector<Check> all = read_manifest(command.manifest);
    FilesOfRun files = files_of(command, all);
    Run run{command, {}, {}};
    choose(run, all);
    for (const Chosen& c : run.checks)
        if (c.subject) files.reads_scene(c.check.picture.file, c.subject->scene);
    for (const Chosen& c : run.checks)
        run.results.push_back({.name = c.check.name, .line = "not run: the run was cut short"});

    std::error_code ignored;
    const bool folder_was_there = fs::exists(command.results, ignored);
    if (folder_was_there && !fs::is_directory(command.results, ignored))
        throw InputError(command.results.string(),
                         "is a file, where a folder for what differs is wanted; name another after --results");
    InSpiteOfErrors tasks;
    bool whole = false;
    {
        const CancelOnSignal cancel;
        tasks.attempt([&] { whole = run_checks(run); });
        write_reports(run, tasks);
        if (whole && command.update) tasks.attempt([&] { update_references(run); });
        if (!folder_was_there) fs::remove(command.results, ignored);  // only if it is empty
        tasks.rethrow();
        if (!whole) {
            std::fprintf(stderr, "normalscope: cancelled after %zu of %zu checks; the others were not run\n", run.known,
                         run.results.size());
            return CancelOnSignal::exit_code();
        }
    }
    const auto good = [&](const CheckResult& r) {
        return r.state == CheckState::Pass ||
               (command.update && r.state == CheckState::Fail && !r.reference_differs && !r.numbers_wrong);
    };
    return std::ranges::all_of(run.results, good) ? 0 : 1;
}

}  // namespace normalscope
