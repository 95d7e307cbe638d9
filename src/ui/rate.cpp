#include "ui/rate.hpp"

#include "core/number_text.hpp"
#include "ui/widgets/format.hpp"

#include <algorithm>
#include <cmath>

namespace steplab::ui {
namespace {

/// The speeds that keys step through: index 0 is 1, 1 is 2, 2 is 5, 3 is 10, -1 is 0.5 ...
double rung(int index) {
    constexpr double factors[] = {1, 2, 5};
    const int decade = static_cast<int>(std::floor(index / 3.0));
    return factors[index - 3 * decade] * std::pow(10.0, decade);
}

/// The highest rung not above `speed`.
int rung_below(double speed) {
    int index = static_cast<int>(3 * std::floor(std::log10(speed)));
    while (rung(index + 1) <= speed * (1 + 1e-9)) ++index;
    return index;
}

}  // namespace

Rate faster(Rate rate) {
    if (rate.as_fast_as_possible || rate.seconds_per_second >= fastest) return {true, rate.seconds_per_second};
    return {false, std::min(rung(rung_below(rate.seconds_per_second) + 1), fastest)};
}

Rate slower(Rate rate) {
    if (rate.as_fast_as_possible) return {false, fastest};
    const int below = rung_below(rate.seconds_per_second);
    const bool on_rung = rung(below) > rate.seconds_per_second * (1 - 1e-9);
    return {false, std::max(rung(on_rung ? below - 1 : below), slowest)};
}

std::string rate_text(Rate rate) {
    return rate.as_fast_as_possible ? "as fast as possible" : with_unit(setting_text(rate.seconds_per_second, 3), "s/s");
}

}  // namespace steplab::ui
