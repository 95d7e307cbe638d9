#include "sim/run/observables.hpp"

#include "core/error.hpp"
#include "core/text.hpp"
#include "models/forces/interactions.hpp"
#include "models/forces/layouts.hpp"
#include "sim/run/fixed_particles.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <variant>

namespace steplab {

namespace {

constexpr std::array all_observables{Observable::kT, Observable::pressure, Observable::msd};

struct Volume {
    double operator()(const NearPairForces& forces) const { return forces.period * forces.period * forces.period; }
    double operator()(const ComposedForces& forces) const {
        const Vec3 box = forces.terms->box;
        return box.x * box.y * box.z;
    }
    template <class Other>
    double operator()(const Other&) const {
        return 0;
    }
};

/// Each formula is the force on the first particle of a pair, by the unit of mass.
template <class Force>
double virial_by_mass(Force force, const Field<double>& u) {
    const auto formulas = force.formulas();
    double sum = 0;
    force.each_interaction(u, [&](std::size_t i, std::size_t j, std::size_t kind) {
        if (i == j) return;  // from outside
        const Vector<double> e = difference(force, u, i, j), rest = formulas[kind].rest;
        const auto work = [&](const Vector<double>& pull) {
            return pull.x * (rest.x + e.x) + pull.y * (rest.y + e.y) + pull.z * (rest.z + e.z);
        };
        if constexpr (Force::capabilities.masses) {
            sum -= work(formulas[kind](e.x, e.y, e.z, force.properties(i, j, kind)));
        } else {
            sum -= work(formulas[kind](e.x, e.y, e.z));
        }
    });
    return sum;
}

}  // namespace

std::string_view id(Observable observable) {
    constexpr std::array<std::string_view, 3> ids{"kT", "pressure", "msd"};
    return ids[static_cast<std::size_t>(observable)];
}

std::vector<Observable> parse_observables(std::string_view list) {
    std::vector<Observable> wanted;
    for (std::size_t begin = 0; begin <= list.size();) {
        const std::size_t end = std::min(list.find(',', begin), list.size());
        const std::string_view name = list.substr(begin, end - begin);
        const auto known = std::find_if(all_observables.begin(), all_observables.end(),
                                        [&](Observable observable) { return id(observable) == name; });
        if (known == all_observables.end()) {
            std::array<std::string_view, all_observables.size()> ids;
            std::transform(all_observables.begin(), all_observables.end(), ids.begin(),
                           [](Observable observable) { return id(observable); });
            throw UsageError(unknown_word("observable", name, ids));
        }
        if (std::find(wanted.begin(), wanted.end(), *known) == wanted.end()) wanted.push_back(*known);
        begin = end + 1;
    }
    return wanted;
}

double virial(const Forces& forces, const Field<double>& displacement) {
    return std::visit(
        [&](const auto& layout) { return layout.mass * virial_by_mass(engine<double>(layout), displacement); }, forces);
}

Observables::Observables(Plan scene, std::vector<Observable> wanted)
    : scene_(std::move(scene)), wanted_(std::move(wanted)) {
    for (std::size_t i = 0; i < scene_.reference.count; ++i) {
        if (!is_fixed(scene_.forces, i)) moving_.push_back(i);
    }
}

std::vector<std::optional<double>> Observables::of(const State<double>& state) {
    std::vector<std::optional<double>> values;
    for (const Observable observable : wanted_) {
        switch (observable) {
            case Observable::kT:
                values.push_back(kT(state.velocity));
                break;
            case Observable::pressure:
                values.push_back(pressure(state));
                break;
            case Observable::msd:
                values.emplace_back(mean_squared_displacement(state.displacement));
                break;
        }
    }
    return values;
}

std::optional<double> Observables::kT(const Field<double>& velocity) const {
    const bool free = moving_.size() == scene_.reference.count;
    const double degrees = 3 * static_cast<double>(moving_.size()) - (free ? 3 : 0);
    if (!(degrees > 0)) return std::nullopt;
    Vec3 momentum;
    double masses = 0, twice_kinetic = 0;
    for (const std::size_t i : moving_) momentum = momentum + mass(i) * velocity.at(i), masses += mass(i);
    const Vec3 drift = free ? 1 / masses * momentum : Vec3{};
    for (const std::size_t i : moving_) {
        const Vec3 v = velocity.at(i) - drift;
        twice_kinetic += mass(i) * dot(v, v);
    }
    return twice_kinetic / degrees;
}

std::optional<double> Observables::pressure(const State<double>& state) const {
    const double volume = std::visit(Volume(), scene_.forces);
    const auto heat = kT(state.velocity);
    if (!(volume > 0) || !heat) return std::nullopt;
    return (static_cast<double>(moving_.size()) * *heat + virial(scene_.forces, state.displacement) / 3) / volume;
}

double Observables::mean_squared_displacement(const Field<double>& displacement) {
    if (!first_) first_ = displacement;
    double sum = 0;
    for (const std::size_t i : moving_) {
        const Vec3 moved = displacement.at(i) - first_->at(i);
        sum += dot(moved, moved);
    }
    return moving_.empty() ? 0 : sum / static_cast<double>(moving_.size());
}

}  // namespace steplab
