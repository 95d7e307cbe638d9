#pragma once

#include "core/entry.hpp"
#include "core/field.hpp"

namespace steplab {

/// The option of every method of fixed steps: its sums of positions and velocities keep what rounding cuts off.
inline constexpr ParameterInfo compensated_sums{.name = "compensated",
                                                .kind = ParameterInfo::Kind::integer,
                                                .unit = "",
                                                .minimum = 0,
                                                .maximum = 1,
                                                .default_value = 0,
                                                .what = "1: sums keep what rounding cuts off, 0: it is lost",
                                                .slider_high = 1};

inline bool asks_for_compensated_sums(const ParameterValues& values) {
    return values.contains(compensated_sums.name) && values[compensated_sums.name] != 0;
}

/// sum += increment, where `lost` holds what rounding has cut off `sum` so far (compensated summation with the error
/// of a sum after Knuth, The Art of Computer Programming 2, 4.2.2, theorem B; Hairer, Lubich, Wanner, Geometric
/// Numerical Integration, VIII.5). What was lost is added to what is lost now: added to an increment, which often is
/// not much smaller than the sum, it would lose its own last digits, and not always as much up as down.
template <class T>
[[gnu::always_inline]] inline void add_compensated(T& sum, T& lost, T increment) {
    const T next = sum + increment;
    const T added = next - sum;
    const T low = lost + ((sum - (next - added)) + (increment - added));
    sum = next + low;
    lost = low - (sum - next);
}

/// The same of quantity q of the particles of register r, whose lost parts are the quantity `lost` (particles.hpp).
template <class Particles, class Change>
[[gnu::always_inline]] inline void add_compensated(Particles& particles, std::size_t q, std::size_t lost, std::size_t r,
                                                   const Change& change) {
    Change sum = particles.get(q, r), low = particles.get(lost, r);
    add_compensated(sum.x, low.x, change.x);
    add_compensated(sum.y, low.y, change.y);
    add_compensated(sum.z, low.z, change.z);
    particles.set(q, r, sum);
    particles.set(lost, r, low);
}

/// What rounding has cut off positions and velocities; empty unless sums are compensated.
template <class T>
struct Lost {
    Field<T> x, v;

    Lost() = default;
    Lost(bool compensated, std::size_t count)
        : x(compensated ? Field<T>(count) : Field<T>()), v(compensated ? Field<T>(count) : Field<T>()) {}
    bool kept() const { return x.count() > 0; }
};

}  // namespace steplab
