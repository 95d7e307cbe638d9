#include <gmock/gmock.h>

#include <array>
#include <cstdio>
#include <memory>
#include <steplab/steplab.hpp>
#include <string>

namespace steplab::library {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

/// What the program prints.
std::string printed(const std::string& arguments) {
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen((STEPLAB_PROGRAM " " + arguments).c_str(), "r"), pclose);
    std::string text;
    for (std::array<char, 4096> part; std::fgets(part.data(), part.size(), pipe.get());) text += part.data();
    return text;
}

TEST(LibraryRun, has_the_bits_of_the_program) {
    const Result run =
        library::run(Scene::model("chain", {{"n", 20}}), {.method = "pefrl", .dt = 0.05, .precision = "float"},
                     {.until = 30.0}, {.every = 7});
    const std::string same =
        "run --model chain --set n=20 --method pefrl --dt 0.05 --precision float --until 30 --summary - 2>/dev/null";
    EXPECT_THAT(printed(same), HasSubstr("\"hash\": \"" + run.hash + "\""));
    const std::string other =
        "run --model chain --set n=20 --method pefrl --dt 0.05 --until 30 --summary - 2>/dev/null";
    EXPECT_THAT(printed(other), testing::Not(HasSubstr(run.hash)));
}

TEST(LibraryRun, opens_a_scene_file_as_it_says) {
    const Result run = library::run(Scene::from_file("kepler-ellipse"));
    EXPECT_THAT(printed("run --scene kepler-ellipse --summary - 2>/dev/null"), HasSubstr(run.hash));
}

TEST(LibraryRun, records_rows_of_all_particles) {
    const Result run = library::run(Scene::model("chain", {{"n", 4}}), {}, {.steps = 25}, {.every = 10});
    EXPECT_THAT(run.rows.steps, testing::ElementsAre(0u, 10u, 20u, 25u));
    EXPECT_THAT(run.rows.positions, SizeIs(4 * 4 * 3));
    EXPECT_EQ(run.rows.positions[3 * 2], 4.0) << "x of the third particle of a chain with L = 2";
    EXPECT_THAT(run.rows.energy, SizeIs(4));
    EXPECT_EQ(run.status, "ok");
    EXPECT_NO_THROW(run.check());
}

TEST(LibraryRun, says_that_it_diverged_and_has_the_valid_rows) {
    const Result run = library::run(Scene::model("chain"), {.method = "rk4", .dt = 3.0}, {.steps = 1000}, {.every = 1});
    EXPECT_EQ(run.status, "diverged");
    EXPECT_LT(run.rows.steps.back(), 1000u);
    EXPECT_THROW(run.check(), Diverged);
}

TEST(LibraryRun, refuses_what_is_not_possible) {
    const Scene chain = Scene::model("chain");
    EXPECT_THROW(library::run(chain, {.method = "rk5"}), UsageError);
    EXPECT_THROW(library::run(chain, {.dt = 0.0}), UsageError);
    EXPECT_THROW(library::run(chain, {.precision = "half"}), UsageError);
    EXPECT_THROW(library::run(chain, {.parameters = {{"k", 2}}}), UsageError) << "a parameter of the scene";
    EXPECT_THROW(library::run(chain, {}, {.steps = 1, .until = 1.0}), UsageError);
    EXPECT_THROW(library::run(chain, {}, {.until = -1.0}), UsageError);
    EXPECT_NO_THROW(library::run(chain, {.dt = -0.1}, {.until = -1.0}));
    EXPECT_THROW(read("/no/such.trajectory"), FileError);
}

TEST(LibraryRun, is_ended_by_an_interruption) {
    const std::atomic<bool> asked = true;
    const Interruption here(asked);
    EXPECT_THROW(library::run(Scene::model("mesh"), {}, {.steps = 10000000}), Interrupted);
    EXPECT_THROW(report(Scene::model("chain"), 100, {.quick = false}), Interrupted);
    EXPECT_THROW(limits(Scene::model("mesh", {{"dim", 9}})), Interrupted);
}

TEST(LibrarySimulation, goes_where_the_run_goes) {
    const Scene chain = Scene::model("chain", {{"n", 5}});
    Simulation simulation(chain, {.method = "verlet", .dt = 0.1});
    simulation.advance(30);
    simulation.advance(70);
    const Result run = library::run(chain, {.method = "verlet", .dt = 0.1}, {.steps = 100});
    EXPECT_EQ(simulation.hash(), run.hash);
    EXPECT_EQ(simulation.step(), 100u);
    std::vector<double> x(15), short_one(14);
    simulation.positions(x);
    EXPECT_EQ(x, std::vector<double>(run.rows.positions.end() - 15, run.rows.positions.end()));
    EXPECT_THROW(simulation.positions(short_one), UsageError);
}

}  // namespace
}  // namespace steplab::library
