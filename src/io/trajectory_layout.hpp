#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The layout of a `.trajectory` file (docs/trajectory-format.md): a signature, then blocks of a head and its content
/// (one description, chunks of frames, one index), and at the end the place of the index. Integers are little-endian.
namespace steplab::trajectory {

/// Of the file; it contains line ends of both kinds, so that a file damaged by a conversion of text is recognised. The
/// version of the format follows it in 4 bytes.
inline constexpr std::string_view magic{"\x89steplab\r\n\x1a\n", 12};
inline constexpr std::size_t signature_bytes = 16;

/// What the first three numbers of a row are.
enum class Version : std::uint32_t { positions = 1, displacements = 2 };

std::string signature(Version version);
/// The version of a file that begins like this; none if it is not one of these.
std::optional<Version> parse_signature(std::string_view bytes);

/// Largest number of rows (frames times particles) of a chunk; larger ones are refused before memory is allocated.
inline constexpr std::uint64_t most_rows = 16384;

enum class BlockKind : std::uint8_t { description, frames, index };

/// The bytes before the content of each block.
struct BlockHead {
    static constexpr std::size_t bytes = 56;

    BlockKind kind = BlockKind::frames;
    std::uint32_t frames = 0;         ///< that have rows in a chunk
    std::uint64_t first_frame = 0;    ///< counted from 0; in the index: the number of all frames
    std::uint64_t first_row = 0;      ///< 0 unless the chunk is a part of one frame
    std::uint64_t rows = 0;           ///< of each frame
    std::uint64_t content_bytes = 0;  ///< that follow
    std::uint64_t content_hash = 0;   ///< hash_of(content)
};

/// XXH3 of 64 bits.
std::uint64_t hash_of(std::string_view bytes);

/// The head of this content, with a hash of the head itself.
std::string head_bytes(const BlockHead& head, std::string_view content);
/// None if the bytes are not a head, or damaged.
std::optional<BlockHead> parse_head(std::string_view bytes);

/// The place in the file of a chunk, and the number of its first frame.
struct IndexEntry {
    std::uint64_t place = 0;
    std::uint64_t first_frame = 0;
};
std::string index_content(const std::vector<IndexEntry>& entries);
std::optional<std::vector<IndexEntry>> parse_index(std::string_view content);

/// The last bytes of a complete file: the place of its index.
inline constexpr std::size_t ending_bytes = 16;
std::string ending(std::uint64_t index_place);
std::optional<std::uint64_t> parse_ending(std::string_view bytes);

}  // namespace steplab::trajectory
