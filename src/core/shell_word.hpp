#pragma once

#include <string>

namespace steplab {

/// A word of a command line, in quotation marks where a shell would not take it as it is. Characters that a terminal
/// would obey are written as $'\x1b', which shells read.
std::string shell_word(const std::string& text);

/// The name of a file as such a word, at the beginning of a command too: neither an option ("-a") nor a job ("%1").
std::string shell_file(const std::string& name);

}  // namespace steplab
