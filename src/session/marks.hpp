#pragma once

#include "session/session_view.hpp"

#include <vector>

namespace steplab {

/// Adds a mark in the order of steps; where there is one of the same step, takes that away instead.
void toggle_mark(std::vector<Mark>& marks, Mark mark);

}  // namespace steplab
