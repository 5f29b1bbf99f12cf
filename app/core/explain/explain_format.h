#pragma once

#include <array>
#include <string_view>

namespace normalscope {

/// How an explanation is written (core/explain/explanation.h).
/// The last is LaTeX for a document of one's own, which no name stands for.
enum class ExplainFormat { Text, Json, Latex, LatexFragment };
inline constexpr std::array kExplainFormats{ExplainFormat::Text, ExplainFormat::Json, ExplainFormat::Latex};

/// "text", "json", "latex".
std::string_view name(ExplainFormat format);

}  // namespace normalscope
