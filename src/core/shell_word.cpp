#include "core/shell_word.hpp"

#include "core/shown.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace steplab {

std::string shell_word(const std::string& text) {
    const auto plain = [](unsigned char c) {
        return std::isalnum(c) != 0 || c >= 0x80 ||
               std::string_view("/._-+,:=@%").find(static_cast<char>(c)) != std::string_view::npos;
    };
    const bool safe = shown(text, text.size()) == text;
    if (safe && !text.empty() && std::all_of(text.begin(), text.end(), plain)) return text;
    std::string quoted = safe ? "'" : "$'";
    for (const char c : text) {
        if (c == '\'') {
            quoted += safe ? "'\\''" : "\\'";
        } else if (c == '\\' && !safe) {
            quoted += "\\\\";
        } else {
            quoted += c;
        }
    }
    return (safe ? quoted : shown(quoted, quoted.size())) + "'";
}

std::string shell_file(const std::string& name) {
    const bool can_be_misread = name.find_first_of("-%=") == 0;  // zsh looks for a program behind =
    return shell_word(can_be_misread ? "./" + name : name);
}

}  // namespace steplab
