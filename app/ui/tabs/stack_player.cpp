#include "ui/tabs/stack_player.h"

#include "ui/kit/number_bar.h"
#include "ui/kit/widgets.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace normalscope {

namespace {

constexpr double kSecondsAnEntry = 1.6;

// What acts in full is as if nothing had been set, so that an entry that is added later acts, too.
void set_position(Scene& scene, double position) {
    if (position >= static_cast<double>(scene.stack.size()))
        scene.stack_position.reset();
    else
        scene.stack_position = std::max(position, 0.0);
}

// Each entry begins and ends gently, so that one sees where the next one sets in.
double eased(double time) {
    const double whole = std::floor(time), t = time - whole;
    return whole + t * t * (3.0 - 2.0 * t);
}

}  // namespace

std::string how_far(const Scene& scene) {
    const std::size_t count = scene.stack.size();
    const double position = std::min(scene.stack_position.value_or(1e9), static_cast<double>(count));
    const std::size_t whole = std::min(static_cast<std::size_t>(position), count);
    if (count == 0) return "No transform: M = I.";
    if (whole == count) return count == 1 ? "The whole stack acts." : "All " + std::to_string(count) + " entries act.";
    const double part = position - static_cast<double>(whole);
    const auto named = [&](std::size_t i) { return std::to_string(i + 1) + " " + std::string(name(scene.stack[i])); };
    if (part <= 0.0)
        return whole == 0 ? "Nothing acts yet: M = I." : "Up to " + named(whole - 1) + "; the others wait.";
    return std::to_string(static_cast<int>(std::lround(100.0 * part))) + " % of " + named(whole) +
           (whole == 0 ? "." : ", after " + named(whole - 1) + ".");
}

void toggle(StackPlayer& player, Scene& scene) {
    player.playing = !player.playing && !scene.stack.empty();
    if (!player.playing) return;
    const auto count = static_cast<double>(scene.stack.size());
    const double position = scene.stack_position.value_or(count);
    player.time = position >= count ? 0.0 : position;
    player.position = eased(player.time);
    set_position(scene, player.position);
}

void finish(StackPlayer& player, Scene& scene) {
    if (player.playing) scene.stack_position.reset();
    player.playing = false;
}

void advance(StackPlayer& player, Scene& scene) {
    if (!player.playing) return;
    const auto count = static_cast<double>(scene.stack.size());
    if (!scene.stack_position || *scene.stack_position != player.position) {  // an undo, another scene, the slider
        player.playing = false;
        return;
    }
    // A window that was asleep, or draws slowly, must not jump.
    player.time += std::min(static_cast<double>(ImGui::GetIO().DeltaTime), 0.1) / kSecondsAnEntry;
    player.position = std::min(eased(player.time), count);
    player.playing = player.time < count;
    set_position(scene, player.position);
}

namespace {

// What steps through the stack, and the slider.
void controls(const Look& look, Scene& scene, StackPlayer& player) {
    const auto count = static_cast<double>(scene.stack.size());
    double position = std::min(scene.stack_position.value_or(count), count);
    const bool any = !scene.stack.empty();
    if (icon_button(look, "##play",
                    {.icon = player.playing ? Icon::Pause : Icon::Play,
                     .about = player.playing ? "Stop here." : "Let the entries act one after the other.",
                     .enabled = any}))
        toggle(player, scene);
    ImGui::SameLine(0, look.px(2));
    if (icon_button(look, "##previous",
                    {.icon = Icon::Previous, .about = "One entry less.", .enabled = any && position > 0.0}))
        set_position(scene, std::ceil(position) - 1.0);
    ImGui::SameLine(0, look.px(2));
    if (icon_button(look, "##next",
                    {.icon = Icon::Next, .about = "One entry more.", .enabled = any && position < count}))
        set_position(scene, std::floor(position) + 1.0);
    ImGui::SameLine(0, look.px(6));
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() + (look.px(30) - ImGui::GetFrameHeight()) / 2);
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    ImGui::BeginDisabled(!any);
    position = std::min(scene.stack_position.value_or(count), count);
    if (number_bar(look, "##position", position,
                   {.letter = "acting",
                    .low = 0.0,
                    .high = std::max(count, 1e-9),
                    .decimals = 2,
                    .range = {0.0, std::max(count, 1e-9)},
                    .about = "How many entries act, a fraction meaning part of the next: angles, offsets and factors "
                             "grow evenly.",
                    .rest = count})) {
        set_position(scene, position);
        player.playing = false;
    }
    ImGui::EndDisabled();
}

}  // namespace

void player_controls(const Look& look, Scene& scene, StackPlayer& player) {
    if (!look.still) controls(look, scene, player);
    ImGui::PushFont(look.fonts.small);
    dim_text(look, how_far(scene));
    ImGui::PopFont();
}

}  // namespace normalscope
