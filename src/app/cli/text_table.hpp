#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace steplab {

/// One line of a table for a person at a terminal; the cells are UTF-8.
using Row = std::vector<std::string>;

/// Rows under each other, at most 100 columns wide: columns as wide as their widest cell, the last one takes the rest
/// of the page and is broken into lines.
std::string aligned(const std::vector<Row>& rows, std::size_t indent);

/// Breaks text into lines within the page, each but the first indented; the first begins at column `indent`.
std::string wrapped(std::string_view text, std::size_t indent);

}  // namespace steplab
