#pragma once

#include <string>
#include <vector>

namespace steplab {

/// A table for a page; cells are plain text, without markup.
struct Table {
    std::vector<std::string> head;
    std::vector<std::vector<std::string>> rows;
};

std::string markdown(const Table& table);
std::string html(const Table& table);

}  // namespace steplab
