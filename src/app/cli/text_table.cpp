#include "app/cli/text_table.hpp"

#include <algorithm>
#include <numeric>

namespace steplab {

namespace {

/// Columns of UTF-8 text on a terminal: one per character, so continuation bytes do not count.
std::size_t width(std::string_view text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string padded(std::string_view text, std::size_t columns) {
    return std::string(text) + std::string(columns - std::min(columns, width(text)), ' ');
}

/// The smallest width at which a text has at most this many lines, and that of its longest word at least.
std::size_t width_for(std::string_view text, std::size_t most_lines) {
    std::size_t columns = 0;
    for (const std::string& word : wrapped_lines(text, 0)) columns = std::max(columns, width(word));
    while (wrapped_lines(text, columns).size() > most_lines) ++columns;
    return columns;
}

/// The widths of columns whose heads take this many lines.
std::vector<std::size_t> widths_for(const Row& head, const std::vector<Row>& rows, std::size_t lines) {
    std::vector<std::size_t> widths;
    for (std::size_t column = 0; column < head.size(); ++column) {
        widths.push_back(width_for(head[column], lines));
        for (const Row& row : rows) widths.back() = std::max(widths.back(), width(row[column]));
    }
    return widths;
}

}  // namespace

std::vector<std::string> wrapped_lines(std::string_view text, std::size_t columns) {
    std::vector<std::string> lines(1);
    while (!text.empty()) {
        const std::string_view word = text.substr(0, text.find(' '));
        if (!lines.back().empty() && width(lines.back()) + 1 + width(word) > columns) lines.emplace_back();
        if (!lines.back().empty()) lines.back() += ' ';
        lines.back() += word;
        text.remove_prefix(std::min(word.size() + 1, text.size()));
    }
    return lines;
}

std::string wrapped(std::string_view text, std::size_t indent) {
    std::string out;
    for (const std::string& line : wrapped_lines(text, page_width - std::min(page_width, indent))) {
        if (!out.empty()) out.append("\n").append(indent, ' ');
        out += line;
    }
    return out;
}

std::string aligned(const std::vector<Row>& rows, std::size_t indent) {
    std::vector<std::size_t> widths(rows.front().size(), 0);
    for (const Row& row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width(row[i]));
    }
    std::string out;
    for (const Row& row : rows) {
        std::string line(indent, ' ');
        for (std::size_t i = 0; i + 1 < row.size(); ++i) line += padded(row[i], widths[i] + 2);
        line += wrapped(row.back(), width(line));
        out += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
    }
    return out;
}

std::string aligned(const Row& head, const std::vector<Row>& rows, std::size_t indent) {
    constexpr std::size_t most_lines = 5, gap = 2;
    std::size_t lines = 0;
    std::vector<std::size_t> widths;
    std::size_t total = page_width + 1;
    while (lines < most_lines && total > page_width) {
        widths = widths_for(head, rows, ++lines);
        total = std::accumulate(widths.begin(), widths.end(), indent + gap * (widths.size() - 1));
    }
    std::vector<Row> all(1, Row(head.size()));
    for (std::size_t column = 0; column < head.size(); ++column) {
        const std::vector<std::string> parts = wrapped_lines(head[column], widths[column]);
        all.resize(std::max(all.size(), parts.size()), Row(head.size()));
        for (std::size_t line = 0; line < parts.size(); ++line) all[line][column] = parts[line];
    }
    all.insert(all.end(), rows.begin(), rows.end());
    return aligned(all, indent);
}

}  // namespace steplab
