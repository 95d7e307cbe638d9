#pragma once

#include "io/frame_block.hpp"
#include "io/trajectory_layout.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace steplab::trajectory {

/// Appends a block of frames as a chunk of a file, head and content. The content is compressed by zstd: steps, times,
/// then all x, all y, ... all vz, each particle's moments side by side; of all numbers the lowest bytes first, the
/// highest last, so that those that hardly differ (signs, exponents) stand together and the noise of the last digits
/// apart. `scratch` is memory to work in.
void append_chunk(std::string& bytes, std::string& scratch, const FrameBlock& block);

/// The content of such a chunk. None if it is not what the head says.
std::optional<FrameBlock> parse_chunk(const BlockHead& head, std::string_view content, Precision precision);

}  // namespace steplab::trajectory
