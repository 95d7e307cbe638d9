#pragma once

#include "core/vec3.hpp"

#include <memory>
#include <string>
#include <vector>

namespace steplab {

/// Positions and velocities of all particles of a scene at one time, as a file holds them.
struct StartingValues {
    std::string given;  ///< what names them on a command line: FILE or FILE:STEP; no part of the content
    std::vector<Vec3> positions, velocities;
    /// From the reference positions of the run that wrote them, with all digits it had; empty if they are not known.
    std::vector<Vec3> displacements = {};

    friend bool operator==(const StartingValues& a, const StartingValues& b) {
        return a.positions == b.positions && a.velocities == b.velocities && a.displacements == b.displacements;
    }
};

/// What a run starts from in place of the start of its scene, by content. The parts apply in this order.
struct StartChange {
    std::shared_ptr<const StartingValues> from = nullptr;  ///< null: the scene's own start
    bool reverse = false;                                  ///< all velocities are turned round

    bool is_none() const { return !from && !reverse; }
    friend bool operator==(const StartChange& a, const StartChange& b) {
        const bool same = a.from == b.from || (a.from && b.from && *a.from == *b.from);
        return same && a.reverse == b.reverse;
    }
};

}  // namespace steplab
