#pragma once

#include "sim/ensemble/live_ensemble.hpp"

#include <cstddef>
#include <span>

namespace steplab {

/// True if a change continues the hold of the one before it.
bool continues(const SegmentBegin& before, const SegmentBegin& change);
/// The first of the changes that are taken back together with the last one; the start is none of them.
std::size_t first_of_last(std::span<const SegmentBegin> changes);

}  // namespace steplab
