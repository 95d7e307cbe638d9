#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <steplab/steplab.hpp>

namespace steplab::library {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

const Particles pair{.positions = {0, 0, 0, 1.5, 0, 0}, .velocities = {0, 0.1, 0, 0, 0, 0}, .masses = {1, 3}};

TEST(LibraryScene, is_made_of_arrays) {
    const Particles start = Scene::of(pair).start();
    EXPECT_EQ(start.positions, pair.positions);
    EXPECT_EQ(start.velocities, pair.velocities);
    EXPECT_EQ(start.masses, pair.masses);
}

TEST(LibraryScene, refuses_arrays_that_do_not_fit) {
    EXPECT_THROW(Scene::of({}), UsageError);
    EXPECT_THROW(Scene::of({.positions = {0, 0, 0, 1}}), UsageError);
    EXPECT_THROW(Scene::of({.positions = {0, 0, 0}, .velocities = {1, 2}}), UsageError);
    EXPECT_THROW(Scene::of({.positions = {0, 0, 0}, .masses = {1, 1}}), UsageError);
    EXPECT_THROW(Scene::of({.positions = {0, 0, 0}, .masses = {-1}}), UsageError);
    EXPECT_THROW(Scene::of({.positions = {0, std::nan(""), 0}}), UsageError);
    EXPECT_THROW(Scene::of({.positions = {0, std::numeric_limits<double>::infinity(), 0}}), UsageError);
}

TEST(LibraryScene, has_the_same_bits_as_text) {
    const Scene rope = Scene::model("rope", {{"n", 6}, {"c", 0.5}});
    EXPECT_EQ(run(Scene::from_text(rope.text())).hash, run(rope).hash);
    EXPECT_NE(run(rope.with_parameters({{"c", 0.6}})).hash, run(rope).hash);
    const Scene arrays = Scene::of(pair);
    EXPECT_EQ(run(Scene::from_text(arrays.text())).hash, run(arrays).hash);
    EXPECT_THROW(arrays.starting_at(pair.positions, pair.positions).text(), UsageError);
    EXPECT_THROW(Scene::from_text("[[particles]"), FileError);
}

TEST(LibraryScene, is_restored_as_it_was_saved) {
    const Scene scene =
        Scene::of(pair).with_pair_force({.potential = "-1/r"}).starting_at(pair.velocities, pair.positions);
    EXPECT_EQ(run(Scene::restored(scene.saved())).hash, run(scene).hash);
    EXPECT_THROW(Scene::restored("{}"), FileError);
}

TEST(LibraryScene, names_what_it_does_not_know) {
    try {
        Scene::model("chian");
        FAIL();
    } catch (const UsageError& error) {
        EXPECT_THAT(error.what(), HasSubstr("chain"));
    }
    EXPECT_THROW(Scene::model("chain", {{"nn", 3}}), UsageError);
    EXPECT_THROW(Scene::model("chain", {{"n", 0.5}}), UsageError);
    EXPECT_THROW(Scene::from_file("/no/such.toml"), FileError);
    EXPECT_THAT(models(), Contains("chain"));
    EXPECT_THAT(scenes(), Contains("figure-eight"));
}

TEST(LibraryScene, starts_elsewhere) {
    const Scene chain = Scene::model("chain", {{"n", 2}});
    const std::vector<double> x{0, 0, 0, 1.25, 0, 0}, v{0, 0, 0, 0, 0.5, 0};
    const Particles start = chain.starting_at(x, v).start();
    EXPECT_EQ(start.positions, x);
    EXPECT_EQ(start.velocities, v);
    EXPECT_THROW(chain.starting_at(x, {}), UsageError);
}

TEST(PairForces, give_the_energy_of_their_expression) {
    const Expression r = Expression::named("r"), m = Expression::named("m1") * Expression::named("m2");
    const Scene scene = Scene::of(pair).with_pair_force(
        PairForce{.potential = (-0.5 * m / sqrt(pow(r, 2) + 0.25) + exp(-r)).text(), .values = {}});
    const double expected = -0.5 * 3 / std::sqrt(1.5 * 1.5 + 0.25) + std::exp(-1.5);
    // a few roundings of numbers below 1, and exp to 1.5 units in the last place
    EXPECT_NEAR(run(scene, {}, {.steps = 0}).rows.potential[0], expected, 1e-15);
}

TEST(PairForces, are_added_to_what_is_there) {
    const Scene both = Scene::of(pair)
                           .with_pair_force(PairForce{.potential = "A/r", .values = {{"A", 2}}})
                           .with_pair_force(PairForce{.potential = "gravity", .values = {{"G", 1}}});
    EXPECT_NEAR(run(both, {}, {.steps = 0}).rows.potential[0], 2 / 1.5 - 3 / 1.5, 1e-15);
}

TEST(PairForces, are_refused_where_they_cannot_be_read) {
    EXPECT_THROW(Scene::of(pair).with_pair_force(PairForce{.potential = "A/r"}), UsageError);
    EXPECT_THROW(Scene::of(pair).with_pair_force(PairForce{.potential = "1/("}), UsageError);
    EXPECT_THROW(Scene::of(pair).with_pair_force(PairForce{.potential = "1/r\"\n[run]\ndt = 3"}), UsageError);
    EXPECT_THROW(Scene::of(pair).with_pair_force(PairForce{.potential = "1/r", .cutoff = -1.0}), UsageError);
    EXPECT_THROW(Expression{std::nan("")}, UsageError);
}

TEST(Expressions, keep_their_order_of_operations) {
    const Expression a = Expression::named("a"), b = Expression::named("b");
    EXPECT_EQ((a - (b - 1)).text(), "(a - (b - 1))");
    EXPECT_EQ(pow(-a, 2).text(), "(-(a) ^ 2)");
}

}  // namespace
}  // namespace steplab::library
