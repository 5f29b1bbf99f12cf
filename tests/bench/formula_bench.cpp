// What a formula's surface costs while one works on it, drawn off-screen as the window draws it: dragging a parameter of a
// torus; and the time from a new formula to its picture while one types, and to its traced one when one pauses, for which
// the driver compiles a program. Prints one line of JSON.

#include "bench_gui.h"
#include "core/frame/frame.h"
#include "core/lessons/open.h"
#include "core/picture/make_frame.h"
#include "core/surface/surface.h"
#include "measure.h"
#include "platform/offscreen_context.h"

#include <glad/gl.h>

#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

using namespace normalscope;

namespace {

constexpr glm::ivec2 kSize(1280, 720);

class Window {
public:
    /// Of the whole frame, from the scene to the last pixel.
    double milliseconds(const Scene& scene, Quality quality) {
        const Stopwatch watch;
        const Frame frame =
            make_frame(scene, surfaces_.get(scene), {.rect = gui_.interface().picture(kSize), .quality = quality});
        Scene shown = scene;
        gui_.layout(scene.theme, 1.0f, [&] { gui_.interface().draw(shown, frame, {}); });
        gui_.draw({.frame = frame, .rough = quality != Quality::Fine, .timed = true});
        glFinish();
        return watch.milliseconds();
    }

private:
    BenchGui gui_{kSize};
    SurfaceCache surfaces_;
};

double median_of(int count, const std::function<double(int)>& measure) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i) values.push_back(measure(i));
    return median(values);
}

Scene with_formula(const std::string& text, double a = 1.0) {
    Scene scene = load_scene(std::string(kDefaultScene));
    FormulaSurface formula{.formula = text};
    formula.parameters[0] = a;
    scene.surface = formula;
    return scene;
}

}  // namespace

int main() {
    setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);  // or a second run would find its new formulas compiled
    const auto context = make_offscreen_context({});
    context->make_current();
    Window window;
    const std::string torus = "(x^2+y^2+z^2+a-0.1)^2-4a(x^2+y^2)";
    for (int i = 0; i < 3; ++i) window.milliseconds(with_formula(torus, 0.8), i > 0 ? Quality::Draft : Quality::Fine);
    const double drag =
        median_of(40, [&](int i) { return window.milliseconds(with_formula(torus, 0.8 + 0.005 * i), Quality::Draft); });
    const double still =
        median_of(15, [&](int i) { return window.milliseconds(with_formula(torus, 0.8 + 0.005 * i), Quality::Fine); });
    // Another number in it each time: nothing that was compiled before serves again.
    const auto anew = [&](Quality quality, int first) {
        return median_of(15, [&, quality](int i) {
            return window.milliseconds(with_formula("x^3+y^2z-" + std::to_string(first + i) + "/7x y-z^2"), quality);
        });
    };
    const double sketched = anew(Quality::Sketch, 2), traced = anew(Quality::Fine, 102);
    std::printf("{\"drag_ms\": %.1f, \"still_ms\": %.1f, \"new_formula_ms\": %.1f, \"new_formula_traced_ms\": %.1f}\n",
                drag, still, sketched, traced);
}
