#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <toml++/toml.h>

namespace steplab {

/// The table of a TOML text, which may be anything; `name` stands for it in messages. Throws toml::parse_error, also
/// where a key has too many parts (the library reads them recursively) or where there are more values than are to be
/// read.
toml::table toml_table(std::string_view text, const std::string& name,
                       std::size_t most_values = std::numeric_limits<std::size_t>::max());

}  // namespace steplab
