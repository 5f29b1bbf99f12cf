#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace normalscope::formulas {

/// A number in a formula: an exact fraction as long as numerator and denominator stay within 2⁵³, otherwise a double.
/// Within that bound both parts are doubles without rounding, so a fraction's value is rounded only once, and whatever
/// is written as a decimal and read again is the same Number.
class Number {
public:
    Number(std::int64_t integer = 0);
    static Number ratio(std::int64_t numerator, std::int64_t denominator);
    /// Exact where the shortest decimal that reads back as `value` is; NaN stands for what has no real value.
    static Number from_double(double value);
    /// Digits with an optional point and exponent, as in "12", ".5", "1.5e-3".
    static Number from_decimal(std::string_view text);

    bool exact() const { return denominator_ != 0; }
    std::int64_t numerator() const { return numerator_; }      ///< of an exact one, in lowest terms
    std::int64_t denominator() const { return denominator_; }  ///< positive; 0 if not exact
    double value() const { return value_; }

    bool zero() const { return value_ == 0.0; }
    bool one() const { return value_ == 1.0; }
    bool negative() const { return value_ < 0.0; }
    bool finite() const;
    bool integer() const;
    bool even() const;  ///< an integer that two divides

    friend Number operator+(const Number& a, const Number& b);
    friend Number operator*(const Number& a, const Number& b);
    friend Number operator-(const Number& a) { return a * Number(-1); }
    friend bool operator==(const Number& a, const Number& b);

private:
    std::int64_t numerator_ = 0, denominator_ = 1;
    double value_ = 0.0;
};

/// base^exponent for an integer exponent, positive or not.
Number integer_power(const Number& base, const Number& exponent);

/// The exact n-th root of a non-negative integer; −1 where there is none.
std::int64_t exact_root(std::int64_t value, std::int64_t n);

/// The shortest decimal that reads back as this double, such as "0.1" or "1e+30".
std::string shortest(double value);

/// The decimal of an exact number that has a short one and is better read so: "0.05", but 1/4 and 1/3 as fractions.
/// Empty where it is a fraction.
std::string decimal(const Number& number);

}  // namespace normalscope::formulas
