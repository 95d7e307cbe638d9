#pragma once

#include <string>

namespace steplab {

/// A number for people: at most 4 significant digits, but no rounding of the integer part below 10 million: "0.7",
/// "68.1", "12346", "1.2e-07".
std::string short_number(double value);

}  // namespace steplab
