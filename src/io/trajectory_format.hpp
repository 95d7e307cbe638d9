#pragma once

#include <string>
#include <string_view>

namespace steplab {

/// How a trajectory is written.
enum class TrajectoryFormat {
    csv,         ///< step,time,particle,x,y,z,vx,vy,vz: one line for each particle
    xyz,         ///< extended XYZ, as OVITO and ASE read it: type (the role), position, velocity
    trajectory,  ///< all digits in compressed chunks with an index, to be read by TrajectoryReader
};

/// The format of this name. Throws UsageError naming the known ones.
TrajectoryFormat trajectory_format(std::string_view name);
/// The format that the file's ending names; csv for what has none by nature ("-", devices, pipes). Throws UsageError.
TrajectoryFormat trajectory_format_of(const std::string& file);

}  // namespace steplab
