#include "methods/sweeps.hpp"

#include "methods/euler.hpp"
#include "methods/pefrl.hpp"
#include "methods/rk4.hpp"
#include "methods/system.hpp"
#include "methods/velocity-verlet.hpp"
#include "models/layouts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace steplab::test {
namespace {

/// A layout that does not sweep: all accelerations first, then all moves.
template <class Force>
struct AllAtOnce {
    Force force;

    template <class T>
    void accelerations(const Field<T>& x, Field<T>& a) {
        force.accelerations(x, a);
    }
};

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

/// Displacements and velocities after `steps` steps, taken `together` at a time.
template <class Method, class T, class Force>
std::vector<T> after(Force force, const State<T>& start, T drag, bool compensated, std::uint64_t steps,
                     std::uint64_t together) {
    System<T, Force> system(force, drag, T(0.05));
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

template <class T>
class Sweep : public testing::Test {
protected:
    /// In registers, in one block and in many; ends before, at and after the end of a register.
    template <class Method>
    static void lines() {
        for (const std::size_t count : {2U, 3U, 8U, 9U, 10U, 16U, 17U, 32U, 33U, 64U, 500U, 1601U}) {
            for (const double gravity : {0.0, 1.0}) {
                const LineForces forces{.count = count, .first_fixed = count % 2 == 0, .k = 2, .gravity = gravity};
                expect_same_bits<Method, T>(Line<T>(forces), count);
            }
        }
    }
    /// Narrower than a register, narrow and wide.
    template <class Method>
    static void grids() {
        for (const std::size_t dim : {3U, 4U, 7U, 8U, 10U, 17U, 31U, 64U, 70U}) {
            expect_same_bits<Method, T>(Grid<T>({.rows = dim, .columns = dim, .k = 2}), dim * dim);
            expect_same_bits<Method, T>(Grid<T>({.rows = 5, .columns = dim, .k = 2}), 5 * dim);
        }
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

TYPED_TEST(Sweep, moves_grids_as_all_accelerations_first_would) {
    this->template grids<Euler>();
    this->template grids<VelocityVerlet>();
    this->template grids<Pefrl>();
    this->template grids<Rk4>();
}

}  // namespace
}  // namespace steplab::test
