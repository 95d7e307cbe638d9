#pragma once

#include <span>
#include <string>
#include <string_view>

namespace steplab {

/// The formats of trajectories.
enum class TrajectoryFormat {
    csv,         ///< step,time,particle,x,y,z,vx,vy,vz: one line for each particle
    xyz,         ///< extended XYZ, for OVITO, ASE and others
    trajectory,  ///< all digits in compressed chunks with an index; see TrajectoryReader
};

/// The format of this name. Throws UsageError naming the known ones, and others that a command has besides.
TrajectoryFormat trajectory_format(std::string_view name, std::span<const std::string_view> others = {});
/// The format of a file by its extension, ".gz" and ".zst" behind it left out; csv for "-", devices and pipes. Throws
/// UsageError naming the known ones, and others.
TrajectoryFormat trajectory_format_of(const std::string& file, std::span<const std::string_view> others = {});
/// Throws UsageError for a file name that asks to compress what is not text.
void check_compression(TrajectoryFormat format, const std::string& file);

}  // namespace steplab
