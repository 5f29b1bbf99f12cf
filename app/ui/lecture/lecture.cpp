#include "ui/lecture/lecture.h"

#include "core/lessons/scene_caption.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace normalscope {

namespace {

// What the picture leaves of the room.
StripRoom beside(const PixelRect& room, const PixelRect& picture) {
    const glm::vec2 low(room.origin), size(room.size), taken(picture.size);
    if (picture.size.x < room.size.x)
        return {{low.x + taken.x, low.y}, {size.x - taken.x, size.y}, StripPlace::Side::Beside};
    return {{low.x, low.y + taken.y}, {size.x, size.y - taken.y}, StripPlace::Side::Below};
}

}  // namespace

void Lecture::start(std::shared_ptr<const Lesson> lesson, const Scene& scene, std::optional<std::size_t> step) {
    const auto left_at = progress.find(lesson->name);
    std::size_t first = step.value_or(left_at == progress.end() ? 0 : left_at->second);
    if (!step && first + 1 >= lesson->steps.size()) first = 0;  // it had been gone through
    exercises.stop();
    // Whoever comes back to a step has answered what has been answered.
    if (!player.running() || player.lesson().name != lesson->name || !step)
        player.start(std::move(lesson), first, scene);
    go_to(first, scene);
}

void Lecture::replace(std::shared_ptr<const Lesson> lesson, const Scene& scene) {
    player.replace(std::move(lesson), player.number());
    go_to(player.number(), scene);
}

void Lecture::follow(const Draft& draft) {
    exercises.stop();
    player.replace(draft.lesson, draft.step);
    announced_ = Announced::Nothing;
}

void Lecture::leave(Scene& scene) {
    player.stop();
    exercises.leave(scene);
    tab_.reset();
    if (std::exchange(opened_tab_, false)) tab_ = "";
}

void Lecture::go_to(std::size_t step, const Scene& scene) {
    announced_ = Announced::Nothing;
    player.go_to(step, scene);
    takes_before_ = takes_;
    progress[player.lesson().name] = player.number();
    const std::string& tab = player.step().tab;
    if (!tab.empty() || opened_tab_) tab_ = tab;
    opened_tab_ = !tab.empty();
}

std::optional<std::string> Lecture::wanted_tab() { return std::exchange(tab_, std::nullopt); }

bool Lecture::press(LectureKey key, Scene& scene, const Frame* frame) {
    switch (key) {
        case LectureKey::Black:
        case LectureKey::White:
            if (!presenting) return false;
            blank_ = key == LectureKey::Black ? Theme::Dark : Theme::Light;
            return true;
        default: break;
    }
    if (exercises.running()) return press_in_exercise(key, scene, frame);
    return player.running() && press_in_lesson(key, scene);
}

bool Lecture::press_in_lesson(LectureKey key, const Scene& scene) {
    switch (key) {
        case LectureKey::Next:
        case LectureKey::Enter:
        case LectureKey::Right: return go_on(scene);
        case LectureKey::Previous:
        case LectureKey::Left: return go_back(scene);
        case LectureKey::Again: go_to(player.number(), scene); return true;
        case LectureKey::Last: go_to(player.lesson().steps.size() - 1, scene); return true;
        default: {
            if (key < LectureKey::First || !player.step().question || announced_ != Announced::Nothing) return false;
            player.choose(static_cast<std::size_t>(key) - static_cast<std::size_t>(LectureKey::First));
            return true;
        }
    }
}

bool Lecture::go_on(const Scene& scene) {
    if (announced_ == Announced::Previous) {
        announced_ = Announced::Nothing;  // back to the first step
        return true;
    }
    if (player.asking()) {  // a remote control has no letters
        player.reveal();
        if (!player.asking()) return true;
    }
    if (player.has_next())
        go_to(player.number() + 1, scene);
    else if (const auto next = next_lesson(); next && std::exchange(announced_, Announced::Next) == Announced::Next)
        wanted_lesson_ = next->name;
    return true;
}

const char* Lecture::next_does() const {
    if (player.asking()) return "The answer (Page Down, right arrow)";
    if (player.has_next()) return "Next step (Page Down, right arrow)";
    return next_lesson() ? "Next lesson (Page Down, right arrow)" : nullptr;
}

bool Lecture::go_back(const Scene& scene) {
    if (announced_ == Announced::Next)
        announced_ = Announced::Nothing;  // back to the last step
    else if (player.has_previous())
        go_to(player.number() - 1, scene);
    else if (const auto previous = previous_lesson();
             previous && std::exchange(announced_, Announced::Previous) == Announced::Previous)
        wanted_lesson_ = previous->name + "#" + std::to_string(previous->steps);
    return true;
}

std::optional<ListedLesson> Lecture::neighbour(int places) const {
    const std::vector<ListedLesson>& lessons = shelf.lessons;
    const auto it = std::ranges::find_if(
        lessons, [&](const ListedLesson& lesson) { return same_lesson(lesson.name, player.lesson().name); });
    const auto at = it - lessons.begin() + places;
    if (it == lessons.end() || at < 0 || at >= std::ssize(lessons)) return std::nullopt;
    return lessons[static_cast<std::size_t>(at)];
}

bool Lecture::press_in_exercise(LectureKey key, Scene& scene, const Frame* frame) {
    constexpr double kDegrees = 3.0;
    const auto turn = [&](double right, double up) {
        if (frame) exercises.turn(*frame, right, up);
        return true;
    };
    switch (key) {
        case LectureKey::Right: return turn(kDegrees, 0.0);
        case LectureKey::Left: return turn(-kDegrees, 0.0);
        case LectureKey::Up: return turn(0.0, kDegrees);
        case LectureKey::Down: return turn(0.0, -kDegrees);
        case LectureKey::Next:
        case LectureKey::Enter: exercises.go_on(scene); return true;
        case LectureKey::Hint: exercises.hint(); return true;
        default:
            if (key < LectureKey::First || !exercises.speech().question) return false;
            exercises.choose(static_cast<std::size_t>(key) - static_cast<std::size_t>(LectureKey::First), scene);
            return true;
    }
}

void Lecture::start_exercises(std::uint64_t seed, Scene& scene) {
    if (player.running()) player.arrive(scene);  // what is gone back to is a step, nothing halfway
    leave(scene);
    exercises.start(seed, scene);
}

Lecture::Said Lecture::said() const {
    Said said;
    if (exercises.running()) {
        said.all = exercises.speeches();  // any of them may come next
        said.count = said.all.size();
    } else if (player.running()) {
        for (std::size_t i = 0; i < player.lesson().steps.size(); ++i)
            said.all.push_back(speech_of(player.lesson(), i));
        said.first = player.number();
        said.count = 1;
    } else if (presenting) {
        said.all.push_back(said_);
        said.count = 1;
    }
    for (Speech& speech : said.all) speech.to_a_room = presenting || recorded;
    return said;
}

PixelRect Lecture::picture(const Look& look, const PixelRect& room) {
    const Said now = said();
    PixelRect picture = room;
    if (now.all.empty() || !look.fonts.caption) return picture;
    const StripPlace place = strip_.place(look, now.all, std::span(now.all).subspan(now.first, now.count),
                                          {static_cast<float>(room.size.x), static_cast<float>(room.size.y)});
    if (place.side == StripPlace::Side::Beside) {
        picture.size.x = std::max(room.size.x - static_cast<int>(place.takes), 1);
        takes_before_ = takes_ = 0.0f;
        return picture;
    }
    // It grows and shrinks as gently as the object moves.
    const auto t = static_cast<float>(player.running() ? player.way_done() : 1.0);
    if (t >= 1.0f || takes_before_ == 0.0f) takes_before_ = place.takes;
    takes_ = takes_before_ + t * (place.takes - takes_before_);
    picture.size.y = std::max(room.size.y - static_cast<int>(takes_), 1);
    return picture;
}

void Lecture::draw(const Look& look, Scene& scene, const PixelRect& room, const PixelRect& picture) {
    if (player.running() && !recorded)
        player.advance(std::min(static_cast<double>(ImGui::GetIO().DeltaTime), 0.1), scene);
    if (presenting && !player.running() && !exercises.running()) {
        SceneSaid said = said_of(scene);
        said_ = {std::move(said.caption), {}, std::move(said.equations), {}};
    }
    const std::vector<Speech> all = said().all;
    const StripRoom strip = beside(room, picture);
    if (all.empty() || strip.size.x < 1.0f || strip.size.y < 1.0f || !look.fonts.caption) return;
    const ImVec2 all_room(static_cast<float>(room.size.x), static_cast<float>(room.size.y));
    const auto draw_strip = [&](const Speech& said, const StripState& state) {
        const Speech speech = fitted(look, said, strip.side, strip.size.x, all_room);
        return strip_.draw(fitting_look(look, speech, strip.side, strip.size.x, all_room), speech, state, strip);
    };
    if (exercises.running()) {
        const StripRequests requests = draw_strip(all.front(), exercises.state());
        ends_ = requests.close;
        return exercises.obey(requests, scene);
    }
    StripState state;
    if (player.running())
        state = {player.lesson().title,
                 player.number(),
                 player.lesson().steps.size(),
                 player.answer(),
                 player.strayed(scene) && !recorded,
                 !recorded,
                 recorded ? nullptr : next_does(),
                 {},
                 recorded};
    Speech speech = player.running() ? all[player.number()] : all.front();
    if (announced_ != Announced::Nothing)
        if (const auto lesson = announced_ == Announced::Next ? next_lesson() : previous_lesson())
            speech = {(announced_ == Announced::Next ? "Next lesson: " : "Previous lesson: ") + lesson->title +
                          ". Press again to open it.",
                      {},
                      {},
                      {}};
    const StripRequests requests = draw_strip(speech, state);
    if (!player.running()) return;
    if (requests.choose) player.choose(*requests.choose);
    if (requests.next) press_in_lesson(LectureKey::Next, scene);
    if (requests.previous) press_in_lesson(LectureKey::Previous, scene);
    if (requests.again) press_in_lesson(LectureKey::Again, scene);
    ends_ = requests.close;
}

void Lecture::draw_screen(const Look& look, bool pointer_rests) const {
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    const ImGuiIO& io = ImGui::GetIO();
    if (blank_) {
        list.AddRectFilled({0, 0}, io.DisplaySize, *blank_ == Theme::Dark ? IM_COL32_BLACK : IM_COL32_WHITE);
        return;
    }
    // So that people at the back find the pointer; a ring, so that what it is on stays to be seen.
    if (presenting && !pointer_rests && ImGui::IsMousePosValid()) {
        list.AddCircleFilled(io.MousePos, look.px(15), IM_COL32(240, 228, 66, 90), 48);
        list.AddCircle(io.MousePos, look.px(15), IM_COL32(20, 20, 20, 150), 48, look.px(1));
        list.AddCircle(io.MousePos, look.px(14), IM_COL32(240, 228, 66, 255), 48, look.px(2));
    }
}

}  // namespace normalscope
