#include "sim/ensemble/ensemble.hpp"

#include "core/error.hpp"
#include "sim/ensemble/parameter_range.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace steplab {
namespace {

using test::MethodCase;

/// More than registers have lanes, and no multiple of them.
constexpr std::size_t run_count = 37;

struct Case {
    std::string_view model;
    std::vector<std::pair<std::string_view, double>> settings;
    std::vector<ParameterRange> ranges;

    RunDescription run(const std::string& method, Precision precision, double dt) const {
        RunDescription description = test::run_of(model, method, precision, dt);
        for (const auto& [name, value] : settings) description.scene.set(name, value);
        return description;
    }
};

/// Scenes of every layout of forces, and what differs from run to run: start, parameters, dt.
const std::vector<Case>& cases() {
    static const std::vector<Case> all{
        {"chain", {{"n", 7}}, {{"v0", -1, 2}}},
        {"chain", {{"n", 2}}, {{"k", 0.5, 3}, {"m", 2, 0.5}, {"L", 0, 3}}},
        {"chain", {{"n", 5}, {"fixed", 0}, {"c", 0.3}}, {{"dt", 0.01, 0.05}, {"c", 0.1, 0.7}}},
        {"rope", {{"n", 6}}, {{"g", 1, 9}, {"L", 0.5, 1.5}, {"dt", 0.01, 0.02}}},
        {"mesh", {{"dim", 4}}, {{"v0", 0.5, 2}, {"k", 1, 2}, {"L", 0.5, 2}}},
        {"morse", {{"edge", 2}}, {{"D", 1, 2}, {"r0", 0.4, 0.6}, {"dt", 0.005, 0.01}}},
        {"oscillator", {}, {{"m", 1, 2}}},
        {"free", {}, {{"dt", 0.01, 0.1}}},
    };
    return all;
}

std::vector<EnsembleRun> runs_of(RunDescription description, const std::vector<ParameterRange>& ranges,
                                 std::uint64_t steps, std::size_t runs = run_count) {
    std::vector<EnsembleRun> all;
    for (std::size_t i = 0; i < runs; ++i) all.push_back({run_in_range(description, ranges, i, runs), {steps}});
    return all;
}

/// The same run by itself.
RunResult alone(const EnsembleRun& run, std::uint64_t every) {
    Simulation simulation(run.description);
    const double energy_start = simulation.energy();
    double energy_error = 0;
    while (simulation.step() < run.end.step && !simulation.divergence()) {
        simulation.advance(std::min(every - simulation.step() % every, run.end.step - simulation.step()));
        energy_error = std::max(energy_error, std::abs(simulation.energy_error()));
    }
    simulation.conclude();
    return result_of(simulation, energy_start, energy_error);
}

void expect_same(const EnsembleResult& run, const RunResult& expected) {
    const RunResult& result = run.result;
    EXPECT_EQ(result.hash, expected.hash);
    EXPECT_EQ(result.dt, expected.dt);
    EXPECT_EQ(result.steps, expected.steps);
    EXPECT_EQ(result.time, expected.time);
    EXPECT_EQ(result.particles, expected.particles);
    EXPECT_EQ(result.evaluations, expected.evaluations);
    EXPECT_EQ(result.energy_start, expected.energy_start);
    EXPECT_EQ(result.energy_end, expected.energy_end);
    EXPECT_EQ(result.farthest, expected.farthest);
    ASSERT_EQ(result.divergence.has_value(), expected.divergence.has_value());
    if (result.divergence) {
        EXPECT_EQ(result.divergence->message, expected.divergence->message);
    } else {
        EXPECT_EQ(result.energy_error, expected.energy_error);
    }
}

std::size_t side_by_side(const std::vector<EnsembleResult>& results) {
    return static_cast<std::size_t>(
        std::count_if(results.begin(), results.end(), [](const auto& result) { return result.in_lanes; }));
}

class Ensembles : public testing::TestWithParam<MethodCase> {};

TEST_P(Ensembles, have_the_bits_of_their_runs_alone) {
    constexpr std::uint64_t every = 100;
    for (const Case& scene : cases()) {
        SCOPED_TRACE(scene.model);
        const auto runs = runs_of(scene.run(GetParam().id(), GetParam().precision, 0.02), scene.ranges, 300);
        const auto results = run_ensemble(runs, every);
        for (std::size_t i = 0; i < runs.size(); ++i) {
            SCOPED_TRACE(i);
            expect_same(results[i], alone(runs[i], every));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Methods, Ensembles, testing::ValuesIn(test::all_methods()), test::case_name);

class Compensated : public testing::TestWithParam<MethodCase> {};

TEST_P(Compensated, sums_have_the_same_bits_in_an_ensemble) {
    RunDescription description = test::run_of("chain", GetParam().id(), GetParam().precision, 0.02, {{"n", 5}});
    description.method_parameters.set("compensated", 1);
    for (const double drag : {0.0, 0.2}) {
        description.scene.set("c", drag);
        const auto runs = runs_of(description, {{"k", 1, 2}}, 300);
        const auto results = run_ensemble(runs, 300);
        for (std::size_t i = 0; i < runs.size(); ++i) expect_same(results[i], alone(runs[i], 300));
    }
}

std::vector<MethodCase> compensating_methods() {
    std::vector<MethodCase> cases = test::all_methods();
    std::erase_if(cases, [](const MethodCase& it) {
        return !describe("chain", it.id()).method_parameters.contains("compensated");
    });
    return cases;
}

INSTANTIATE_TEST_SUITE_P(Methods, Compensated, testing::ValuesIn(compensating_methods()), test::case_name);

/// Numbers of a precision that one register has room for.
std::size_t lanes(Instructions instructions, Precision precision) {
    const std::size_t bytes = instructions == Instructions::avx512 ? 64 : instructions == Instructions::avx2 ? 32 : 16;
    return bytes / (precision == Precision::double_ ? sizeof(double) : sizeof(float));
}

/// Runs of one size go side by side where they fill half of a register at least.
void expect_side_by_side_where_half_is_full(const RunDescription& chain, Instructions instructions) {
    const auto together = [&](const ParameterRange& spread, std::size_t runs) {
        return side_by_side(run_ensemble(runs_of(chain, {spread}, 10, runs), 10, {.instructions = instructions}));
    };
    const std::size_t half = lanes(instructions, chain.precision) / 2;
    for (const ParameterRange& spread : {ParameterRange{"k", 1, 2}, ParameterRange{"dt", 0.01, 0.02}}) {
        EXPECT_EQ(together(spread, half), half);
        EXPECT_EQ(together(spread, half - 1), 0u);
        EXPECT_GE(together(spread, run_count), 32u);
    }
    EXPECT_EQ(together({"n", 10, 46}, run_count), half == 1 ? run_count : 0u);
}

TEST(Ensemble, computes_runs_side_by_side_where_it_can) {
    for (const char* const method : {"euler", "stoermer", "kahan-li-8", "rk4", "midpoint", "euler-forward"}) {
        for (const Precision precision : test::precisions) {
            for (const Instructions instructions : instructions_here()) {
                SCOPED_TRACE(std::string(method) + " by " + std::string(id(instructions)));
                expect_side_by_side_where_half_is_full(test::run_of("chain", method, precision, 0.02), instructions);
            }
        }
    }
}

TEST(Ensemble, computes_what_does_not_go_in_lanes_run_by_run) {
    for (const char* const method : {"dop853", "implicit-midpoint"}) {
        const RunDescription chain = test::run_of("chain", method, Precision::double_, 0.02);
        EXPECT_EQ(side_by_side(run_ensemble(runs_of(chain, {{"k", 1, 2}}, 10), 10)), 0u);
    }
}

/// What decides that something is not computed at all may be zero in one of the runs.
TEST(Ensemble, keeps_bits_where_a_number_is_zero_in_some_runs) {
    for (const Precision precision : test::precisions) {
        for (const char* const name : {"c", "g", "L"}) {
            const auto runs = runs_of(test::run_of("rope", "velocity-verlet", precision, 0.02), {{name, 0, 0.5}}, 50);
            const auto results = run_ensemble(runs, 50);
            for (std::size_t i = 0; i < runs.size(); ++i) expect_same(results[i], alone(runs[i], 50));
        }
    }
}

TEST(Ensemble, runs_may_differ_in_everything) {
    std::vector<EnsembleRun> runs;
    std::uint64_t steps = 0;
    for (const Case& scene : cases()) {
        for (const Method& method : methods()) {
            for (const Precision precision : test::precisions)
                runs.push_back({scene.run(std::string(method.info.id), precision, 0.01), {++steps}});
        }
    }
    const auto results = run_ensemble(runs, 7);
    for (std::size_t i = 0; i < runs.size(); ++i) expect_same(results[i], alone(runs[i], 7));
}

TEST(Ensemble, runs_of_one_group_end_at_their_own_steps) {
    auto runs = runs_of(test::run_of("chain", "euler", Precision::double_, 0.02), {{"k", 1, 2}}, 0, 16);
    for (std::size_t i = 0; i < runs.size(); ++i) runs[i].end.step = i * i * 3;
    const auto results = run_ensemble(runs, 50);
    for (std::size_t i = 0; i < runs.size(); ++i) expect_same(results[i], alone(runs[i], 50));
    EXPECT_EQ(side_by_side(results), 16u);
}

TEST(Ensemble, does_not_depend_on_threads_or_instructions) {
    for (const Precision precision : test::precisions) {
        const auto runs =
            runs_of(test::run_of("chain", "velocity-verlet", precision, 0.02), {{"k", 1, 2}, {"v0", 0, 3}}, 300, 213);
        const auto expected = run_ensemble(runs, 300, {.threads = 1});
        for (const std::size_t threads : {2U, 3U}) {
            const auto results = run_ensemble(runs, 300, {.threads = threads});
            for (std::size_t i = 0; i < runs.size(); ++i) expect_same(results[i], expected[i].result);
        }
        for (const Instructions instructions : instructions_here()) {
            const auto results = run_ensemble(runs, 300, {.instructions = instructions});
            for (std::size_t i = 0; i < runs.size(); ++i) expect_same(results[i], expected[i].result);
        }
    }
}

/// From just below the stability limit 2 / omega_max to far beyond it.
TEST(Ensemble, runs_that_diverge_stop_where_they_would_alone) {
    for (const char* const method : {"euler", "pefrl", "rk4"}) {
        for (const Precision precision : test::precisions) {
            const auto runs = runs_of(test::run_of("chain", method, precision, 1), {{"dt", 0.8, 4}}, 1000);
            const auto results = run_ensemble(runs, 64);
            std::size_t diverged = 0;
            for (std::size_t i = 0; i < runs.size(); ++i) {
                expect_same(results[i], alone(runs[i], 64));
                diverged += results[i].result.divergence.has_value();
            }
            EXPECT_GT(diverged, 10u);
            EXPECT_GT(side_by_side(results), 0u);
        }
    }
}

/// What the tests above compare sees the least change of one run.
TEST(Ensemble, an_ulp_of_dt_gives_another_hash) {
    auto runs = runs_of(test::run_of("chain", "euler", Precision::double_, 0.02), {{"k", 1, 2}}, 100, 16);
    const auto before = run_ensemble(runs, 100);
    runs[5].description.dt = std::nextafter(runs[5].description.dt, 1);
    const auto after = run_ensemble(runs, 100);
    for (std::size_t i = 0; i < runs.size(); ++i) EXPECT_EQ(before[i].result.hash == after[i].result.hash, i != 5);
}

TEST(Ensemble, tells_how_many_steps_are_done_and_ends_when_that_throws) {
    const auto runs = runs_of(test::run_of("chain", "euler", Precision::double_, 0.02), {{"k", 1, 2}}, 1000);
    std::uint64_t done = 0;
    run_ensemble(runs, 1000, {}, [&](std::uint64_t steps) {
        EXPECT_GE(steps, done);
        done = steps;
    });
    EXPECT_EQ(done, run_count * 1000);
    EXPECT_THROW(run_ensemble(runs, 1000, {}, [](std::uint64_t) { throw std::runtime_error("enough"); }),
                 std::runtime_error);
}

TEST(Ensemble, refuses_a_run_that_cannot_be) {
    auto runs = runs_of(test::run_of("chain", "euler", Precision::double_, 0.02), {{"k", 1, 2}}, 10);
    runs[9].description.dt = 0;
    EXPECT_THROW(run_ensemble(runs, 10), UsageError);
}

TEST(ParameterRange, goes_from_one_value_to_the_other) {
    const ParameterRange spread{"k", 0.1, 0.7};
    EXPECT_EQ(spread.value(0, 1), 0.1);
    EXPECT_EQ(spread.value(0, 10), 0.1);
    EXPECT_EQ(spread.value(9, 10), 0.7);
    for (std::size_t i = 1; i < 9; ++i)
        EXPECT_EQ(spread.value(i, 10), 0.1 + (0.7 - 0.1) * static_cast<double>(i) / 9.0);
}

TEST(ParameterRange, is_read_from_text) {
    const RunDescription chain = describe("chain", "euler");
    const ParameterRange spread = parse_parameter_range(chain, "v0=-1:2e-1");
    EXPECT_EQ(spread.name, "v0");
    EXPECT_EQ(spread.from, -1);
    EXPECT_EQ(spread.to, 0.2);
    EXPECT_EQ(parse_parameter_range(chain, "dt=0.1:0.2").name, "dt");
    for (const char* const wrong : {"", "k", "k=1", "=1:2", "k=1:", "k=:1", "k=0:1", "dt=0:1", "kk=1:2", "k=1:2:3"})
        EXPECT_THROW(parse_parameter_range(chain, wrong), UsageError) << wrong;
    EXPECT_THROW(parse_parameter_range(describe("mesh", "euler"), "kick=centre:corner"), UsageError);
    EXPECT_THROW(run_in_range(chain, std::vector<ParameterRange>{{"n", 10, 11}}, 1, 3), UsageError);
}

}  // namespace
}  // namespace steplab
