#pragma once

namespace normalscope {

/// What a first look can do without: each stands behind one press, and what has been opened stays open, also in later
/// sessions.
struct Unfolded {
    bool rules = false;   ///< the cofactor matrix, and the mistakes that programs make
    bool matrix = false;  ///< the entries of M
    bool tabs = false;    ///< those beside the derivation, the stack and the error
    friend bool operator==(const Unfolded&, const Unfolded&) = default;
};

}  // namespace normalscope
