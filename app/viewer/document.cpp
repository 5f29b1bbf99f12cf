#include "viewer/document.h"

#include <algorithm>
#include <filesystem>
#include <ranges>
#include <set>

namespace normalscope {

namespace {

// Meshes have files, too, and what is built in has none.
bool is_scene_file(const std::filesystem::path& file) {
    std::error_code error;
    return file.extension() == ".json" && std::filesystem::is_regular_file(file, error);
}

bool is_unsaved(const Work& work) {
    const Origin& origin = *work.origin;
    if (work.draft.lesson) return work.draft.lesson != origin.saved_lesson;
    if (origin.is_play) return false;
    Scene now = work.scene;
    now.theme = origin.saved.theme;  // the room's light
    if (!origin.is_the_users) now.camera = origin.saved.camera;
    return now != origin.saved;
}

std::shared_ptr<Origin> origin_of(const Scene& scene, const std::string& file) {
    return std::make_shared<Origin>(Origin{file, is_scene_file(file), scene});
}

}  // namespace

bool as_named(const Work& work) {
    const Scene &scene = work.scene, &named = work.origin->saved;
    return scene.about != named.about || (scene.surface == named.surface && scene.stack == named.stack &&
                                          scene.mistake == named.mistake && scene.power == named.power);
}

Scene given(const Work& work) {
    Scene given = work.scene;
    if (!as_named(work)) given.about.clear();
    return given;
}

Document::Document(Scene first, const std::string& file)
    : scene(std::move(first)), origin_(origin_of(scene, file)), history_({scene, origin_}) {}

bool Document::unsaved() const { return is_unsaved({scene, origin_, draft}); }

bool Document::as_opened() const {
    Scene now = scene;
    now.theme = origin_->saved.theme;
    return now == origin_->saved;
}

std::vector<Work> Document::all_unsaved() const {
    std::vector<Work> works;
    std::set<const Origin*> seen;  // of each, only the last state counts
    const auto look_at = [&](const Work& work) {
        if (seen.contains(work.origin.get())) return;
        for (const Origin* o = work.origin.get(); o; o = o->goes_on_from.get()) seen.insert(o);
        if (is_unsaved(work)) works.push_back(work);
    };
    look_at({scene, origin_, draft});
    std::ranges::for_each(history_.done() | std::views::reverse, look_at);
    std::ranges::reverse(works);
    return works;
}

void Document::open(Scene opened, const std::string& file) {
    scene = std::move(opened);
    origin_ = origin_of(scene, file);
    draft = {};
}

void Document::open_mesh(Scene with_mesh, const std::string& file) {
    std::shared_ptr<Origin> origin = origin_of(with_mesh, file);
    if (unsaved()) {
        origin->saved = origin_->saved;
        if (!has_file()) origin->goes_on_from = origin_;
    }
    take({std::move(with_mesh), std::move(origin)});
}

void Document::go_back_to(const Work& work) {
    commit();
    take(work);
}

void Document::recover(const UnsavedWork& work) {
    if (work.draft.lesson) {
        commit();
        scene = work.scene;
        return write(work.file, work.draft, nullptr);
    }
    const std::optional<Scene> saved = saved_scene(work.file);
    std::shared_ptr<Origin> origin = origin_of(saved.value_or(Scene{}), work.file);
    if (!saved) origin->is_the_users = false;  // it may be a lesson's by now
    go_back_to({work.scene, std::move(origin)});
}

void Document::saved_as(const std::string& file) {
    *origin_ = {file, is_scene_file(file), scene, false, origin_->goes_on_from};
}

}  // namespace normalscope
