#include "app/commands/hard_cases_text.hpp"

#include "app/cli/text_table.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>

namespace steplab {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const HardCase& hard_case) {
    return {{"id", hard_case.id}, {"title", hard_case.title}, {"shows", hard_case.shows}};
}

/// The rows without the backticks of Markdown around ids.
std::vector<Row> plain_rows(const Table& table) {
    std::vector<Row> rows = table.rows;
    for (Row& row : rows) {
        for (std::string& cell : row) std::erase(cell, '`');
    }
    return rows;
}

}  // namespace

std::string hard_cases_list(std::span<const HardCase> cases) {
    std::vector<Row> rows{{"NAME", "TITLE"}};
    for (const HardCase& each : cases) rows.push_back({std::string(each.id), std::string(each.title)});
    return aligned(rows, 0);
}

std::string hard_cases_json(std::span<const HardCase> cases) {
    Json list = Json::array();
    for (const HardCase& each : cases) list.push_back(json_of(each));
    return list.dump(2) + "\n";
}

std::string hard_case_text(const HardCase& hard_case, const Table& table) {
    return fmt::format("{}\n\n{}\n\n{}", hard_case.title, wrapped(hard_case.shows, 0),
                       aligned(table.head, plain_rows(table), 0));
}

std::string hard_case_json(const HardCase& hard_case, const Table& table) {
    Json json = json_of(hard_case);
    json["columns"] = table.head;
    json["rows"] = plain_rows(table);
    return json.dump(2) + "\n";
}

}  // namespace steplab
