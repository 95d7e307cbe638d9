#pragma once

#include <string>

namespace steplab {

/// A duration for people, with three significant digits in a suitable unit: "420 ns", "62 µs", "3.05 ms", "1.2 s"; from
/// one minute "9 min 05 s", from one hour "2 h 45 min"; "days" for 100 hours or more, and for NaN.
std::string duration_text(double seconds);

/// A size in memory or of a file for people, with three significant digits in decimal units: "512 bytes", "1.5 MB",
/// "473 GB"; from 1e18 bytes on in powers of ten.
std::string bytes_text(double bytes);

}  // namespace steplab
