#pragma once

#include <string>

namespace steplab {

/// A number for people, with this number of digits: "0.21", "1500", and "2.3·10⁻⁷" where a decimal would be long (below
/// 0.001, or 10 000 and above); a power of ten alone as "10⁻⁶".
std::string readable(double value, int digits = 2);

/// The same in a form that can be typed: "0.21", "2.3e-7", "1e-6".
std::string typed(double value, int digits = 2);

/// An integer in groups of three digits: "12 345 678", separated by narrow no-break spaces.
std::string grouped(unsigned long long count);

}  // namespace steplab
