#pragma once

#include <string>
#include <vector>

namespace steplab::manual {

/// An option as the command line describes it to its parser.
struct DescribedOption {
    std::vector<std::string> names;  ///< "-h", "--help"; of a word that follows the command, its name alone
    std::string placeholder;         ///< of its value: "ID", "float|double"; empty: it takes none
    std::string what;
    std::string group;

    bool is_positional() const { return !names.front().starts_with('-'); }
    /// The words that its value may be, where its placeholder lists them: {"float", "double"}.
    std::vector<std::string> words() const;
};

/// A command of `steplab`.
struct DescribedCommand {
    std::string name, what, examples;
    std::vector<DescribedOption> options;  ///< in the order of the help
};

/// All of them, in the order of the help.
std::vector<DescribedCommand> described_commands();

}  // namespace steplab::manual
