#pragma once

#include "core/entry.hpp"
#include "core/field.hpp"
#include "core/vector.hpp"

namespace steplab {

/// The option of every method of fixed steps: its sums of positions and velocities keep what rounding cuts off.
inline constexpr ParameterInfo compensated_sums{.name = "compensated",
                                                .kind = ParameterInfo::Kind::integer,
                                                .unit = "",
                                                .minimum = 0,
                                                .maximum = 1,
                                                .default_value = 0,
                                                .what = "compensated (Kahan) summation: 1 on, 0 off",
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

/// The same in memory, a register N of numbers from `sum` and `lost` on.
template <class T, class N>
void add_compensated_at(T* sum, T* lost, N increment) {
    N high = N::load(sum), low = N::load(lost);
    add_compensated(high, low, increment);
    high.store(sum);
    low.store(lost);
}

template <class N>
[[gnu::always_inline]] inline void add_compensated(Vector<N>& sum, Vector<N>& lost, const Vector<N>& increment) {
    add_compensated(sum.x, lost.x, increment.x);
    add_compensated(sum.y, lost.y, increment.y);
    add_compensated(sum.z, lost.z, increment.z);
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
