#include "viewer/document.h"

#include <filesystem>

namespace normalscope {

namespace {

// Meshes have files, too, and what is built in has none.
bool is_scene_file(const std::filesystem::path& file) {
    std::error_code error;
    return file.extension() == ".json" && std::filesystem::is_regular_file(file, error);
}

std::shared_ptr<Origin> origin_of(const Scene& scene, const std::string& file) {
    return std::make_shared<Origin>(Origin{file, is_scene_file(file), scene});
}

}  // namespace

Document::Document(Scene first, const std::string& file)
    : scene(std::move(first)), origin_(origin_of(scene, file)), history_({scene, origin_}) {}

bool Document::unsaved() const {
    Scene now = scene;
    now.theme = origin_->saved.theme;  // the room's light
    if (!has_file()) now.camera = origin_->saved.camera;
    return now != origin_->saved;
}

void Document::open(Scene opened, const std::string& file) {
    scene = std::move(opened);
    origin_ = origin_of(scene, file);
}

void Document::open_lesson(const std::string& name) {
    origin_ = std::make_shared<Origin>(Origin{.file = name, .saved = scene});
}

void Document::recover(Scene unsaved) {
    commit();
    scene = std::move(unsaved);
    origin_ = origin_of({}, "");
}

void Document::saved_as(const std::string& file) { *origin_ = {file, is_scene_file(file), scene}; }

}  // namespace normalscope
