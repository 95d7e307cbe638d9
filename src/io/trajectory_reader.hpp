#pragma once

#include "core/frame.hpp"
#include "io/frame_block.hpp"
#include "io/input_file.hpp"
#include "io/trajectory_description.hpp"
#include "io/trajectory_layout.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace steplab {

/// Reads the frames of a `.trajectory` file in any order, and only the parts of the file that are needed.
///
///     TrajectoryReader reader("chain.trajectory");
///     Frame frame;
///     for (std::uint64_t i = 0; i < reader.frames(); ++i) reader.frame(i, frame);
class TrajectoryReader {
public:
    /// Throws FileError if the file cannot be read or is not a trajectory.
    explicit TrajectoryReader(std::string file);

    /// The run. Throws FileError if this program does not know its model, method or parameters.
    RunDescription run() const;
    /// The program that wrote the file: "steplab 0.1.0".
    const std::string& program() const { return description_.program; }
    Precision precision() const { return description_.precision; }
    /// The particles in the file, by their numbers in the scene, ascending.
    const std::vector<std::size_t>& particles() const { return *description_.particles; }

    /// The number of complete frames.
    std::uint64_t frames() const { return frames_; }
    /// False if the end of the file is missing or damaged: frames() are those before it.
    bool complete() const { return complete_; }
    /// The frame with this number, counted from 0, of particles() alone; its shape has only their roles and the box.
    /// Throws FileError if it is damaged.
    void frame(std::uint64_t number, Frame& out);

private:
    void read_description();
    bool read_index(std::uint64_t place);
    /// Finds the chunks without an index, up to the end of the file or its first damage.
    void search(std::uint64_t place);
    std::optional<std::string> content_of(const trajectory::BlockHead& head, std::uint64_t place) const;
    const FrameBlock& chunk(std::size_t entry, std::uint64_t frame);
    void append_rows(const FrameBlock& block, std::uint64_t frame, Frame& out) const;
    [[noreturn]] void fail(const std::string& what) const;

    InputFile file_;
    trajectory::Description description_;
    std::uint64_t first_chunk_ = 0;
    std::vector<trajectory::IndexEntry> index_;
    std::uint64_t frames_ = 0;
    bool complete_ = true;
    std::optional<FrameBlock> read_;  ///< the last chunk that was read
    std::size_t read_entry_ = 0;
};

}  // namespace steplab
