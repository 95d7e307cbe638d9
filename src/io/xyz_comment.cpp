#include "io/xyz_comment.hpp"

#include <algorithm>

namespace steplab {

XyzComment::XyzComment(std::string_view line) {
    constexpr std::string_view blanks = " \t";
    while (true) {
        line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
        const std::size_t equals = line.find('=');
        if (equals == std::string_view::npos) return;
        const std::string key(line.substr(0, equals));
        line.remove_prefix(equals + 1);
        const bool quoted = line.starts_with('"');
        if (quoted) line.remove_prefix(1);
        const std::size_t end = std::min(quoted ? line.find('"') : line.find_first_of(blanks), line.size());
        pairs_[key] = std::string(line.substr(0, end));
        line.remove_prefix(std::min(end + 1, line.size()));
    }
}

std::optional<std::string> XyzComment::value(std::string_view key) const {
    const auto pair = pairs_.find(key);
    return pair == pairs_.end() ? std::nullopt : std::optional(pair->second);
}

}  // namespace steplab
