#pragma once

#include "core/vec3.hpp"
#include "io/dump_trajectory.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace steplab {

/// One moment of a run of LAMMPS.
struct LammpsMoment {
    std::uint64_t step = 0;
    std::vector<Vec3> positions, velocities;
    std::vector<Vec3> forces;  ///< empty unless the dump has them
};

/// Reads the dump that an exported input script has LAMMPS write (export_to_lammps()), moment after moment.
class LammpsDump {
public:
    /// Of so many particles. Throws FileError if there is no such file.
    LammpsDump(const std::string& file, std::size_t particles);

    /// Reads the next moment; false at the end. Throws FileError for one that is no dump of such a script, or not
    /// whole.
    bool next(LammpsMoment& moment);

private:
    DumpTrajectory dump_;
    std::size_t particles_;
};

}  // namespace steplab
