#include "method_types.hpp"
#include "methods/system.hpp"
#include "models/line.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>
#include <utility>

namespace steplab::test {
namespace {

/// A nonlinear scene in which everything moves: a soft rope of six particles falling from the level.
constexpr LineForces rope{.count = 6, .first_fixed = true, .mass = 1, .k = 20, .rest_length = 0.5, .gravity = 9.81};

/// Where a method takes the rope in one second, in long double, whose rounding lies far below the errors of order 8.
template <class Method>
Field<long double> end(std::uint64_t steps, long double drag, const LineForces& forces = rope) {
    System<long double, Line<long double>> system(Line<long double>(forces), drag, 1 / static_cast<long double>(steps));
    State<long double> state{Field<long double>(forces.count), Field<long double>(forces.count)};
    typename Method::template Integrator<long double> integrator{ParameterValues(Method::info.parameters)};
    integrator.start(system, state);
    for (std::uint64_t i = 0; i < steps; ++i) integrator.step(system);
    integrator.synchronised(system, state);
    return state.displacement;
}

double separation(const Field<long double>& a, const Field<long double>& b) {
    long double largest = 0;
    for (std::size_t k = 0; k < a.flat().size(); ++k) largest = std::max(largest, std::abs(a.flat()[k] - b.flat()[k]));
    return static_cast<double>(largest);
}

/// Its error is some 1e-17: below a thousandth of every error it is compared with.
const Field<long double>& reference(long double drag) {
    static const Field<long double> without = end<KahanLi8>(1024, 0), with = end<KahanLi8>(1024, 0.3L);
    return drag == 0 ? without : with;
}

/// The order that halving dt shows: the slope of log error against log dt.
template <class Method>
double slope(long double drag, std::uint64_t steps, const LineForces& forces = rope) {
    return std::log2(separation(end<Method>(steps, drag, forces), reference(drag)) /
                     separation(end<Method>(2 * steps, drag, forces), reference(drag)));
}

/// Steps so fine that the next order's term is below a tenth of the error, coarse enough to stand above rounding.
std::uint64_t fine_steps(int order) { return order <= 2 ? 1024 : order <= 4 ? 128 : 32; }

template <class Method>
void expect_declared_order() {
    const MethodInfo& info = Method::info;
    if (info.adaptive || info.curiosity || info.order > 8) return;  // order 16 has tests of its own
    SCOPED_TRACE(info.id);
    EXPECT_NEAR(slope<Method>(0, fine_steps(info.order)), info.order, 0.1);
    EXPECT_NEAR(slope<Method>(0.3L, fine_steps(info.order_with_drag)), info.order_with_drag, 0.1) << "with drag";
}

template <class... Methods>
void expect_declared_orders(std::tuple<Methods...>*) {
    (expect_declared_order<Methods>(), ...);
}

TEST(Order, is_the_declared_one_on_both_sides) { expect_declared_orders(static_cast<MethodTypes*>(nullptr)); }

// The partners that must fail: a scene a little off has an error that halving dt does not reduce; drag taken out of the
// kicks leaves order 1.
TEST(Order, of_a_wrong_scene_is_not_the_declared_one) {
    LineForces wrong = rope;
    wrong.k = 20.0001;
    EXPECT_LT(slope<Rk4>(0, 256, wrong), 0.1);
}

struct VerletWithExplicitDrag : VelocityVerlet {
    static constexpr bool explicit_drag = true;
    template <class T>
    using Integrator = Splitting<T, VerletWithExplicitDrag>;
};

TEST(Order, of_a_splitting_with_explicit_drag_is_not_the_declared_one) {
    EXPECT_NEAR(slope<VelocityVerlet>(0.3L, 1024), 2, 0.1);
    EXPECT_LT(slope<VerletWithExplicitDrag>(0.3L, 1024), 1.5);
}

/// The same rope as a run of the catalogue.
RunDescription falling_rope(const MethodCase& c, double dt, double drag) {
    RunDescription description = run_of("rope", c.id(), c.precision, dt, {{"n", 6}, {"k", 20}, {"m", 1}, {"c", drag}});
    if (description.method_parameters.contains("substeps")) description.method_parameters.set("substeps", 2);
    return description;
}

class OrderInFloat : public testing::TestWithParam<MethodCase> {};

// Float has a slope where its rounding, some 1e-5 here (accelerations of 10 and positions of 3 over 256 steps), stays
// far below the error; elsewhere it must be equal to double within that rounding.
TEST_P(OrderInFloat, is_that_of_double_within_rounding) {
    MethodCase in_float = GetParam(), in_double = GetParam();
    in_float.precision = Precision::float_;
    in_double.precision = Precision::double_;
    constexpr double rounding = 3e-5;
    const auto run = [](const MethodCase& c, std::uint64_t steps) {
        return frame_after(falling_rope(c, 1 / static_cast<double>(steps), 0.3), steps);
    };
    for (const std::uint64_t steps : {64u, 128u, 256u}) {
        EXPECT_LT(distance(run(in_float, steps), run(in_double, steps)), rounding) << steps;
    }
    const Frame right = run({&method("kahan-li-8").info, Precision::double_}, 512);
    if (distance(run(in_double, 256), right) > 50 * rounding) {
        EXPECT_NEAR(std::log2(distance(run(in_float, 128), right) / distance(run(in_float, 256), right)),
                    GetParam().info->order, 0.15);
    }
}

INSTANTIATE_TEST_SUITE_P(Catalogue, OrderInFloat, testing::ValuesIn(working_methods()), case_name);

}  // namespace
}  // namespace steplab::test
