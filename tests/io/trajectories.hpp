#pragma once

#include "io/files.hpp"
#include "io/trajectory.hpp"
#include "io/trajectory_reader.hpp"
#include "sim/run/simulation.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace steplab {

/// What a writer makes of what `add(writer)` gives it.
template <class Add>
std::string written_by(const RunDescription& run, TrajectoryFormat format, const RowOptions& rows, const Add& add) {
    const TemporaryFolder folder;
    OutputFile file(folder.file("a"));
    TrajectoryWriter writer(file, format, run, rows);
    add(writer);
    writer.finish();
    file.commit();
    return text_of(folder.file("a"));
}

inline std::string written(const RunDescription& run, const std::vector<Frame>& frames, TrajectoryFormat format,
                           const RowOptions& rows = {}) {
    return written_by(run, format, rows, [&](TrajectoryWriter& writer) {
        for (const Frame& frame : frames) writer.add(frame);
    });
}

/// The same from a file, as `convert` does it.
inline std::string converted(TrajectoryReader& reader, TrajectoryFormat format, const Columns& columns = {}) {
    return written_by({}, format, {.columns = columns}, [&](TrajectoryWriter& writer) {
        writer.describe(reader.version(), reader.description());
        reader.each_block([&](FrameBlock block) { writer.add(std::move(block)); });
    });
}

inline std::vector<Frame> frames_of(const RunDescription& run, std::size_t count) {
    Simulation simulation(run);
    std::vector<Frame> frames(count);
    for (Frame& frame : frames) {
        simulation.frame(frame, {.displacements = true});
        simulation.advance(2);
    }
    return frames;
}

/// A trajectory in a file of its own.
class Kept {
public:
    explicit Kept(std::string_view bytes) { put_text(name(), bytes); }
    std::string name() const { return folder_.file("a.trajectory"); }

private:
    TemporaryFolder folder_;
};

inline std::vector<Frame> read_all(TrajectoryReader& reader) {
    std::vector<Frame> frames(reader.frames());
    for (std::size_t i = 0; i < frames.size(); ++i) reader.frame(i, frames[i]);
    return frames;
}

inline std::vector<std::uint64_t> bits_of(const Frame& frame) {
    std::vector<std::uint64_t> bits{frame.step, std::bit_cast<std::uint64_t>(frame.time)};
    for (const auto* vectors : {&frame.positions, &frame.displacements, &frame.velocities}) {
        for (const Vec3& v : *vectors) {
            for (const double value : {v.x, v.y, v.z}) bits.push_back(std::bit_cast<std::uint64_t>(value));
        }
    }
    return bits;
}

inline bool same_frames(const std::vector<Frame>& a, const std::vector<Frame>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Frame& left, const Frame& right) {
        return bits_of(left) == bits_of(right) && left.precision == right.precision;
    });
}

}  // namespace steplab
