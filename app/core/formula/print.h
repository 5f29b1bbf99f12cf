#pragma once

#include "core/formula/graph.h"

#include <string>
#include <vector>

namespace normalscope::formulas {

/// An expression as a row of signs with begin and end marks around what stands above, below or in a root: whoever sets
/// it in two dimensions walks it from left to right.
struct Piece {
    enum class Kind : std::uint8_t {
        Number,    // text: digits
        Name,      // text: x, a, pi, e
        Function,  // text: sin; Open follows
        Plus,
        Minus,
        Negative,  // a sign, not an operation
        Times,     // between digits, where nothing would not do
        Space,     // a thin one, between factors
        Comma,
        Open,
        Close,
        AbsBegin,
        AbsEnd,
        FractionBegin,
        FractionOver,
        FractionEnd,
        SuperscriptBegin,
        SuperscriptEnd,
        RootBegin,
        RootEnd,
        CasesBegin,  // what has this value …
        CasesWhere,  // … where this is ≤ 0 …
        CasesElse,   // … and this elsewhere
        CasesEnd,
        Truncated,  // too long; the rest is left out
    } kind;
    std::string text{};
    /// Of a Begin, and of FractionOver: what follows needs brackets when all is written in one line.
    bool compound = false;
};

/// A gradient can be far longer than its formula; nobody reads ten thousand signs.
inline constexpr std::size_t kMostPieces = 100'000;

std::vector<Piece> pieces(const Graph& graph, Id root, std::size_t most = kMostPieces);

/// One line that parse() reads back as the same expression: "-2x/3 + x^2 y + sqrt(z)".
std::string to_text(const std::vector<Piece>& pieces);
/// One line for people: "−2x/3 + x² y + √z".
std::string to_unicode(const std::vector<Piece>& pieces);
/// For LaTeX's mathematics mode; amsmath where there are cases.
std::string to_latex(const std::vector<Piece>& pieces);

inline std::string to_text(const Graph& graph, Id root) { return to_text(pieces(graph, root)); }
inline std::string to_unicode(const Graph& graph, Id root) { return to_unicode(pieces(graph, root)); }
inline std::string to_latex(const Graph& graph, Id root) { return to_latex(pieces(graph, root)); }

}  // namespace normalscope::formulas
