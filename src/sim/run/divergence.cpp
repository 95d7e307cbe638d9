#include "sim/run/divergence.hpp"

#include "core/number_text.hpp"
#include "sim/catalogue.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace steplab {

namespace {

constexpr double possible_gain = 1000;

double squared_speed(const State<double>& state, std::size_t i) {
    const double measure =
        dot(state.velocity.at(i), state.velocity.at(i)) + 0 * dot(state.displacement.at(i), state.displacement.at(i));
    return std::isfinite(measure) ? measure : infinity;
}

std::string reason(const Divergence& divergence, const RunDescription& held) {
    const std::string dt = fmt::format("dt = {} s", significant(held.dt, 4));
    if (method(held.method).info.curiosity)
        return fmt::format("{} repeats a mistake that makes it fail at any dt", held.method);
    if (chooses_its_steps(held))
        return fmt::format("the numbers of {} leave what {} holds, whatever dt is", held.method, id(held.precision));
    if (!divergence.limit) return fmt::format("{} is too large for {} on this scene", dt, held.method);
    if (*divergence.limit == 0)
        return fmt::format("{} gains energy at any dt, the faster the larger dt is ({})", held.method, dt);
    if (std::abs(held.dt) >= *divergence.limit) {
        return fmt::format("{} is beyond the stability limit {} s of {} on this scene", dt,
                           significant(*divergence.limit, 4), held.method);
    }
    return fmt::format("{} is below the stability limit {} s of {} at rest, but the motion is too violent for it", dt,
                       significant(*divergence.limit, 4), held.method);
}

/// Whether the run can hold the energy, and so the forces, at the last good step.
bool is_held(double energy, Precision precision) {
    return std::abs(energy) <=
           (precision == Precision::float_ ? std::numeric_limits<float>::max() : std::numeric_limits<double>::max());
}

std::string encounter(const OwnStop& stop) {
    if (stop.first == stop.second) return {};
    return fmt::format("; nearest to each other are particles {} and {}, {} m apart", stop.first, stop.second,
                       typed(stop.distance, 3));
}

std::string stop_reason(const OwnStop& stop, const RunDescription& held) {
    const std::string what = chooses_its_steps(held)
                                 ? "meets its tolerance of " + typed(held.method_parameters["tolerance"], 3)
                                 : "solves its equations";
    const std::string shortest =
        stop.step > 0 ? fmt::format("not even one of {} s", typed(stop.step, 3)) : "however short";
    return fmt::format("at t = {} s no step of {} {}, {}{}", significant(stop.time, 8), held.method, what, shortest,
                       encounter(stop));
}

}  // namespace

bool energy_is_possible(const Energy& now, const Energy& start, double floor) {
    const double work = std::abs(now.potential.external - start.potential.external);
    const double scale = start.kinetic + start.potential.magnitude + work + floor;
    return gain_is_possible(now.total() - start.total(), scale);
}

bool gain_is_possible(double gain, double scale) { return gain <= possible_gain * scale; }

/// What outer forces have added is their work, which is on the other side too.
bool energy_is_surely_possible(double bound, const Energy& start, double floor) {
    return bound <= possible_gain * (start.kinetic + start.potential.magnitude + floor);
}

std::size_t wildest_particle(const State<double>& state) {
    std::size_t wildest = 0;
    for (std::size_t i = 1; i < state.velocity.count(); ++i) {
        if (squared_speed(state, i) > squared_speed(state, wildest)) wildest = i;
    }
    return wildest;
}

void explain(Divergence& divergence, const RunDescription& held, const std::optional<StabilityLimit>& limit,
             double energy) {
    divergence.dt = held.dt;
    const std::string last =
        fmt::format("step {} (t = {} s) was the last valid one", divergence.step, significant(divergence.time, 6));
    if (!is_held(energy, held.precision)) {
        divergence.message = fmt::format("The run {}: {}; the energy there is more than {} holds, whatever dt is.",
                                         divergence.stop ? "stopped" : "diverged", last, id(held.precision));
        return;
    }
    if (divergence.stop) {
        divergence.message = fmt::format("The run stopped: {}; {}.", last, stop_reason(*divergence.stop, held));
        return;
    }
    if (limit && std::isfinite(limit->limit)) divergence.limit = limit->limit;
    divergence.message = fmt::format("The run diverged: {}; particle {} blew up in step {}: {}.", last,
                                     divergence.particle, divergence.step + 1, reason(divergence, held));
}

}  // namespace steplab
