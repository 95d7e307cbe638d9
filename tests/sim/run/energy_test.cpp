#include "sim/run/energy.hpp"

#include "models/forces/layouts.hpp"
#include "sim/steppers/bands.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <variant>
#include <vector>

namespace steplab::test {
namespace {

/// Every layout of forces, also in several pieces and with a last one that is not full.
std::vector<RunDescription> scenes() {
    std::vector<RunDescription> all;
    for (const Model& model : models())
        all.push_back(small_run_of(model.info.id, "velocity-verlet", Precision::double_, 0.01));
    all.push_back(run_of("chain", "euler", Precision::double_, 0.1, {{"n", 9001}, {"c", 0.01}}));
    all.push_back(run_of("mesh", "euler", Precision::float_, 0.1, {{"dim", 131}}));
    all.push_back(run_of("morse", "verlet", Precision::double_, 0.01, {{"cutoff", 1}, {"edge", 4}}));
    return all;
}

struct Moment {
    Plan scene;
    State<double> state;
};
Moment after(const RunDescription& description, std::uint64_t steps) {
    Simulation simulation(description);
    simulation.advance(steps);
    return {model_of(description).plan(description.scene), simulation.state()};
}

Energy energy_of(const Moment& moment, Instructions instructions) {
    EnergyMeter meter(moment.scene, instructions);
    return meter.energy([&](const PortionSink& sink) { sink({0, moment.state.velocity.count(), moment.state}); });
}

double potential_in(const Field<long double>& u, const ConstantForces& forces) {
    long double sum = 0;
    for (std::size_t i = 0; i < u.count(); ++i) sum += forces.mass * forces.step * static_cast<double>(i) * u.y()[i];
    return static_cast<double>(sum);
}
template <class Layout>
double potential_in(const Field<long double>& u, const Layout& forces) {
    return engine<long double>(forces).potential(u).value;
}
double potential_in_long_double(const Moment& moment) {
    const auto u = converted<long double>(moment.state.displacement);
    return std::visit([&](const auto& forces) { return potential_in(u, forces); }, moment.scene.forces);
}

std::vector<double> numbers(const Energy& energy) {
    return {energy.kinetic, energy.potential.value, energy.potential.magnitude, energy.potential.external};
}

TEST(Energies, have_the_same_bits_by_every_instruction_set) {
    for (const RunDescription& description : scenes()) {
        const Moment moment = after(description, 37);
        const auto expected = numbers(energy_of(moment, instructions_here().front()));
        for (const Instructions instructions : instructions_here())
            EXPECT_EQ(numbers(energy_of(moment, instructions)), expected) << description.model << id(instructions);
    }
}

TEST(Energies, have_the_same_bits_by_any_number_of_threads) {
    Moment moment = after(run_of("crystal", "verlet", Precision::double_, 0.005, {{"edge", 12}}), 20);
    const auto expected = numbers(energy_of(moment, fastest_instructions()));
    for (const std::size_t threads : {2u, 3u, 5u}) {
        std::get<NearPairForces>(moment.scene.forces).threads = threads;
        EXPECT_EQ(numbers(energy_of(moment, fastest_instructions())), expected) << threads;
    }
}

// Terms of either sign have a sum as large as the rounding of each: a pair's distance of some ulp, which b = 5 of the
// steepest well multiplies, in its magnitude.
constexpr double rounding = 50 * std::numeric_limits<double>::epsilon();

TEST(Energies, are_those_of_plain_sums_in_long_double) {
    for (const RunDescription& description : scenes()) {
        const Moment moment = after(description, 37);
        const Energy energy = energy_of(moment, fastest_instructions());
        const double magnitude = std::abs(energy.potential.magnitude);
        EXPECT_NEAR(energy.potential.value, potential_in_long_double(moment), rounding * magnitude)
            << description.model;
        long double squares = 0;
        for (const double v : moment.state.velocity.flat()) squares += static_cast<long double>(v) * v;
        const double kinetic = static_cast<double>(squares / 2 * moment.scene.mass);
        EXPECT_NEAR(energy.kinetic, kinetic, rounding * kinetic) << description.model;
    }
}

TEST(Energies, tell_a_particle_that_moved_by_a_millionth) {
    // of those whose particles act on each other
    const auto is_not_free = [](const RunDescription& description) { return description.model != "free"; };
    for (const RunDescription& description : those_where(scenes(), is_not_free)) {
        Moment moment = after(description, 37);
        const Energy before = energy_of(moment, fastest_instructions());
        const std::size_t last = moment.state.displacement.count() - 2;
        moment.state.displacement.set(last, moment.state.displacement.at(last) + Vec3{1e-6, 1e-6, 1e-6});
        const Energy moved = energy_of(moment, fastest_instructions());
        EXPECT_GT(std::abs(moved.potential.value - before.potential.value), rounding * before.potential.magnitude)
            << description.model;
        EXPECT_EQ(moved.kinetic, before.kinetic);
    }
}

}  // namespace
}  // namespace steplab::test
