#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace steplab {

/// Which particles act on which: what a method that solves linear systems needs to know about a scene before it runs.
struct Coupling {
    enum class Kind {
        none,   ///< no particle acts on another
        chain,  ///< each on the next
        sheet,  ///< each on its neighbours in a sheet
        near,   ///< each on those near it in space
        all,    ///< each on all others
    };

    /// Scenes of at most this many particles are small enough for the steps of methods to end where a pair crosses a
    /// cut-off.
    static constexpr std::size_t most_held = 50;

    Kind kind = Kind::none;
    std::size_t particles = 0;
    bool smooth = true;  ///< false where a potential has min, max or abs, which have seams
    bool cut = false;    ///< some act on each other within a cut-off alone
};

/// How many pairs act on each other.
struct Interactions {
    double pairs = 0;
    /// Each of them, where they are the same at all times and no sheet; else empty.
    std::span<const std::array<std::uint32_t, 2>> bonds = {};
};

}  // namespace steplab
