#include "described_command.hpp"

#include "app/commands/commands.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>

namespace steplab::manual {

namespace {

/// Help texts are wrapped for a terminal.
std::string on_one_line(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

DescribedOption described(const CLI::Option& option) {
    DescribedOption result{.names = {},
                           .placeholder = option.get_option_text(),
                           .what = on_one_line(option.get_description()),
                           .group = option.get_group()};
    for (const std::string& name : option.get_snames()) result.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) result.names.push_back("--" + name);
    if (result.names.empty()) result.names.push_back(option.get_name(true));  // of a word that follows the command
    return result;
}

DescribedCommand described(Command& command) {
    CLI::App app;
    command.declare(app);
    DescribedCommand result{.name = std::string(command.name()),
                            .what = std::string(command.what()),
                            .examples = app.get_footer(),
                            .options = {}};
    for (const CLI::Option* option : app.get_options()) result.options.push_back(described(*option));
    return result;
}

bool is_word(const std::string& text) {
    const auto is_in_word = [](unsigned char c) { return std::islower(c) != 0 || std::isdigit(c) != 0 || c == '-'; };
    return text.size() > 1 && std::all_of(text.begin(), text.end(), is_in_word);
}

}  // namespace

std::vector<std::string> DescribedOption::words() const {
    std::vector<std::string> words;
    for (std::size_t from = 0, end = 0; placeholder.find('|') != std::string::npos && end < placeholder.size();
         from = end + 1) {
        end = std::min(placeholder.find('|', from), placeholder.size());
        const std::string word = placeholder.substr(from, end - from);
        if (is_word(word)) words.push_back(word);
    }
    return words;
}

std::vector<DescribedCommand> described_commands() {
    std::vector<DescribedCommand> all;
    for (const auto& command : commands({})) all.push_back(described(*command));
    return all;
}

}  // namespace steplab::manual
