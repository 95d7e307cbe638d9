#pragma once

#include "stepping.hpp"

#include <vector>

namespace steplab::benchmark {

/// What the machine can do at most: a square root and a division, what every spring needs, for each of some numbers
/// that the first-level cache holds ("machine-springs", in both precisions); y += c x over doubles that one cache after
/// the other, and in the end the memory alone, holds ("machine-memory"). A step is one pass over the numbers.
std::vector<Comparison> machine_comparisons();

}  // namespace steplab::benchmark
