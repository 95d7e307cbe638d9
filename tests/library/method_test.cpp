#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <steplab/steplab.hpp>
#include <utility>

namespace steplab::library {
namespace {

using testing::Contains;
using testing::HasSubstr;

/// Half a kick, a drift, half a kick; with a mistake on request: the second half kick is too long.
class OwnVerlet final : public Method {
public:
    explicit OwnVerlet(std::string id, double second_kick = 0.5) : id_(std::move(id)), second_kick_(second_kick) {}
    MethodDescription description() const override {
        return {.id = id_, .order = 2, .evaluations = 2, .symplectic = true, .reversible = true};
    }
    void step(Motion& motion) const override {
        const auto x = motion.positions(), v = motion.velocities();
        kick(motion, 0.5);
        for (std::size_t i = 0; i < x.size(); ++i) x[i] += motion.dt() * v[i];
        kick(motion, second_kick_);
    }

private:
    static void kick(Motion& motion, double part) {
        const auto v = motion.velocities();
        const auto a = motion.accelerations(motion.positions(), v);
        for (std::size_t i = 0; i < v.size(); ++i) v[i] += part * motion.dt() * a[i];
    }

    std::string id_;
    double second_kick_;
};

/// Adds it once for all tests of this program.
std::string own_verlet() {
    static const bool added = [] {
        add_method(std::make_shared<const OwnVerlet>("own-verlet"));
        return true;
    }();
    return added ? "own-verlet" : "";
}

double distance(const Result& a, const Result& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.rows.positions.size(); ++i)
        largest = std::max(largest, std::abs(a.rows.positions[i] - b.rows.positions[i]));
    return largest;
}

TEST(OwnMethods, go_where_the_same_method_of_the_catalogue_goes) {
    for (const char* model : {"chain", "mesh", "morse", "crystal"}) {
        const Scene scene = Scene::model(model);
        const Settings settings{.dt = 0.01};
        Settings own = settings, known = settings;
        own.method = own_verlet();
        known.method = "velocity-verlet";
        const Result mine = run(scene, own, {.steps = 50}), theirs = run(scene, known, {.steps = 50});
        // the same steps in another order of rounding: 50 of them, of numbers of about 1
        EXPECT_LT(distance(mine, theirs), 1e-12) << model;
        EXPECT_NE(distance(mine, run(scene, known, {.steps = 49})), 0) << model;
    }
}

TEST(OwnMethods, are_measured_by_the_lab) {
    const Scene chain = Scene::model("chain");
    EXPECT_NEAR(order(chain, own_verlet(), 10).value(), 2, 0.02);
    const Limit limit = limits(chain, {own_verlet()}).front();
    const Limit known = limits(chain, {"velocity-verlet"}).front();
    EXPECT_NEAR(*limit.theory, *known.theory, 1e-6 * *known.theory) << "bisected on the steps";
    EXPECT_NEAR(*limit.measured, *limit.theory, 1e-3 * *limit.theory);
    EXPECT_EQ(compare(chain, {{.method = own_verlet(), .dt = 0.1}}, 5).front().times.size(), 101u);
    const Advice advice = advise(chain, 1e-3, 5, {.methods = {own_verlet()}, .precisions = {"double"}});
    EXPECT_EQ(advice.best.method, "own-verlet");
    EXPECT_LE(advice.best.error, 1e-3);
}

TEST(OwnMethods, have_drag_in_their_accelerations) {
    // its kicks take drag as it is at their beginning: of order 1, and of none if it were left out or turned round
    EXPECT_NEAR(order(Scene::model("rope", {{"n", 5}, {"c", 1}}), own_verlet(), 2).value(), 1, 0.1);
}

TEST(OwnMethods, with_a_mistake_fail_the_tests_of_order_and_limit) {
    add_method(std::make_shared<const OwnVerlet>("broken-verlet", 0.6));
    const Scene chain = Scene::model("chain");
    EXPECT_LT(order(chain, "broken-verlet", 10).value_or(0), 1.5);
    // its force is 1.1 times as large: the limit is shorter by the root of that
    const double limit = *limits(chain, {"broken-verlet"}).front().measured;
    EXPECT_NEAR(limit * std::sqrt(1.1), *limits(chain, {"velocity-verlet"}).front().theory, 1e-3);
}

TEST(OwnMethods, are_stopped_and_set_back_where_they_diverge) {
    const Result run =
        library::run(Scene::model("chain"), {.method = own_verlet(), .dt = 3.0}, {.steps = 5000}, {.every = 1});
    EXPECT_EQ(run.status, "diverged");
    EXPECT_TRUE(
        std::all_of(run.rows.positions.begin(), run.rows.positions.end(), [](double x) { return std::isfinite(x); }));
}

TEST(OwnMethods, are_listed_and_counted) {
    EXPECT_THAT(methods(), Contains(own_verlet()));
    EXPECT_EQ(run(Scene::model("chain"), {.method = own_verlet(), .dt = 0.1}, {.steps = 10}).evaluations, 20u);
}

TEST(OwnMethods, are_refused_where_they_cannot_run) {
    EXPECT_THROW(run(Scene::model("chain"), {.method = own_verlet(), .precision = "float"}), UsageError);
    const Scene dashpots = Scene::from_text(
        "steplab = 1\ntitle = \"d\"\n[[particles]]\ngroup = \"a\"\nline = { count = 2, step = [1, 0, 0] }\n"
        "[[springs]]\nbetween = \"a\"\nk = 1\ndamping = 0.1\n");
    EXPECT_THROW(run(dashpots, {.method = own_verlet()}), UsageError);
    EXPECT_NO_THROW(run(dashpots, {.method = "velocity-verlet"}));
}

TEST(OwnMethods, need_an_id_of_their_own) {
    own_verlet();
    for (const char* id : {"own-verlet", "rk4", "Own", "", "a b", "a=1"})
        EXPECT_THROW(add_method(std::make_shared<const OwnVerlet>(id)), UsageError) << id;
    EXPECT_THROW(add_method(nullptr), UsageError);
    try {
        run(Scene::model("chain"), {.method = "own-verlot"});
        FAIL();
    } catch (const UsageError& error) {
        EXPECT_THAT(error.what(), HasSubstr("own-verlet"));
    }
}

}  // namespace
}  // namespace steplab::library
