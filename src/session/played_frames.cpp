#include "session/played_frames.hpp"

#include "core/error.hpp"
#include "io/indexed_text.hpp"
#include "io/springs_beside.hpp"
#include "io/trajectory_reader.hpp"

#include <utility>
#include <vector>

namespace steplab {

namespace {

class TrajectoryFrames final : public PlayedFrames {
public:
    explicit TrajectoryFrames(TrajectoryReader reader) : reader_(std::move(reader)) {}

    std::uint64_t frames() const override { return reader_.frames(); }
    std::uint64_t rows() const override { return reader_.rows(); }
    FrameBlock::Moment moment(std::uint64_t number) override { return reader_.moment(number); }
    void frame(std::uint64_t number, Frame& out) override { reader_.frame(number, out); }
    std::string fault() const override {
        return reader_.complete() ? "" : "the file is truncated or damaged after these";
    }
    std::optional<RunDescription> run() const override { return reader_.run(); }

private:
    TrajectoryReader reader_;
};

/// CSV, XYZ or a dump.
class PlayedText final : public PlayedFrames {
public:
    explicit PlayedText(const std::string& file) : frames_(file) {
        Frame first;
        frames_.frame(0, first);
        springs_ = springs_beside(file, frames_.particles(0), first.positions);
    }

    std::uint64_t frames() const override { return frames_.frames(); }
    std::uint64_t rows() const override { return frames_.rows(); }
    FrameBlock::Moment moment(std::uint64_t number) override { return frames_.moment(number); }
    void frame(std::uint64_t number, Frame& out) override {
        frames_.frame(number, out);
        if (springs_.empty()) return;
        Shape shape = *out.shape;
        shape.springs = springs_;
        out.shape = std::make_shared<const Shape>(std::move(shape));
    }
    bool has_velocities() const override { return frames_.has_velocities(); }
    std::string units() const override { return frames_.units(); }
    std::string fault() const override { return frames_.fault(); }
    bool can_grow() const override { return true; }
    bool has_more() const override { return frames_.has_more(); }
    double looked_through() const override { return frames_.looked_through(); }
    /// As much as takes some hundredths of a second.
    bool look_on() override { return frames_.look_on(std::uint64_t{16} << 20); }

private:
    IndexedText frames_;
    std::vector<Spring> springs_;
};

}  // namespace

std::unique_ptr<PlayedFrames> played_frames(const std::string& file) {
    InputFile input(file);
    if (TrajectoryReader::reads(input)) return std::make_unique<TrajectoryFrames>(TrajectoryReader(std::move(input)));
    return std::make_unique<PlayedText>(file);
}

}  // namespace steplab
