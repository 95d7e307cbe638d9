#pragma once

#include "core/field.hpp"

#include <algorithm>
#include <cstddef>

namespace steplab {

/// Axes along which nothing moves nor pulls can be left out: 1 if all that comes of this state happens along x, 2 if in
/// the plane of x and y, else 3.
template <class Force, class T>
std::size_t moving_axes(const Force& force, const State<T>& state) {
    std::size_t axes = 1;
    const auto take = [&axes](std::size_t axis, const T& along) {
        if (!(along == T(0))) axes = std::max(axes, axis + 1);
    };
    const Field<T>&x = state.displacement, &v = state.velocity;
    for (std::size_t i = 0; i < x.count() && axes < 3; ++i) {
        const auto external = force.external(i);
        take(1, external.y), take(1, x.y()[i]), take(1, v.y()[i]);
        take(2, external.z), take(2, x.z()[i]), take(2, v.z()[i]);
    }
    for (const auto& formula : force.formulas()) take(1, formula.rest.y), take(2, formula.rest.z);
    return axes;
}

/// The axes along which a step computes: 1 where the layout of forces has code for motion along x alone and all motion
/// is along x, else 3.
template <class Force, class T>
std::size_t axes_of_steps(const Force& force, const State<T>& state) {
    if constexpr (Force::capabilities.along_x) return moving_axes(force, state) == 1 ? 1 : 3;
    return 3;
}

}  // namespace steplab
