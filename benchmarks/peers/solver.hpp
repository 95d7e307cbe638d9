#pragma once

#include "core/vec3.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace steplab::benchmark {

/// A start and a time: what every solver is given.
struct Problem {
    std::string_view scene;  ///< of a contest: which force
    double time = 0;
    std::vector<Vec3> positions, velocities;  ///< of what moves
    std::vector<double> strengths;            ///< G m of each, where planets pull
    std::size_t most_steps = 10000000;        ///< after which methods that choose their steps give up
};

/// One method of one library on one problem. `solve` goes from the start to the problem's time with a tolerance or a
/// number of steps, and returns the positions at the end; it throws if the library gives up.
struct Solver {
    std::string name;
    bool adaptive = true;  ///< its setting is a tolerance, else a number of steps
    std::function<std::vector<Vec3>(double setting)> solve;
};

/// Boost.odeint, GSL and SUNDIALS with the plain force, and with the gather force compiled with -fno-math-errno.
std::vector<Solver> plain_solvers(const Problem& problem);
std::vector<Solver> gather_solvers(const Problem& problem);

}  // namespace steplab::benchmark
