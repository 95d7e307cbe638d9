#include "sim/run/remedy.hpp"

#include "sim/run/start_frequency.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace steplab::test {
namespace {

/// The first of each kind: they are tried in this order.
struct Remedies {
    std::optional<double> dt;
    std::optional<std::string> method;
};

Remedies remedies_of(const RunDescription& run, double omega) {
    const RemedyCandidates found = remedy_candidates(run, model_of(run).plan(run.scene), omega);
    Remedies first;
    if (!found.dts.empty()) first.dt = found.dts.front();
    if (!found.methods.empty()) first.method = found.methods.front();
    return first;
}

Remedies remedies_of(const RunDescription& run) { return remedies_of(run, fastest_frequency(run)); }

TEST(Remedy, is_no_method_where_none_is_stable) {
    EXPECT_FALSE(remedies_of(run_of("chain", "euler", Precision::double_, 1000)).method);
}

TEST(Remedy, is_the_cheapest_method_that_works) {
    const auto remedy = remedies_of(describe("chain", "midpoint")).method;
    ASSERT_TRUE(remedy);
    const MethodInfo& info = method(*remedy).info;
    EXPECT_EQ(info.evaluations, 1);
    EXPECT_FALSE(info.curiosity);
}

/// How much of the swing of an oscillator is left: its largest displacement in the last of 40 periods over that in the
/// first 10.
double kept_swing(const RunDescription& remedied, double omega) {
    RunDescription run = run_of("oscillator", remedied.method, Precision::double_, remedied.dt, {{"k", omega * omega}});
    run.method_parameters = remedied.method_parameters;
    Simulation simulation(run);
    // with fewer samples, those of less than one a period might all miss the turning points
    const double periods = std::ceil(10 * 2 * std::numbers::pi / (omega * run.dt));
    const auto steps = static_cast<std::uint64_t>(std::max(100.0, periods));
    const auto largest = [&] {
        double found = 0;
        for (std::uint64_t step = 0; step < steps; ++step) {
            simulation.advance(1);
            found = std::max(found, std::abs(simulation.state().displacement.at(1).x));
        }
        return found;
    };
    const double first = largest();
    simulation.advance(2 * steps);
    return largest() / first;
}

/// 1 % a period is 27 % in the 30 between; as much again for the few samples of a period that dt leaves.
constexpr double least_kept = 0.5, most_kept = 1.5;

/// Runs without drag that diverge, of methods and scenes with a known limit.
std::vector<RunDescription> runs_to_cure() {
    std::vector<RunDescription> runs;
    for (const MethodCase& c : working_methods_where(has_equal_steps)) {
        if (c.precision == Precision::float_) continue;  // judged alike
        for (const std::string_view id : {"oscillator", "chain", "mesh"}) {
            for (const double phase : {0.5, 1.2, 1.7, 2.1, 2.6, 3.0, 4.5, 9.0, 25.0}) {
                RunDescription run = run_of(id, c.id(), c.precision, 1);
                run.dt = phase / fastest_frequency(run);
                runs.push_back(run);
            }
        }
    }
    return runs;
}

TEST(Remedy, keeps_the_motion) {
    int methods = 0, steps = 0;
    for (const RunDescription& run : runs_to_cure()) {
        const Remedies found = remedies_of(run);
        const double omega = fastest_frequency(run);
        const auto kept = [&](RunDescription cured, double dt) {
            cured.dt = dt;
            return kept_swing(cured, omega);
        };
        if (found.method) {
            const double swing = kept(with_method(run, *found.method), run.dt);
            EXPECT_TRUE(swing > least_kept && swing < most_kept) << command_line(run) << ": " << *found.method;
            ++methods;
        }
        if (found.dt && run.dt / *found.dt < 100) {
            const double swing = kept(run, *found.dt);
            EXPECT_TRUE(swing > least_kept && swing < most_kept) << command_line(run) << ": " << *found.dt;
            ++steps;
        }
    }
    EXPECT_GT(methods, 100);
    EXPECT_GT(steps, 100);
}

// It is stable there, but a step multiplies the swing by 0.68: within some steps the energy is gone.
TEST(Remedy, is_not_a_method_that_damps) {
    RunDescription run = describe("chain", "euler");
    run.dt = 2.1 / fastest_frequency(run);
    RunDescription damped = with_method(run, "rk4");
    EXPECT_LT(damped.dt, 0.9 * stability_limit(damped)->limit);
    EXPECT_LT(kept_swing(damped, fastest_frequency(run)), 1e-9);
    const auto offered = remedies_of(run).method;
    ASSERT_TRUE(offered);
    EXPECT_NE(*offered, "rk4");
}

TEST(Remedy, is_no_dt_for_what_fails_at_any) {
    for (const std::string_view id : {"verlet-2008", "stoermer-2008", "midpoint", "euler-forward"}) {
        const Remedies found = remedies_of(run_of("oscillator", id, Precision::double_, 0.9));
        EXPECT_FALSE(found.dt) << id;
        EXPECT_TRUE(found.method) << id;
    }
}

TEST(Remedy, of_a_scene_without_known_limit_is_a_quarter_of_dt) {
    const Remedies found = remedies_of(run_of("morse", "euler", Precision::double_, 0.4), 0);
    EXPECT_EQ(found.dt, 0.1);
    EXPECT_FALSE(found.method);
}

TEST(Remedy, is_not_needed_by_methods_that_choose_their_steps) {
    const Remedies found = remedies_of(describe("morse", "dopri5"));
    EXPECT_FALSE(found.dt);
    EXPECT_FALSE(found.method);
}

// A scene that is not linear stiffens as it moves.
TEST(Remedy, keeps_away_from_the_limit) {
    bool any_method = false;
    for (int tenths = 2; tenths < 40; ++tenths) {
        const RunDescription run = run_of("chain", "euler", Precision::double_, 0.1 * tenths);
        const Remedies remedies = remedies_of(run);
        if (remedies.method) {
            any_method = true;
            EXPECT_LE(run.dt, 0.9 * stability_limit(with_method(run, *remedies.method))->limit) << *remedies.method;
        }
        ASSERT_TRUE(remedies.dt) << run.dt;
        EXPECT_LE(*remedies.dt, 0.9 * stability_limit(run)->limit);
    }
    EXPECT_TRUE(any_method);
}

TEST(Remedy, of_the_first_kind_halves_dt_from_one_to_the_next) {
    for (const double omega : {0.0, 2.0}) {
        const RunDescription run = run_of("oscillator", "rk4", Precision::double_, 2);
        const std::vector<double> dts = remedy_candidates(run, model_of(run).plan(run.scene), omega).dts;
        ASSERT_GT(dts.size(), 3u) << omega;
        for (std::size_t i = 1; i < dts.size(); ++i) EXPECT_LE(dts[i], 0.51 * dts[i - 1]);
        EXPECT_LE(dts.front(), 0.51 * run.dt);
    }
}

TEST(Remedy, of_the_second_kind_costs_more_from_one_to_the_next) {
    const RunDescription run = run_of("oscillator", "midpoint", Precision::double_, 0.5);
    const auto methods = remedy_candidates(run, model_of(run).plan(run.scene), 1).methods;
    ASSERT_GT(methods.size(), 3u);
    const auto cost = [&](const std::string& id) {
        return evaluations_per_step(method(id).info, with_method(run, id).method_parameters);
    };
    for (std::size_t i = 1; i < methods.size(); ++i) EXPECT_LE(cost(methods[i - 1]), cost(methods[i])) << methods[i];
}

// Nothing moves yet: that of the first motion, which the springs of a lattice give, omega <= sqrt(16 k / m) = 4.
TEST(StartFrequency, of_a_scene_at_rest_is_that_of_its_first_motion) {
    const RunDescription run = run_of("crystal", "rk4", Precision::double_, 0.1, {{"kT", 0}, {"edge", 5}});
    const double omega = start_frequency(model_of(run).plan(run.scene));
    EXPECT_GT(omega, 0.5);
    EXPECT_LT(omega, 4);
}

}  // namespace
}  // namespace steplab::test
