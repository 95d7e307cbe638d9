#pragma once

#include "core/flush_subnormals.hpp"
#include "methods/engines/system.hpp"
#include "models/forces/line.hpp"
#include "sim/run/segment.hpp"
#include "support/runs.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace steplab::test {

/// 34 digits: 10^9 steps of long double would lose what is looked for.
using Quad = boost::multiprecision::cpp_bin_float_quad;

/// A linear map of (x, v).
struct Map {
    Quad xx = 1, xv = 0, vx = 0, vv = 1;

    friend Map operator*(const Map& a, const Map& b) {
        return {a.xx * b.xx + a.xv * b.vx, a.xx * b.xv + a.xv * b.vv, a.vx * b.xx + a.vv * b.vx,
                a.vx * b.xv + a.vv * b.vv};
    }
};

inline Map power(Map base, std::uint64_t exponent) {
    Map result;
    for (; exponent > 0; exponent /= 2) {
        if (exponent % 2 == 1) result = result * base;
        base = base * base;
    }
    return result;
}

/// What one step of a method makes of the oscillator x'' = -x, in long double: with numbers right to 5e-20 it tells
/// where n steps lead, but for n times that.
template <class Method>
Map step_map(long double dt) {
    constexpr LineForces spring{.count = 2, .first_fixed = true, .mass = 1, .k = 1, .rest_length = 0};
    System<long double, Line<long double>> system(Line<long double>(spring), 0, dt);
    State<long double> state{Field<long double>(2), Field<long double>(2)};
    state.displacement.x()[1] = state.velocity.y()[1] = 1;  // both columns of the map in one run
    typename Method::template Integrator<long double> integrator{ParameterValues(Method::info.parameters)};
    integrator.start(system, state);
    integrator.step(system);
    integrator.synchronised(system, state);
    return {state.displacement.x()[1], state.displacement.y()[1], state.velocity.x()[1], state.velocity.y()[1]};
}

/// The exact motion over dt: what a method without error of its own makes of it.
inline Map exact_map(long double dt) {
    const Quad angle = dt;
    return {cos(angle), sin(angle), -sin(angle), cos(angle)};
}

/// How far an oscillator is from where it should be.
struct Deviation {
    double phase = 0;   ///< radians it is ahead
    double energy = 0;  ///< relative
};

inline Deviation deviation(const Quad& x, const Quad& v, const Map& theory) {
    const Quad &right_x = theory.xv, &right_v = theory.vv;  // from x = 0, v = 1
    const Quad across = x * right_v - v * right_x, along = x * right_x + v * right_v;
    return {static_cast<double>(atan2(across, along)),
            static_cast<double>((x * x + v * v) / (right_x * right_x + right_v * right_v) - 1)};
}

/// The oscillator of the catalogue with its step dt, as the run's precision holds it.
inline RunDescription oscillator(std::string_view method, Precision precision, double dt, bool compensated) {
    RunDescription run = run_of("oscillator", method, precision, dt);
    if (run.method_parameters.contains("compensated")) run.method_parameters.set("compensated", compensated ? 1 : 0);
    return run;
}

/// Where the run stands against theory after each of these ascending numbers of steps, of which `map` is one.
inline std::vector<Deviation> deviations(const RunDescription& run, const Map& map,
                                         std::span<const std::uint64_t> steps) {
    const FlushSubnormals flush;
    const Segment segment(run);
    State<double> state;
    std::vector<Deviation> all;
    std::uint64_t now = 0;
    for (const std::uint64_t step : steps) {
        segment.stepper->advance(step - now);
        now = step;
        segment.stepper->synchronised(state);
        all.push_back(deviation(state.displacement.x()[1], state.velocity.x()[1], power(map, step)));
    }
    return all;
}

}  // namespace steplab::test
