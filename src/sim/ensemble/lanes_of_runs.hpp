#pragma once

#include "core/field.hpp"
#include "core/lanes.hpp"
#include "sim/ensemble/lane_compatible.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace steplab {

/// A number of several runs, one in each SIMD lane of a register.
template <class T>
using InLanes = RegisterLanes<T>;

/// f(run) of the run in each lane; lanes without a run of their own have the last one's.
template <class T, class F>
InLanes<T> in_lanes(std::size_t runs, F f) {
    return InLanes<T>::each([&](std::size_t lane) { return f(std::min(lane, runs - 1)); });
}

template <class T>
InLanes<T> dt_in_lanes(std::span<const StepperSetup> runs) {
    return in_lanes<T>(runs.size(), [&](std::size_t run) { return static_cast<T>(runs[run].dt); });
}
template <class T>
InLanes<T> drag_in_lanes(std::span<const StepperSetup> runs) {
    return in_lanes<T>(runs.size(), [&](std::size_t run) { return static_cast<T>(runs[run].scene.drag); });
}

/// The engine of forces that differ in their numbers alone, whose every constant is computed in T, as for a run alone.
template <template <class> class Force, class T, class Forces>
Force<InLanes<T>> forces_in_lanes(const std::vector<Forces>& forces) {
    std::vector<std::vector<T>> constants;
    for (const Forces& one : forces) {
        const Force<T> engine(one);
        constants.emplace_back();
        Force<T>::each_constant(engine, [&](const T& number) { constants.back().push_back(number); });
    }
    Force<InLanes<T>> all(forces.front());
    std::size_t place = 0;
    Force<InLanes<T>>::each_constant(all, [&](InLanes<T>& number) {
        number = in_lanes<T>(forces.size(), [&](std::size_t run) { return constants[run][place]; });
        ++place;
    });
    return all;
}

template <class T, class Part>
Field<InLanes<T>> field_in_lanes(const std::vector<State<T>>& states, Part part) {
    Field<InLanes<T>> all((states.front().*part).count());
    for (std::size_t k = 0; k < all.flat().size(); ++k) {
        all.flat()[k] = in_lanes<T>(states.size(), [&](std::size_t run) { return (states[run].*part).flat()[k]; });
    }
    return all;
}

/// States of as many particles each.
template <class T>
State<InLanes<T>> state_in_lanes(const std::vector<State<T>>& states) {
    return {field_in_lanes(states, &State<T>::displacement), field_in_lanes(states, &State<T>::velocity)};
}

/// One run's field; the memory of `out` is used again.
template <class N>
void take_lane(const Field<N>& all, std::size_t lane, Field<double>& out) {
    if (out.count() != all.count()) out = Field<double>(all.count());
    for (std::size_t k = 0; k < all.flat().size(); ++k) out.flat()[k] = static_cast<double>(all.flat()[k][lane]);
}

}  // namespace steplab
