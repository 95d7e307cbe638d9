#pragma once

#include "io/frame_block.hpp"
#include "io/runs.hpp"
#include "io/trajectory_layout.hpp"
#include "sim/run/run_description.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace steplab::trajectory {

/// The rows of each frame of a file.
struct RowList {
    Runs<std::uint64_t> particles;  ///< their numbers in the scene, ascending by one within a run
    Runs<Role> roles;
    Runs<double> masses;  ///< none: all that of the scene

    /// Fills in the particles, roles and masses of the rows of a block.
    void name(FrameBlock& block) const;
};

RowList row_list(const Frame& frame, const ParticleChoice& chosen);

/// The description at the beginning of a trajectory file.
struct Description {
    std::string program;     ///< that wrote it: "steplab 0.1.0"
    std::string run;         ///< the RunDescription as JSON (parse_run)
    std::uint64_t rows = 0;  ///< of a frame
    RowList list;
    FileScene scene;
};

/// As JSON, readable for people too.
std::string description_json(const RunDescription& run, const FileScene& scene, const RowList& rows);
/// Its memory is proportional to the text. Throws a std::exception for a text that is not a description.
Description parse_description(std::string_view json, Version version);
/// A run as JSON, from which parse_run() gives the same.
std::string run_text(const RunDescription& run);
/// Throws UsageError for an unknown model, method or parameter, another std::exception for a text that is not a run.
RunDescription parse_run(const std::string& json);

}  // namespace steplab::trajectory
