#include "io/trajectory_layout.hpp"

#include <xxhash.h>

#include <array>

namespace steplab::trajectory {

namespace {

constexpr std::array<std::string_view, 3> kind_names{"desc", "data", "indx"};
constexpr std::string_view end_mark = "steplab.";

template <class Integer>
void put(std::string& bytes, Integer value) {
    for (std::size_t i = 0; i < sizeof value; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xff);
}

/// Removes an integer from the front of bytes, of which there are enough.
template <class Integer>
Integer take(std::string_view& bytes) {
    Integer value = 0;
    for (std::size_t i = 0; i < sizeof value; ++i)
        value |= static_cast<Integer>(static_cast<Integer>(static_cast<unsigned char>(bytes[i])) << (8 * i));
    bytes.remove_prefix(sizeof value);
    return value;
}

}  // namespace

std::string signature(Version version) {
    std::string bytes(magic);
    put(bytes, static_cast<std::uint32_t>(version));
    return bytes;
}

std::optional<Version> parse_signature(std::string_view bytes) {
    for (const Version version : {Version::positions, Version::displacements}) {
        if (bytes == signature(version)) return version;
    }
    return std::nullopt;
}

std::uint64_t hash_of(std::string_view bytes) { return XXH3_64bits(bytes.data(), bytes.size()); }

std::string head_bytes(const BlockHead& head, std::string_view content) {
    std::string bytes(kind_names[static_cast<std::size_t>(head.kind)]);
    put(bytes, head.frames);
    for (const std::uint64_t value :
         {head.first_frame, head.first_row, head.rows, std::uint64_t{content.size()}, hash_of(content)})
        put(bytes, value);
    put(bytes, hash_of(bytes));
    return bytes;
}

std::optional<BlockHead> parse_head(std::string_view bytes) {
    if (bytes.size() < BlockHead::bytes) return std::nullopt;
    const std::uint64_t hash = hash_of(bytes.substr(0, BlockHead::bytes - sizeof(std::uint64_t)));
    BlockHead head;
    std::size_t kind = 0;
    while (kind < kind_names.size() && !bytes.starts_with(kind_names[kind])) ++kind;
    if (kind == kind_names.size()) return std::nullopt;
    head.kind = static_cast<BlockKind>(kind);
    bytes.remove_prefix(kind_names[kind].size());
    head.frames = take<std::uint32_t>(bytes);
    for (std::uint64_t* value :
         {&head.first_frame, &head.first_row, &head.rows, &head.content_bytes, &head.content_hash})
        *value = take<std::uint64_t>(bytes);
    if (take<std::uint64_t>(bytes) != hash) return std::nullopt;
    return head;
}

std::string index_content(const std::vector<IndexEntry>& entries) {
    std::string bytes;
    for (const IndexEntry& entry : entries) {
        put(bytes, entry.place);
        put(bytes, entry.first_frame);
    }
    return bytes;
}

std::optional<std::vector<IndexEntry>> parse_index(std::string_view content) {
    if (content.size() % (2 * sizeof(std::uint64_t)) != 0) return std::nullopt;
    std::vector<IndexEntry> entries;
    while (!content.empty()) {
        const auto place = take<std::uint64_t>(content);
        entries.push_back({place, take<std::uint64_t>(content)});
    }
    return entries;
}

std::string ending(std::uint64_t index_place) {
    std::string bytes;
    put(bytes, index_place);
    return bytes.append(end_mark);
}

std::optional<std::uint64_t> parse_ending(std::string_view bytes) {
    if (bytes.size() != ending_bytes || !bytes.ends_with(end_mark)) return std::nullopt;
    return take<std::uint64_t>(bytes);
}

}  // namespace steplab::trajectory
