#pragma once

#include "core/scene/history.h"
#include "core/scene/scene.h"

#include <memory>
#include <string>

namespace normalscope {

/// What a scene comes from, and what it was there. All its states that can be undone share it, so that a scene which is
/// saved under another name has that name also after an undo.
struct Origin {
    std::string file;           ///< or the name of whatever is built in; empty: none
    bool is_the_users = false;  ///< a scene file, which can be saved to without asking
    Scene saved;
};

/// The scene, its name, and what can be undone: an undo brings back both.
class Document {
public:
    Document(Scene first, const std::string& file);

    Scene scene;  ///< as it is being edited

    const std::string& file() const { return origin_->file; }
    bool has_file() const { return origin_->is_the_users; }
    /// There is work that no file holds. How one looks at a scene is none where it has no file of its own.
    bool unsaved() const;

    /// Another scene, which is as it is in its file.
    void open(Scene opened, const std::string& file);
    /// The scene comes from a lesson from now on: saving it to the lesson's file would lose the steps.
    void open_lesson(const std::string& name);
    /// Work of an earlier session, which no file holds.
    void recover(Scene unsaved);
    /// The same scene is called that from now on.
    void saved_as(const std::string& file);
    /// The scene as it is now counts as saved.
    void settle() { origin_->saved = scene; }
    /// Exercises come and go, and the scene's origin with them.
    std::shared_ptr<Origin> origin() const { return origin_; }
    void set_origin(std::shared_ptr<Origin> origin) { origin_ = std::move(origin); }

    /// What has been done becomes one step to undo.
    void commit() { history_.commit({scene, origin_}); }
    bool can_undo() const { return history_.can_undo(); }
    bool can_redo() const { return history_.can_redo(); }
    void undo() { take(history_.undo()); }
    void redo() { take(history_.redo()); }
    /// The last step is still good.
    void go_back_to_last() { take(history_.current()); }

private:
    struct State {
        Scene scene;
        std::shared_ptr<Origin> origin;
        friend bool operator==(const State&, const State&) = default;
    };
    void take(const State& state) {
        scene = state.scene;
        origin_ = state.origin;
    }

    std::shared_ptr<Origin> origin_;
    History<State> history_;
};

}  // namespace normalscope
