// What is said of scenes, that their motion keeps energy and momenta, against the motion itself.

#include "models/conservation.hpp"
#include "models/scene/scene_particles.hpp"
#include "support/runs.hpp"
#include "support/scene_texts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace steplab::test {
namespace {

// To a tolerance of 1e-12 a step, what is kept stays within 1e-9, energies where balls touch within 1e-7; what is not
// kept moves by more than 1e-6.
constexpr double kept_within = 1e-9, energy_kept_within = 1e-7, changed_by = 1e-6;

/// Sums over the particles, and what is summed without its signs and directions.
struct Sums {
    Diagnostics now;
    double momenta = 0, levers = 0;

    explicit Sums(const Simulation& simulation) : now(simulation.diagnostics()) {
        const RunDescription& run = simulation.description();
        const Scene scene = model_of(run).scene(run.scene);
        const SceneParticles particles(scene);
        const Frame frame = simulation.frame();
        for (std::size_t i = 0; i < frame.positions.size(); ++i) {
            const double momentum = particles[i].mass * length(frame.velocities[i]);
            momenta += momentum;
            levers += length(frame.positions[i]) * momentum;
        }
    }
};

/// How far the sums have moved in a run, in units of what is summed.
struct Moved {
    double momentum = 0, angular_momentum = 0, energy = 0;
    bool turns = false;  ///< there is an angular momentum: none of a motion that is symmetric

    void add(const Sums& start, const Sums& now) {
        const double momenta = start.momenta + now.momenta, levers = start.levers + now.levers;
        const double energies = start.now.kinetic + now.now.kinetic;
        const auto part = [](double change, double all) { return all > 0 ? change / all : 0; };
        momentum = std::max(momentum, part(length(now.now.momentum - start.now.momentum), momenta));
        angular_momentum =
            std::max(angular_momentum, part(length(now.now.angular_momentum - start.now.angular_momentum), levers));
        energy = std::max(energy, part(std::abs(now.now.energy - start.now.energy), energies));
        turns = turns || length(start.now.angular_momentum) + length(now.now.angular_momentum) > kept_within * levers;
    }
};

/// An accurate motion of so many steps that the scene opens with.
Moved moved(Simulation& simulation, std::uint64_t steps) {
    const Sums start(simulation);
    Moved all;
    for (int part = 0; part < 4; ++part) {
        simulation.advance(steps / 4);
        all.add(start, Sums(simulation));
    }
    EXPECT_FALSE(simulation.divergence());
    return all;
}

void expect_claimed(RunDescription run, std::uint64_t steps, const std::string& name) {
    const double dt = run.dt;
    run = with_method(std::move(run), "dop853");
    run.method_parameters.set("tolerance", 1e-12);
    run.dt = dt;
    Simulation simulation(run);
    const Conservation claim = simulation.conservation();
    const Moved by = moved(simulation, steps);
    const auto expect = [&](bool kept, double change, const char* what, double within = kept_within) {
        EXPECT_TRUE(kept ? change < within : change > changed_by)
            << name << ": " << what << (kept ? " is said to be kept: " : " is said to change: ") << change;
    };
    expect(claim.energy, by.energy, "energy", energy_kept_within);
    expect(claim.momentum, by.momentum, "momentum");
    expect(claim.angular_momentum || !by.turns, by.angular_momentum, "angular momentum");
    EXPECT_EQ(claim.cause.empty(), claim.momentum && claim.angular_momentum && claim.energy) << name;
}

TEST(SceneConservation, of_shipped_scenes_is_what_the_motion_keeps) {
    for (const std::string& name : shipped_scenes()) {
        const RunDescription run = describe(find_scene(name));
        const double particles = model_of(run).particles(run.scene);
        expect_claimed(run, particles > 500 ? 8 : particles > 100 ? 24 : 200, name);
    }
}

struct Case {
    const char* name;
    const char* terms;
    bool energy, momentum, angular_momentum;
    const char* cause;
};

constexpr const char* three_particles =
    "steplab = 1\n[[particles]]\ngroup = \"a\"\nposition = [1, 0.2, 0]\nvelocity = [0.1, 0.5, 0.2]\n"
    "[[particles]]\ngroup = \"b\"\nposition = [2, 0.1, 0.4]\nmass = 2\ncharge = 1\n"
    "[[particles]]\ngroup = \"c\"\nposition = [0, 0, 0]\nfixed = true\n";

const std::vector<Case>& cases() {
    static const std::vector<Case> all{
        {"a spring", "[[springs]]\npairs = [[\"a\", \"b\"]]\nk = 5\nlength = 1\n", true, true, true, ""},
        {"a dashpot", "[[springs]]\npairs = [[\"a\", \"b\"]]\nk = 5\ndamping = 1\n", false, true, true, "dashpots"},
        {"a dashpot to a fixed particle", "[[springs]]\npairs = [[\"a\", \"c\"]]\nk = 5\nlength = 0.8\ndamping = 1\n",
         false, false, true, "a fixed particle"},
        {"held at the origin", "[[springs]]\npairs = [[\"a\", \"c\"]]\nk = 5\nlength = 0.5\n", true, false, true,
         "a fixed particle"},
        {"held elsewhere",
         "[[springs]]\npairs = [[\"a\", \"c\"]]\nk = 5\nlength = 0.5\n[[fix]]\nparticles = [\"c\"]\n"
         "displacement = [0, 1, 0]\n",
         true, false, false, "a fixed particle"},
        {"held by a pair force", "[[pairs]]\npotential = \"gravity\"\nG = 1\nsoftening = 0.1\n", true, false, true,
         "a fixed particle"},
        {"a pair force apart from it",
         "[[pairs]]\nbetween = [\"a\", \"b\"]\npotential = \"gravity\"\nG = 1\nsoftening = 0.1\n", true, true, true,
         ""},
        {"gravity", "[[fields]]\ngravity = [0, -1, 0]\n", true, false, false, "gravity"},
        {"gravity of the fixed particle alone", "[[fields]]\nparticles = \"c\"\ngravity = [0, -1, 0]\n", true, true,
         true, ""},
        {"accelerations that cancel",
         "[[fields]]\nparticles = \"a\"\ngravity = [0, -2, 0]\n[[fields]]\nparticles = \"b\"\ngravity = [0, 1, 0]\n",
         true, true, false, "outer forces"},
        {"drag of one", "[[fields]]\nparticles = \"a\"\ndrag = 0.3\n", false, false, false, "drag"},
        {"drag of the fixed particle alone", "[[fields]]\nparticles = \"c\"\ndrag = 0.3\n", true, true, true, ""},
        {"a trap", "[[fields]]\npotential = \"x^2 + y^2 + z^2\"\n", true, false, true, "outer forces"},
        {"a trap of charges", "[[fields]]\nparticles = [\"a\", \"b\"]\npotential = \"q * sqrt(x^2 + y^2 + z^2)\"\n",
         true, false, true, "outer forces"},
        {"a trough", "[[fields]]\npotential = \"x^2 + y^2\"\n", true, false, false, "outer forces"},
        {"a trap beside the origin", "[[fields]]\npotential = \"(x - 1)^2 + y^2 + z^2\"\n", true, false, false,
         "outer forces"},
        {"a field of the fixed particle alone", "[[fields]]\nparticles = \"c\"\npotential = \"x^2 + y\"\n", true, true,
         true, ""},
        {"a box", "[box]\nsize = [9, 9, 9]\n", true, true, true, ""},
        {"a box, and springs across its border",
         "[[springs]]\npairs = [[\"a\", \"b\"]]\nk = 5\nlength = 1\n[[fix]]\nparticles = [\"a\"]\ndisplacement = [6, "
         "2, 0]\n[box]\nsize = [9, 9, 9]\n",
         true, true, false, "periodic boundary conditions"},
    };
    return all;
}

TEST(SceneConservation, of_every_term_is_what_the_motion_keeps) {
    for (const Case& c : cases()) {
        RunDescription run = describe(read_scene(std::string(three_particles) + c.terms));
        run.dt = 0.01;
        const Conservation claim = Simulation(run).conservation();
        EXPECT_EQ(claim.energy, c.energy) << c.name;
        EXPECT_EQ(claim.momentum, c.momentum) << c.name;
        EXPECT_EQ(claim.angular_momentum, c.angular_momentum) << c.name;
        EXPECT_EQ(claim.cause, c.cause) << c.name;
        expect_claimed(run, 200, c.name);
    }
}

// A wall that no particle has come near yet is one all the same.
TEST(SceneConservation, counts_what_acts_far_away_only) {
    const auto claim = [](const char* potential) {
        return Simulation(describe(read_scene(std::string(three_particles) + "[[fields]]\npotential = \"" + potential +
                                              "\"\n")))
            .conservation();
    };
    EXPECT_FALSE(claim("max(0, x - 500)^2").angular_momentum);
    EXPECT_FALSE(claim("x^2 + y^2 + z^2 + max(0, x - 500)^2").angular_momentum);
    EXPECT_TRUE(claim("max(0, x^2 + y^2 + z^2 - 250000)^2").angular_momentum) << "a round wall";
}

}  // namespace
}  // namespace steplab::test
