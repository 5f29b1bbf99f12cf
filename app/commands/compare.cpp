#include "commands/compare.h"

#include "commands/commands.h"
#include "commands/evidence.h"
#include "commands/files_of_run.h"
#include "commands/verdict.h"
#include "core/base/error.h"
#include "core/base/json_text.h"
#include "core/base/output.h"
#include "core/image/png.h"
#include "core/image/png_rows.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <vector>

namespace normalscope {

namespace {

bool same_bytes(const std::filesystem::path& a, const std::filesystem::path& b) {
    std::error_code error;
    if (std::filesystem::file_size(a, error) != std::filesystem::file_size(b, error) || error) return false;
    std::ifstream in_a(a, std::ios::binary), in_b(b, std::ios::binary);
    std::vector<char> from_a(std::size_t{1} << 16), from_b(from_a.size());
    while (in_a && in_b) {
        in_a.read(from_a.data(), static_cast<std::streamsize>(from_a.size()));
        in_b.read(from_b.data(), static_cast<std::streamsize>(from_b.size()));
        const std::streamsize got = in_a.gcount();
        if (got != in_b.gcount() || !std::equal(from_a.begin(), from_a.begin() + got, from_b.begin())) return false;
    }
    return in_a.eof() && in_b.eof();
}

// What can be told without holding either picture: sizes that differ, files that do not, and how far large ones are apart.
std::optional<Verdict> quick_verdict(const CompareCommand& command) {
    const auto actual = png_size(command.actual), expected = png_size(command.expected);
    if (!actual || !expected) return std::nullopt;
    Verdict verdict{false, *actual, *expected, {}, command.tolerance};
    if (*actual != *expected) return verdict;
    if (same_bytes(command.actual, command.expected))
        verdict.difference.emplace();
    else
        verdict.difference = difference_by_rows(command.actual, command.expected, command.tolerance);
    if (!verdict.difference) return std::nullopt;
    verdict.agree = verdict.difference->within(command.tolerance);
    return verdict;
}

void refuse_large_difference(const CompareCommand& command) {
    const auto actual = png_size(command.actual), expected = png_size(command.expected);
    if (actual && expected && too_large_to_show(*actual, *expected))
        throw InputError("--diff: pictures of " + std::to_string(actual->x) + "x" + std::to_string(actual->y) +
                         " pixels are too large to be laid side by side; compare without it");
}

}  // namespace

int run(const CompareCommand& command) {
    FilesOfRun files;
    files.reads(command.actual, "ACTUAL " + command.actual.string());
    files.reads(command.expected, "EXPECTED " + command.expected.string());
    if (command.diff) files.writes(*command.diff, "--diff");
    if (command.diff) refuse_large_difference(command);
    Image actual, expected;  // which not every comparison needs
    std::optional<Verdict> quick;
    if (!command.diff) quick = quick_verdict(command);
    if (!quick) {
        actual = read_png(command.actual);
        expected = read_png(command.expected);
    }
    const Verdict verdict = quick ? *quick : judge(actual, expected, command.tolerance);
    const std::string result =
        (command.json ? json_text(verdict.json()) : (verdict.agree ? "agree: " : "differ: ") + verdict.line()) + "\n";
    if (command.diff) write(*command.diff, png_bytes(difference_picture(actual, expected, command.tolerance)));
    if (command.diff && command.diff->is_standard())
        std::fputs(result.c_str(), stderr);  // not into the picture
    else
        print(result);
    return verdict.agree ? 0 : 1;
}

int compare_capture(const CaptureCommand& command, const Image& actual) {
    std::error_code ignored;
    if (!std::filesystem::exists(*command.expected, ignored))
        throw InputError(command.expected->string() + ": no such file; look at " + command.output.file.string() +
                         " and copy it there");
    const Image expected = read_png(*command.expected);
    const Verdict verdict = judge(actual, expected, command.tolerance);
    print((verdict.agree ? "agree: " : "differ: ") + command.output.file.string() + ": " + verdict.line() + "\n");
    if (verdict.agree)
        remove_evidence(command.output.file, *command.expected);
    else
        leave_evidence(command.output.file, *command.expected, actual, expected, command.tolerance);
    return verdict.agree ? 0 : 1;
}

}  // namespace normalscope
