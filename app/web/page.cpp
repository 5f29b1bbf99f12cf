#include "web/page.h"

#include "core/base/error.h"
#include "core/base/file.h"
#include "web/browser.h"

#include <emscripten/html5.h>
#include <imgui.h>

#include <array>
#include <cstdlib>

namespace normalscope {

namespace {

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

// Whether anything moves is the browser's to say, each time; and files are gone with the page.
std::string kept(Remembered remembered) {
    remembered.motion = true;
    remembered.recent_files.clear();
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

Page::Page(glm::ivec2 size, float scale, Opened first, Remembered remembered)
    : size_(size), scale_(scale), context_(make_context()), remembered_(kept(remembered)) {
    viewer_ = std::make_unique<Viewer>(*this, std::move(first), std::move(remembered));
    screen_ = std::make_unique<Screen>();  // Dear ImGui's context is the viewer's
}

Page::~Page() {
    screen_.reset();
    emscripten_webgl_destroy_context(context_);
}

void Page::resize(glm::ivec2 size, float scale) {
    size_ = size;
    scale_ = scale;
    viewer_->expose();
}

// What is lost need not be deleted, but that does no harm either.
void Page::lose() { screen_.reset(); }

void Page::restore() {
    emscripten_webgl_make_context_current(context_);
    screen_ = std::make_unique<Screen>();
    screen_->upload_fonts();
    viewer_->expose();
}

void Page::remember() {
    std::string now = kept(viewer_->remembered());
    if (now != remembered_) page_remember("settings", (remembered_ = std::move(now)).c_str());
}

double Page::now() const { return emscripten_get_now() / 1000.0; }

void Page::upload_fonts() {
    if (screen_) screen_->upload_fonts();
}

void Page::draw(const Picture& picture) { screen_->draw(picture, size_); }

void Page::show() {
    screen_->show();
    page_cursor(cursor());
}

Image Page::image_of(const Frame& frame) { return screen_->image_of(frame, size_); }

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
