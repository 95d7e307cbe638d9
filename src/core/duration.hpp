#pragma once

#include <string>

namespace steplab {

/// A duration for people, with three significant digits in a suitable unit: "420 ns", "62 µs", "3.05 ms", "1.2 s"; from
/// one minute "9 min 05 s", from one hour "2 h 45 min"; "days" for 100 hours or more, and for NaN.
std::string duration_text(double seconds);

}  // namespace steplab
