#include "sim/run/run_description.hpp"

#include "core/error.hpp"
#include "sim/run/memory.hpp"
#include "support/heap.hpp"
#include "support/runs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>

namespace steplab::test {
namespace {

using testing::HasSubstr;

/// The message with which a description is refused; empty if it is not.
template <class Call>
std::string refusal(Call call) {
    try {
        call();
    } catch (const UsageError& error) {
        return error.what();
    }
    return "";
}

TEST(RunDescription, unknown_ids_are_answered_with_known_ones) {
    EXPECT_THAT(refusal([] { describe("chian", "rk4"); }), HasSubstr("did you mean 'chain'?"));
    EXPECT_THAT(refusal([] { describe("pendulum", "rk4"); }),
                HasSubstr("known: free, oscillator, chain, mesh, rope, morse"));
    EXPECT_THAT(refusal([] { describe("chain", "rk5"); }), HasSubstr("did you mean 'rk4'?"));
}

TEST(RunDescription, parameters_belong_to_the_model_or_to_the_method) {
    RunDescription description = describe("chain", "stoermer");
    set_parameter(description, "n", "20");
    set_parameter(description, "substeps", "5");
    EXPECT_EQ(description.scene["n"], 20);
    EXPECT_EQ(description.method_parameters["substeps"], 5);
    EXPECT_THAT(refusal([&] { set_parameter(description, "g", "1"); }),
                HasSubstr("unknown parameter 'g' of chain and stoermer; known: n, L, k, m, c, fixed, v0, substeps"));
}

TEST(RunDescription, refuses_a_dt_that_is_none) {
    for (const double dt : {0.0, std::numeric_limits<double>::quiet_NaN(), infinity}) {
        EXPECT_THAT(refusal([&] { check(run_of("chain", "rk4", Precision::double_, dt)); }),
                    HasSubstr("dt must be a number > 0"));
    }
    EXPECT_THAT(refusal([] { check(run_of("chain", "rk4", Precision::float_, 1e-60)); }), HasSubstr("lost in float"));
    EXPECT_THAT(refusal([] { check(run_of("chain", "rk4", Precision::float_, 1e60)); }), HasSubstr("lost in float"));
    EXPECT_EQ(refusal([] { check(run_of("chain", "rk4", Precision::double_, 1e-60)); }), "");
}

TEST(RunDescription, refuses_what_float_cannot_hold) {
    EXPECT_THAT(refusal([] {
                    check(run_of("chain", "rk4", Precision::float_, 0.1, {{"v0", 1e300}}));
                }),
                HasSubstr("v0 = 1e300"));
    EXPECT_THAT(refusal([] {
                    check(run_of("chain", "rk4", Precision::float_, 0.1, {{"m", 1e-60}}));
                }),
                HasSubstr("m = 1e-60"));
    EXPECT_EQ(refusal([] { check(run_of("chain", "rk4", Precision::double_, 0.1, {{"m", 1e-60}})); }), "");
    EXPECT_EQ(refusal([] { check(run_of("chain", "rk4", Precision::float_, 0.1, {{"v0", 1e-60}})); }), "");
}

TEST(RunDescription, refuses_more_particles_than_memory_before_allocating) {
    for (const auto& description : {run_of("chain", "rk4", Precision::double_, 0.1, {{"n", 1e12}}),
                                    run_of("mesh", "rk4", Precision::double_, 0.1, {{"dim", 1e6}}),
                                    run_of("morse", "rk4", Precision::double_, 0.1, {{"edge", 1e4}}),
                                    run_of("free", "euler", Precision::float_, 0.1, {{"n", 9e15}})}) {
        const std::string message = refusal([&] { check(description); });
        EXPECT_THAT(message, testing::ContainsRegex("need [0-9.e+]+ ([kMGTP]B|bytes) of memory")) << description.model;
        EXPECT_THAT(message, HasSubstr("particles need")) << description.model;
        EXPECT_NE(refusal([&] { Simulation{description}; }), "") << description.model;
    }
}

TEST(RunDescription, memory_is_counted_in_bytes_of_the_right_size) {
    const double in_double = bytes_per_particle(describe("mesh", "rk4"));
    EXPECT_GT(in_double, 6 * 3 * 8);  // rk4 alone holds six fields
    EXPECT_LT(in_double, 2000);
    EXPECT_GT(available_memory(), 1e8);
}

RunDescription scene_of(RunDescription description, std::initializer_list<std::pair<const char*, double>> values) {
    for (const auto& [name, value] : values) description.scene.set(name, value);
    return description;
}

double estimated_bytes(const RunDescription& description) {
    const Model& entry = model_of(description);
    return entry.particles(description.scene) * bytes_per_particle(description) +
           bytes_of_interactions(description, entry.plan(description.scene));
}

/// What is refused before it is allocated is refused rightly: a run takes no more than the estimate, and more than a
/// sixth of it.
void expect_estimate_holds(const RunDescription& description) {
    const double before = heap();
    Simulation simulation(description);
    simulation.advance(1);
    const Frame frame = simulation.frame();
    const double taken = heap() - before, estimated = estimated_bytes(description);
    SCOPED_TRACE(description.model + " " + description.method);
    EXPECT_LE(taken, estimated * 1.1);  // rows are padded, memory is handed out in blocks
    EXPECT_GE(taken, before > 0 ? estimated / 6 : 0);
}

TEST(Memory, estimated_is_what_a_run_takes) {
    for (const Method& method : methods())
        expect_estimate_holds(scene_of(describe("chain", method.info.id), {{"n", 20000}}));
}

TEST(Memory, estimated_counts_what_is_held_for_interactions) {
    std::size_t counted = 0;
    for (const Method& method : methods()) {
        if (!method.info.bytes_of_interactions) continue;
        ++counted;
        expect_estimate_holds(scene_of(describe("mesh", method.info.id), {{"dim", 60}}));
        expect_estimate_holds(scene_of(describe("morse", method.info.id), {{"edge", 5}}));
        // taylor refuses so many particles with a cut-off
        if (method.info.id != "taylor")
            expect_estimate_holds(scene_of(describe("morse", method.info.id), {{"edge", 8}, {"cutoff", 1.2}}));
    }
    EXPECT_GT(counted, 0u);
}

TEST(RunDescription, default_of_every_model_can_be_run_by_all_but_taylor_of_crystal) {
    for (const Model& model : models()) {
        for (const Method& method : methods()) {
            const std::string refused = refusal([&] { check(describe(model.info.id, method.info.id)); });
            if (model.info.id == "crystal" && method.info.id == "taylor") {
                EXPECT_THAT(refused, HasSubstr("crosses the cut-off"));
            } else {
                EXPECT_EQ(refused, "");
            }
        }
    }
}

TEST(Memory, counted_grows_with_what_the_cut_off_takes_in) {
    const RunDescription crystal = scene_of(describe("crystal", "euler"), {{"edge", 200}, {"cutoff", 60}});
    EXPECT_GT(estimated_bytes(crystal), 8e6 * 2e5);
    EXPECT_THAT(refusal([&] { check(crystal); }), testing::ContainsRegex("need [0-9.e+]+ ([kMGTP]B|bytes) of memory"));
    expect_estimate_holds(scene_of(describe("crystal", "euler"), {{"edge", 30}}));
    expect_estimate_holds(scene_of(describe("crystal", "rk4"), {{"edge", 20}, {"cutoff", 3.5}}));
    expect_estimate_holds(scene_of(describe("morse", "euler"), {{"edge", 20}, {"cutoff", 0.7}}));
}

/// The description a command line stands for.
RunDescription parsed(const std::string& line) {
    std::istringstream words(line);
    std::string option, value;
    RunDescription description = describe();
    while (words >> option >> value) {
        if (option == "--model") description = with_model(description, value);
        if (option == "--method") description = with_method(description, value);
        if (option == "--precision") description.precision = value == "float" ? Precision::float_ : Precision::double_;
        if (option == "--dt") description.dt = std::stod(value);
        if (option == "--set")
            set_parameter(description, value.substr(0, value.find('=')), value.substr(value.find('=') + 1));
    }
    return description;
}

TEST(RunDescription, command_line_gives_it_back) {
    for (const Model& model : models()) {
        for (const MethodCase& c : all_methods()) {
            RunDescription description = run_of(model.info.id, c.id(), c.precision, 1.0 / 3);
            for (const auto& info : description.scene.infos()) {
                if (info.kind == ParameterInfo::Kind::real) description.scene.set(info.name, info.default_value + 0.1);
            }
            EXPECT_EQ(parsed(command_line(description)), description) << command_line(description);
            EXPECT_EQ(parsed(command_line(describe(model.info.id, c.id()))), describe(model.info.id, c.id()));
        }
    }
    RunDescription corner = describe("mesh", "stoermer");
    set_parameter(corner, "kick", "corner");
    set_parameter(corner, "substeps", "3");
    EXPECT_EQ(command_line(corner),
              "--model mesh --set kick=corner --method stoermer --set substeps=3 --precision double --dt 0.1");
    EXPECT_EQ(parsed(command_line(corner)), corner);
}

TEST(RunDescription, a_time_takes_the_steps_that_reach_it) {
    EXPECT_EQ(steps_until(68.1, 0.1), 681u);
    EXPECT_EQ(steps_until(1, 0.3), 4u);
    EXPECT_EQ(steps_until(0, 0.1), 0u);
    EXPECT_EQ(steps_until(0.1 * 3, 0.1), 3u);  // 0.30000000000000004 / 0.1 is a little more than 3
}

TEST(StabilityLimit, is_the_methods_limit_over_the_scenes_frequency) {
    EXPECT_EQ(stability_limit(run_of("oscillator", "verlet", Precision::double_, 0.1, {{"k", 4}}))->limit, 1);
    EXPECT_EQ(stability_limit(describe("oscillator", "stoermer"))->limit, 20);
    EXPECT_EQ(stability_limit(describe("oscillator", "midpoint"))->limit, 0);
    EXPECT_EQ(stability_limit(describe("free", "midpoint"))->limit, infinity);
    EXPECT_FALSE(stability_limit(describe("morse", "rk4")).has_value());
}

// Semi-implicit Euler with drag in the explicit force: 2 (sqrt(1 + zeta^2) - zeta) / omega, zeta = gamma / (2 omega).
TEST(StabilityLimit, of_euler_falls_with_drag_as_its_formula_says) {
    for (const double c : {0.1, 1.0, 5.0}) {
        const double zeta = c / 2;
        const auto limit = stability_limit(run_of("oscillator", "euler", Precision::double_, 0.1, {{"c", c}}));
        EXPECT_NEAR(limit->limit, 2 * (std::sqrt(1 + zeta * zeta) - zeta), 1e-9) << c;  // the bisection's last interval
    }
}

TEST(StabilityLimit, of_strong_drag_is_that_of_decay_alone) {
    // rk4 on v' = -gamma v is stable up to gamma dt = 2.785293563 (Hairer, Wanner II, IV.2)
    const auto limit = stability_limit(run_of("oscillator", "rk4", Precision::double_, 0.1, {{"c", 1e4}, {"k", 1e-4}}));
    EXPECT_NEAR(limit->limit * 1e4, 2.785293563, 1e-6);
}

// At this damping rk4 bears the chain's fastest mode (omega dt up to 2.9) better than the decay of its motion as a
// whole.
TEST(StabilityLimit, is_that_of_the_mode_that_bears_least) {
    const auto limit = stability_limit(run_of("chain", "rk4", Precision::double_, 0.1, {{"c", 2.5}, {"fixed", 0}}));
    EXPECT_NEAR(limit->limit * 2.5, 2.785293563, 1e-6);
}

// Just below it a damped oscillator comes to rest, just above it blows up: the limit is the run's own.
TEST(StabilityLimit, with_drag_is_where_runs_blow_up) {
    const Settings settings{{"c", 0.5}};
    const auto limit_of = [&](const MethodCase& c) {
        return stability_limit(run_of("oscillator", c.id(), Precision::double_, 0.1, settings))->limit;
    };
    for (const MethodCase& c : working_methods_where([&](const MethodCase& it) { return limit_of(it) < infinity; })) {
        const double limit = limit_of(c);
        ASSERT_GT(limit, 0) << c;
        Simulation below(run_of("oscillator", c.id(), c.precision, 0.99 * limit, settings));
        Simulation above(run_of("oscillator", c.id(), c.precision, 1.01 * limit, settings));
        below.advance(20000);
        above.advance(20000);
        EXPECT_LT(below.diagnostics().energy, 0.01) << c;
        EXPECT_TRUE(above.divergence()) << c;
    }
}

TEST(Catalogue, entries_are_complete) {
    for (const Method& method : methods()) {
        const MethodInfo& info = method.info;
        for (const std::string_view text : {info.id, info.name, info.what, info.conserves, info.source})
            EXPECT_FALSE(text.empty()) << info.id;
        EXPECT_GE(info.evaluations, 1) << info.id;
    }
    for (const Model& model : models()) {
        for (const std::string_view text : {model.info.id, model.info.name, model.info.what})
            EXPECT_FALSE(text.empty()) << model.info.id;
    }
}

TEST(Catalogue, parameters_have_words_and_defaults_within_their_sliders) {
    const auto examine = [](std::string_view owner, std::span<const ParameterInfo> infos) {
        for (const ParameterInfo& info : infos) {
            EXPECT_FALSE(info.name.empty() || info.what.empty()) << owner;
            EXPECT_EQ(refusal([&] { check_value(info, info.default_value); }), "") << owner << " " << info.name;
            if (info.kind == ParameterInfo::Kind::choice) continue;
            EXPECT_LE(info.slider_low, info.default_value) << owner << " " << info.name;
            EXPECT_GE(info.slider_high, info.default_value) << owner << " " << info.name;
            for (const double end : {info.slider_low, info.slider_high})
                EXPECT_EQ(refusal([&] { check_value(info, end); }), "") << owner << " " << info.name;
        }
    };
    for (const Model& model : models()) examine(model.info.id, model.info.parameters);
    for (const Method& method : methods()) examine(method.info.id, method.info.parameters);
}

}  // namespace
}  // namespace steplab::test
