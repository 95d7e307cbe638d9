#include "models/conservation.hpp"

#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace steplab::test {
namespace {

struct Case {
    std::string_view model;
    std::vector<std::pair<std::string_view, double>> settings;
};

RunDescription run_of_case(const Case& c) {
    RunDescription run = run_of(c.model, "kahan-li-8", Precision::double_, 0.005);
    for (const auto& [name, value] : c.settings) run.scene.set(name, value);
    return run;
}

const std::vector<Case>& moving_scenes() {
    static const std::vector<Case> cases{{"free", {}},
                                         {"oscillator", {}},
                                         {"oscillator", {{"c", 0.2}}},
                                         {"chain", {}},
                                         {"chain", {{"fixed", 0}}},
                                         {"chain", {{"fixed", 0}, {"c", 0.3}}},
                                         {"mesh", {}},
                                         {"rope", {}},
                                         {"rope", {{"c", 0}}},
                                         {"morse", {{"v0", 5}}},
                                         {"morse", {{"v0", 5}, {"cutoff", 3}}},
                                         {"crystal", {{"edge", 5}}}};
    return cases;
}

/// How far a sum has moved, in units of what is summed.
struct Moved {
    double momentum, angular_momentum, energy;
    bool turns;  ///< there is an angular momentum: none where all move along a line through the origin
};

Moved moved(Simulation& simulation, const RunDescription& run, std::uint64_t steps) {
    const Diagnostics start = simulation.diagnostics();
    simulation.advance(steps);
    const Diagnostics end = simulation.diagnostics();
    const double reach = 20;  // m, of every scene here
    const double speed = end.max_speed + start.max_speed;
    const double mass = run.scene["m"] * static_cast<double>(simulation.particles());
    return {length(end.momentum - start.momentum) / (mass * speed),
            length(end.angular_momentum - start.angular_momentum) / (mass * speed * reach),
            std::abs(end.energy - start.energy) / (mass * speed * speed),
            length(start.angular_momentum) > 0 || length(end.angular_momentum) > 0};
}

// The motion itself, computed accurately for 4 s: what it keeps stays within 1e-9 of the sizes that are summed, what it
// does not keep moves by more; energies within 1e-5, the error of the method where particles meet.
TEST(Conservation, is_what_the_motion_keeps) {
    for (const Case& c : moving_scenes()) {
        const RunDescription run = run_of_case(c);
        Simulation simulation(run);
        const Conservation claim = simulation.conservation();
        const Moved by = moved(simulation, run, 800);
        EXPECT_EQ(claim.momentum, by.momentum < 1e-9) << command_line(run) << ' ' << by.momentum;
        EXPECT_EQ(claim.energy, by.energy < 1e-5) << command_line(run) << ' ' << by.energy;
        EXPECT_EQ(claim.angular_momentum || !by.turns, by.angular_momentum < 1e-9)
            << command_line(run) << ' ' << by.angular_momentum;
        EXPECT_EQ(claim.cause.empty(), claim.momentum && claim.angular_momentum && claim.energy) << command_line(run);
    }
}

TEST(Conservation, names_its_cause) {
    const auto cause = [](std::string_view id, Settings settings = {}) {
        return Simulation(run_of(id, "rk4", Precision::double_, 0.01, settings)).conservation().cause;
    };
    EXPECT_EQ(cause("free"), "constant forces");
    EXPECT_EQ(cause("chain"), "a fixed particle");
    EXPECT_EQ(cause("chain", {{"c", 1}}), "drag");
    EXPECT_EQ(cause("mesh"), "fixed particles");
    EXPECT_EQ(cause("rope", {{"c", 0}}), "gravity");
    EXPECT_EQ(cause("crystal"), "periodic boundary conditions");
    EXPECT_EQ(cause("morse"), "");
}

}  // namespace
}  // namespace steplab::test
