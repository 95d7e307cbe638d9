// Encounters of particles in scenes that people write: methods that choose their own steps jump over none.

#include "core/error.hpp"
#include "io/scene_file.hpp"
#include "sim/run/simulation.hpp"
#include "support/asked.hpp"
#include "support/integral.hpp"
#include "support/runs.hpp"
#include "support/scene_texts.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace steplab::test {
namespace {

/// 34 digits: near a turning point nearly equal energies are subtracted.
using Real = boost::multiprecision::cpp_bin_float_quad;

/// A potential V(r) that ends at a distance.
struct ShortRange {
    std::string name;
    std::string text;  ///< of the scene file
    double end;        ///< beyond it there is no force, or less than 1e-30
    std::function<Real(Real)> energy;
};

/// V(r) - V(c) - (r - c) V'(c) below a cut-off c: what a scene file's cut-off makes of a potential.
ShortRange cut(ShortRange potential, double cutoff, std::function<Real(Real)> slope) {
    const Real c = cutoff, there = potential.energy(c), slope_there = slope(c);
    potential.name += fmt::format(", cut-off {}", cutoff);
    potential.text += fmt::format("cutoff = {}\n", cutoff);
    potential.end = cutoff;
    potential.energy = [=, uncut = potential.energy](Real r) { return uncut(r) - there - (r - c) * slope_there; };
    return potential;
}

ShortRange morse(double k, double cutoff) {
    const Real b = sqrt(Real(k) / 2);
    const auto e = [b](Real r) -> Real { return exp(-b * (r - Real(0.5))); };
    return cut({fmt::format("morse, k {}", k), fmt::format("potential = \"morse\"\nD = 1\nk = {}\nr0 = 0.5\n", k), 0,
                [e](Real r) -> Real { return e(r) * (e(r) - 2); }},
               cutoff, [e, b](Real r) -> Real { return 2 * b * e(r) * (1 - e(r)); });
}

ShortRange lennard_jones(double sigma, double cutoffs) {
    const auto s6 = [sigma](Real r) -> Real { return pow(sigma / r, 6); };
    return cut({fmt::format("lennard-jones, sigma {}", sigma),
                fmt::format("potential = \"lennard-jones\"\nepsilon = 1\nsigma = {}\n", sigma), 0,
                [s6](Real r) -> Real { return 4 * s6(r) * (s6(r) - 1); }},
               cutoffs * sigma, [s6](Real r) -> Real { return -24 * s6(r) * (2 * s6(r) - 1) / r; });
}

/// Typed, without a cut-off: from outside nothing of it is seen.
ShortRange hill(double height, double width) {
    return {fmt::format("hill of {}, width {}", height, width),
            fmt::format("potential = \"A*exp(-(r/w)^2)\"\nA = {}\nw = {}\n", height, width), 8.5 * width,
            [height, width](Real r) -> Real { return height * exp(-(r / width) * (r / width)); }};
}

/// Where a potential, which falls from the inside, has this energy.
Real turning_point(const std::function<Real(Real)>& potential, Real energy, Real outside) {
    Real inside = 1e-12;
    for (int i = 0; i < 120; ++i) {
        const Real middle = (inside + outside) / 2;
        (potential(middle) > energy ? inside : outside) = middle;
    }
    return outside;
}

/// A bullet that flies at one particle at rest, head on, from 10 m away.
struct HeadOn {
    ShortRange potential;
    double target_mass, bullet_mass, speed;

    double reduced_mass() const { return target_mass * bullet_mass / (target_mass + bullet_mass); }
    Real energy() const { return Real(reduced_mass()) * speed * speed / 2; }
    bool passes() const { return potential.energy(Real(1e-12)) < energy(); }
    /// Where passing and turning are so near to each other that neither is asked for.
    bool is_undecided() const {
        const Real barrier = potential.energy(Real(1e-12));
        return abs(barrier - energy()) < Real(0.01) * std::max(energy(), barrier);
    }

    Real turning_point() const { return steplab::test::turning_point(potential.energy, energy(), potential.end); }

    /// How long they are within reach: 2 int dr / speed, in r = nearest + s^2.
    Real duration() const {
        const Real nearest = passes() ? Real(1e-12) : turning_point(), mass = reduced_mass();
        const auto time = [&](Real s) -> Real {
            const Real left = 2 * (energy() - potential.energy(nearest + s * s)) / mass;
            return left > 0 ? 4 * s / sqrt(left) : Real(0);
        };
        return integral(time, Real(sqrt(Real(potential.end) - nearest)), Real(1e-14));
    }

    /// The bullet's place at a time behind the encounter.
    double bullet_at(double time, Real within) const {
        const Real behind = potential.end + speed * (time - (10 - potential.end) / speed - within);
        const double all = target_mass + bullet_mass;
        const Real centre = bullet_mass * (10 - Real(speed) * time) / all;
        return static_cast<double>(centre + target_mass / all * (passes() ? -behind : behind));
    }

    RunDescription run(std::string_view method, double tolerance, double dt) const {
        const std::string text = fmt::format(
            "steplab = 1\n[[particles]]\ngroup = \"target\"\nmass = {}\n[[particles]]\ngroup = \"bullet\"\nmass = {}\n"
            "position = [10, 0, 0]\nvelocity = [{}, 0, 0]\n[[pairs]]\nbetween = [\"target\", \"bullet\"]\n{}",
            target_mass, bullet_mass, -speed, potential.text);
        RunDescription description = with_method(describe(read_scene(text)), method);
        description.method_parameters.set("tolerance", tolerance);
        description.dt = dt;
        return description;
    }
};

/// With a cusp where two particles meet.
ShortRange cusp(double height, double width) {
    return {fmt::format("cusp of {}, width {}", height, width),
            fmt::format("potential = \"A*exp(-r/w)\"\nA = {}\nw = {}\n", height, width), 75 * width,
            [height, width](Real r) -> Real { return height * exp(-r / width); }};
}

std::vector<ShortRange> potentials() {
    std::vector<ShortRange> all{hill(0.1, 0.5),  hill(3, 0.5),   hill(3, 0.05),
                                hill(-0.5, 0.2), cusp(0.1, 0.1), cusp(-0.5, 0.05)};
    for (const double k : {0.5, 50.0, 500.0})
        for (const double cutoff : {0.8, 1.5, 3.0}) all.push_back(morse(k, cutoff));
    for (const double sigma : {0.1, 1.0}) all.push_back(lennard_jones(sigma, 2.5));
    return all;
}

class SceneEncounters : public testing::TestWithParam<std::string_view> {};

// With 40 for dt, the whole flight is one step of output and free for the method to divide.
TEST_P(SceneEncounters, two_particles_head_on_follow_the_closed_form) {
    double worst = 0;
    for (const ShortRange& potential : potentials())
        for (const auto& [mass, speed] : {std::pair{1.0, 0.5}, {1.0, 1.0}, {4.0, 3.0}}) {
            const HeadOn scene{potential, 1, mass, speed};
            if (scene.is_undecided()) continue;
            const Real within = scene.duration();
            const double time = std::max(40.0, std::ceil(static_cast<double>(20 / Real(speed) + within)));
            for (const double tolerance : {1e-4, 1e-7, 1e-10, 1e-13})
                for (const double dt : {0.1, 1.0, time}) {
                    Simulation simulation(scene.run(GetParam(), tolerance, dt));
                    simulation.advance(static_cast<std::uint64_t>(std::lround(time / dt)));
                    const double exact =
                        scene.bullet_at(static_cast<double>(std::lround(time / dt)) * simulation.dt(), within);
                    const double error = std::abs(simulation.frame().positions[1].x - exact) / asked_error(tolerance);
                    EXPECT_LT(error, 1) << potential.name << ", mass " << mass << ", speed " << speed << ", tolerance "
                                        << tolerance << ", dt " << dt << ": exact " << exact;
                    worst = std::max(worst, error);
                }
        }
    RecordProperty("worst_ratio", std::to_string(worst));
}

RunDescription tolerant_run(const std::string& text, std::string_view method, double tolerance, double dt) {
    RunDescription description = with_method(describe(read_scene(text)), method);
    description.method_parameters.set("tolerance", tolerance);
    description.dt = dt;
    return description;
}

/// A particle that flies along x at a barrier or a well that stands across its way, from 10 m before it.
RunDescription barrier_run(std::string_view method, double height, double width, double tolerance, double dt) {
    const std::string text = fmt::format(
        "steplab = 1\n[[particles]]\nposition = [-10, 0, 0]\nvelocity = [1, 0, 0]\n[[fields]]\n"
        "potential = \"A*exp(-(x/w)^2)\"\nA = {}\nw = {}\n",
        height, width);
    return tolerant_run(text, method, tolerance, dt);
}

/// Where it is then. Its energy is 0.5: what is higher sends it back.
double behind_barrier(double height, double width, double time) {
    const auto potential = [=](Real x) -> Real { return height * exp(-(x / width) * (x / width)); };
    const bool passes = height < 0.5;
    const Real end = 8.5 * width, nearest = passes ? Real(0) : turning_point(potential, Real(0.5), end);
    const auto pace = [&](Real s) -> Real {  // in x = nearest + s^2
        const Real left = 1 - 2 * potential(nearest + s * s);
        return left > 0 ? 2 * s / sqrt(left) : Real(0);
    };
    const Real within = 2 * integral(pace, Real(sqrt(end - nearest)), Real(1e-14));
    const Real behind = end + time - (10 - end) - within;
    return static_cast<double>(passes ? behind : -behind);
}

/// A run over this time ends where it should, whatever the tolerance and dt. `run_of`: the run with these; `end_of`:
/// what is looked at of its frame.
template <class RunOf, class EndOf>
void expect_end(double exact, double time, RunOf run_of, EndOf end_of) {
    for (const double tolerance : {1e-4, 1e-7, 1e-10})
        for (const double dt : {0.1, time}) {
            Simulation simulation(run_of(tolerance, dt));
            simulation.advance(static_cast<std::uint64_t>(std::lround(time / dt)));
            EXPECT_NEAR(end_of(simulation.frame()), exact, 2 * asked_error(tolerance))
                << "tolerance " << tolerance << ", dt " << dt;
        }
}

// No length is known of a field that the tolerance could go with: narrow ones cost twice what pairs may.
TEST_P(SceneEncounters, a_field_on_the_way_is_not_jumped_over) {
    for (const double width : {0.05, 0.5})
        for (const double height : {0.3, 0.6, 5.0, -2.0}) {
            SCOPED_TRACE(fmt::format("height {}, width {}", height, width));
            const auto run = [&](double tolerance, double dt) {
                return barrier_run(GetParam(), height, width, tolerance, dt);
            };
            expect_end(behind_barrier(height, width, 40), 40, run,
                       [](const Frame& frame) { return frame.positions[0].x; });
        }
}

/// Two particles of mass 1 that approach each other at 1 m/s from 10 m, with a shell at 5 m around each, and others.
RunDescription shell_run(std::string_view method, double height, double width, double tolerance, double dt,
                         const std::string& others = {}) {
    const std::string text = fmt::format(
        "steplab = 1\n[[particles]]\n[[particles]]\nposition = [10, 0, 0]\nvelocity = [-1, 0, 0]\n[[pairs]]\n"
        "potential = \"A*exp(-((r-5)/w)^2)\"\nA = {}\nw = {}\n{}",
        height, width, others);
    return tolerant_run(text, method, tolerance, dt);
}

double distance_along_x(const Frame& frame) { return frame.positions[1].x - frame.positions[0].x; }

/// How far behind the first one the second then is. Their relative energy is 1/4: what is higher sends them back, else
/// they go through both shells.
double behind_shells(double height, double width, double time) {
    const auto speed2 = [=](Real x) -> Real { return 1 - 4 * height * exp(-(x / width) * (x / width)); };
    const Real end = Real(8.5) * width;
    if (height < 0.25) {
        const auto pace = [&](Real x) -> Real { return 1 / sqrt(speed2(x - end)); };
        const Real across = integral(pace, Real(2 * end), Real(1e-14));
        return static_cast<double>(10 - time - 2 * (2 * end - across));
    }
    const Real turning = width * sqrt(log(Real(4 * height)));
    const auto pace = [&](Real s) -> Real {  // in x = turning point + s^2
        const Real left = speed2(turning + s * s);
        return left > 0 ? 2 * s / sqrt(left) : Real(0);
    };
    const Real within = 2 * integral(pace, Real(sqrt(end - turning)), Real(1e-14));
    return static_cast<double>(5 + end + time - (5 - end) - within);
}

// A shell may be far narrower than its distance, and nothing of it be felt elsewhere.
TEST_P(SceneEncounters, a_narrow_shell_on_the_way_is_not_jumped_over) {
    for (const double width : {0.02, 0.01, 0.001})
        for (const double height : {0.15, 0.5, 20.0, -2.0}) {
            SCOPED_TRACE(fmt::format("height {}, width {}", height, width));
            const auto run = [&](double tolerance, double dt) {
                return shell_run(GetParam(), height, width, tolerance, dt);
            };
            expect_end(behind_shells(height, width, 20), 20, run, distance_along_x);
        }
}

// Of the pairs of a crowd no one is asked for alone.
TEST_P(SceneEncounters, a_narrow_shell_in_a_crowd_is_not_jumped_over) {
    const std::string crowd = "[[particles]]\nposition = [0, 1000, 0]\nline = { count = 49, step = [10, 0, 0] }\n";
    for (const double width : {0.1, 0.01})
        for (const double height : {0.15, 20.0}) {
            Simulation simulation(shell_run(GetParam(), height, width, 1e-7, 20, crowd));
            simulation.advance(1);
            EXPECT_NEAR(distance_along_x(simulation.frame()), behind_shells(height, width, 20), 2 * asked_error(1e-7))
                << "height " << height << ", width " << width;
        }
}

// A force may be too weak to be felt anywhere, or act nowhere at all.
TEST_P(SceneEncounters, a_crowd_that_feels_nothing_goes_on) {
    for (const std::string force : {"potential = \"0*r\"\n", "potential = \"1e-30*exp(-r)\"\n"}) {
        const std::string crowd =
            "steplab = 1\n[[particles]]\nvelocity = [0, 1, 0]\n"
            "line = { count = 60, step = [10, 0, 0] }\n[[pairs]]\n" +
            force;
        Simulation simulation(tolerant_run(crowd, GetParam(), 1e-9, 0.5));
        simulation.advance(4);
        EXPECT_NEAR(simulation.frame().positions[59].y, 2, 1e-12) << force;
    }
}

// A series ends where a pair crosses a cut-off; springs have none, however many there are.
TEST(SceneSeries, are_refused_for_cutoffs_of_many_particles_alone) {
    const auto refusal = [](const std::string& forces) {
        try {
            check(with_method(describe(read_scene(row_between_walls(60) + forces)), "taylor"));
            return std::string("runs");
        } catch (const UsageError& error) {
            return std::string(error.what());
        }
    };
    const std::string pairs = "[[pairs]]\npotential = \"lennard-jones\"\nepsilon = 1e-3\nsigma = 0.1\n";
    EXPECT_EQ(refusal(""), "runs");
    EXPECT_EQ(refusal(pairs), "runs");
    EXPECT_NE(refusal(pairs + "cutoff = 1\n").find("for up to 50 particles, not for 62"), std::string::npos);
    EXPECT_NE(refusal(pairs + pairs + "cutoff = 1\n").find("for up to 50 particles, not for 62"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Methods, SceneEncounters,
                         testing::Values("dopri5", "dop853", "rkn-12-10", "taylor", "ias15", "gauss-16"),
                         [](const auto& test) {
                             std::string name(test.param);
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

}  // namespace
}  // namespace steplab::test
