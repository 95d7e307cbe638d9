#include "io/columns.hpp"

#include "core/error.hpp"
#include "core/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace steplab {

namespace {

constexpr std::array<std::string_view, 9> names{"x", "y", "z", "vx", "vy", "vz", "ux", "uy", "uz"};

Column column_of(std::string_view name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) throw UsageError(unknown_word("column", name, names));
    return static_cast<Column>(found - names.begin());
}

}  // namespace

std::string_view id(Column column) { return names[static_cast<std::size_t>(column)]; }

const Columns& usual_columns() {
    static const Columns columns{Column::x, Column::y, Column::z, Column::vx, Column::vy, Column::vz};
    return columns;
}

Columns parse_columns(std::string_view list) {
    Columns columns;
    for (std::size_t begin = 0; begin <= list.size();) {
        const std::size_t end = std::min(list.find(',', begin), list.size());
        const Column column = column_of(list.substr(begin, end - begin));
        if (contains(columns, column)) throw UsageError(fmt::format("column {} is named more than once", id(column)));
        columns.push_back(column);
        begin = end + 1;
    }
    return columns;
}

FrameParts parts_of(const Columns& columns) {
    const auto any = [&columns](Column first, Column last) {
        return std::any_of(columns.begin(), columns.end(), [=](Column c) { return first <= c && c <= last; });
    };
    return {.positions = any(Column::x, Column::z), .displacements = any(Column::ux, Column::uz)};
}

bool contains(const Columns& columns, Column column) {
    return std::find(columns.begin(), columns.end(), column) != columns.end();
}

std::string names_of(const Columns& columns) {
    std::string text;
    for (const Column column : columns) text.append(text.empty() ? "" : ",").append(id(column));
    return text;
}

}  // namespace steplab
