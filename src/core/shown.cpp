#include "core/shown.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

namespace steplab {

namespace {

bool continues(std::string_view text, std::size_t i) {
    return i < text.size() && (static_cast<unsigned char>(text[i]) & 0xc0) == 0x80;
}

/// The bytes of the character that begins a text if a terminal may be given it as it is, else 0.
std::size_t plain_bytes(std::string_view text) {
    const auto first = static_cast<unsigned char>(text[0]);
    if (first < 0x80) return first >= 0x20 && first != 0x7f ? 1 : 0;
    const std::size_t bytes = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
    if (first < 0xc2 || first > 0xf4 || bytes > text.size()) return 0;
    for (std::size_t i = 1; i < bytes; ++i) {
        if (!continues(text, i)) return 0;
    }
    std::uint32_t point = first & (0x7fu >> bytes);
    for (std::size_t i = 1; i < bytes; ++i) point = point << 6 | (static_cast<unsigned char>(text[i]) & 0x3fu);
    constexpr std::uint32_t least[] = {0, 0, 0xa0, 0x800, 0x10000};  // below 0xa0 are control characters
    const bool surrogate = point >= 0xd800 && point < 0xe000;
    // marks that turn the direction of writing, and separators of lines
    const bool turns = (point >= 0x2028 && point <= 0x202e) || (point >= 0x2066 && point <= 0x2069);
    return point >= least[bytes] && point <= 0x10ffff && !surrogate && !turns ? bytes : 0;
}

std::string escaped(std::string_view text, bool lines) {
    std::string safe;
    while (!text.empty()) {
        std::size_t bytes = plain_bytes(text);
        if (bytes == 0 && lines && (text[0] == '\n' || text[0] == '\t')) bytes = 1;
        if (bytes > 0) {
            safe += text.substr(0, bytes);
        } else {
            safe += fmt::format("\\x{:02x}", static_cast<unsigned char>(text[0]));
        }
        text.remove_prefix(std::max<std::size_t>(bytes, 1));
    }
    return safe;
}

}  // namespace

std::string shown(std::string_view text, std::size_t most) {
    if (text.size() <= most) return escaped(text, false);
    std::size_t head = most * 3 / 4, tail = text.size() - most / 4;
    while (head > 0 && continues(text, head)) --head;
    while (continues(text, tail)) ++tail;
    return escaped(text.substr(0, head), false) + "..." + escaped(text.substr(tail), false);
}

std::string safe_message(std::string_view text) { return escaped(text, true); }

}  // namespace steplab
