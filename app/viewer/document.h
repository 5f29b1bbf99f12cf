#pragma once

#include "core/lessons/unsaved_work.h"
#include "core/lessons/writing.h"
#include "core/scene/history.h"
#include "core/scene/scene.h"

#include <memory>
#include <string>
#include <vector>

namespace normalscope {

/// What a scene comes from, and what it was there. All its states that can be undone share it, so that a scene which is
/// saved under another name has that name also after an undo.
struct Origin {
    std::string file;           ///< or the name of whatever is built in; empty: none
    bool is_the_users = false;  ///< a scene file, which can be saved to without asking
    Scene saved;
    bool is_play = false;  ///< a lesson's or an exercise's: what is done there is no work
    /// Where a mesh was opened into work that has no file, that work is this one by now.
    std::shared_ptr<const Origin> goes_on_from{};
    std::shared_ptr<const Lesson> saved_lesson{};  ///< of a lesson that is written: what its file holds
};

/// A scene and what it comes from.
struct Work {
    Scene scene;
    std::shared_ptr<Origin> origin;
    Draft draft{};  ///< a lesson that is written: it is what is to be saved, and not the scene
    friend bool operator==(const Work&, const Work&) = default;
};

/// Surface and map are those of which the scene's `about` speaks.
bool as_named(const Work& work);
/// The scene for others, and for another session: without an `about` that speaks of something else.
Scene given(const Work& work);

/// The scene, its name, and what can be undone: an undo brings back both.
class Document {
public:
    Document(Scene first, const std::string& file);

    Scene scene;  ///< as it is being edited
    Draft draft;  ///< the lesson that is being written, if one is

    const std::string& file() const { return origin_->file; }
    bool has_file() const { return origin_->is_the_users; }
    bool as_named() const { return normalscope::as_named({scene, origin_, draft}); }
    Scene given() const { return normalscope::given({scene, origin_, draft}); }
    /// There is work that no file holds. How one looks at a scene is none where it has no file of its own.
    bool unsaved() const;
    /// It is what its file holds, and seen as it was there; but for the room's light.
    bool as_opened() const;
    /// All such work that an undo leads back to, also from before another scene was opened; the newest is the last.
    std::vector<Work> all_unsaved() const;

    /// Another scene, which is as it is in its file.
    void open(Scene opened, const std::string& file);
    /// A mesh in place of the surface: what else has been done to the scene is as unsaved as it was.
    void open_mesh(Scene with_mesh, const std::string& file);
    /// A lesson or exercises, whose scenes are no work, begin with the scene as it is: saving it to a lesson's file would
    /// lose the steps.
    void play(const std::string& name) {
        origin_ = std::make_shared<Origin>(Origin{name, false, scene, true});
        draft = {};
    }
    /// A lesson is written from now on, of which a file, or the program, holds `saved`.
    void write(const std::string& name, Draft begun, std::shared_ptr<const Lesson> saved) {
        play(name);
        draft = std::move(begun);
        origin_->saved_lesson = std::move(saved);
    }
    /// The lesson that is written is in that file by now.
    void lesson_saved_as(const std::string& file) {
        origin_->file = file;
        origin_->saved_lesson = draft.lesson;
    }
    bool unsaved_lesson() const { return draft.lesson && draft.lesson != origin_->saved_lesson; }
    /// The lesson is left, and the scene stays. An undo leads back to what has been written.
    void leave_lesson() {
        if (draft.lesson)
            open(scene, "");
        else
            settle();
    }
    /// To work that was left.
    void go_back_to(const Work& work);
    /// Work of an earlier session, which no file holds.
    void recover(const UnsavedWork& work);
    /// The same scene is called that from now on.
    void saved_as(const std::string& file);
    /// The scene as it is now counts as saved.
    void settle() { *origin_ = {origin_->file, origin_->is_the_users, scene}; }
    /// Nothing that is unsaved matters any more.
    void discard() {
        for (const Work& work : all_unsaved()) {
            work.origin->saved = work.scene;
            work.origin->saved_lesson = work.draft.lesson;
        }
    }
    /// Exercises come and go, and the scene's origin with them.
    std::shared_ptr<Origin> origin() const { return origin_; }
    void set_origin(std::shared_ptr<Origin> origin) { origin_ = std::move(origin); }

    /// What has been done becomes one step to undo.
    void commit() { history_.commit({scene, origin_, draft}); }
    bool can_undo() const { return history_.can_undo(); }
    bool can_redo() const { return history_.can_redo(); }
    void undo() { take(history_.undo()); }
    void redo() { take(history_.redo()); }
    /// The last step is still good.
    void go_back_to_last() { take(history_.current()); }

private:
    void take(const Work& work) {
        scene = work.scene;
        origin_ = work.origin;
        draft = work.draft;
    }

    std::shared_ptr<Origin> origin_;
    History<Work> history_;
};

}  // namespace normalscope
