#pragma once

#include <algorithm>
#include <charconv>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace steplab {

/// The parts of a text between separators; the last one only if it is not empty.
inline std::vector<std::string> split(std::string_view text, char separator) {
    std::vector<std::string> parts;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(separator), text.size());
        parts.emplace_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return parts;
}

/// The number that the whole text represents.
template <class Number = double>
Number number(const std::string& text) {
    Number value{};
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    if (result.ec != std::errc{} || result.ptr != text.data() + text.size())
        throw std::runtime_error("no number: " + text);
    return value;
}

/// A CSV text as a head and rows of fields.
struct CsvTable {
    std::string head;
    std::vector<std::vector<std::string>> rows;
};

inline CsvTable table(std::string_view text) {
    CsvTable table;
    std::vector<std::string> lines = split(text, '\n');
    if (lines.empty()) throw std::runtime_error("no table");
    table.head = lines.front();
    for (std::size_t i = 1; i < lines.size(); ++i) table.rows.push_back(split(lines[i], ','));
    return table;
}

}  // namespace steplab
