#pragma once

#include "core/frame.hpp"
#include "io/ordered_writer.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace steplab {

enum class TrajectoryFormat {
    csv,  ///< step,time,particle,x,y,z,vx,vy,vz: one line for each particle
    xyz,  ///< extended XYZ, as OVITO and ASE read it: type (the role), position, velocity
};

/// The format of this name. Throws UsageError naming the known ones.
TrajectoryFormat trajectory_format(std::string_view name);
/// The format that the file's ending names; csv for what has none by nature ("-", devices, pipes). Throws UsageError.
TrajectoryFormat trajectory_format_of(const std::string& file);

/// Writes the frames of a run as text, as fast as a disk takes it.
class TrajectoryWriter {
public:
    /// `particles`: which ones, ascending; empty means all. `file` must outlive the writer.
    TrajectoryWriter(OutputFile& file, TrajectoryFormat format, std::vector<std::size_t> particles);
    ~TrajectoryWriter();

    /// Frames of one run, in their order. The frame is copied.
    void add(const Frame& frame);
    /// Everything added so far goes to the file. The file itself is not committed.
    void flush();

private:
    struct Block;
    void submit();

    OrderedWriter writer_;
    TrajectoryFormat format_;
    std::vector<std::size_t> particles_;
    std::shared_ptr<Block> block_;  // std::function wants what it holds to be copyable
};

}  // namespace steplab
