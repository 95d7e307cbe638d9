#include "lab/report/table.hpp"

namespace steplab {

namespace {

std::string markdown_row(const std::vector<std::string>& cells) {
    std::string row = "|";
    for (const std::string& cell : cells) row += " " + cell + " |";
    return row + "\n";
}

std::string html_row(const std::vector<std::string>& cells, const char* tag) {
    std::string row = "<tr>";
    for (const std::string& cell : cells) row += std::string("<") + tag + ">" + cell + "</" + tag + ">";
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
    Table safe = table;
    for (std::string& cell : safe.head) cell = escaped(cell);
    for (auto& row : safe.rows) {
        for (std::string& cell : row) cell = escaped(cell);
    }
    return html_of_markup(safe);
}

std::string html_of_markup(const Table& table) {
    std::string text = "<div class=\"wide\"><table>\n<thead>" + html_row(table.head, "th") + "</thead>\n<tbody>\n";
    for (const auto& row : table.rows) text += html_row(row, "td");
    return text + "</tbody></table></div>\n";
}

}  // namespace steplab
