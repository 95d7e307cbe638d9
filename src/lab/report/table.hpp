#pragma once

#include "core/markup.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace steplab {

/// A table for a page; cells are plain text, without markup.
struct Table {
    std::vector<std::string> head;
    std::vector<std::vector<std::string>> rows;
};

std::string markdown(const Table& table);
/// As HTML, in a box that scrolls if the page is narrower.
std::string html(const Table& table);
/// The same for cells that are already HTML.
std::string html_of_markup(const Table& table);

}  // namespace steplab
