// What is reported of an exception where there may be no memory for it: in handlers of threads, whose own exceptions
// would end the program.
#pragma once

#include <exception>
#include <string>

namespace steplab {

/// A copy of the text, or "out of memory", which a string holds without any.
inline std::string copy_or_short(const char* text) noexcept {
    try {
        return text;
    } catch (const std::exception&) {
        return "out of memory";
    }
}

/// The message of an exception; that of a missing allocation in words.
std::string problem_text(const std::exception& problem) noexcept;

}  // namespace steplab
