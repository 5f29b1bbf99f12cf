#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace normalscope {

/// Reads the decimal number that the text begins with, such as -1.5e-3, .5 or 2. (no plus, no hexadecimal, no inf or
/// nan), rounded to the nearest double; beyond their range it is infinite or 0. Gives how many characters it takes, 0
/// where there is no number. The same in every locale.
std::size_t read_decimal(std::string_view text, double& number);

/// The text as such a number; nothing where it is anything else, or more.
std::optional<double> decimal(std::string_view text);

/// The number with so many digits after the point, as printf's %.nf has it in the C locale.
std::string with_decimals(double number, int decimals);
/// With so many digits in all and no zeros behind them, as %.ng.
std::string with_digits(double number, int digits);
/// With an exponent, as %.ne.
std::string with_exponent(double number, int decimals);

}  // namespace normalscope
