#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace steplab {

constexpr bool is_blank(char c) { return c == ' ' || c == '\t'; }

/// The words of a line, between blanks; the memory of `words` is reused.
inline void split(std::string_view line, std::vector<std::string_view>& words) {
    words.clear();
    for (std::size_t begin = 0, end = 0; begin < line.size(); begin = end) {
        while (begin < line.size() && is_blank(line[begin])) ++begin;
        for (end = begin; end < line.size() && !is_blank(line[end]);) ++end;
        if (end > begin) words.push_back(line.substr(begin, end - begin));
    }
}

inline std::vector<std::string_view> words_of(std::string_view line) {
    std::vector<std::string_view> words;
    split(line, words);
    return words;
}

}  // namespace steplab
