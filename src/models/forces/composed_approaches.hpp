#pragma once

#include "core/pair_approach.hpp"
#include "models/forces/composition.hpp"

#include <memory>

namespace steplab {

/// How the pairs of a composition act on each other at all distances. Takes about a tenth of a millisecond for a
/// built-in potential, some for an expression.
Approaches approaches_of(const std::shared_ptr<const Composition>& of);

}  // namespace steplab
