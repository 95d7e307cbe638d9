#pragma once

#include "sim/run/worker.hpp"

#include <string>

namespace steplab::ui {

/// The range the speed slider offers, simulated seconds a second.
inline constexpr double slowest = 0.01;
inline constexpr double fastest = 1000;

/// The next speed of 1, 2, 5 times a power of ten up or down; beyond `fastest` comes "as fast as possible".
Rate faster(Rate rate);
Rate slower(Rate rate);

/// "1.0 s/s", "as fast as possible".
std::string rate_text(Rate rate);

}  // namespace steplab::ui
