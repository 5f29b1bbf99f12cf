#include "commands/live_handout.h"

#include "core/base/base64.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/html.h"
#include "core/base/own_page.h"
#include "core/base/system.h"
#include "core/lessons/link.h"

#include <embedded.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <variant>

namespace normalscope {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestPage = std::size_t{1} << 26, kLargestMesh = std::size_t{1} << 29;

fs::path page_file() {
    if (fs::path page = own_page(); !page.empty()) return page;
    throw InputError(
        "normalscope.html",
        "the program as a page, which --live puts in, is not beside the program; put it there, or build it "
        "by ./dev web");
}

std::string with(std::string text, std::string_view placeholder, const std::string& value) {
    return text.replace(text.find(placeholder), placeholder.size(), value);
}

}  // namespace

LiveHandout::LiveHandout(FilesOfRun& files) {
    const fs::path file = page_file();
    files.reads(file, text_of(file));
    page_ = read_file(file, kLargestPage);
}

std::string LiveHandout::policy() {
    return "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'unsafe-inline' "
           "'wasm-unsafe-eval'; style-src 'unsafe-inline'; img-src data: blob:; form-action 'none'; base-uri "
           "'none'\">\n";
}

std::string LiveHandout::attributes(Scene scene) {
    if (auto* mesh = std::get_if<MeshSurface>(&scene.surface)) {
        std::string& name = names_[mesh->mesh];
        if (name.empty()) name = std::to_string(names_.size()) + "-" + fs::path(mesh->mesh).filename().string();
        mesh->mesh = "/" + name;
    }
    return " data-scene=\"" + html_text(link_of(scene)) + "\"";
}

std::string LiveHandout::program() const {
    nlohmann::ordered_json files = nlohmann::ordered_json::object();
    for (const auto& [path, name] : names_) files[name] = base64(read_file(path, kLargestMesh));
    std::string html(embedded::file("assets/live_handout.html").value());
    html = with(std::move(html), "@FILES@", html_text(files.dump()));
    return with(std::move(html), "@PAGE@", html_text(page_));
}

}  // namespace normalscope
