#pragma once

#include "io/frame_block.hpp"
#include "sim/run/run_description.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace steplab::trajectory {

/// The description at the beginning of a trajectory file.
struct Description {
    std::string program;  ///< that wrote it: "steplab 0.1.0"
    std::string run;      ///< the RunDescription as JSON (parse_run)
    Precision precision = Precision::double_;
    std::size_t rows = 0;                ///< of a frame
    ParticleChoice particles;            ///< those of the scene that are in the file
    std::shared_ptr<const Shape> shape;  ///< their roles, and the periodic box
};

/// As JSON, readable for people too. `block`: any block of the trajectory.
std::string description_json(const RunDescription& run, const FrameBlock& block);
/// Throws a std::exception for a text that is not a description, or has more rows than a file of its size can hold.
Description parse_description(std::string_view json, std::uint64_t most_rows);
/// Throws UsageError for an unknown model, method or parameter, another std::exception for a text that is not a run.
RunDescription parse_run(const std::string& json);

}  // namespace steplab::trajectory
