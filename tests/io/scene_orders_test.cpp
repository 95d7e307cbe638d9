// Orders of all methods on scenes that people write: networks of dashpots, all kinds of forces, typed potentials.

#include "sim/run/simulation.hpp"
#include "support/runs.hpp"
#include "support/scene_texts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace steplab::test {
namespace {

using testing::ElementsAre;

/// Dashpots along every direction, several on each particle; a fixed corner, three masses, drag of one.
const std::string dashpot_network = R"(
[[particles]]
group = "net"
grid = { count = [3, 3], steps = [[1, 0, 0], [0, 1, 0.1]] }
[[fix]]
particles = "net[0,0]"
fixed = true
[[fix]]
particles = "net[1,1]"
mass = 5
velocity = [0.3, 0.2, 0.4]
[[fix]]
particles = "net[2,2]"
mass = 0.5
velocity = [-0.2, 0.3, 0.1]
[[springs]]
between = "net"
along = "both"
k = 3
damping = 0.8
cubic = 1
[[fields]]
particles = "net[2,0]"
drag = 0.7
)";

/// A damped row on a wall, charges in a trap above it, forces within and across.
const std::string forces_of_all_kinds = R"toml(
[[particles]]
group = "wall"
fixed = true
[[particles]]
group = "row"
position = [1, 0.1, 0]
line = { count = 3, step = [1, 0.2, 0.1] }
mass = 2
[[particles]]
group = "ions"
position = [0.5, 2, 0.3]
line = { count = 3, step = [1.2, 0.1, -0.2] }
charge = 0.8
[[fix]]
particles = "row[2]"
velocity = [0.2, 0.5, -0.3]
mass = 0.7
[[fix]]
particles = "ions[1]"
velocity = [-0.3, 0, 0.4]
charge = 1.1
[[springs]]
between = "row"
pairs = [["wall", "row[0]"]]
k = 6
quadratic = 0.4
damping = 0.5
[[pairs]]
between = ["row", "ions"]
potential = "morse"
D = 0.5
k = 2
r0 = 1.5
[[pairs]]
between = "ions"
potential = "coulomb"
K = 1
softening = 0.2
[[pairs]]
potential = "gravity"
G = 0.1
softening = 0.5
[[fields]]
particles = "row"
gravity = [0, -0.5, 0]
[[fields]]
particles = "ions"
potential = "stiff/2*(x^2/4 + (y - 2)^2 + z^2)"
stiff = 1.5
drag = 0.3
)toml";

/// A Gaussian well and powers, in a typed trap.
const std::string typed_trap = R"toml(
[[particles]]
group = "a"
mass = 2
velocity = [0.1, 0.2, 0]
[[particles]]
group = "b"
position = [1.3, 0, 0]
velocity = [-0.2, 0.1, 0.1]
[[particles]]
group = "c"
position = [0, 1.4, 0.2]
mass = 3
[[pairs]]
potential = "-A*exp(-(r - 1.2)^2/w^2) + C/r^3 + 0.1*r^2"
A = 1.5
w = 0.8
C = 0.2
[[fields]]
potential = "trap/2*(x^2 + 2*y^2 + 3*z^2)"
trap = 0.5
)toml";

const std::string typed_trap_with_drag =
    replaced(replaced(typed_trap, "mass = 3", "mass = 2"), "velocity = [-0.2, 0.1, 0.1]",
             "velocity = [-0.2, 0.1, 0.1]\nmass = 2") +
    "[[fields]]\ndrag = 0.4\n";

RunDescription ordered_run(const std::string& text, const MethodInfo& info, double dt) {
    RunDescription run = with_method(describe(read_scene("steplab = 1\n" + text)), info.id);
    run.dt = dt;
    return run;
}

struct ReachedState {
    Frame frame;
    double evaluations = 0;
};
ReachedState state_reached(const RunDescription& run, std::uint64_t steps) {
    Simulation simulation(run);
    simulation.advance(steps);
    EXPECT_FALSE(simulation.divergence()) << command_line(run);
    return {simulation.frame(), static_cast<double>(simulation.evaluations())};
}
ReachedState to_tolerance(const std::string& text, const MethodInfo& info, double time, double tolerance) {
    RunDescription run = ordered_run(text, info, time);
    run.method_parameters.set("tolerance", tolerance);
    return state_reached(run, 1);
}

/// Where the scene is after a time: right to some 1e-15.
const Frame& right_place(const std::string& text, double time) {
    static std::map<std::pair<std::string, double>, Frame> known;
    const auto [place, unknown] = known.try_emplace({text, time});
    if (unknown) {
        place->second = to_tolerance(text, method("ias15").info, time, 1e-15).frame;
        const Frame other = to_tolerance(text, method("dop853").info, time, 1e-13).frame;
        EXPECT_LT(distance(place->second, other), 1e-11) << "two references agree";
    }
    return place->second;
}

constexpr double measured_time = 4;

double error_of(const std::string& text, const MethodInfo& info, std::uint64_t steps) {
    const RunDescription run = ordered_run(text, info, measured_time / static_cast<double>(steps));
    return distance(state_reached(run, steps).frame, right_place(text, measured_time));
}

/// The power of dt with which the error falls: of the finest steps whose errors are a thousand times rounding
/// (positions are about 1), where the next term of the error counts least, but of at most 2048.
double measured_order(const std::string& text, const MethodInfo& info) {
    double order = 0, coarse = error_of(text, info, 16);
    for (std::uint64_t steps = 32; steps <= 2048; steps *= 2) {
        const double fine = error_of(text, info, steps);
        if (fine < 3e-13) break;
        order = std::log2(coarse / fine);
        coarse = fine;
    }
    return order;
}

/// The same of order 16, whose errors fall from 1e-8 to rounding within a factor of 2.5 of the step and scatter: the
/// slope of a line through all of them.
double fitted_order(const std::string& text, const MethodInfo& info) {
    double count = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (std::uint64_t steps = 9; steps <= 24; ++steps) {
        const double error = error_of(text, info, steps), at = std::log(static_cast<double>(steps));
        if (error < 3e-15) break;
        count += 1, x += at, y += std::log(error), xx += at * at, xy += at * std::log(error);
    }
    return -(count * xy - x * y) / (count * xx - x * x);
}

/// A method that chooses its steps: its error follows the tolerance, and falls with the power of its work that is its
/// order. How many steps it takes depends on where it meets the end and on those that are refused; at loose tolerances
/// on how far steps may go into forces, too.
void expect_order_by_tolerance(const std::string& text, const MethodInfo& info) {
    constexpr double time = 12, loose = 1e-6, tight = 1e-11;
    const ReachedState first = to_tolerance(text, info, time, loose), last = to_tolerance(text, info, time, tight);
    const double coarse = distance(first.frame, right_place(text, time));
    const double fine = distance(last.frame, right_place(text, time));
    EXPECT_LT(fine, 200 * tight) << info.id;
    const double by_tolerance = std::log(coarse / fine) / std::log(loose / tight);
    EXPECT_GT(by_tolerance, 0.7) << info.id << ' ' << coarse << ' ' << fine;
    EXPECT_LT(by_tolerance, 1.4) << info.id << ' ' << coarse << ' ' << fine;
    if (info.id == "taylor") return;  // it chooses its order too
    const double by_work = std::log(coarse / fine) / std::log(last.evaluations / first.evaluations);
    EXPECT_GT(by_work, 0.75 * info.order) << info.id;
    EXPECT_LT(by_work, 1.5 * info.order) << info.id;
}

class SceneOrders : public testing::TestWithParam<MethodCase> {
protected:
    static void expect_orders(const std::string& text, int order) {
        const MethodInfo& info = *GetParam().info;
        if (info.adaptive)
            expect_order_by_tolerance(text, info);
        else if (order > 8)
            EXPECT_NEAR(fitted_order(text, info), order, 2) << info.id;
        else
            EXPECT_NEAR(measured_order(text, info), order, 0.05 + 0.025 * order) << info.id;
    }
};

TEST_P(SceneOrders, with_a_network_of_dashpots) {
    const int order = GetParam().info->order_with_damping;
    if (order > 0) expect_orders(dashpot_network, order);
}

TEST_P(SceneOrders, with_forces_of_all_kinds) {
    const int order = GetParam().info->order_with_damping;
    if (order > 0) expect_orders(forces_of_all_kinds, order);
    const std::string undamped = replaced(replaced(forces_of_all_kinds, "damping = 0.5\n", ""), "drag = 0.3\n", "");
    expect_orders(undamped, GetParam().info->order);
}

TEST_P(SceneOrders, with_a_typed_potential) {
    expect_orders(typed_trap, GetParam().info->order);
    expect_orders(typed_trap_with_drag, GetParam().info->order_with_drag);
}

bool is_working_in_double(const MethodCase& c) { return c.precision == Precision::double_; }
INSTANTIATE_TEST_SUITE_P(Catalogue, SceneOrders, testing::ValuesIn(working_methods_where(is_working_in_double)),
                         case_name);

// In float the same motion: a hundred steps of rounding 6e-8 at positions of 2, grown a little.
TEST(SceneOrder, of_typed_potentials_in_float_is_a_matter_of_rounding) {
    for (const MethodCase& c : working_methods_where(is_working_in_double)) {
        RunDescription run = ordered_run(typed_trap, *c.info, 0.02);
        if (c.info->adaptive) run.method_parameters.set("tolerance", 1e-7);
        const Frame in_double = state_reached(run, 100).frame;
        run.precision = Precision::float_;
        const double apart = distance(state_reached(run, 100).frame, in_double);
        EXPECT_LT(apart, 2e-5) << c.id();
        EXPECT_GT(apart, 0) << c.id();
    }
}

/// "id: reason" of the methods that refuse a scene, in the order of the catalogue.
std::vector<std::string> refusals(const std::string& text) {
    std::vector<std::string> all;
    for (const Method& method : methods()) {
        const std::string before = std::string(method.info.id) + " cannot run this scene: ";
        try {
            check(ordered_run(text, method.info, 0.01));
        } catch (const UsageError& error) {
            const std::string message = error.what();
            EXPECT_EQ(message.find(before), 0u) << message;
            all.push_back(std::string(method.info.id) + ": " + message.substr(std::min(before.size(), message.size())));
        }
    }
    return all;
}

TEST(SceneOrder, is_none_of_methods_that_refuse_a_scene_by_name) {
    const std::string as_printed = "it is kept as printed in 2008, for the models of then";
    const std::string seam = "its potential has min, max or abs, whose seams a power series does not see";
    const std::string damped = "dashpots, and drag whose rate c / m differs between particles, are not in its formulas";
    EXPECT_THAT(refusals(typed_trap), ElementsAre("verlet-2008: " + as_printed, "stoermer-2008: " + as_printed));
    EXPECT_THAT(refusals(replaced(typed_trap, "0.1*r^2", "0.1*max(r, 1)^2")),
                ElementsAre("taylor: " + seam, "verlet-2008: " + as_printed, "stoermer-2008: " + as_printed));
    EXPECT_THAT(refusals(dashpot_network),
                ElementsAre("rkn-12-10: " + damped, "taylor: " + damped, "gauss-16: " + damped,
                            "verlet-2008: " + as_printed, "stoermer-2008: " + as_printed));
    std::size_t without = 0;
    for (const Method& method : methods()) without += method.info.order_with_damping == 0 ? 1 : 0;
    EXPECT_EQ(refusals(dashpot_network).size(), without) << "those that the catalogue says take no dashpots";
}

}  // namespace
}  // namespace steplab::test
