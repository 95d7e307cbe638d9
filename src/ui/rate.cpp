#include "ui/rate.hpp"

#include "core/number_text.hpp"
#include "core/ticks.hpp"

#include <algorithm>

namespace steplab::ui {

Rate faster(Rate rate) {
    if (rate.as_fast_as_possible || rate.seconds_per_second >= fastest) return {true, rate.seconds_per_second};
    return {false, std::min(nice_above(rate.seconds_per_second), fastest)};
}

Rate slower(Rate rate) {
    if (rate.as_fast_as_possible) return {false, fastest};
    return {false, std::max(nice_below(rate.seconds_per_second), slowest)};
}

std::string rate_text(double seconds_per_second) { return setting_text(seconds_per_second, 3) + "x real time"; }

}  // namespace steplab::ui
