#pragma once

#include "ui/kit/style.h"

#include <imgui.h>

#include <cstddef>
#include <string>

namespace normalscope {

/// A field for the words of a lesson, as wide as what it stands in.
struct WordField {
    const char* id;
    int lines = 1;
    std::size_t most = 0;   ///< characters that can be typed
    const char* hint = "";  ///< in a single line that is empty
};
/// What has been done to it.
struct Typed {
    bool changed = false;  ///< just now
    bool typing = false;   ///< somebody is at it
    ImGuiID field = 0;     ///< the one that has been changed
    void operator|=(const Typed& more) {
        if (more.changed) field = more.field;
        changed |= more.changed, typing |= more.typing;
    }
};
/// Words that are one paragraph, whose lines break at the field's edge. A field that is full says so.
Typed word_field(const Look& look, const WordField& field, std::string& text);
/// The same, but for lines that are broken by whoever types.
Typed line_field(const Look& look, const WordField& field, std::string& text);

/// What a field below it is for.
void name_of_field(const Look& look, const char* name);
/// What is wrong with the one above it.
void say_of_field(const Look& look, const std::string& line);

/// Of a field that is put here.
float width_of_lines();
/// The words as a field of that width has them, whose lines Dear ImGui does not break itself: a break stands in the place of
/// a space. And back.
std::string broken(std::string words, float width);
std::string in_a_row(std::string text);

}  // namespace normalscope
