#include "lab/limits/limits.hpp"

#include "core/error.hpp"
#include "lab/limits/all_limits.hpp"
#include "lab/limits/mode_run.hpp"
#include "support/runs.hpp"
#include "support/scene_texts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace steplab::test {
namespace {

Limit limit_of(std::string_view id, std::string_view method, Precision precision = Precision::double_,
               Settings settings = {}) {
    const RunDescription run = run_of(id, method, precision, 0.1, settings);
    return StabilityLab(run).limit(run);
}

/// Linear scenes agree to 0.1 %, others to 1 %, or a note says why not.
void expect_agreement(const Limit& limit, double tolerance) {
    ASSERT_TRUE(limit.theory.has_value());
    if (!limit.measured) {  // methods that are stable at any dt are not always measured; a note says so
        EXPECT_TRUE(std::isinf(*limit.theory) && !limit.note.empty());
        return;
    }
    if (const auto ratio = limit.ratio()) {
        EXPECT_TRUE(!limit.note.empty() || std::abs(*ratio - 1) <= tolerance) << *ratio;
        EXPECT_NEAR(*ratio, 1, 0.01);  // whatever the note says
    } else {
        EXPECT_EQ(*limit.theory, *limit.measured);
    }
}

/// Of a model at its defaults; of implicit methods, which solve linear systems, on smaller ones.
Settings scene_for(const MethodInfo& method, const Model& model) {
    static const Settings small_mesh{{"dim", 6}}, small_cube{{"edge", 2}}, defaults{};
    if (!method.implicit) return defaults;
    return model.info.id == "mesh" ? small_mesh : model.info.id == "morse" ? small_cube : defaults;
}

/// Masses that differ by a factor of 50, in a network whose modes are of all of them.
constexpr const char* mixed_masses = R"(steplab = 1
[[particles]]
group = "net"
grid = { count = [3, 3], steps = [[1, 0, 0], [0, 0, 1]] }
[[fix]]
particles = ["net[0,0]", "net[2,2]"]
fixed = true
[[fix]]
particles = ["net[1,1]", "net[0,1]"]
mass = 50
[[fix]]
particles = ["net[2,0]"]
mass = 7
[[springs]]
between = "net"
along = "both"
k = 3
)";

// The shape of a mode is that of displacements, and modes are at right angles with the masses as weights.
TEST(Limits, of_mixed_masses_agree_with_theory) {
    RunDescription run = describe(read_scene(mixed_masses));
    for (const char* const method : {"velocity-verlet", "rk4", "pefrl"}) {
        run = with_method(run, method);
        const Limit limit = StabilityLab(run).limit(run);
        ASSERT_TRUE(limit.ratio()) << limit.note;
        EXPECT_NEAR(*limit.ratio(), 1, 1e-3) << method << ": " << limit.note;
        EXPECT_EQ(limit.note, "") << method;
    }
}

class CatalogueLimits : public testing::TestWithParam<MethodCase> {};

TEST_P(CatalogueLimits, theory_and_runs_agree_on_every_model) {
    // a crystal has 375 modes and more: below, by two methods
    for (const Model* const model : models_where([](const Model& it) { return it.info.id != "crystal"; })) {
        const bool linear = model->info.id != "mesh" && model->info.id != "morse";
        const Limit limit =
            limit_of(model->info.id, GetParam().info->id, GetParam().precision, scene_for(*GetParam().info, *model));
        SCOPED_TRACE(std::string(model->info.id) + ": " + limit.note);
        if (GetParam().info->adaptive) {
            EXPECT_TRUE(std::isinf(*limit.theory) && std::isinf(*limit.measured));
        } else {
            expect_agreement(limit, linear ? 1e-3 : 1e-2);
        }
    }
}

TEST(LimitsOfCrystal, agree_with_runs) {
    for (const char* method : {"velocity-verlet", "rk4"})
        expect_agreement(limit_of("crystal", method, Precision::double_, {{"edge", 5}}), 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Catalogue, CatalogueLimits, testing::ValuesIn(working_methods()), case_name);

class LimitsOfFixedSteps : public testing::TestWithParam<MethodCase> {};

TEST_P(LimitsOfFixedSteps, include_drag) {
    for (const double c : {0.1, 5.0}) {
        const Limit limit = limit_of("chain", GetParam().info->id, GetParam().precision, {{"c", c}, {"n", 6}});
        SCOPED_TRACE(testing::Message() << c << ": " << limit.note);
        expect_agreement(limit, 1e-3);
    }
}

INSTANTIATE_TEST_SUITE_P(Catalogue, LimitsOfFixedSteps, testing::ValuesIn(working_methods_where(has_fixed_steps)),
                         case_name);

TEST(Limit, of_the_ten_particle_chain_is_the_published_one) {
    const auto expect = [](std::string_view method, double published, double digit) {
        const Limit limit = limit_of("chain", method);
        EXPECT_NEAR(limit.omega_max, 1.97272261, 5e-9) << method;
        EXPECT_NEAR(*limit.theory, published, digit) << method;
        EXPECT_NEAR(*limit.measured, published, 1e-3 * published) << method;
    };
    expect("euler", 1.01383, 5e-6);
    expect("verlet", 1.01383, 5e-6);
    expect("rk4", 1.43377, 5e-6);
    expect("stoermer", 10.138, 5e-4);
}

TEST(Limit, is_zero_where_a_method_is_unstable_at_any_dt) {
    for (const char* method : {"midpoint", "euler-forward"}) {
        for (const char* model : {"oscillator", "chain", "mesh", "morse"}) {
            const Limit limit = limit_of(model, method);
            EXPECT_EQ(*limit.theory, 0) << method << ' ' << model;
            EXPECT_EQ(*limit.measured, 0) << method << ' ' << model;
        }
    }
}

TEST(Limit, is_none_where_nothing_oscillates) {
    const Limit limit = limit_of("free", "midpoint");
    EXPECT_EQ(limit.omega_max, 0);
    EXPECT_EQ(*limit.theory, infinity);
    EXPECT_EQ(*limit.measured, infinity);
    EXPECT_NE(limit.note, "");
}

TEST(Limit, of_a_curiosity_is_not_measured_and_has_a_note) {
    const Limit limit = limit_of("chain", "verlet-2008");
    EXPECT_FALSE(limit.measured.has_value());
    EXPECT_NE(limit.note, "");
}

// The Morse cube does not start in equilibrium; its initial forces are subtracted, so that they vanish there and only
// there.
TEST(Balanced, scene_is_in_equilibrium_at_its_start) {
    const RunDescription run = run_of("morse", "rk4", Precision::double_, 0.1);
    const Plan scene = balanced(model("morse").plan(run.scene));
    const Plan plain = model("morse").plan(run.scene);
    State<double> state{scene.start.state().displacement, Field<double>(scene.start.count())};
    const auto moved = [&](const Plan& where) {
        const auto stepper = method("rk4").make({where, state, run.method_parameters, Precision::double_, 0.1});
        stepper->advance(10);
        State<double> end;
        stepper->synchronised(end);
        double largest = 0;
        for (std::size_t k = 0; k < end.displacement.flat().size(); ++k)
            largest = std::max(largest, std::abs(end.displacement.flat()[k] - state.displacement.flat()[k]));
        return largest;
    };
    EXPECT_EQ(moved(scene), 0);
    EXPECT_GT(moved(plain), 0.01);
}

/// The fastest mode of a scene under a method.
ModeRun mode_of(const Plan& scene, const LinearisedScene& linear, const Eigenpairs& pairs, std::string_view method_id,
                Precision precision = Precision::double_, double departure = 0) {
    const Method& it = method(method_id);
    return {it,
            ParameterValues(it.info.parameters),
            precision,
            scene,
            linear.field(pairs.vectors.col(pairs.values.size() - 1)),
            highest_frequency(pairs),
            precision == Precision::float_ ? 1e-3 : 1e-6,
            departure};
}

// The partner: runs contradict a limit that is 1 % off on either side.
TEST(ModeRun, refuses_a_limit_that_is_one_percent_off) {
    const RunDescription run = run_of("chain", "rk4", Precision::double_, 0.1);
    const Plan scene = balanced(model("chain").plan(run.scene));
    const LinearisedScene linear(scene, model("chain").shape(run.scene));
    const Eigenpairs pairs = modes(linear);
    const auto phase_of = [](const MethodCase& c) {
        return linear_limit(*c.info, ParameterValues(c.info->parameters));
    };
    const auto has_limit = [&](const MethodCase& c) {  // that of srkn-11b is a narrow band
        return has_fixed_steps(c) && phase_of(c) > 0 && !std::isinf(phase_of(c)) && c.id() != "srkn-11b";
    };
    for (const MethodCase& c : working_methods_where(has_limit)) {
        const double phase = phase_of(c);
        const ModeRun mode = mode_of(scene, linear, pairs, c.id());
        const double limit = phase / highest_frequency(pairs);
        EXPECT_FALSE(mode.grows({.dt = 0.99 * limit, .steps = 8192})) << c;
        EXPECT_TRUE(mode.grows({.dt = 1.01 * limit, .steps = 8192})) << c;
    }
}

/// Questions about dt around a limit, from far below to far above it, a few of them about shorter runs.
std::vector<GrowthQuestion> questions_around(double limit) {
    std::vector<GrowthQuestion> questions;
    for (const double factor : {1.0001, 0.5, 0.99, 0.9999, 1.0, 1.00005, 1.001, 1.01, 1.3, 5.0, 0.999, 1.002})
        questions.push_back({.dt = factor * limit, .steps = questions.size() % 5 == 4 ? 700u : 2000u});
    return questions;
}

class Modes : public testing::TestWithParam<MethodCase> {};

// Runs in lanes answer as each run alone does, so that the limit they find is the same number.
TEST_P(Modes, are_judged_in_lanes_as_alone) {
    const MethodInfo& info = *GetParam().info;
    const double phase = linear_limit(info, ParameterValues(info.parameters));
    const auto run_on = [&](std::string_view id, Settings settings) {
        return run_of(id, info.id, GetParam().precision, 0.1, settings);
    };
    for (const RunDescription& run : {run_on("chain", {{"n", 6}}), run_on("chain", {{"n", 5}, {"c", 0.1}}),
                                      run_on("mesh", {{"dim", 4}}), run_on("morse", {{"edge", 2}})}) {
        const Plan scene = balanced(model_of(run).plan(run.scene));
        const LinearisedScene linear(scene, model_of(run).shape(run.scene));
        const Eigenpairs pairs = modes(linear);
        for (const double departure : {0.0, 0.05}) {
            const ModeRun mode = mode_of(scene, linear, pairs, info.id, GetParam().precision, departure);
            const double limit = (phase > 0 ? phase : 1) / highest_frequency(pairs);
            std::vector<GrowthQuestion> questions = questions_around(limit);
            mode.answer(questions);
            EXPECT_TRUE(questions.front().grows.has_value());
            for (const GrowthQuestion& question : questions) {
                EXPECT_EQ(question.grows.value_or(mode.grows(question)), mode.grows(question)) << question.dt / limit;
            }
            const LimitSearch search{.expected = limit, .above = 1.0005 * limit, .time_scale = limit, .steps = 1024};
            const auto alone = [&](const GrowthQuestion& question) { return mode.grows(question); };
            EXPECT_EQ(search.limit(mode.most_at_once(), [&](auto open) { mode.answer(open); }), search.limit(alone));
        }
    }
}

std::vector<MethodCase> methods_with_limits() {
    return working_methods_where([](const MethodCase& c) {
        return has_fixed_steps(c) && !std::isinf(linear_limit(*c.info, ParameterValues(c.info->parameters)));
    });
}

INSTANTIATE_TEST_SUITE_P(Catalogue, Modes, testing::ValuesIn(methods_with_limits()), case_name);

TEST(ModeRun, runs_in_lanes_where_its_method_does) {
    const RunDescription run = run_of("morse", "rk4", Precision::double_, 0.1, {{"edge", 2}});
    const Plan scene = balanced(model("morse").plan(run.scene));
    const LinearisedScene linear(scene, model("morse").shape(run.scene));
    const Eigenpairs pairs = modes(linear);
    for (const char* const id : {"euler", "srkn-11b", "rk4", "midpoint"})
        EXPECT_GT(mode_of(scene, linear, pairs, id).most_at_once(), 1u) << id;
    EXPECT_EQ(mode_of(scene, linear, pairs, "implicit-midpoint").most_at_once(), 1u);
}

TEST(AllLimits, are_those_of_each_method) {
    std::vector<RunDescription> runs;
    for (const char* const id : {"rk4", "dop853", "euler", "implicit-midpoint"})
        runs.push_back(run_of("chain", id, Precision::double_, 0.1, {{"n", 6}}));
    const StabilityLab lab(runs.front());
    std::size_t found = 0;
    const std::vector<Limit> limits = all_limits(lab, runs, [&](std::size_t done) {
        EXPECT_TRUE(done == found || done == found + 1) << "also while the next one is searched for";
        found = done;
    });
    EXPECT_EQ(found, runs.size());
    ASSERT_EQ(limits.size(), runs.size());
    for (std::size_t i = 0; i < runs.size(); ++i) {
        EXPECT_EQ(limits[i].description.method, runs[i].method);
        EXPECT_EQ(limits[i].measured, lab.limit(runs[i]).measured);
        EXPECT_EQ(limits[i].note, lab.limit(runs[i]).note);
    }
    const auto enough = [](std::size_t) { throw std::runtime_error("enough"); };
    EXPECT_THROW(all_limits(lab, runs, enough), std::runtime_error);
}

TEST(AllLimits, have_a_note_for_a_method_that_is_refused_and_continue) {
    std::vector<RunDescription> runs(2, run_of("chain", "euler", Precision::double_, 0.1, {{"n", 6}}));
    runs[0].method = "unheard-of";
    const std::vector<Limit> limits = all_limits(StabilityLab(runs[1]), runs, [](std::size_t) {});
    ASSERT_EQ(limits.size(), 2u);
    EXPECT_FALSE(limits[0].measured);
    EXPECT_NE(limits[0].note.find("unheard-of"), std::string::npos) << limits[0].note;
    EXPECT_TRUE(limits[1].measured);
}

// srkn-11b has a resonance at omega dt = pi, so narrow that 1 % further it is stable again.
TEST(ModeRun, finds_the_narrow_resonance) {
    const Limit limit = limit_of("oscillator", "srkn-11b");
    EXPECT_NEAR(*limit.measured, 3.1414, 1e-3 * 3.1414);
}

TEST(ModeRun, detects_a_force_that_is_not_smooth) {
    // a pair exactly at the cut-off distance: a force on one side, none on the other
    const RunDescription run =
        run_of("morse", "verlet", Precision::double_, 0.1, {{"edge", 2}, {"spacing", 1}, {"cutoff", 1}});
    const Limit limit = StabilityLab(run).limit(run);
    EXPECT_NE(limit.note, "");
}

// What is measured goes through squares of frequencies: units must not matter as long as these are numbers.
TEST(Limits, do_not_depend_on_the_units) {
    for (const char* id : {"chain", "mesh", "oscillator"}) {
        const Limit one = limit_of(id, "rk4", Precision::double_, {{"k", 1}});
        for (const double k : {1e-290, 1e-200, 1e-160, 1e160, 1e200, 1e290}) {
            const Limit limit = limit_of(id, "rk4", Precision::double_, {{"k", k}});
            EXPECT_NEAR(*limit.theory * std::sqrt(k) / *one.theory, 1, 1e-9) << id << " k = " << k;
            // bisection ends within 1e-4
            EXPECT_NEAR(*limit.measured * std::sqrt(k) / *one.measured, 1, 2e-4) << id << " k = " << k;
            EXPECT_EQ(limit.note, one.note) << id << " k = " << k;
        }
    }
}

TEST(Limits, that_are_none_by_theory_are_measured_unless_time_is_short) {
    const RunDescription run = run_of("chain", "implicit-midpoint", Precision::double_, 0.1);
    const Limit measured = StabilityLab(run).limit(run), by_theory = StabilityLab(run, NoLimit::by_theory).limit(run);
    EXPECT_EQ(measured.measured, infinity);
    EXPECT_EQ(by_theory.theory, infinity);
    EXPECT_FALSE(by_theory.measured);
    EXPECT_EQ(by_theory.note, "stable at any dt by theory: not measured (--quick)");
    const RunDescription other = run_of("chain", "rk4", Precision::double_, 0.1);
    EXPECT_TRUE(StabilityLab(other, NoLimit::by_theory).limit(other).measured);
}

TEST(Limits, of_scenes_too_stiff_for_double_are_refused) {
    for (const char* id : {"chain", "mesh", "rope", "oscillator"})
        EXPECT_THROW(limit_of(id, "rk4", Precision::double_, {{"k", 1.7e308}}), UsageError) << id;
}

}  // namespace
}  // namespace steplab::test
