#pragma once

#include "core/frame.hpp"

#include <cstddef>
#include <span>
#include <string>

namespace steplab::render {

/// A run in a picture that shows several runs of one scene.
struct ShownRun {
    const Frame* frame = nullptr;  ///< at the same time as those of the others; not null
    std::string name = {};         ///< "rk4, dt 0.1 s, double"
    std::size_t swatch = 0;        ///< its colour and outline, below most_shown_runs
};

/// The runs in a picture, one at least, the leading one first. They have the same particles.
using ShownRuns = std::span<const ShownRun>;

inline constexpr std::size_t most_shown_runs = 4;

}  // namespace steplab::render
