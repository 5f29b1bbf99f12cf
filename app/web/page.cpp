#include "web/page.h"

#include "core/base/error.h"
#include "core/base/file.h"
#include "web/browser.h"

#include <emscripten/html5.h>
#include <imgui.h>
#include <imgui_impl_opengl3.h>

#include <array>
#include <cstdlib>

namespace normalscope {

namespace {

constexpr int kSamples = 4;
constexpr std::size_t kLargestSaved = std::size_t{1} << 28;

EMSCRIPTEN_WEBGL_CONTEXT_HANDLE make_context() {
    EmscriptenWebGLContextAttributes wanted;
    emscripten_webgl_init_context_attributes(&wanted);
    wanted.majorVersion = 2;
    wanted.alpha = wanted.depth = wanted.stencil = wanted.antialias = false;  // the renderer has its own framebuffer
    const auto context = emscripten_webgl_create_context("#canvas", &wanted);
    if (context == 0) throw ContextError("this browser has no WebGL 2, or it is turned off");
    emscripten_webgl_make_context_current(context);
    return context;
}

// Whether anything moves is the browser's to say, each time.
std::string kept(Remembered remembered) {
    remembered.motion = true;
    return remembered_text(remembered);
}

const char* cursor() {
    switch (ImGui::GetMouseCursor()) {
        case ImGuiMouseCursor_None: return "none";
        case ImGuiMouseCursor_TextInput: return "text";
        case ImGuiMouseCursor_ResizeNS: return "ns-resize";
        case ImGuiMouseCursor_ResizeEW: return "ew-resize";
        case ImGuiMouseCursor_Hand: return "pointer";
        default: return "default";
    }
}

}  // namespace

struct Page::Drawing {
    Drawing() { ImGui_ImplOpenGL3_Init("#version 300 es"); }
    ~Drawing() { ImGui_ImplOpenGL3_Shutdown(); }
    Drawing(const Drawing&) = delete;
    Drawing& operator=(const Drawing&) = delete;

    Renderer renderer;
    std::optional<Target> target, rough_target;  // the latter while something moves that takes its time
    Target* last = nullptr;
};

Page::Page(glm::ivec2 size, float scale, Opened first, Remembered remembered)
    : size_(size), scale_(scale), context_(make_context()), remembered_(kept(remembered)) {
    viewer_ = std::make_unique<Viewer>(*this, std::move(first), std::move(remembered));
    drawing_ = std::make_unique<Drawing>();  // Dear ImGui's context is the viewer's
}

Page::~Page() {
    drawing_.reset();
    emscripten_webgl_destroy_context(context_);
}

void Page::resize(glm::ivec2 size, float scale) {
    size_ = size;
    scale_ = scale;
    viewer_->expose();
}

// What is lost need not be deleted, but that does no harm either.
void Page::lose() { drawing_.reset(); }

void Page::restore() {
    emscripten_webgl_make_context_current(context_);
    drawing_ = std::make_unique<Drawing>();
    upload_fonts();
    viewer_->expose();
}

void Page::remember() {
    std::string now = kept(viewer_->remembered());
    if (now != remembered_) page_remember("settings", (remembered_ = std::move(now)).c_str());
}

double Page::now() const { return emscripten_get_now() / 1000.0; }

void Page::upload_fonts() {
    if (!drawing_) return;
    // The backend's NewFrame uploads a new font atlas only where it makes everything anew.
    ImGui_ImplOpenGL3_DestroyDeviceObjects();
    ImGui_ImplOpenGL3_NewFrame();
}

Target& Page::target(bool rough) {
    Drawing& d = *drawing_;
    if (!d.target || d.target->size() != size_) {
        d.target.reset();
        d.rough_target.reset();
        d.target.emplace(size_, kSamples);
    }
    if (rough && !d.rough_target) d.rough_target.emplace(size_, 1);
    return rough ? *d.rough_target : *d.target;
}

void Page::draw(const Picture& picture) {
    Drawing& d = *drawing_;
    const bool first = !d.last;
    d.last = &target(picture.rough);
    d.renderer.coarsen_drafts(picture.coarse);
    if (picture.anew || first)
        d.renderer.draw(picture.frame, *d.last);
    else
        d.renderer.draw_again(picture.frame, *d.last);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    if (picture.timed) Target::finish();
}

void Page::show() {
    drawing_->last->show();
    page_cursor(cursor());
}

Image Page::image_of(const Frame& frame) {
    Target& whole = target(false);
    drawing_->renderer.draw(frame, whole);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    return whole.read();
}

std::optional<LetterPicture> Page::draw_letter(char32_t letter, float em) {
    std::array<float, 5> measures{};
    unsigned char* cover = page_draw_letter(letter, em, measures.data());
    if (!cover) return std::nullopt;
    const auto [width, height, left, above, advance] = measures;
    LetterPicture picture{.width = static_cast<int>(width),
                          .height = static_cast<int>(height),
                          .left = left,
                          .above = above,
                          .advance = advance};
    picture.cover.assign(cover, cover + static_cast<std::ptrdiff_t>(picture.width) * picture.height);
    std::free(cover);
    return picture;
}

void Page::set_clipboard(const std::string& text) {
    clipboard_ = text;
    page_copy(text.c_str());
}

void Page::set_title(const std::string& title) { page_title(title.c_str()); }
bool Page::full_screen() const { return page_is_full_screen() != 0; }
void Page::toggle_full_screen() { page_toggle_full_screen(); }

bool Page::choose_file() {
    page_choose_file();
    return true;
}

void Page::saved(const std::filesystem::path& file) {
    const std::string bytes = read_file(file, kLargestSaved);
    page_download(file.filename().c_str(), bytes.data(), bytes.size());
}

std::string Page::address_of(const std::string& link) const {
    char* address = page_address(link.c_str());
    std::string result = address;
    std::free(address);
    return result;
}

void Page::keep(const std::string& scene) { page_remember("unsaved", scene.c_str()); }

}  // namespace normalscope
