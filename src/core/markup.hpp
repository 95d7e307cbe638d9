#pragma once

#include <string>
#include <string_view>

namespace steplab {

/// Text escaped for HTML and SVG, also within an attribute.
std::string escaped(std::string_view text);

}  // namespace steplab
