#pragma once

#include "session/recording.hpp"

#include <string>

namespace steplab {

/// A recording as a session file (docs/session-files.md): TOML, all numbers exact. Throws FileError if a file that the
/// scene reads is no UTF-8 text.
std::string session_text(const Recording& recording);

/// The recording of such a text; `name` stands for it in messages. Throws FileError: "FILE:LINE:COLUMN: what is wrong;
/// what would be right".
Recording parse_session(const std::string& text, const std::string& name);

/// The recording of a file. Throws FileError.
Recording read_session_file(const std::string& path);

}  // namespace steplab
