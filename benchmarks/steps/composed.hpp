#pragma once

#include "sim/run/run_description.hpp"
#include "stepping.hpp"

#include <functional>
#include <string>
#include <vector>

namespace steplab::benchmark {

/// Steps of scenes from files that no model is: a network of 10^5 particles, each on springs to its 6 nearest, numbered
/// in any order (the peers' in that in which steplab steps them); a Lennard-Jones liquid of 32 000 up to a cut-off of
/// 2.5, with the potential built in and as an expression; gravity between 1000 bodies. Each by one thread, and the
/// first two by two; `ourselves` is steplab by so many threads. Only what is `wanted` is made, by names
/// row/method/precision.
std::vector<Comparison> composed_comparisons(
    const std::function<Contestant(const RunDescription&, std::size_t threads)>& ourselves,
    const std::function<bool(const std::string& name)>& wanted);

}  // namespace steplab::benchmark
