#include "completion.hpp"

#include "io/scene_file.hpp"
#include "sim/catalogue.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <string_view>

namespace steplab::manual {

namespace {

using Words = std::vector<std::string>;

template <class Entries>
Words ids_of(const Entries& entries) {
    Words ids;
    for (const auto& entry : entries) ids.emplace_back(entry.info.id);
    return ids;
}

std::string joined(const Words& words) { return fmt::format("{}", fmt::join(words, " ")); }

/// The names that the value of an option may have; files besides if `files`.
struct Values {
    Words words;
    bool files = false;
};

Values values_of(const DescribedOption& option) {
    const auto is = [&](std::string_view name) {
        return std::find(option.names.begin(), option.names.end(), name) != option.names.end();
    };
    if (is("--model")) return {ids_of(models())};
    if (is("--method")) return {ids_of(methods())};
    if (is("--scene")) return {shipped_scenes(), true};
    const bool names_file =
        option.placeholder.find("FILE") != std::string::npos || option.placeholder.find("DIR") != std::string::npos;
    return {option.words(), names_file};
}

/// What may follow a command: its options, and the words or files that it takes.
Values following(const DescribedCommand& command) {
    Values all;
    for (const DescribedOption& option : command.options) {
        const Values values = option.is_positional() ? values_of(option) : Values{option.names};
        all.words.insert(all.words.end(), values.words.begin(), values.words.end());
        all.files = all.files || values.files;
    }
    return all;
}

Words names_of(std::span<const DescribedCommand> commands) {
    Words names;
    for (const DescribedCommand& command : commands) names.push_back(command.name);
    names.emplace_back("help");
    return names;
}

std::string bash_reply(const Values& values) {
    std::string reply = "COMPREPLY=()";
    if (!values.words.empty()) reply = fmt::format("COMPREPLY=($(compgen -W '{}' -- \"$word\"))", joined(values.words));
    return values.files ? reply + "; _steplab_files" : reply;
}

/// "run:--model)": values of options, where they are known. Those of a command and an option that others share are
/// written once.
std::string bash_values(std::span<const DescribedCommand> commands) {
    std::map<std::string, Words> patterns;  // by what they complete
    for (const DescribedCommand& command : commands) {
        for (const DescribedOption& option : command.options) {
            if (option.placeholder.empty() || option.is_positional()) continue;
            const Values values = values_of(option);
            for (const std::string& name : option.names)
                patterns[bash_reply(values)].push_back(command.name + ":" + name);
        }
    }
    std::string text;
    for (const auto& [reply, cases] : patterns)
        text += fmt::format("        {}) {}; return ;;\n", fmt::join(cases, "|"), reply);
    return text;
}

/// A text within single quotes of zsh, inside the brackets of a description.
std::string in_description(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '\'') {
            result += "'\\''";
        } else if (c == '[' || c == ']' || c == ':' || c == '\\') {
            result += std::string("\\") + c;
        } else {
            result += c;
        }
    }
    return result;
}

std::string zsh_values(const Values& values) {
    if (values.words.empty()) return values.files ? "_files" : "";
    if (!values.files) return fmt::format("({})", joined(values.words));
    return fmt::format("{{_alternative \"names\\:name\\:({})\" \"files\\:file\\:_files\"}}", joined(values.words));
}

std::string zsh_word(const DescribedOption& option) {
    return fmt::format(" \\\n                ':{}:{}'", in_description(option.names.front()),
                       zsh_values(values_of(option)));
}

std::string zsh_option(const DescribedOption& option) {
    std::string text;
    for (const std::string& name : option.names) {
        text += fmt::format(" \\\n                '*{}[{}]", name, in_description(option.what));
        if (!option.placeholder.empty()) {
            const Values values = values_of(option);
            text += fmt::format(":{}:{}", in_description(option.placeholder), zsh_values(values));
        }
        text += "'";
    }
    return text;
}

}  // namespace

std::string bash_completion(std::span<const DescribedCommand> commands) {
    std::string text =
        "# bash completion for steplab; made from the descriptions of its options\n\n"
        "_steplab_files() { compopt -o filenames 2>/dev/null; COMPREPLY+=($(compgen -f -- \"$word\")); }\n\n"
        "_steplab() {\n"
        "    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command=${COMP_WORDS[1]}\n"
        "    if [[ ${COMP_WORDS[0]##*/} == steplab-view || $command == -* ]]; then command=view; fi\n"
        "    COMPREPLY=()\n"
        "    case $command:$before in\n" +
        bash_values(commands) + "    esac\n";
    text += fmt::format(
        "    if ((COMP_CWORD == 1)) && [[ $word != -* && ${{COMP_WORDS[0]##*/}} == steplab ]]; then\n"
        "        COMPREPLY=($(compgen -W '{}' -- \"$word\"))\n        return\n    fi\n    case $command in\n",
        joined(names_of(commands)));
    for (const DescribedCommand& command : commands)
        text += fmt::format("        {}) {} ;;\n", command.name, bash_reply(following(command)));
    text += fmt::format("        help) COMPREPLY=($(compgen -W '{}' -- \"$word\")) ;;\n", joined(names_of(commands)));
    return text + "    esac\n}\ncomplete -F _steplab steplab steplab-view\n";
}

std::string zsh_completion(std::span<const DescribedCommand> commands) {
    std::string text =
        "#compdef steplab steplab-view\n# made from the descriptions of the options of steplab\n\n"
        "_steplab() {\n    local command=$words[2]\n"
        "    if [[ $service == steplab-view || $command == -* ]]; then command=view; else\n"
        "        if ((CURRENT == 2)); then\n            local -a all=(\n";
    for (const DescribedCommand& command : commands)
        text += fmt::format("                '{}:{}'\n", command.name, in_description(command.what));
    text +=
        "            )\n            _describe command all\n            return\n        fi\n"
        "        shift words\n        ((CURRENT--))\n    fi\n    case $command in\n";
    for (const DescribedCommand& command : commands) {
        text += fmt::format("        {})\n            _arguments", command.name);
        for (const DescribedOption& option : command.options) {
            text += option.is_positional() ? zsh_word(option) : zsh_option(option);
        }
        text += " ;;\n";
    }
    return text + "    esac\n}\n\n_steplab \"$@\"\n";
}

}  // namespace steplab::manual
