#pragma once

#include <string>

namespace steplab {

/// A span of time as a person reads it, to three digits in the unit that suits it: "420 ns", "62 µs", "3.05 ms",
/// "1.2 s", from a minute on "9 min 05 s", from an hour on "2 h 45 min". "days" from 100 hours on and for what is no
/// number.
std::string duration_text(double seconds);

}  // namespace steplab
