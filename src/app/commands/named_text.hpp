#pragma once

#include "app/commands/run_frame.hpp"
#include "io/frame_block.hpp"

#include <string>

namespace steplab {

/// The frames of a text as those of the run whose scene was named, as a trajectory file describes its run and a text
/// does not.
class NamedText {
public:
    /// `file`: its name in messages.
    NamedText(std::string file, const RunDescription& run);

    /// A whole frame of it. Throws UsageError where it cannot be of the run: it has not all particles of the scene in
    /// their order, its time is not that of its step, or it is the start and the scene begins elsewhere.
    const Frame& frame(const FrameBlock& of_text, const FrameParts& wanted);
    /// What trajectory files have no columns for: "type, c_pe"; empty: nothing.
    const std::string& left_out() const { return left_out_; }

private:
    void check_is_whole(const FrameBlock& frame) const;
    void check_start(const FrameBlock& frame) const;
    double time_of(const FrameBlock::Moment& moment) const;

    std::string file_;
    RunDescription run_;
    RunFrame frame_;
    std::string left_out_;
};

}  // namespace steplab
