#pragma once

#include "session/worker.hpp"

#include <string>

namespace steplab::ui {

/// The range of the speed slider, in simulated seconds per second of real time.
inline constexpr double slowest = 0.01;
inline constexpr double fastest = 1000;

/// The next nice number (core/ticks.hpp) up or down; the step above `fastest` is unlimited speed.
Rate faster(Rate rate);
Rate slower(Rate rate);

/// "1.0x real time".
std::string rate_text(double seconds_per_second);

}  // namespace steplab::ui
