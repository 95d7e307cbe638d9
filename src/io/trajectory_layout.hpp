#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// How the bytes of a `.trajectory` file lie (docs/trajectory-format.md): a signature, then blocks, each of a head and
/// its content: one description, chunks of frames, one index; at last where the index stands. Whole numbers have their
/// lowest byte first.
namespace steplab::trajectory {

/// Of the file; not text, so that what is changed as text is (line ends) shows at once. The last 4 bytes are the
/// version of the format.
inline constexpr std::string_view signature{"\x89steplab\r\n\x1a\n\x01\0\0\0", 16};
inline constexpr std::size_t signature_without_version = 12;

/// Rows (frames times particles) of a chunk at most; what claims more is refused before memory is taken.
inline constexpr std::uint64_t most_rows = 16384;

enum class BlockKind : std::uint8_t { description, frames, index };

/// What stands before the content of each block.
struct BlockHead {
    static constexpr std::size_t bytes = 56;

    BlockKind kind = BlockKind::frames;
    std::uint32_t frames = 0;         ///< of which rows are in a chunk
    std::uint64_t first_frame = 0;    ///< counted from 0; in the index the number of all frames
    std::uint64_t first_row = 0;      ///< 0 unless the chunk is a piece of one frame
    std::uint64_t rows = 0;           ///< of each frame
    std::uint64_t content_bytes = 0;  ///< that follow
    std::uint64_t content_hash = 0;   ///< hash_of(content)
};

/// XXH3 of 64 bits.
std::uint64_t hash_of(std::string_view bytes);

/// The head of this content, with a hash of the head itself.
std::string head_bytes(const BlockHead& head, std::string_view content);
/// None if the bytes are no head as it was written.
std::optional<BlockHead> parse_head(std::string_view bytes);

/// Where the frame with the number `first_frame`, or a piece of it, begins in the file.
struct IndexEntry {
    std::uint64_t place = 0;
    std::uint64_t first_frame = 0;
};
std::string index_content(const std::vector<IndexEntry>& entries);
std::optional<std::vector<IndexEntry>> parse_index(std::string_view content);

/// The last bytes of a file that is complete: where its index begins.
inline constexpr std::size_t ending_bytes = 16;
std::string ending(std::uint64_t index_place);
std::optional<std::uint64_t> parse_ending(std::string_view bytes);

}  // namespace steplab::trajectory
