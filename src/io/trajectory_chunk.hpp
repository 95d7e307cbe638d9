#pragma once

#include "io/frame_block.hpp"
#include "io/trajectory_layout.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace steplab::trajectory {

/// Appends a block of frames as a chunk of a file, head and content. The content is compressed by zstd: steps, times,
/// then all x, all y, ... all vz, the frames of each particle next to each other; the lowest bytes of all numbers
/// first, the highest last, so that bytes that hardly differ (signs, exponents) are together and separate from the
/// noise of the last digits. `scratch` is working memory. Throws FileError if zstd fails.
void append_chunk(std::string& bytes, std::string& scratch, const FrameBlock& block, Version version);

/// The most bytes that the content of a chunk has.
std::size_t most_content_bytes();
/// The moments and numbers of such a chunk. None if it does not match the head.
std::optional<FrameBlock> parse_chunk(const BlockHead& head, std::string_view content, Precision precision,
                                      Version version);

}  // namespace steplab::trajectory
