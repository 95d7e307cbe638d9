#pragma once

#include "core/field.hpp"

#include <algorithm>
#include <cstddef>

namespace steplab {

/// Axes along which nothing moves nor pulls can be left out: 1 if all that comes of this state happens along x, 2 if in
/// the plane of x and y, else 3.
template <class System, class T>
std::size_t moving_axes(const System& system, const State<T>& state) {
    std::size_t axes = 1;
    const auto take = [&axes](std::size_t axis, const T& along) {
        if (!(along == T(0))) axes = std::max(axes, axis + 1);
    };
    const Field<T>&x = state.displacement, &v = state.velocity;
    for (std::size_t i = 0; i < x.count() && axes < 3; ++i) {
        const auto external = system.force().external(i);
        take(1, external.y), take(1, x.y()[i]), take(1, v.y()[i]);
        take(2, external.z), take(2, x.z()[i]), take(2, v.z()[i]);
    }
    for (const auto& formula : system.force().formulas()) take(1, formula.rest.y), take(2, formula.rest.z);
    return axes;
}

}  // namespace steplab
