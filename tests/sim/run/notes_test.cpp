#include "sim/run/notes.hpp"

#include "support/runs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace steplab::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(NotesOfRounding, are_none_on_default_runs) {
    for (const MethodCase& c : all_methods()) {
        for (const Model* model : models_for(c.id(), c.precision)) {
            Simulation simulation(small_run_of(model->info.id, c.id(), c.precision, 0.1));
            simulation.advance(20);
            simulation.conclude();
            EXPECT_THAT(notes_of_rounding(simulation), IsEmpty()) << c << ' ' << model->info.id;
        }
    }
}

std::vector<std::string> notes(std::string_view model, std::string_view method, Precision precision, double dt,
                               double farthest = 1, Settings settings = {}) {
    const RunDescription run = run_of(model, method, precision, dt, settings);
    return notes_of_rounding(run, farthest);
}

// velocity-verlet at dt = 1e-6 in float is off by 0.0095 m at t = 20, with compensated sums by 2e-8.
TEST(NotesOfRounding, name_steps_too_short_for_the_precision) {
    EXPECT_THAT(notes("chain", "velocity-verlet", Precision::float_, 1e-6),
                ElementsAre(AllOf(HasSubstr("1e-6"), HasSubstr("float"), HasSubstr("compensated=1"))));
    EXPECT_THAT(notes("morse", "rk4", Precision::float_, 1e-6), ElementsAre(HasSubstr("float")));
    EXPECT_THAT(notes("chain", "velocity-verlet", Precision::double_, 1e-6), IsEmpty());
    EXPECT_THAT(notes("chain", "velocity-verlet", Precision::double_, 1e-15), ElementsAre(HasSubstr("double")));
    EXPECT_THAT(notes("chain", "ias15", Precision::float_, 1e-6), IsEmpty()) << "its steps are its own";
}

TEST(NotesOfRounding, are_none_with_compensated_sums) {
    RunDescription run = run_of("chain", "velocity-verlet", Precision::float_, 1e-6);
    run.method_parameters.set("compensated", 1);
    EXPECT_THAT(notes_of_rounding(run, 1), IsEmpty());
}

TEST(NotesOfRounding, name_distances_at_which_bonds_are_not_resolved) {
    EXPECT_THAT(notes("morse", "rk4", Precision::float_, 0.01, 1e5),
                ElementsAre(AllOf(HasSubstr("1e5 m"), HasSubstr("0.5 m"))));
    EXPECT_THAT(notes("morse", "rk4", Precision::double_, 0.01, 1e5), IsEmpty());
    EXPECT_THAT(notes("morse", "rk4", Precision::float_, 0.01, 1000), IsEmpty());
    EXPECT_THAT(notes("oscillator", "rk4", Precision::float_, 0.01, 1e9), IsEmpty()) << "it has no bond to resolve";
}

TEST(NotesOfRounding, name_bonds_too_stiff_to_be_resolved) {
    const auto of_stiffness = [](double k) {
        return notes("morse", "dopri5", Precision::double_, 0.01, 10, {{"k", k}});
    };
    EXPECT_THAT(of_stiffness(1e26), ElementsAre(AllOf(HasSubstr("10 m"), HasSubstr("1.4e-13 m"))));
    EXPECT_THAT(of_stiffness(1e20), IsEmpty()) << "1.4e-10 m";
}

TEST(NotesOfRounding, name_tolerances_that_the_precision_does_not_hold) {
    for (const MethodCase& c : all_methods()) {
        RunDescription run = run_of("free", c.id(), c.precision, 0.1);
        if (!run.method_parameters.contains("tolerance")) continue;
        const bool single = c.precision == Precision::float_;
        run.method_parameters.set("tolerance", single ? 1e-6 : 1e-15);
        EXPECT_THAT(notes_of_rounding(run, 1), IsEmpty()) << c;
        run.method_parameters.set("tolerance", single ? 1e-7 : 1e-16);
        EXPECT_THAT(notes_of_rounding(run, 1), ElementsAre(HasSubstr(single ? "1e-7" : "1e-16"))) << c;
    }
}

}  // namespace
}  // namespace steplab::test
