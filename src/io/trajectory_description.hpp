#pragma once

#include "io/frame_block.hpp"
#include "sim/run/run_description.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace steplab::trajectory {

/// What a trajectory file says of itself, once, at its beginning.
struct Description {
    std::string program;  ///< that wrote it: "steplab 0.1.0"
    std::string run;      ///< the RunDescription as JSON (parse_run)
    Precision precision = Precision::double_;
    std::size_t rows = 0;                ///< of a frame
    ParticleChoice particles;            ///< which ones of the scene
    std::shared_ptr<const Shape> shape;  ///< the roles of just these, and the box that repeats
};

/// As JSON, for people too. `block`: any one of the trajectory.
std::string description_json(const RunDescription& run, const FrameBlock& block);
/// Throws std::exception of some kind for what is no description, or of more rows than a file of its size can hold.
Description parse_description(std::string_view json, std::uint64_t most_rows);
/// Throws UsageError if a model, method or parameter is not known here, others for what is no run.
RunDescription parse_run(const std::string& json);

}  // namespace steplab::trajectory
