#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace steplab {

/// Columns of the help and of tables on a terminal.
inline constexpr std::size_t page_width = 100;

/// One line of a table; the cells are UTF-8.
using Row = std::vector<std::string>;

/// Rows as aligned text, at most 100 columns wide: columns are as wide as their widest cell; the last one has the rest
/// of the line and is wrapped. At least one row, all of the same length.
std::string aligned(const std::vector<Row>& rows, std::size_t indent);
/// The same below a head whose cells are wrapped, to as few lines as make the table fit into 100 columns.
std::string aligned(const Row& head, const std::vector<Row>& rows, std::size_t indent);

/// The lines of a text that is wrapped at this many columns; a longer word has a line of its own.
std::vector<std::string> wrapped_lines(std::string_view text, std::size_t columns);
/// Wraps text at 100 columns. The first line begins at column `indent`, the others are indented to it.
std::string wrapped(std::string_view text, std::size_t indent);

}  // namespace steplab
