#include "method_types.hpp"
#include "methods/engines/system.hpp"
#include "models/forces/line.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <tuple>

namespace steplab::test {
namespace {

/// A nonlinear scene in which everything moves: a soft rope of six particles falling from the level.
constexpr LineForces rope{.count = 6, .first_fixed = true, .mass = 1, .k = 20, .rest_length = 0.5, .gravity = 9.81};

/// Where a method takes the rope in one second, in long double, whose rounding lies far below the errors of order 8.
template <class Method>
Field<long double> end(std::uint64_t steps, long double drag) {
    System<long double, Line<long double>> system(Line<long double>(rope), drag, 1 / static_cast<long double>(steps));
    State<long double> state{Field<long double>(rope.count), Field<long double>(rope.count)};
    typename Method::template Integrator<long double> integrator{ParameterValues(Method::info.parameters)};
    integrator.start(system, state);
    for (std::uint64_t i = 0; i < steps; ++i) integrator.step(system);
    integrator.synchronised(system, state);
    return state.displacement;
}

/// Its error is some 1e-17: below a thousandth of every error it is compared with.
const Field<long double>& reference(long double drag) {
    static const Field<long double> without = end<KahanLi8>(1024, 0), with = end<KahanLi8>(1024, 0.3);
    return drag == 0 ? without : with;
}

template <class Method>
double error_in_long_double(std::uint64_t steps, double drag) {
    const Field<long double> reached = end<Method>(steps, drag), &right = reference(drag);
    long double largest = 0;
    for (std::size_t k = 0; k < right.flat().size(); ++k)
        largest = std::max(largest, std::abs(reached.flat()[k] - right.flat()[k]));
    return static_cast<double>(largest);
}

/// The same rope as a run of the catalogue.
RunDescription falling_rope(const MethodCase& c, double dt, double drag) {
    RunDescription description = run_of("rope", c.id(), c.precision, dt, {{"n", 6}, {"k", 20}, {"m", 1}, {"c", drag}});
    if (description.method_parameters.contains("substeps")) description.method_parameters.set("substeps", 2);
    return description;
}

Frame after_a_second(const MethodCase& c, std::uint64_t steps, double drag) {
    return frame_after(falling_rope(c, 1 / static_cast<double>(steps), drag), steps);
}

/// Where the rope is after one second in double, right to some 1e-14.
const Frame& right_end(double drag) {
    static const MethodCase best{&method("kahan-li-8").info, Precision::double_};
    static const Frame without = after_a_second(best, 512, 0), with = after_a_second(best, 512, 0.3);
    return drag == 0 ? without : with;
}

/// The order that halving dt shows: the slope of log error against log dt.
template <class Error>
double slope(Error error, double drag, std::uint64_t steps) {
    return std::log2(error(steps, drag) / error(2 * steps, drag));
}

/// Steps so fine that the next order's term is below a tenth of the error, coarse enough to stand above rounding.
std::uint64_t fine_steps(int order) { return order <= 2 ? 1024 : order <= 4 ? 128 : 32; }

template <class Error>
void expect_declared_order(const MethodInfo& info, Error error) {
    EXPECT_NEAR(slope(error, 0, fine_steps(info.order)), info.order, 0.1) << info.id;
    EXPECT_NEAR(slope(error, 0.3, fine_steps(info.order_with_drag)), info.order_with_drag, 0.1)
        << info.id << " with drag";
}

// Errors of 1e-4 to 1e-9, far above the rounding of double.
TEST(Order, up_to_4_is_the_declared_one_on_both_sides) {
    const auto of_low_order = [](const MethodCase& c) {
        return has_fixed_steps(c) && c.info->order <= 4 && c.precision == Precision::double_;
    };
    for (const MethodCase& subject : working_methods_where(of_low_order)) {
        expect_declared_order(*subject.info, [&](std::uint64_t steps, double drag) {
            return distance(after_a_second(subject, steps, drag), right_end(drag));
        });
    }
}

/// Whether it is such a method.
template <class Method>
bool expect_declared_order_above_4() {
    constexpr const MethodInfo& info = Method::info;
    constexpr bool concerned = !info.adaptive && info.order > 4 && info.order <= 8;
    if constexpr (concerned) expect_declared_order(info, error_in_long_double<Method>);
    return concerned;
}

template <class... Methods>
void expect_declared_orders_above_4(std::tuple<Methods...>*) {
    EXPECT_GT((int{expect_declared_order_above_4<Methods>()} + ...), 0);
}

// In long double, as errors go down to 1e-14. Orders above 8 have tests of their own.
TEST(Order, above_4_is_the_declared_one_on_both_sides) {
    expect_declared_orders_above_4(static_cast<MethodTypes*>(nullptr));
}

/// Largest violation of the order conditions of a splitting method as the Nystrom method with nodes c_i, weights b_i
/// and a_ij = b_j (c_i - c_j) that it is: of sum b_i c_i^m = 1 / (m + 1), up to the order, and of sum b_i c_i^m a_ij
/// c_j^n = 1 / ((n + 1) (n + 2) (m + n + 3)) (Hairer, Norsett, Wanner I, II.14).
template <std::size_t N>
double violation(const std::array<KickAndDrift, N>& table, int order) {
    long double worst = 0;
    for (int m = 0; m < order; ++m) {
        for (int n = -1; m + n + 3 <= order || n < 0; ++n) {
            long double sum = 0, c_i = 0;
            for (std::size_t i = 0; i < N; c_i += table[i++].drift) {
                long double inner = n < 0 ? 1 : 0, c_j = 0;
                for (std::size_t j = 0; n >= 0 && j < i; c_j += table[j++].drift)
                    inner += table[j].kick * (c_i - c_j) * std::pow(c_j, n);
                sum += table[i].kick * std::pow(c_i, m) * inner;
            }
            const long double right = n < 0 ? m + 1 : (n + 1) * (n + 2) * (m + n + 3);
            worst = std::max(worst, std::abs(sum - 1 / right));
        }
    }
    return static_cast<double>(worst);
}

/// Whether it is a method of such a table.
template <class Method>
bool expect_order_conditions() {
    constexpr bool splits = requires { Method::table.front().drift; };
    if constexpr (splits) {
        EXPECT_LT(violation(Method::table, Method::info.order), 1e-14) << Method::info.id;
        auto wrong = Method::table;
        wrong[0].kick += 1e-12L;
        EXPECT_GT(violation(wrong, Method::info.order), 1e-14) << Method::info.id;  // the partner
        EXPECT_GT(violation(Method::table, Method::info.order + 1), 1e-6) << Method::info.id;
    }
    return splits;
}

template <class... Methods>
void expect_order_conditions_of_all(std::tuple<Methods...>*) {
    EXPECT_GT((int{expect_order_conditions<Methods>()} + ...), 0);
}

// The tables print 15 digits and more.
TEST(SplittingTables, hold_their_order_conditions) {
    expect_order_conditions_of_all(static_cast<MethodTypes*>(nullptr));
}

// The partners that must fail: a scene a little off has an error that halving dt does not reduce; drag taken out of the
// kicks leaves order 1.
TEST(Order, of_a_wrong_scene_is_not_the_declared_one) {
    const auto error = [](std::uint64_t steps, double drag) {
        RunDescription wrong =
            falling_rope({&method("rk4").info, Precision::double_}, 1 / static_cast<double>(steps), drag);
        wrong.scene.set("k", 20.0001);
        return distance(frame_after(wrong, steps), right_end(drag));
    };
    EXPECT_LT(slope(error, 0, 256), 0.1);
}

struct VerletWithExplicitDrag : VelocityVerlet {
    static constexpr bool explicit_drag = true;
    template <class T>
    using Integrator = Splitting<T, VerletWithExplicitDrag>;
};

TEST(Order, of_velocity_verlet_with_explicit_drag_is_1) {
    EXPECT_NEAR(slope(error_in_long_double<VerletWithExplicitDrag>, 0.3, 1024), 1, 0.1);
    EXPECT_NEAR(slope(error_in_long_double<VerletWithExplicitDrag>, 0, 1024), 2, 0.1);
}

/// In float; the same method in double is what it is compared with.
class OrderInFloat : public testing::TestWithParam<MethodCase> {};

// Float has a slope where its rounding, some 1e-5 here (accelerations of 10 and positions of 3 over 256 steps), stays
// far below the error; elsewhere it must be equal to double within that rounding.
TEST_P(OrderInFloat, is_that_of_double_within_rounding) {
    const MethodCase in_float = GetParam(), in_double{in_float.info, Precision::double_};
    constexpr double rounding = 3e-5;
    for (const std::uint64_t steps : {64u, 128u, 256u}) {
        EXPECT_LT(distance(after_a_second(in_float, steps, 0.3), after_a_second(in_double, steps, 0.3)), rounding)
            << steps;
    }
    const Frame& right = right_end(0.3);
    if (distance(after_a_second(in_double, 256, 0.3), right) > 50 * rounding) {
        EXPECT_NEAR(std::log2(distance(after_a_second(in_float, 128, 0.3), right) /
                              distance(after_a_second(in_float, 256, 0.3), right)),
                    GetParam().info->order, 0.15);
    }
}

INSTANTIATE_TEST_SUITE_P(Catalogue, OrderInFloat, testing::ValuesIn(working_methods_where([](const MethodCase& c) {
                             return c.precision == Precision::float_;
                         })),
                         case_name);

}  // namespace
}  // namespace steplab::test
