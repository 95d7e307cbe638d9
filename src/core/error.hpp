#pragma once

#include <stdexcept>

namespace steplab {

/// The exit codes of the programs (README, "Exit codes").
enum class ExitCode : int { done = 0, usage = 2, file = 3, diverged = 4, no_opengl = 5, replay = 6 };

/// Base class of the project's exceptions. what() is one message for the user: what is wrong, where, and what would be
/// right.
class Error : public std::runtime_error {
public:
    Error(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
    ExitCode code() const { return code_; }

private:
    ExitCode code_;
};

/// The request is invalid: unknown id, option or parameter, a value that does not parse or is out of range.
class UsageError : public Error {
public:
    explicit UsageError(const std::string& message) : Error(ExitCode::usage, message) {}
};

/// A file cannot be read, written or understood.
class FileError : public Error {
public:
    explicit FileError(const std::string& message) : Error(ExitCode::file, message) {}
};

/// No OpenGL, no display, or a shader that does not compile.
class GraphicsError : public Error {
public:
    explicit GraphicsError(const std::string& message) : Error(ExitCode::no_opengl, message) {}
};

}  // namespace steplab
