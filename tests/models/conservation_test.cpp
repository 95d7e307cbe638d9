#include "models/conservation.hpp"

#include "support/runs.hpp"

#include <gtest/gtest.h>

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

// The motion itself, computed accurately for 4 s: what it keeps stays within 1e-9 of the sizes that are summed, what it
// does not keep moves by more.
TEST(Conservation, is_what_the_motion_keeps) {
    for (const Case& c : moving_scenes()) {
        const RunDescription run = run_of_case(c);
        Simulation simulation(run);
        const Conservation claim = simulation.conservation();
        const Diagnostics start = simulation.diagnostics();
        simulation.advance(800);
        const Diagnostics end = simulation.diagnostics();
        const double mass = run.scene["m"] * static_cast<double>(simulation.particles());
        const double speed = end.max_speed + start.max_speed, reach = 20;  // m, of every scene here
        const double momentum = length(end.momentum - start.momentum) / (mass * speed);
        const double angular = length(end.angular_momentum - start.angular_momentum) / (mass * speed * reach);
        const double energy = std::abs(end.energy - start.energy) / (mass * speed * speed);
        EXPECT_EQ(claim.momentum, momentum < 1e-9) << command_line(run) << momentum;
        EXPECT_EQ(claim.angular_momentum, angular < 1e-9) << command_line(run) << angular;
        EXPECT_EQ(claim.energy, energy < 1e-7) << command_line(run) << energy;
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
