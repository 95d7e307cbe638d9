#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace steplab {

/// The particles in a list that is given to an option, such as "9,0-3", ascending, each once. Throws UsageError for
/// anything else and for numbers that are not below `count`.
std::vector<std::size_t> parse_particles(std::string_view option, std::string_view text, std::size_t count);

}  // namespace steplab
