// What a formula's surface costs while one works on it, drawn off-screen as the window draws it: dragging a parameter of a
// torus, and the time from a new formula to its picture. Prints one line of JSON.

#include "core/frame.h"
#include "core/scene_file.h"
#include "core/surface.h"
#include "gl/renderer.h"
#include "gl/target.h"
#include "gui.h"
#include "platform/context.h"

#include <glad/gl.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

using namespace normalscope;

namespace {

constexpr glm::ivec2 kSize(1280, 720);

class Window {
public:
    /// Of the whole frame, from the scene to the last pixel.
    double milliseconds(const Scene& scene, bool draft) {
        const auto start = std::chrono::steady_clock::now();
        const Frame frame =
            make_frame(scene, surfaces_.get(scene), {.rect = gui_.interface.picture(kSize), .draft = draft});
        Scene shown = scene;
        gui_.layout(kSize, scene.theme, 1.0f, [&] { gui_.interface.draw(shown, frame, {}); });
        renderer_.draw(frame, draft ? rough_target_ : target_);
        gui_.draw();
        glFinish();
        const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
        return took.count();
    }

private:
    Target target_{kSize, 4}, rough_target_{kSize, 1};
    Renderer renderer_;
    Gui gui_{Gui::Brush::Gl};
    SurfaceCache surfaces_;
};

double median(int count, const std::function<double(int)>& measure) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i) values.push_back(measure(i));
    std::nth_element(values.begin(), values.begin() + count / 2, values.end());
    return values[static_cast<std::size_t>(count / 2)];
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
    const auto context = make_offscreen_context(ContextChoice::Auto);
    context->make_current();
    Window window;
    const std::string torus = "(x^2+y^2+z^2+a-0.1)^2-4a(x^2+y^2)";
    for (int i = 0; i < 3; ++i) window.milliseconds(with_formula(torus, 0.8), i > 0);
    const double drag =
        median(40, [&](int i) { return window.milliseconds(with_formula(torus, 0.8 + 0.005 * i), true); });
    const double still =
        median(15, [&](int i) { return window.milliseconds(with_formula(torus, 0.8 + 0.005 * i), false); });
    // Another number in it each time: nothing that was compiled before serves again.
    const double anew = median(15, [&](int i) {
        return window.milliseconds(with_formula("x^3+y^2z-" + std::to_string(i + 2) + "/7x y-z^2"), true);
    });
    std::printf("{\"drag_ms\": %.1f, \"still_ms\": %.1f, \"new_formula_ms\": %.1f}\n", drag, still, anew);
}
