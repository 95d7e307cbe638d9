// What methods that choose their own steps must not miss: forces that begin at a seam, hills and walls on curved ways,
// and motion of which next to nothing is felt at the start.

#include "io/scene_file.hpp"
#include "sim/run/simulation.hpp"
#include "support/asked.hpp"
#include "support/runs.hpp"
#include "support/scene_texts.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace steplab::test {
namespace {

RunDescription own_step_run(const std::string& text, std::string_view method, double tolerance, double dt) {
    RunDescription run = with_method(describe(read_scene("steplab = 1\n" + text)), method);
    if (tolerance > 0) run.method_parameters.set("tolerance", tolerance);
    run.dt = dt;
    return run;
}

Frame seen_at(const RunDescription& run, double time) {
    Simulation simulation(run);
    simulation.advance(static_cast<std::uint64_t>(std::lround(time / run.dt)));
    EXPECT_FALSE(simulation.divergence()) << simulation.divergence()->message;
    return simulation.frame();
}

/// Calls test(tolerance, dt); in the last one all is one step of output.
template <class Test>
void over_settings(double time, Test test) {
    for (const double tolerance : {1e-5, 1e-7, 1e-9, 1e-12})
        for (const double dt : {0.01, 0.1, time}) test(tolerance, dt);
}

class OwnSteps : public testing::TestWithParam<std::string_view> {};

/// The same without `taylor`, which refuses max, min and abs.
class OwnStepsAtSeams : public OwnSteps {};

/// Two balls of unit mass that touch below 1 m, thrown at each other from 10 m with 1 m/s.
std::string contact(double power) {
    return fmt::format(
        "[[particles]]\ngroup = \"t\"\n[[particles]]\ngroup = \"b\"\nposition = [10, 0, 0]\nvelocity = [-1, 0, 0]\n"
        "[[pairs]]\nbetween = [\"t\", \"b\"]\npotential = \"2500*max(0, 1 - r)^{}\"\n",
        power);
}

// In contact 1 - r swings with omega = sqrt(2 * 5000) for half a period.
TEST_P(OwnStepsAtSeams, balls_that_touch_bounce) {
    const double time = 20, within = std::numbers::pi / 100, apart = 1 + (time - 9 - within);
    over_settings(time, [&](double tolerance, double dt) {
        const Frame frame = seen_at(own_step_run(contact(2), GetParam(), tolerance, dt), time);
        EXPECT_NEAR(frame.positions[1].x, 5 - time / 2 + apart / 2, asked_error(tolerance))
            << "tolerance " << tolerance << ", dt " << dt;
    });
}

// Balls of one mass exchange their velocities, whatever holds them apart.
TEST_P(OwnStepsAtSeams, balls_exchange_their_velocities) {
    over_settings(20, [&](double tolerance, double dt) {
        const Frame frame = seen_at(own_step_run(contact(2.5), GetParam(), tolerance, dt), 20);
        EXPECT_NEAR(frame.velocities[0].x, -1, asked_error(tolerance)) << "tolerance " << tolerance << ", dt " << dt;
        EXPECT_NEAR(frame.velocities[1].x, 0, asked_error(tolerance)) << "tolerance " << tolerance << ", dt " << dt;
    });
}

/// Where a ball is that falls from 10 m onto a floor with the potential k y^2 / 2 below 0; unit mass.
double bouncing(double time, double k) {
    const double g = 9.81, fall = std::sqrt(20 / g), speed = g * fall, omega = std::sqrt(k);
    // y = -(v / omega) sin(omega t) - (g / k)(1 - cos(omega t)) until it is 0 again
    const double contact = 2 * (std::numbers::pi - std::atan(speed * omega / g)) / omega;
    const double period = 2 * fall + contact;
    double t = std::fmod(time + fall, period) - fall;  // 0 at the highest point
    if (t > fall + contact) t -= period;
    if (t <= fall) return 10 - g * t * t / 2;
    const double phase = omega * (t - fall);
    return -(speed / omega) * std::sin(phase) - g / k * (1 - std::cos(phase));
}

TEST_P(OwnStepsAtSeams, a_ball_bounces_on_a_floor) {
    const std::string text =
        "[[particles]]\nposition = [0, 10, 0]\n[[fields]]\ngravity = [0, -9.81, 0]\n"
        "[[fields]]\npotential = \"5e3*max(0, -y)^2\"\n";
    over_settings(6, [&](double tolerance, double dt) {
        const Frame frame = seen_at(own_step_run(text, GetParam(), tolerance, dt), 6);
        // the speed of 14 m/s at two bounces of 0.03 s
        EXPECT_NEAR(frame.positions[0].y, bouncing(6, 1e4), 20 * asked_error(tolerance))
            << "tolerance " << tolerance << ", dt " << dt;
    });
}

// V = exp(x / w), E = 1/2: exp(-x / w) = cosh^2((t - t*) / (2 w)) / E, from where it turns at w ln E.
TEST_P(OwnSteps, a_soft_wall_that_is_not_felt_at_the_start_sends_back) {
    const double w = 0.05, time = 15;
    for (const double start : {-10.0, -3.0, -1.6}) {
        const std::string text = fmt::format(
            "[[particles]]\nposition = [{}, 0, 0]\nvelocity = [1, 0, 0]\n"
            "[[fields]]\npotential = \"exp(x/0.05)\"\n",
            start);
        // far from the wall cosh(s) = e^s / 2
        const double arrival = -start + w * std::log(0.5) + 2 * w * std::log(2.0);
        const double exact = -w * (2 * (time - arrival) / (2 * w) - 2 * std::log(2.0) - std::log(0.5));
        over_settings(time, [&](double tolerance, double dt) {
            const Frame frame = seen_at(own_step_run(text, GetParam(), tolerance, dt), time);
            EXPECT_NEAR(frame.positions[0].x, exact, asked_error(tolerance))
                << "from " << start << ", tolerance " << tolerance << ", dt " << dt;
        });
    }
}

// Springs that do nothing in the time of the run: the mass goes on as it began.
TEST_P(OwnSteps, where_next_to_nothing_acts_the_motion_goes_on) {
    for (const double k : {1e-8, 1e-16, 1e-20, 1e-24, 1e-28, 1e-32, 1e-40, 1e-100, 1e-300}) {
        for (const double dt : {0.013, 1.0, 100.0}) {
            RunDescription run = with_method(describe("oscillator", "rk4"), GetParam());
            run.scene.set("k", k);
            run.dt = dt;
            const Frame frame = seen_at(run, 100);
            const double omega = std::sqrt(k);
            EXPECT_NEAR(frame.positions[1].x, std::sin(omega * frame.time) / omega, 1e-7 * frame.time)
                << "k " << k << ", dt " << dt << " at the default tolerance";
        }
    }
}

/// The same motion by a method of order 8 with fixed short steps, which sees all.
Frame reference_of(const std::string& text, double time, double dt) {
    return seen_at(own_step_run(text, "kahan-li-8", 0, dt), time);
}

struct Way {
    const char* name;
    const char* text;
    double time;
    double growth;  ///< of an error, by the way behind what is met
};

// Thrown over a narrow hill; through one in a trap; drawn through a shell by a spring: none of them is straight.
const Way ways[] = {
    {"a hill below a throw",
     "[[particles]]\nposition = [-10, 5, 0]\nvelocity = [2, 3, 0]\n[[fields]]\ngravity = [0, -1, 0]\n"
     "[[fields]]\npotential = \"3*exp(-((x-2.03)^2+(y-5)^2)/0.1^2)\"\n",
     8, 20},
    {"a hill in a trap",
     "[[particles]]\nposition = [5, 0, 0]\n[[fields]]\npotential = \"0.5*x^2+3*exp(-(x/0.05)^2)\"\n", 8, 5},
    {"a shell on a spring",
     "[[particles]]\ngroup = \"t\"\nline = { count = 2, step = [4, 0, 0] }\n[[springs]]\nbetween = \"t\"\nk = 1\n"
     "length = 0\n[[pairs]]\nbetween = \"t\"\npotential = \"2*exp(-((r-2)/0.05)^2)\"\n",
     8, 5},
};

TEST_P(OwnSteps, what_lies_on_a_curved_way_is_not_jumped_over) {
    for (const Way& way : ways) {
        const Frame right = reference_of(way.text, way.time, 2e-4);
        over_settings(way.time, [&](double tolerance, double dt) {
            const Frame frame = seen_at(own_step_run(way.text, GetParam(), tolerance, dt), way.time);
            for (std::size_t i = 0; i < right.positions.size(); ++i)
                EXPECT_NEAR(length(frame.positions[i] - right.positions[i]), 0, way.growth * asked_error(tolerance))
                    << way.name << ", tolerance " << tolerance << ", dt " << dt;
        });
    }
}

std::string name_of_method(const testing::TestParamInfo<std::string_view>& test) {
    std::string name(test.param);
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}
INSTANTIATE_TEST_SUITE_P(Methods, OwnSteps,
                         testing::Values("dopri5", "dop853", "rkn-12-10", "taylor", "ias15", "gauss-16"),
                         name_of_method);
INSTANTIATE_TEST_SUITE_P(Methods, OwnStepsAtSeams,
                         testing::Values("dopri5", "dop853", "rkn-12-10", "ias15", "gauss-16"), name_of_method);

}  // namespace
}  // namespace steplab::test
