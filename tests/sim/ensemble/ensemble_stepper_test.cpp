#include "sim/ensemble/ensemble_stepper.hpp"

#include "core/flush_subnormals.hpp"
#include "sim/ensemble/lane_compatible.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>
#include <variant>
#include <vector>

namespace steplab::test {
namespace {

/// A scene of every layout of forces that goes in lanes; the forces of pairs less what they are somewhere.
std::vector<Plan> scenes() {
    const auto scene_of = [](std::string_view id, Settings settings) {
        return model(id).plan(run_of(id, "euler", Precision::double_, 0.1, settings).scene);
    };
    std::vector<Plan> all{scene_of("chain", {{"n", 7}, {"c", 0.2}}), scene_of("mesh", {{"dim", 4}}),
                          scene_of("morse", {{"edge", 2}})};
    auto balance = std::make_shared<Field<double>>(all.back().reference.count);
    for (std::size_t i = 0; i < balance->count(); ++i) balance->set(i, {0.1 * static_cast<double>(i), -0.3, 0.7});
    std::get<PairForces>(all.back().forces).balance = balance;
    return all;
}

/// Numbers that have nothing to do with each other.
Field<double> scattered(std::size_t count, double size, double seed) {
    Field<double> field(count);
    for (std::size_t i = 0; i < count; ++i) {
        const auto number = [&](double k) { return size * std::sin(seed + 7 * k * static_cast<double>(i + 1)); };
        field.set(i, {number(1), number(2), number(3)});
    }
    return field;
}

State<double> start_of(const Plan& scene, std::size_t run) {
    const auto seed = static_cast<double>(run + 1);
    State<double> state = scene.start.state();
    const Field<double> moved = scattered(scene.reference.count, 1e-3, seed);
    for (std::size_t k = 0; k < moved.flat().size(); ++k) state.displacement.flat()[k] += moved.flat()[k];
    state.velocity = scattered(scene.reference.count, 1e-2, -seed);
    return state;
}

double dot(const Field<double>& a, const Field<double>& b) {
    return std::inner_product(a.flat().begin(), a.flat().end(), b.flat().begin(), 0.0);
}

std::vector<StepperSetup> setups_of(const MethodCase& method, const Plan& scene, const ParameterValues& parameters) {
    std::vector<StepperSetup> all;
    for (std::size_t run = 0; run < most_lanes; ++run) {
        const double dt = 0.01 + 0.001 * static_cast<double>(run);
        all.push_back({scene, start_of(scene, run), parameters, method.precision, dt});
    }
    return all;
}

class Groups : public testing::TestWithParam<MethodCase> {};

TEST_P(Groups, begin_anew_and_are_seen_along_a_shape_as_runs_alone) {
    const FlushSubnormals flush;
    const Method& method = steplab::method(GetParam().id());
    const ParameterValues parameters(method.info.parameters);
    for (const Plan& scene : scenes()) {
        std::vector<StepperSetup> setups = setups_of(GetParam(), scene, parameters);
        ASSERT_TRUE(lane_compatible(setups[0], setups[1]));
        const auto group = method.make_ensemble_stepper(setups);
        ASSERT_TRUE(group);
        group->advance(3);
        std::vector<State<double>> starts;
        for (std::size_t run = 0; run < group->runs(); ++run) starts.push_back(start_of(scene, run + 100));
        group->restart(starts);
        group->advance(2);
        group->advance(3);
        const std::size_t count = scene.reference.count;
        const Field<double> shape = scattered(count, 1, 0.5), origin = scene.start.state().displacement;
        std::array<Along, most_lanes> along;
        group->along(shape, origin, along);
        for (std::size_t run = 0; run < group->runs(); ++run) {
            setups[run].start = starts[run];
            const auto alone = method.make(setups[run]);
            alone->advance(5);
            State<double> expected, seen;
            alone->synchronised(expected);
            group->synchronised(run, seen);
            EXPECT_TRUE(std::ranges::equal(seen.displacement.flat(), expected.displacement.flat()));
            EXPECT_TRUE(std::ranges::equal(seen.velocity.flat(), expected.velocity.flat()));
            for (std::size_t k = 0; k < origin.flat().size(); ++k) expected.displacement.flat()[k] -= origin.flat()[k];
            EXPECT_EQ(along[run].displacement, dot(shape, expected.displacement));
            EXPECT_EQ(along[run].velocity, dot(shape, expected.velocity));
            EXPECT_NE(along[run].velocity, along[(run + 1) % group->runs()].velocity);
        }
    }
}

/// The scene's own start, faster from run to run.
State<double> faster(const Plan& scene, std::size_t run) {
    State<double> state = scene.start.state();
    for (double& v : state.velocity.flat()) v *= 1 + 0.1 * static_cast<double>(run);
    return state;
}

// A chain moves along x. Lanes leave the other axes out until one run is pulled sideways.
TEST_P(Groups, leave_axes_out_as_runs_alone) {
    const FlushSubnormals flush;
    const Method& method = steplab::method(GetParam().id());
    const ParameterValues parameters(method.info.parameters);
    const Plan chain = scenes().front();
    std::vector<StepperSetup> setups = setups_of(GetParam(), chain, parameters);
    for (std::size_t run = 0; run < setups.size(); ++run) setups[run].start = faster(chain, run);
    const auto group = method.make_ensemble_stepper(setups);
    for (const double sideways : {0.0, 0.1, 0.0}) {
        std::vector<State<double>> starts;
        for (std::size_t run = 0; run < group->runs(); ++run) starts.push_back(faster(chain, run));
        starts.back().velocity.set(3, {0, 0, sideways});
        group->restart(starts);
        group->advance(20);
        for (std::size_t run = 0; run < group->runs(); ++run) {
            setups[run].start = starts[run];
            const auto alone = method.make(setups[run]);
            alone->advance(20);
            State<double> expected, seen;
            alone->synchronised(expected);
            group->synchronised(run, seen);
            EXPECT_TRUE(std::ranges::equal(seen.displacement.flat(), expected.displacement.flat())) << sideways;
            EXPECT_TRUE(std::ranges::equal(seen.velocity.flat(), expected.velocity.flat())) << sideways;
            const bool moves_sideways = sideways != 0 && run + 1 == group->runs();
            EXPECT_EQ(seen.displacement.at(3).z != 0, moves_sideways);
        }
    }
}

std::vector<MethodCase> methods_in_lanes() {
    std::vector<MethodCase> cases = all_methods();
    std::erase_if(cases, [](const MethodCase& it) { return !method(it.id()).runs_in_lanes(fastest_instructions()); });
    return cases;
}

INSTANTIATE_TEST_SUITE_P(Methods, Groups, testing::ValuesIn(methods_in_lanes()), case_name);

TEST(Group, of_pairs_has_one_balance) {
    const ParameterValues parameters(method("euler").info.parameters);
    const Plan scene = scenes().back();
    Plan other = scene;
    std::get<PairForces>(other.forces).balance = std::make_shared<Field<double>>(scene.reference.count);
    const StepperSetup a{scene, scene.start, parameters, Precision::double_, 0.1};
    const StepperSetup b{other, other.start, parameters, Precision::double_, 0.1};
    EXPECT_TRUE(lane_compatible(a, a));
    EXPECT_FALSE(lane_compatible(a, b));
}

}  // namespace
}  // namespace steplab::test
