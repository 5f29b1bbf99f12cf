#pragma once

#include "core/explain/derivation.h"
#include "ui/typeset/math_layout.h"

#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace normalscope {

/// What of the derivation is shown as name and what as number.
struct NamesOrNumbers {
    bool numbers = false;
    std::set<std::pair<std::size_t, Place>> switched;  ///< line and place: what is shown the other way

    bool number(std::size_t line, Place place, bool symbol) const {
        return (numbers && symbol) != switched.contains({line, place});
    }
    friend bool operator==(const NamesOrNumbers&, const NamesOrNumbers&) = default;
    void toggle(std::size_t line, Place place) {
        if (!switched.erase({line, place})) switched.insert({line, place});
    }
};

/// What a lecturer stops at: a line of the derivation with its reason, the check, or why translation drops out.
struct Passage {
    struct Row {
        MathBox box;
        std::size_t line = 0;  ///< for NamesOrNumbers
        float above = 0.0f;    ///< space
    };
    std::string title;  ///< empty: its number is its title
    Step::State state = Step::State::Holds;
    std::vector<Row> rows;
};

/// The whole derivation laid out. What has no number (the inverse of a singular matrix) stays a name.
std::vector<Passage> passages(const Look& look, const Derivation& derivation, const NamesOrNumbers& shown,
                              std::size_t tangent, float width);

// Its last two.
Passage check_passage(const Look& look, const Derivation& derivation, const NamesOrNumbers& shown, std::size_t tangent,
                      std::size_t first_line, float width);
Passage homogeneous_passage(const Look& look, const Derivation& derivation, const NamesOrNumbers& shown,
                            std::size_t first_line, float width);

/// Equations as large as the width allows, their signs aligned. `make` lays one out.
using MakeEquation = std::function<Equation(const MathStyle& style, std::size_t i)>;
std::vector<AlignedEquation> fitted(const Look& look, std::size_t count, const MakeEquation& make, float width);

}  // namespace normalscope
