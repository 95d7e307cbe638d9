// Composed scenes from files whose energies, places of rest and times of return are known.

#include "core/number_text.hpp"
#include "sim/run/simulation.hpp"
#include "support/runs.hpp"
#include "support/scene_texts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

namespace steplab::test {
namespace {

RunDescription run_of(const std::string& text, const char* method, double dt) {
    RunDescription run = with_method(describe(read_scene("steplab = 1\n" + text)), method);
    run.dt = dt;
    return run;
}

/// Unit charges of unit mass on the x axis of a trap whose frequency is 1 along it and 3 across, at rest.
std::string trapped(const std::vector<double>& places) {
    std::string text;
    for (const double x : places) text += "[[particles]]\ncharge = 1\nposition = [" + number_text(x) + ", 0, 0]\n";
    return text + R"toml(
[[pairs]]
potential = "coulomb"
K = 1
[[fields]]
potential = "m / 2 * (x^2 + 9 * (y^2 + z^2))"
)toml";
}

struct IonCase {
    std::size_t ions;
    double outermost;  // James, Appl. Phys. B 66 (1998) 181, table 1: (1/4)^(1/3) and (5/4)^(1/3)
};

class TrappedIons : public testing::TestWithParam<IonCase> {
protected:
    /// All places times a factor.
    static std::vector<double> places(double factor) {
        const double u = GetParam().outermost * factor;
        return GetParam().ions == 2 ? std::vector<double>{-u, u} : std::vector<double>{-u, 0, u};
    }
};

TEST_P(TrappedIons, rest_at_their_places) {
    const Frame frame = frame_after(run_of(trapped(places(1)), "ias15", 0.1), 100);
    // rounding of the force, 1e-16, in ten seconds
    for (std::size_t i = 0; i < GetParam().ions; ++i) EXPECT_NEAR(frame.positions[i].x, places(1)[i], 1e-14);
    const Frame off = frame_after(run_of(trapped(places(1.01)), "ias15", 0.1), 18);
    EXPECT_GT(std::abs(off.positions[0].x - places(1.01)[0]), 0.01) << "the partner";
}

// However many they are, they breathe with sqrt(3) times the frequency of the trap (James 1998, table 2).
TEST_P(TrappedIons, breathe_with_the_root_of_three) {
    const double amplitude = 1e-6;
    const Frame frame = frame_after(run_of(trapped(places(1 + amplitude)), "ias15", 0.1), 100);
    const double swing = (frame.positions[0].x / places(1)[0] - 1) / amplitude;
    EXPECT_NEAR(swing, std::cos(std::sqrt(3.0) * frame.time), 1e-4);  // the next term is of the order of the amplitude
}

INSTANTIATE_TEST_SUITE_P(OfTwoAndThree, TrappedIons,
                         testing::Values(IonCase{2, std::cbrt(0.25)}, IonCase{3, std::cbrt(1.25)}),
                         [](const auto& of) { return std::to_string(of.param.ions); });

// Eight charges of alternating sign on the corners of a cube of side 1: twelve edges, twelve diagonals of faces, four
// of the body.
TEST(KnownAnswer, charges_on_a_cube_have_the_energy_of_their_sum) {
    std::string text = "[[pairs]]\npotential = \"coulomb\"\nK = 1\n";
    for (int corner = 0; corner < 8; ++corner) {
        const int x = corner & 1, y = corner >> 1 & 1, z = corner >> 2;
        text += "[[particles]]\ncharge = " + std::to_string((x + y + z) % 2 == 0 ? 1 : -1) + "\nposition = [" +
                std::to_string(x) + ", " + std::to_string(y) + ", " + std::to_string(z) + "]\n";
    }
    const double sum = -12 + 12 / std::sqrt(2.0) - 4 / std::sqrt(3.0);
    EXPECT_NEAR(Simulation(run_of(text, "rk4", 0.1)).diagnostics().energy, sum, 1e-14);
}

struct Returned {
    double distance, farthest;
};

/// From the perihelion, a = 1 and G m = 1, over ten periods of 2 pi.
Returned after_ten_periods(const char* method, double eccentricity) {
    const double near = 1 - eccentricity, speed = std::sqrt((1 + eccentricity) / (1 - eccentricity));
    const std::string text = "[[particles]]\nfixed = true\n[[particles]]\nposition = [" + number_text(near) +
                             ", 0, 0]\nvelocity = [0, " + number_text(speed) +
                             ", 0]\n[[pairs]]\npotential = \"gravity\"\nG = 1\n";
    RunDescription run = run_of(text, method, std::numbers::pi / 50);
    run.method_parameters.set("tolerance", 1e-13);
    Simulation simulation(run);
    Returned found{0, 0};
    for (int part = 0; part < 20; ++part) {
        simulation.advance(50);
        found.farthest = std::max(found.farthest, length(simulation.frame().positions[1]));
    }
    found.distance = length(simulation.frame().positions[1] - Vec3{near, 0, 0});
    return found;
}

// An error of 1e-13 in the energy is one of 1e-11 in the time of ten periods; at the perihelion of e = 0.99 it is
// passed with speed 14.
TEST(KnownAnswer, eccentric_ellipses_return) {
    for (const char* const method : {"ias15", "dop853", "taylor", "gauss-16", "rkn-12-10"}) {
        for (const double eccentricity : {0.9, 0.99}) {
            const Returned found = after_ten_periods(method, eccentricity);
            EXPECT_LT(found.distance, 1e-7) << method << ' ' << eccentricity;
            EXPECT_NEAR(found.farthest, 1 + eccentricity, 1e-9) << method << ": the aphelion, after half a period";
        }
    }
}

/// The part of its energy that a chain of unit masses and springs between walls has in its first mode.
double share_of_first_mode(const Frame& frame, double energy) {
    const std::size_t intervals = frame.positions.size() - 1;
    const double phase = std::numbers::pi / static_cast<double>(intervals);
    double x = 0, v = 0;
    for (std::size_t i = 1; i < intervals; ++i) {
        const double shape = std::sqrt(2 / static_cast<double>(intervals)) * std::sin(phase * static_cast<double>(i));
        x += shape * (frame.positions[i].x - static_cast<double>(i));
        v += shape * frame.velocities[i].x;
    }
    const double omega = 2 * std::sin(phase / 2);
    return (v * v + omega * omega * x * x) / 2 / energy;
}

// Fermi, Pasta, Ulam, Tsingou (Los Alamos report 1940, 1955), figure 1: 32 masses, alpha = 1/4, all energy in the first
// mode; after some 157 of its periods all but 3 % is there again, and not before.
TEST(KnownAnswer, the_chain_of_fermi_pasta_ulam_and_tsingou_returns) {
    const RunDescription run = describe(find_scene("fermi-pasta-ulam"));
    Simulation simulation(run);
    const double energy = simulation.diagnostics().energy, period = std::numbers::pi / std::sin(std::numbers::pi / 66);
    double least = 1, before = 0, returned = 0;
    for (double periods = 0; periods < 162; periods = simulation.time() / period) {
        simulation.advance(100);
        const double share = share_of_first_mode(simulation.frame(), energy);
        least = std::min(least, share);
        if (periods > 30 && periods < 125) before = std::max(before, share);
        if (periods > 147) returned = std::max(returned, share);
    }
    EXPECT_LT(least, 0.1);
    EXPECT_LT(before, 0.7);
    EXPECT_GT(returned, 0.97);
}

/// Masses of 1, 2, 5 and 1/2 held by springs with a cubic term, a Morse pair and gravity; nothing is symmetric.
const std::string mixed_masses = R"(
[[particles]]
group = "row"
line = { count = 4, step = [1, 0, 0] }
[[fix]]
particles = "row[1]"
mass = 2
velocity = [0.2, 0.1, 0]
[[fix]]
particles = "row[2]"
mass = 5
[[fix]]
particles = "row[3]"
mass = 0.5
velocity = [-0.3, 0, 0.4]
[[springs]]
between = "row"
k = 3
cubic = 2
[[pairs]]
potential = "morse"
D = 1
k = 4
r0 = 1.5
[[fields]]
gravity = [0, -0.5, 0]
)";

class MixedMasses : public testing::TestWithParam<MethodCase> {};

std::vector<MethodCase> methods_of_fixed_steps() {
    std::vector<MethodCase> all;
    for (const MethodCase& c : working_methods()) {
        if (!c.info->adaptive && c.info->order <= 8 && c.precision == Precision::double_) all.push_back(c);
    }
    return all;
}

// The finest two step sizes whose errors rounding leaves alone give the order; a method of order p + 1/2 would fail.
TEST_P(MixedMasses, have_the_stated_order) {
    const double time = 3;
    RunDescription exact = run_of(mixed_masses, "ias15", time);
    exact.method_parameters.set("tolerance", 1e-13);
    const Frame end = frame_after(exact, 1);
    const auto error = [&](std::uint64_t steps) {
        return distance(
            frame_after(run_of(mixed_masses, GetParam().id().c_str(), time / static_cast<double>(steps)), steps), end);
    };
    double coarse = error(8), found = 0;
    for (std::uint64_t steps = 16; steps <= 4096; steps *= 2) {
        const double fine = error(steps);
        if (fine < 3e-12) break;  // of the reference and of rounding, 1e-13
        found = std::log2(coarse / fine);
        coarse = fine;
    }
    EXPECT_NEAR(found, GetParam().info->order, 0.4);
}

INSTANTIATE_TEST_SUITE_P(Catalogue, MixedMasses, testing::ValuesIn(methods_of_fixed_steps()), case_name);

}  // namespace
}  // namespace steplab::test
