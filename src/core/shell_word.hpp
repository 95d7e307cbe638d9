#pragma once

#include <string>

namespace steplab {

/// A word of a command line, in quotation marks where a shell would not take it as it is. Characters that a terminal
/// would obey are written as $'\x1b', which shells read.
std::string shell_word(const std::string& text);

}  // namespace steplab
