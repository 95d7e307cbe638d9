#pragma once

#include <cstddef>
#include <cstdio>
#include <initializer_list>
#include <string>
#include <string_view>

namespace steplab {

/// A text from outside (an argument, the name or the content of a file) as messages show it: control characters and
/// bytes that are no UTF-8 as "\x1b", so that no terminal obeys them, and of a long text its beginning and its end with
/// "..." between.
std::string shown(std::string_view text, std::size_t most = 200);

/// The same of a whole message, line ends and all else that is text as it is.
std::string safe_message(std::string_view text);

/// Writes texts as one safe message. Needs no memory, of which there may be none; what cannot be written is lost.
void write_safely(std::FILE* to, std::initializer_list<std::string_view> texts);

}  // namespace steplab
