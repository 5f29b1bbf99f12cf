#pragma once

#include <optional>
#include <string>

namespace normalscope {

/// A number as mathematics writes it, always with as many decimals, so that a column does not jitter as it changes:
/// a real minus sign, no "−0.000", powers of ten from 10,000 on, and "—" for what is not a finite number.
std::string fixed(double value, int decimals = 3);
std::string fixed(const std::optional<double>& value, int decimals = 3);

/// As `fixed`, but a value that would read 0.000 without being 0 shows its size, such as "−2.1e−7".
std::string fixed_unless_small(double value, int decimals = 3);

/// "36.870°", or "—".
std::string in_degrees(const std::optional<double>& value, int decimals = 3);

/// As short as can be: "2", "0.5", "−1.25"; at most three decimals.
std::string brief(double value);

/// "16,384".
std::string grouped(std::size_t count);

}  // namespace normalscope
