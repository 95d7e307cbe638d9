#pragma once

#include <filesystem>
#include <string>

namespace steplab::docs {

/// How a shell command ended.
struct Outcome {
    int code = 0;        ///< its exit code; 128 + n if signal n ended it
    std::string output;  ///< what it wrote to standard output; standard error too if the command says 2>&1
};

/// Runs a command by bash in `folder`, with `programs` first in PATH, no display and nothing on standard input.
/// Throws std::runtime_error if no shell can be started.
Outcome run(const std::string& command, const std::filesystem::path& folder, const std::filesystem::path& programs);

}  // namespace steplab::docs
