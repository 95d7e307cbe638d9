#pragma once

#include "core/frame.hpp"
#include "io/frame_block.hpp"
#include "sim/run/run_description.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace steplab {

/// The frames of a file that is played back, in any order.
class PlayedFrames {
public:
    virtual ~PlayedFrames() = default;
    virtual std::uint64_t frames() const = 0;
    /// Particles of a frame.
    virtual std::uint64_t rows() const = 0;
    /// Throw FileError if the frame is damaged. Velocities are 0 where none are known.
    virtual FrameBlock::Moment moment(std::uint64_t number) = 0;
    virtual void frame(std::uint64_t number, Frame& out) = 0;
    virtual bool has_velocities() const { return true; }
    /// Those of its numbers, by LAMMPS' name of them; empty: not said.
    virtual std::string units() const { return ""; }
    /// Why there are no more; empty if the file is whole.
    virtual std::string fault() const = 0;
    /// The run that wrote it; none of a file that does not describe its run. Throws FileError.
    virtual std::optional<RunDescription> run() const { return std::nullopt; }

    /// True if frames may come yet: it is still being looked through, or written.
    virtual bool can_grow() const { return false; }
    /// True if there is more to be looked through at once, and the part of the file that was.
    virtual bool has_more() const { return false; }
    virtual double looked_through() const { return 1; }
    /// Looks through some megabytes more. True if there are other frames or another fault now.
    virtual bool look_on() { return false; }
};

/// Of a trajectory, CSV or XYZ file, or a LAMMPS dump. Of a text, bonds come from a LAMMPS data file of the same name
/// with the ending `.data`, if there is one. Throws FileError, Interrupted.
std::unique_ptr<PlayedFrames> played_frames(const std::string& file);

}  // namespace steplab
