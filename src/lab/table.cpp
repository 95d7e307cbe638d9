#include "lab/table.hpp"

namespace steplab {

namespace {

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '<') {
            out += "&lt;";
        } else if (c == '&') {
            out += "&amp;";
        } else {
            out += c;
        }
    }
    return out;
}

std::string markdown_row(const std::vector<std::string>& cells) {
    std::string row = "|";
    for (const std::string& cell : cells) row += " " + cell + " |";
    return row + "\n";
}

std::string html_row(const std::vector<std::string>& cells, const char* tag) {
    std::string row = "<tr>";
    for (const std::string& cell : cells) row += std::string("<") + tag + ">" + escaped(cell) + "</" + tag + ">";
    return row + "</tr>\n";
}

}  // namespace

std::string markdown(const Table& table) {
    std::string text = markdown_row(table.head) + "|";
    for (std::size_t i = 0; i < table.head.size(); ++i) text += "---|";
    text += "\n";
    for (const auto& row : table.rows) text += markdown_row(row);
    return text;
}

std::string html(const Table& table) {
    std::string text = "<table>" + html_row(table.head, "th");
    for (const auto& row : table.rows) text += html_row(row, "td");
    return text + "</table>\n";
}

}  // namespace steplab
