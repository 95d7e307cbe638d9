// Steps a chain with steplab's methods and with Boost.odeint's, interleaved in one program, and prints the time of a
// step of each: the minimum of several rounds. odeint gets the chain's force in both ways its users write it and is
// measured with the faster one. Usage: benchmark_odeint [particles] [rounds]

#include "chain_force.hpp"
#include "core/flush_subnormals.hpp"
#include "sim/simulation.hpp"

#include <boost/array.hpp>
#include <boost/numeric/odeint.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

namespace steplab::benchmark {

namespace odeint = boost::numeric::odeint;

constexpr double dt = 0.1;

/// Takes so many steps from where it stands.
using Stepping = std::function<void(std::size_t)>;

Stepping ours(std::string_view method, std::size_t particles, Precision precision) {
    RunDescription description = describe("chain", method);
    description.scene.set("n", static_cast<double>(particles));
    description.precision = precision;
    return [simulation = std::make_shared<Simulation>(description)](std::size_t steps) { simulation->advance(steps); };
}

/// A peer whose state is positions and velocities in two vectors.
template <class Stepper, class Force>
Stepping pair_stepping(Force force) {
    return
        [=, stepper = Stepper(), x = force.start_positions(), v = force.start_velocities()](std::size_t steps) mutable {
            using T = typename Stepper::value_type;
            for (std::size_t i = 0; i < steps; ++i) {
                stepper.do_step(force, std::make_pair(std::ref(x), std::ref(v)), T(0), static_cast<T>(dt));
            }
        };
}

/// A peer whose state is one vector, positions first.
template <class Stepper, class Force>
Stepping vector_stepping(Force force, Stepper stepper = Stepper()) {
    auto state = force.start_positions();
    const auto v = force.start_velocities();
    state.insert(state.end(), v.begin(), v.end());
    return [=](std::size_t steps) mutable {
        using T = typename Stepper::value_type;
        for (std::size_t i = 0; i < steps; ++i) stepper.do_step(force, state, T(0), static_cast<T>(dt));
    };
}

template <class T>
using Numbers = std::vector<T>;

template <class T>
using GenericMidpoint = odeint::explicit_generic_rk<2, 2, Numbers<T>, T, Numbers<T>, T>;

template <class T>
GenericMidpoint<T> generic_midpoint() {
    const boost::array<T, 1> a1{{T(0.5)}};
    const boost::array<T, 2> b{{T(0), T(1)}}, c{{T(0), T(0.5)}};
    return GenericMidpoint<T>(boost::fusion::make_vector(a1), b, c);
}

template <class T, class Force>
Stepping peer(std::string_view method, Force force) {
    using Euler = odeint::symplectic_euler<Numbers<T>, Numbers<T>, T>;
    using Verlet = odeint::velocity_verlet<Numbers<T>, Numbers<T>, T, Numbers<T>, T>;
    using Rk4 = odeint::runge_kutta4<Numbers<T>, T, Numbers<T>, T>;
    if (method == "euler") return pair_stepping<Euler>(force);
    if (method == "midpoint") return vector_stepping(force, generic_midpoint<T>());
    if (method == "rk4") return vector_stepping<Rk4>(force);
    Stepping verlet = pair_stepping<Verlet>(force);
    if (method == "verlet") return verlet;
    return [verlet](std::size_t steps) { verlet(10 * steps); };  // stoermer: ten substeps
}

double nanoseconds_per_step(const Stepping& stepping, std::size_t steps) {
    const auto begin = std::chrono::steady_clock::now();
    stepping(steps);
    const std::chrono::duration<double, std::nano> spent = std::chrono::steady_clock::now() - begin;
    return spent.count() / static_cast<double>(steps);
}

struct Comparison {
    std::string_view method, peer_name;
    std::size_t cost;  ///< evaluations a step
};

constexpr Comparison comparisons[] = {{"euler", "symplectic_euler", 1},
                                      {"verlet", "velocity_verlet", 1},
                                      {"midpoint", "explicit_generic_rk<2>", 2},
                                      {"rk4", "runge_kutta4", 4},
                                      {"stoermer", "velocity_verlet x 10", 10}};

template <class T>
void compare(Precision precision, std::size_t particles, std::size_t rounds) {
    for (const auto& [method, name, cost] : comparisons) {
        // short enough that midpoint, which gains energy, stays bounded in every round
        const std::size_t steps = std::max<std::size_t>(1, 100000 / (particles * cost));
        double own = 1e300, plain = 1e300, gather = 1e300;
        for (std::size_t round = 0; round < rounds; ++round) {
            own = std::min(own, nanoseconds_per_step(ours(method, particles, precision), steps));
            plain = std::min(plain, nanoseconds_per_step(peer<T>(method, PlainForce<T>{particles}), steps));
            gather = std::min(gather, nanoseconds_per_step(peer<T>(method, GatherForce<T>{particles}), steps));
        }
        const double theirs = std::min(plain, gather);
        fmt::print("{:<9} {:<6} {:>9.1f} ns  {:<23} plain {:>9.1f} ns  gather {:>9.1f} ns  {:>5.2f} times as fast\n",
                   method, id(precision), own, name, plain, gather, theirs / own);
    }
}

}  // namespace steplab::benchmark

int main(int argc, char** argv) {
    using namespace steplab;
    const std::size_t particles = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 10;
    const std::size_t rounds = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 20;
    const FlushSubnormals flush;  // for the peers too
    fmt::print("chain of {} particles, dt = {}, one step, minimum of {} interleaved rounds\n", particles, benchmark::dt,
               rounds);
    benchmark::compare<double>(Precision::double_, particles, rounds);
    benchmark::compare<float>(Precision::float_, particles, rounds);
}
