#pragma once

#include <string_view>

namespace CLI {
class App;
}

namespace steplab {

/// One sub-command of `steplab`. The program has it declare its options, parses them, and runs it.
class Command {
public:
    virtual ~Command() = default;
    /// The word on the command line: "run".
    virtual std::string_view name() const = 0;
    /// One line for the list of commands.
    virtual std::string_view what() const = 0;
    /// Adds the options to the parser; the values go to this object, which outlives the parser.
    virtual void declare(CLI::App& app) = 0;
    /// Does the work once the options are parsed, and returns the exit code. Throws Error, ReaderGone, Interrupted.
    virtual int run() = 0;
};

}  // namespace steplab
