// What a scene file knows of itself: the same as the model that it was written from.

#include "io/scene_file.hpp"
#include "io/scene_writer.hpp"
#include "sim/run/notes.hpp"
#include "sim/run/opening.hpp"
#include "support/runs.hpp"
#include "support/scene_texts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace steplab::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

RunDescription written(const RunDescription& run) { return describe(read_scene(scene_file_text(run))); }

std::vector<RunDescription> scenes_of_models() {
    std::vector<RunDescription> all;
    for (const Model& model : models()) all.push_back(describe(model.info.id));
    all.push_back(scene_with("chain", {{"L", 0.01}, {"k", 7}, {"m", 3}, {"c", 0.5}}));
    all.push_back(scene_with("chain", {{"L", 0}, {"n", 3}}));
    all.push_back(scene_with("chain", {{"n", 2}}));
    all.push_back(scene_with("chain", {{"n", 2}, {"fixed", 0}}));
    all.push_back(scene_with("mesh", {{"dim", 3}, {"L", 0.3}}));
    all.push_back(scene_with("mesh", {{"dim", 5}, {"k", 20}, {"m", 0.1}}));
    all.push_back(scene_with("rope", {{"n", 2}, {"c", 0}, {"k", 1e4}}));
    all.push_back(scene_with("oscillator", {{"m", 0.2}, {"k", 30}, {"c", 1}}));
    all.push_back(scene_with("morse", {{"edge", 1}, {"r0", 1.5}, {"k", 50}, {"m", 0.1}}));
    all.push_back(scene_with("morse", {{"edge", 2}, {"cutoff", 3}}));
    all.push_back(scene_with("crystal", {{"edge", 5}, {"r0", 0.9}, {"m", 2}}));
    return all;
}

// Lengths are differences of positions, minima are bisected: some units of rounding.
TEST(SceneFacts, of_a_file_are_those_of_the_model) {
    for (const RunDescription& run : scenes_of_models()) {
        const SceneFacts model = facts_of(run), file = facts_of(written(run));
        const std::string name = command_line(run);
        EXPECT_EQ(file.mass, model.mass) << name;
        EXPECT_DOUBLE_EQ(file.drag, model.drag) << name;
        EXPECT_EQ(file.damping, model.damping) << name;
        EXPECT_NEAR(file.bond, model.bond, 1e-12 * model.bond) << name;
        EXPECT_EQ(file.bond_width, model.bond_width) << name;
        EXPECT_NEAR(file.pair_frequency, model.pair_frequency, 1e-12 * model.pair_frequency) << name;
        EXPECT_EQ(file.lists_pairs, model.lists_pairs) << name;
    }
}

TEST(SceneFacts, of_a_file_give_the_notes_of_the_model) {
    std::size_t noted = 0;
    for (const Precision precision : precisions) {
        for (const double dt : {1e-16, 1e-12, 1e-6, 1e-3}) {
            for (const double farthest : {1.0, 3e5, 1e13}) {
                for (RunDescription run : scenes_of_models()) {
                    run.method = "velocity-verlet";
                    run = with_method(run, run.method);
                    run.precision = precision;
                    run.dt = dt;
                    const auto notes = notes_of_rounding(run, farthest);
                    EXPECT_EQ(notes_of_rounding(written(run), farthest), notes) << command_line(run);
                    noted += notes.size();
                }
            }
        }
    }
    EXPECT_GT(noted, 100u);
}

constexpr const char* pair_of_masses =
    "steplab = 1\n[[particles]]\ngroup = \"a\"\n[[particles]]\ngroup = \"b\"\nposition = [2, 0, 0]\nmass = 4\n";

SceneFacts facts_of_text(const std::string& more) { return facts_of(describe(read_scene(pair_of_masses + more))); }

TEST(SceneFacts, are_of_the_shortest_bond_and_the_fastest_pair) {
    const std::string spring = "[[springs]]\npairs = [[\"a\", \"b\"]]\nk = 5\n";
    EXPECT_EQ(facts_of_text(spring).bond, 2);
    EXPECT_DOUBLE_EQ(facts_of_text(spring).pair_frequency, std::sqrt(5 * (1 + 0.25)));
    EXPECT_EQ(facts_of_text(spring + "length = 0.5\n").bond, 0.5);
    EXPECT_EQ(facts_of_text(spring + "length = 0\n").bond, 0) << "a length of 0 needs no resolution";
    const std::string held = "[[fix]]\nparticles = [\"a\"]\nfixed = true\n";
    EXPECT_DOUBLE_EQ(facts_of_text(spring + held).pair_frequency, std::sqrt(5 * 0.25));
    EXPECT_EQ(facts_of_text(spring + held + "[[fix]]\nparticles = [\"b\"]\nfixed = true\n").bond, 0)
        << "what does not move needs no resolution";
    const std::string morse = "[[pairs]]\npotential = \"morse\"\nD = 1\nk = 80\nr0 = 0.7\n";
    EXPECT_NEAR(facts_of_text(spring + morse).bond, 0.7, 1e-12);
    EXPECT_NEAR(facts_of_text(spring + morse).pair_frequency, 10, 1e-9);
    EXPECT_EQ(facts_of_text("[[pairs]]\npotential = \"gravity\"\nG = 1\n").bond, 0);
}

// Positions of pairs are counted from the origin: it is their size that rounding takes from, not how far they moved.
TEST(SceneFacts, resolve_no_bonds_far_from_the_origin_in_float) {
    const auto notes = [](const std::string& place, Precision precision) {
        RunDescription run =
            describe(read_scene("steplab = 1\n[[particles]]\nposition = " + place +
                                "\nlattice = { kind = \"cubic\", cells = [2, 2, 2], constant = 1 }\n[[pairs]]\n"
                                "potential = \"lennard-jones\"\nepsilon = 1\nsigma = 0.9\n"));
        run.precision = precision;
        run.dt = 0.001;
        return notes_of_rounding(Simulation(run));
    };
    EXPECT_THAT(notes("[3e5, 0, 0]", Precision::float_), testing::ElementsAre(HasSubstr("too little for bonds of")));
    EXPECT_THAT(notes("[3e5, 0, 0]", Precision::double_), IsEmpty());
    EXPECT_THAT(notes("[30, 0, 0]", Precision::float_), IsEmpty());
}

// No frequency of gravity is known in advance: that of the motion itself is taken, also where a particle turns round.
TEST(SceneFacts, of_scenes_without_a_frequency_name_steps_too_short_for_the_precision) {
    for (const char* name : {"kepler-ellipse", "outer-solar-system", "double-well"}) {
        for (const double factor : {1.0, 1e-6}) {
            RunDescription run = with_method(describe(find_scene(name)), "velocity-verlet");
            run.precision = Precision::float_;
            run.dt = factor * opening_dt(run);
            Simulation simulation(run);
            simulation.advance(20);
            const auto notes = notes_of_rounding(simulation);
            if (factor == 1) {
                EXPECT_THAT(notes, IsEmpty()) << name;
            } else {
                EXPECT_THAT(notes, testing::ElementsAre(HasSubstr("rounds most of it away"))) << name;
            }
        }
    }
}

TEST(SceneFacts, of_a_particle_that_turns_round_give_no_note) {
    RunDescription run =
        describe(read_scene("steplab = 1\n[[particles]]\nposition = [1, 0, 0]\n[[fields]]\npotential = \"x^4 / 4\"\n"));
    run = with_method(run, "velocity-verlet");
    run.precision = Precision::float_;
    run.dt = 0.01;
    Simulation simulation(run);
    for (int step = 0; step < 800; ++step) {  // a period is 7.4 s
        simulation.advance(1);
        ASSERT_THAT(notes_of_rounding(simulation), IsEmpty()) << step;
    }
}

TEST(SceneFacts, of_a_particle_beside_a_far_one_that_rests_give_no_note) {
    for (const char* const held : {"fixed = true\n", ""}) {
        RunDescription run = describe(
            read_scene(std::string("steplab = 1\n[[particles]]\ngroup = \"ball\"\nposition = [1, 0, 0]\n[[particles]]\n"
                                   "position = [0, 1e6, 0]\n") +
                       held + "[[fields]]\nparticles = \"ball\"\npotential = \"x^4 / 4 + x^2 / 2\"\n"));
        run = with_method(run, "velocity-verlet");
        run.precision = Precision::float_;
        run.dt = 0.001;
        Simulation simulation(run);
        simulation.advance(100);
        EXPECT_THAT(notes_of_rounding(simulation), IsEmpty()) << held;
    }
}

// Altered particles are those of a composed scene, whatever the model was.
TEST(SceneFacts, follow_altered_masses) {
    const RunDescription run = describe("morse");
    const std::vector<Alteration> lighter{{0, std::nullopt, 0.01}};
    const SceneFacts altered = facts_of(with_alterations(run, lighter));
    EXPECT_NEAR(altered.pair_frequency, std::sqrt(0.5 * (1 / 0.01 + 1)), 1e-9);
    EXPECT_NEAR(altered.bond, facts_of(run).bond, 1e-12);
    EXPECT_EQ(altered.mass, 0);
}

}  // namespace
}  // namespace steplab::test
