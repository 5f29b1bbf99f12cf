#pragma once

namespace normalscope {

/// What a key, or a presenter's remote control, asks for.
enum class LectureKey {
    Next,
    Previous,
    Up,
    Down,
    Left,
    Right,
    Again,
    Last,
    Enter,
    Hint,
    Black,
    White,
    First,
    Second,
    Third,
    Fourth,
    Fifth
};

}  // namespace normalscope
