#pragma once

#include "sim/run/run_description.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace steplab {

/// The angular frequencies of the normal modes of a scene, ascending [rad/s]: of small vibrations about its rest
/// positions (Shape::rest), without drag; what does not vibrate is left out. The first is that of the normal mode 1 of
/// a scene file. None of a scene of more than `most` particles. Throws UsageError where the scene cannot be stepped.
std::optional<std::vector<double>> mode_frequencies(const RunDescription& description, std::size_t most);

}  // namespace steplab
