#pragma once

#include "core/frame/frame.h"
#include "core/scene/scene.h"
#include "ui/kit/style.h"

namespace normalscope {

enum class Icon {
    Open,
    Save,
    Undo,
    Redo,
    Help,
    Up,
    Down,
    Left,
    Right,
    Close,
    Plus,
    LockOpen,
    LockClosed,
    Reset,
    Grip,
    Folder,
    File,
    Play,
    Pause,
    Previous,
    Next,
    Share,
    More
};

/// Draws an icon into the square of this side about `centre`, in lines of one weight.
void draw_icon(ImDrawList& list, Icon icon, ImVec2 centre, float side, ImU32 color);

/// An arrow as the picture draws it, in a shape of its own for each kind, since colour alone tells not everyone apart:
/// the object's is hollow, the naive one dashed, the cofactor's double.
void draw_arrow(ImDrawList& list, ArrowLook look, ImVec2 from, ImVec2 to, float thickness, ImU32 color);

}  // namespace normalscope
