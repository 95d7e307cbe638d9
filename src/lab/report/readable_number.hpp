#pragma once

#include <string>

namespace steplab {

/// A number for a person, to so many digits: "0.21", "1500", and "2.3·10⁻⁷" where a decimal would be long (below 0.001,
/// from 10 000 on); a power of ten alone as "10⁻⁶".
std::string readable(double value, int digits = 2);

/// The same as one types it: "0.21", "2.3e-7", "1e-6".
std::string typed(double value, int digits = 2);

/// A whole number in groups of three: "12 345 678", the groups held together by narrow spaces that do not break.
std::string grouped(unsigned long long count);

}  // namespace steplab
