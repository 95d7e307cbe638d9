#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace steplab {

/// Doubles at the ends of what they can be, and everyday ones.
inline std::vector<double> special_doubles() {
    using Limits = std::numeric_limits<double>;
    std::vector<double> values{0,
                               Limits::denorm_min(),
                               1e-310,
                               Limits::min(),
                               1e-300,
                               1e-30,
                               1e-3,
                               1,
                               1.5,
                               10,
                               12345,
                               1e15,
                               1e16,
                               1e30,
                               1e100,
                               1e300,
                               1e308,
                               Limits::max(),
                               Limits::infinity()};
    for (std::size_t i = 0, count = values.size(); i < count; ++i) values.push_back(-values[i]);
    values.push_back(Limits::quiet_NaN());
    values.push_back(-Limits::quiet_NaN());
    return values;
}

/// Pairs of doubles: every two special ones, neighbours, and `random` pairs of any 64 bits or of one size. The same at
/// each call.
inline std::vector<std::pair<double, double>> extreme_pairs(int random) {
    std::vector<std::pair<double, double>> pairs;
    for (const double a : special_doubles()) {
        for (const double b : special_doubles()) pairs.emplace_back(a, b);
        pairs.emplace_back(a, std::nextafter(a, std::numeric_limits<double>::infinity()));
    }
    std::mt19937_64 generator(1);
    std::uniform_real_distribution<double> part(-1, 1);
    for (int i = 0; i < random; ++i) {
        const auto any = std::bit_cast<double>(std::uint64_t{generator()});
        pairs.emplace_back(any, std::bit_cast<double>(std::uint64_t{generator()}));
        pairs.emplace_back(any, any * (1 + std::ldexp(part(generator), -static_cast<int>(generator() % 54))));
    }
    return pairs;
}

}  // namespace steplab
