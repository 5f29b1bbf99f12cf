#include "platform/offscreen_context.h"

#include "core/base/error.h"
#include "core/base/system.h"
#include "core/base/text.h"
#include "platform/mesa_settings.h"
#include "platform/offscreen_ways.h"
#include "platform/shared_library.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace normalscope {

namespace {

// What else can be asked for: "--context egl".
std::string others(ContextChoice choice) {
    std::vector<std::string> words;
    for (const OffscreenWay& way : offscreen_ways())
        if (way.choice != choice) words.push_back("--context " + std::string(way.word));
    return alternatives(words);
}

std::unique_ptr<Context> make_context(ContextChoice choice) {
    const std::span<const OffscreenWay> ways = offscreen_ways();
    // Where a system has a way of its own, nobody misses the libraries of the others.
    const bool has_own = choice == ContextChoice::Auto && ways.front().choice == ContextChoice::Auto;
    std::vector<std::string> reasons, remedies;
    for (const OffscreenWay& way : ways) try {
            if (choice == ContextChoice::Auto || choice == way.choice) return way.make();
        } catch (const MissingLibrary& e) {
            if (has_own) continue;
            reasons.push_back(std::string(way.name) + ": " + e.what());
            remedies.emplace_back(remedy(way.missing));
        } catch (const ContextError& e) {
            reasons.push_back(std::string(way.name) + ": " + e.what());
        }
    if (remedies.empty()) remedies.emplace_back(remedy(Missing::OpenGl));
    if (choice != ContextChoice::Auto) remedies.push_back("use " + others(choice));
    throw ContextError("no graphics context: " + joined(reasons, "; ") + "; " + joined(remedies, ", or "));
}

}  // namespace

std::unique_ptr<Context> make_offscreen_context(const ContextOptions& options) {
    prefer_large_pages_from_now_on();
    const SetForNow silence("EGL_LOG_LEVEL", "fatal");  // what is wrong is said in one line, once all has been tried
    const ShadersByWidth kept;
    std::optional<SetForNow> shaders, threads;
    if (options.quick_shaders) shaders.emplace("GALLIVM_PERF", "nopt");
    if (options.threads > 0) threads.emplace("LP_NUM_THREADS", std::to_string(options.threads));
    return make_context(options.choice);
}

}  // namespace normalscope
