#include "methods/engines/sweeps.hpp"

#include "methods/engines/system.hpp"
#include "methods/euler.hpp"
#include "methods/pefrl.hpp"
#include "methods/rk4.hpp"
#include "methods/velocity-verlet.hpp"
#include "models/forces/layouts.hpp"
#include "support/all_at_once.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace steplab::test {
namespace {

/// Every particle that can move has a place and a velocity of its own.
template <class T, class Force>
State<T> disturbed(const Force& force, std::size_t count) {
    State<T> state{Field<T>(count), Field<T>(count)};
    for (std::size_t i = 0; i < count; ++i) {
        const double phase = static_cast<double>(i);
        if (!force.moves(i)) continue;
        state.displacement.set(i, {0.1 * std::sin(phase), 0.1 * std::cos(2 * phase), 0.1 * std::sin(3 * phase)});
        state.velocity.set(i, {std::cos(5 * phase), std::sin(7 * phase), std::cos(11 * phase)});
    }
    return state;
}

/// Particles that move along x alone. Some meet their neighbours, pass them, or lie where they are.
template <class T, class Force>
State<T> disturbed_along_x(const Force& force, std::size_t count) {
    State<T> state{Field<T>(count), Field<T>(count)};
    for (std::size_t i = 0; i < count; ++i) {
        if (!force.moves(i)) continue;
        const double phase = static_cast<double>(i), sizes[] = {1, 0.1, 0, 3};
        state.displacement.set(i, {sizes[i % 4] * (i % 8 < 4 ? 1 : -1), 0, 0});
        state.velocity.set(i, {std::cos(5 * phase), 0, 0});
    }
    return state;
}

/// Displacements and velocities after `steps` steps, taken `together` at a time.
template <class Method, class T, class Force>
std::vector<T> after(Force force, const State<T>& start, T drag, bool compensated, std::uint64_t steps,
                     std::uint64_t together, std::size_t axes = 3) {
    System<T, Force> system(force, drag, T(0.05));
    system.axes(axes);
    ParameterValues values(Method::info.parameters);
    values.set("compensated", compensated ? 1 : 0);
    typename Method::template Integrator<T> integrator{values};
    integrator.start(system, start);
    for (std::uint64_t taken = 0; taken < steps; taken += together) integrator.advance(system, together);
    EXPECT_EQ(system.evaluations(), steps * static_cast<std::uint64_t>(Method::info.evaluations));
    State<T> end;
    integrator.synchronised(system, end);
    std::vector<T> numbers(end.displacement.flat().begin(), end.displacement.flat().end());
    numbers.insert(numbers.end(), end.velocity.flat().begin(), end.velocity.flat().end());
    return numbers;
}

template <class Method, class T, class Force>
void expect_same_bits(const Force& force, std::size_t count) {
    const State<T> start = disturbed<T>(force, count);
    for (const T drag : {T(0), T(0.3)}) {
        for (const bool compensated : {false, true}) {
            const std::vector<T> wanted = after<Method, T>(AllAtOnce<Force>{force}, start, drag, compensated, 40, 1);
            EXPECT_TRUE((after<Method, T>(force, start, drag, compensated, 40, 1) == wanted)) << count << " one by one";
            EXPECT_TRUE((after<Method, T>(force, start, drag, compensated, 40, 40) == wanted)) << count << " at once";
            EXPECT_FALSE((after<Method, T>(force, start, drag, compensated, 39, 39) == wanted)) << "the partner";
        }
    }
}

/// Some numbers of particles: in registers, in one block and in many; ends before, at and after the end of a register.
constexpr std::size_t lengths[] = {2, 3, 8, 9, 10, 16, 17, 32, 33, 64, 500, 1601};

template <class Method, class T>
void expect_same_bits_along_x(std::size_t count) {
    const Line<T> line({.count = count, .first_fixed = count % 2 == 0, .k = 2, .rest_length = 1});
    const State<T> start = disturbed_along_x<T>(line, count), sideways = disturbed<T>(line, count);
    for (const T drag : {T(0), T(0.3)}) {
        for (const bool compensated : {false, true}) {
            const auto run = [&](const State<T>& from, std::size_t axes) {
                return after<Method, T>(line, from, drag, compensated, 40, 20, axes);
            };
            EXPECT_TRUE(run(start, 1) == run(start, 3)) << count;
            EXPECT_FALSE(run(sideways, 1) == run(sideways, 3)) << count << ", the partner";
        }
    }
}

template <class T>
class Sweep : public testing::Test {
protected:
    template <class Method>
    static void lines() {
        for (const std::size_t count : lengths) {
            for (const double gravity : {0.0, 1.0}) {
                const LineForces forces{.count = count, .first_fixed = count % 2 == 0, .k = 2, .gravity = gravity};
                expect_same_bits<Method, T>(Line<T>(forces), count);
            }
        }
    }
    template <class Method>
    static void lines_along_x() {
        for (const std::size_t count : lengths) expect_same_bits_along_x<Method, T>(count);
    }
    /// Narrower than a register, narrow and wide.
    template <class Method>
    static void grids() {
        for (const std::size_t dim : {3U, 4U, 7U, 8U, 10U, 17U, 31U, 64U, 70U}) {
            expect_same_bits<Method, T>(Grid<T>({.rows = dim, .columns = dim, .k = 2}), dim * dim);
            expect_same_bits<Method, T>(Grid<T>({.rows = 5, .columns = dim, .k = 2}), 5 * dim);
        }
    }
    /// More than a core's cache holds: several sweeps go one behind the other.
    template <class Method>
    static void large_grid(std::size_t rows, std::size_t columns) {
        expect_same_bits<Method, T>(Grid<T>({.rows = rows, .columns = columns, .k = 2}), rows * columns);
    }
};

using Numbers = testing::Types<float, double>;
TYPED_TEST_SUITE(Sweep, Numbers);

// However many sweeps are under way at a time, and wherever the particles are meanwhile.
TYPED_TEST(Sweep, moves_lines_as_all_accelerations_first_would) {
    this->template lines<Euler>();
    this->template lines<VelocityVerlet>();
    this->template lines<Pefrl>();
    this->template lines<Rk4>();
}

TYPED_TEST(Sweep, moves_lines_along_x_as_along_all_axes) {
    this->template lines_along_x<Euler>();
    this->template lines_along_x<Pefrl>();
    this->template lines_along_x<Rk4>();
}

// A method that works on accelerations must not find numbers of before along y and z, least of all some that are none.
TYPED_TEST(Sweep, along_x_leaves_no_component_as_it_was) {
    const std::size_t count = 33;
    const Line<TypeParam> line({.count = count, .first_fixed = true, .k = 2, .rest_length = 1});
    System<TypeParam, Line<TypeParam>> system(line, 0, 1);
    const Field<TypeParam> x = disturbed_along_x<TypeParam>(line, count).displacement;
    Field<TypeParam> all(count), along(count);
    system.accelerations(x, all);
    for (std::size_t i = 0; i < count; ++i) along.set(i, {7, 8, 9});
    system.axes(1);
    system.accelerations(x, along);
    for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(along.at(i), all.at(i)) << i;
}

TYPED_TEST(Sweep, moves_grids_as_all_accelerations_first_would) {
    this->template grids<Euler>();
    this->template grids<VelocityVerlet>();
    this->template grids<Pefrl>();
    this->template grids<Rk4>();
    this->template large_grid<VelocityVerlet>(6, 8000);
    this->template large_grid<Rk4>(6, 3000);
    this->template large_grid<Rk4>(260, 70);
}

}  // namespace
}  // namespace steplab::test
