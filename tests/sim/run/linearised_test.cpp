#include "sim/run/linearised.hpp"

#include "models/forces/layouts.hpp"
#include "models/scene/planner.hpp"
#include "models/scene/scene.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

namespace steplab::test {
namespace {

LinearisedScene linearised(std::string_view id, Settings settings = {}) {
    const RunDescription run = run_of(id, "rk4", Precision::double_, 0.1, settings);
    return {model(id).plan(run.scene), model(id).shape(run.scene)};
}

double omega_max(std::string_view id, Settings settings = {}) {
    return highest_frequency(modes(linearised(id, settings)));
}

/// The matrix itself, column by column.
Eigen::MatrixXd dense(const LinearisedScene& scene) {
    Eigen::MatrixXd matrix(scene.size(), scene.size());
    for (Eigen::Index k = 0; k < scene.size(); ++k)
        matrix.col(k) = scene.stiffness(Eigen::VectorXd::Unit(scene.size(), k));
    return matrix;
}

// The complete Lanczos iteration: a few roundings of the largest eigenvalue.
TEST(OmegaMax, agrees_with_the_closed_forms) {
    EXPECT_NEAR(omega_max("oscillator", {{"k", 9}, {"m", 4}}), 1.5, 1e-14);
    EXPECT_NEAR(omega_max("chain"), 1.97272261, 5e-9);  // digits as published
    for (const double n : {2.0, 3.0, 10.0, 60.0}) {
        for (const double fixed : {0.0, 1.0}) {
            const Settings settings{{"n", n}, {"fixed", fixed}, {"k", 3}, {"m", 2}};
            const double exact =
                *model("chain").omega_max(run_of("chain", "rk4", Precision::double_, 0.1, settings).scene);
            EXPECT_NEAR(omega_max("chain", settings), exact, 1e-13 * exact) << n << ' ' << fixed;
        }
    }
    EXPECT_NEAR(omega_max("rope"), 1.97272261 * std::sqrt(200), 1e-7);
    EXPECT_EQ(omega_max("free"), 0);
}

// Force constants and masses whose squares overflow or underflow: nothing but the unit of time differs.
TEST(OmegaMax, does_not_depend_on_the_units) {
    for (const char* id : {"chain", "mesh", "oscillator", "rope"}) {
        const double one = omega_max(id, {{"k", 1}});
        for (const double k : {1e-300, 1e-250, 1e-160, 1e-100, 1e100, 1e160, 1e250, 1e300})
            EXPECT_NEAR(omega_max(id, {{"k", k}}) / std::sqrt(k) / one, 1, 1e-12) << id << " k = " << k;
    }
}

TEST(OmegaMax, beyond_what_double_holds_is_not_zero) {
    for (const char* id : {"chain", "mesh", "rope"})
        EXPECT_GT(omega_max(id, {{"k", 1.7e308}}), largest_frequency) << id;
}

// Beyond 300 numbers it ends when the residual is small or after 300 steps; the largest eigenvalue of a chain is then
// accurate to (pi / 600)^2 times the gap there.
TEST(OmegaMax, of_a_long_chain_is_accurate_enough_for_limits) {
    const double exact =
        *model("chain").omega_max(run_of("chain", "rk4", Precision::double_, 0.1, {{"n", 5000}}).scene);
    EXPECT_NEAR(omega_max("chain", {{"n", 5000}}), exact, 1e-5 * exact);
}

// The closed form is that of an infinite mesh: an upper bound, which larger meshes approach.
TEST(OmegaMax, of_a_mesh_is_below_that_of_an_infinite_one) {
    EXPECT_LT(omega_max("mesh"), std::sqrt(8.0));
    EXPECT_GT(omega_max("mesh", {{"dim", 40}}), omega_max("mesh"));
    EXPECT_LT(omega_max("mesh", {{"dim", 40}}), std::sqrt(8.0));
}

TEST(Lanczos, finds_what_a_dense_solver_finds) {
    for (const auto& scene : {linearised("mesh", {{"dim", 6}}), linearised("morse", {{"edge", 2}})}) {
        const Eigen::MatrixXd matrix = dense(scene);
        EXPECT_LT((matrix - matrix.transpose()).norm(), 1e-14 * matrix.norm());  // forces have a potential
        const Eigen::VectorXd all = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvalues();
        const Eigenpairs found = modes(scene);
        const double largest = all[all.size() - 1];
        EXPECT_TRUE(found.complete);
        EXPECT_NEAR(found.values[found.values.size() - 1], largest, 1e-12 * largest);
        EXPECT_NEAR(found.values[0], all[0], 1e-12 * largest);
        for (const double value : all) {  // each of them at least once
            EXPECT_LT((found.values.array() - value).abs().minCoeff(), 1e-10 * largest);
        }
        for (Eigen::Index i = 0; i < found.values.size(); ++i) {
            const Eigen::VectorXd v = found.vectors.col(i);
            EXPECT_LT((matrix * v - found.values[i] * v).norm(), 1e-10 * largest);
        }
    }
}

TEST(LargestEigenpair, is_that_of_a_dense_solver) {
    for (const auto& scene :
         {linearised("mesh", {{"dim", 6}}), linearised("morse", {{"edge", 2}}), linearised("rope")}) {
        const Eigen::MatrixXd matrix = dense(scene);
        const Eigen::VectorXd all = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvalues();
        const double largest = all[all.size() - 1];
        const auto product = [&](const Eigen::VectorXd& u) { return scene.stiffness(u); };
        for (const double accuracy : {1e-3, 1e-9}) {
            const Eigenpair found = largest_eigenpair(product, Eigen::VectorXd::Zero(scene.size()), accuracy);
            EXPECT_NEAR(found.value, largest, 2 * accuracy * largest);  // the residual bounds the error
            EXPECT_NEAR(found.vector.norm(), 1, 1e-12);
            // without reorthogonalisation the vector is as good as the residual, but for some roundings
            EXPECT_LE((matrix * found.vector - found.value * found.vector).norm(), 2 * accuracy * largest);
        }
    }
}

// 4 is the eigenvalue of three directions.
TEST(LargestEigenpair, of_a_multiple_eigenvalue_is_along_what_is_given) {
    Eigen::VectorXd diagonal(5), along(5), expected(5);
    diagonal << 4, 1, 4, 2, 4;
    along << 1, 5, 2, -3, 0;
    expected << 1, 0, 2, 0, 0;
    const auto matrix = [&](const Eigen::VectorXd& u) { return Eigen::VectorXd(diagonal.cwiseProduct(u)); };
    const Eigenpair found = largest_eigenpair(matrix, along, 1e-12);
    EXPECT_NEAR(found.value, 4, 1e-12);
    EXPECT_GT(std::abs(found.vector.dot(expected.normalized())), 0.999);  // but for a hundredth of anything
    // and where `along` has nothing of them
    EXPECT_NEAR(largest_eigenpair(matrix, Eigen::VectorXd::Unit(5, 1), 1e-12).value, 4, 1e-12);
}

// The partner: one entry of the diagonal is 1 % off.
TEST(LargestEigenpair, of_a_wrong_matrix_is_another) {
    const LinearisedScene scene = linearised("mesh", {{"dim", 6}});
    const auto wrong = [&](const Eigen::VectorXd& u) -> Eigen::VectorXd {
        Eigen::VectorXd out = scene.stiffness(u);
        out[30] += 0.01 * 8 * u[30];
        return out;
    };
    const double largest = std::pow(highest_frequency(modes(scene)), 2);
    EXPECT_GT(std::abs(largest_eigenpair(wrong, Eigen::VectorXd::Zero(scene.size()), 1e-9).value / largest - 1), 1e-5);
}

// Two masses 4 and 1 between walls, all k = 1: (K - omega^2 M) u = 0 with K = [2 -1; -1 2] along the row.
TEST(LinearisedScene, gives_displacements_without_the_weights_of_masses) {
    Scene scene;
    scene.particles = {{.group = "row", .mass = 1, .arrangement = LineArrangement{4, {1, 0, 0}}}};
    scene.fixes = {{.particles = {"row[0]", "row[-1]"}, .fixed = true}, {.particles = {"row[1]"}, .mass = 4}};
    scene.springs = {{.pairs = {{"row[0]", "row[1]"}, {"row[1]", "row[2]"}, {"row[2]", "row[3]"}}, .k = 1}};
    Shape shape;
    shape.roles = {Role::fixed, Role::moving, Role::moving, Role::fixed};
    const LinearisedScene linear(planned(scene), shape);
    const auto product = [&](const Eigen::VectorXd& u) { return linear.stiffness(u); };
    const Eigenpair fastest = largest_eigenpair(product, Eigen::VectorXd::Zero(linear.size()), 1e-12);
    const double value = (10 + std::sqrt(52.0)) / 8;  // of (2 - 4 w)(2 - w) = 1
    EXPECT_NEAR(fastest.value, value, 1e-12);
    const Field<double> u = linear.displacements(fastest.vector);
    EXPECT_NEAR(u.at(1).x / u.at(2).x, 1 / (2 - 4 * value), 1e-9) << "the heavy one moves against the light one";
}

// The Jacobian is that of the forces: differences of them over 2e-6 agree within their own error, about 1e-9.
TEST(Jacobian, is_the_derivative_of_the_forces) {
    for (const char* id : {"chain", "mesh", "rope", "morse", "oscillator"}) {
        const RunDescription run = run_of(id, "rk4", Precision::double_, 0.1);
        const Plan scene = model(id).plan(run.scene);
        const LinearisedScene linear(scene, model(id).shape(run.scene));
        Eigen::VectorXd u(linear.size());
        for (Eigen::Index k = 0; k < u.size(); ++k) u[k] = std::sin(static_cast<double>(k) + 1);
        const auto accelerations = [&](double along) {
            const Field<double> step = linear.field(along * u);
            Field<double> x = scene.start.state().displacement, a(x.count());
            for (std::size_t k = 0; k < x.flat().size(); ++k) x.flat()[k] += step.flat()[k];
            std::visit([&](const auto& forces) { engine<double>(forces).accelerations(x, a); }, scene.forces);
            return linear.vector(a);
        };
        const Eigen::VectorXd slope = (accelerations(1e-6) - accelerations(-1e-6)) / 2e-6;
        EXPECT_LT((slope + linear.stiffness(u)).norm(), 1e-7 * (1 + slope.norm())) << id;
    }
}

// The partner: a Jacobian that is 1 % off in one entry of the diagonal has another largest eigenvalue.
TEST(Lanczos, detects_a_wrong_matrix) {
    const LinearisedScene scene = linearised("mesh", {{"dim", 6}});
    const Eigenpairs wrong = lanczos(
        [&](const Eigen::VectorXd& u) -> Eigen::VectorXd {
            Eigen::VectorXd out = scene.stiffness(u);
            out[30] += 0.01 * 8 * u[30];
            return out;
        },
        scene.size());
    EXPECT_GT(std::abs(highest_frequency(wrong) / highest_frequency(modes(scene)) - 1), 1e-5);
}

// An operator with known eigenvalues 1, 2, ... 1000, too large for a complete iteration.
TEST(Lanczos, of_a_large_matrix_ends_when_the_largest_is_found) {
    const Eigen::Index size = 1000;
    const Eigen::VectorXd diagonal = Eigen::VectorXd::LinSpaced(size, 1, 1000);
    const Eigenpairs found =
        lanczos([&](const Eigen::VectorXd& u) { return Eigen::VectorXd(diagonal.cwiseProduct(u)); }, size);
    EXPECT_NEAR(found.values[found.values.size() - 1], 1000, 1e-6);
    EXPECT_LT(found.residual, 1e-5);
    EXPECT_FALSE(found.complete);
}

}  // namespace
}  // namespace steplab::test
