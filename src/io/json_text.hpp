// JSON as text for files and programs.
#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace steplab {

/// In place of the number of blanks that one level is indented by.
constexpr int one_line = -1;

/// With a line end behind it. Of a name that is no UTF-8, as names of files may be, the bytes that are none become
/// U+FFFD.
template <class Json>
std::string json_text(const Json& json, int indent = 2) {
    return json.dump(indent, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace steplab
