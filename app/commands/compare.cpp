#include "commands/compare.h"

#include "commands/commands.h"
#include "commands/verdict.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/json_text.h"
#include "core/image/png.h"

#include <nlohmann/json.hpp>

#include <cstdio>

namespace normalscope {

int run(const CompareCommand& command) {
    const Image actual = read_png(command.actual), expected = read_png(command.expected);
    const Verdict verdict = judge(actual, expected, command.tolerance);
    const std::string result =
        (command.json ? json_text(verdict.json()) : (verdict.agree ? "agree: " : "differ: ") + verdict.line()) + "\n";
    if (command.diff) write_png(*command.diff, difference_picture(actual, expected, command.tolerance));
    if (command.diff == "/dev/stdout")
        std::fputs(result.c_str(), stderr);  // not into the picture
    else
        write_file("/dev/stdout", result);
    return verdict.agree ? 0 : 1;
}

int compare_capture(const CaptureCommand& command, const Image& actual) {
    std::error_code ignored;
    if (!std::filesystem::exists(*command.expected, ignored))
        throw InputError(command.expected->string() + ": no such file; look at " + command.output.string() +
                         " and copy it there");
    const Image expected = read_png(*command.expected);
    const Verdict verdict = judge(actual, expected, command.tolerance);
    write_file("/dev/stdout",
               (verdict.agree ? "agree: " : "differ: ") + command.output.string() + ": " + verdict.line() + "\n");
    if (verdict.agree)
        remove_evidence(command.output, *command.expected);
    else
        leave_evidence(command.output, actual, *command.expected, expected, command.tolerance);
    return verdict.agree ? 0 : 1;
}

}  // namespace normalscope
