#include "platform/offscreen_context.h"

#include "core/base/error.h"
#include "core/base/system.h"
#include "core/base/text.h"
#include "platform/offscreen_ways.h"

#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

namespace normalscope {

namespace {

/// A variable of the environment, set while one lives unless the user has set it: Mesa can be told some things in no other
/// way, and reads them once, when a process makes its first context. Nothing that is started later shall find them.
class SetForNow {
public:
    SetForNow(const char* name, const std::string& value) : name_(std::getenv(name) ? nullptr : name) {
        if (name_) set_variable(name_, value);
    }
    ~SetForNow() {
        if (name_) set_variable(name_, std::nullopt);
    }
    SetForNow(const SetForNow&) = delete;
    SetForNow& operator=(const SetForNow&) = delete;

private:
    const char* name_;
};

// What else can be asked for: "--context egl".
std::string others(ContextChoice choice) {
    std::vector<std::string> words;
    for (const OffscreenWay& way : offscreen_ways())
        if (way.choice != choice) words.push_back("--context " + std::string(way.word));
    return alternatives(words);
}

std::unique_ptr<Context> make_context(ContextChoice choice) {
    std::string reasons;
    std::vector<std::string> remedies;
    for (const OffscreenWay& way : offscreen_ways()) try {
            if (choice == ContextChoice::Auto || choice == way.choice) return way.make();
        } catch (const ContextError& e) {
            reasons += (reasons.empty() ? "" : "; ") + std::string(way.name) + ": " + e.what();
            remedies.emplace_back(remedy(way.missing));
        }
    if (choice != ContextChoice::Auto) remedies.push_back("use " + others(choice));
    throw ContextError("no graphics context: " + reasons + "; " + joined(remedies, ", or "));
}

}  // namespace

std::unique_ptr<Context> make_offscreen_context(const ContextOptions& options) {
    const SetForNow silence("EGL_LOG_LEVEL", "fatal");  // what is wrong is said in one line, once all has been tried
    std::optional<SetForNow> shaders, threads;
    if (options.quick_shaders) shaders.emplace("GALLIVM_PERF", "nopt");
    if (options.threads > 0) threads.emplace("LP_NUM_THREADS", std::to_string(options.threads));
    return make_context(options.choice);
}

}  // namespace normalscope
