#include "core/shown.hpp"

#include <algorithm>
#include <array>
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

/// Hands a text over character by character, each as it may be shown. Needs no memory.
template <class Take>
void escape(std::string_view text, bool lines, const Take& take) {
    constexpr std::string_view digits = "0123456789abcdef";
    while (!text.empty()) {
        std::size_t bytes = plain_bytes(text);
        if (bytes == 0 && lines && (text[0] == '\n' || text[0] == '\t')) bytes = 1;
        if (bytes > 0) {
            take(text.substr(0, bytes));
        } else {
            const auto byte = static_cast<unsigned char>(text[0]);
            const std::array<char, 4> code{'\\', 'x', digits[byte >> 4], digits[byte & 15]};
            take(std::string_view(code.data(), code.size()));
        }
        text.remove_prefix(std::max<std::size_t>(bytes, 1));
    }
}

std::string escaped(std::string_view text, bool lines) {
    std::string safe;
    escape(text, lines, [&safe](std::string_view piece) { safe += piece; });
    return safe;
}

/// Collects small pieces, so that a message is one write as a rule.
class SafeLine {
public:
    explicit SafeLine(std::FILE* to) : to_(to) {}
    ~SafeLine() { send(); }
    SafeLine(const SafeLine&) = delete;
    SafeLine& operator=(const SafeLine&) = delete;

    void add(std::string_view piece) {
        if (used_ + piece.size() > bytes_.size()) send();
        std::copy(piece.begin(), piece.end(), bytes_.begin() + static_cast<std::ptrdiff_t>(used_));
        used_ += piece.size();
    }

private:
    void send() {
        const std::size_t written = std::fwrite(bytes_.data(), 1, used_, to_);
        static_cast<void>(written);
        used_ = 0;
    }

    std::FILE* to_;
    std::array<char, 4096> bytes_;
    std::size_t used_ = 0;
};

}  // namespace

std::string shown(std::string_view text, std::size_t most) {
    if (text.size() <= most) return escaped(text, false);
    std::size_t head = most * 3 / 4, tail = text.size() - most / 4;
    while (head > 0 && continues(text, head)) --head;
    while (continues(text, tail)) ++tail;
    return escaped(text.substr(0, head), false) + "..." + escaped(text.substr(tail), false);
}

std::string safe_message(std::string_view text) { return escaped(text, true); }

void write_safely(std::FILE* to, std::initializer_list<std::string_view> texts) {
    SafeLine line(to);
    for (const std::string_view text : texts) escape(text, true, [&line](std::string_view piece) { line.add(piece); });
}

}  // namespace steplab
