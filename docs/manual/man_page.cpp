#include "man_page.hpp"

#include "io/commit.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <sstream>

namespace steplab::manual {

namespace {

constexpr const char* exit_codes =
    ".SH EXIT STATUS\n"
    ".TP\n0\nDone.\n"
    ".TP\n2\nThe command line is wrong.\n"
    ".TP\n3\nA file cannot be read, written or understood.\n"
    ".TP\n4\nThe run diverged or stopped; what was computed until then is written.\n"
    ".TP\n5\nNo OpenGL.\n"
    ".TP\n6\nA repeated run differs.\n"
    ".TP\n128 + n\nEnded by signal n.\n";

std::string page_name(std::string program) {
    std::replace(program.begin(), program.end(), ' ', '-');
    return program;
}

std::string head(const std::string& program, const std::string& what) {
    const std::string name = page_name(program);
    std::string title = name;
    std::transform(title.begin(), title.end(), title.begin(), [](unsigned char c) { return std::toupper(c); });
    return fmt::format(".TH {} 1 \"\" \"steplab {}\" \"User commands\"\n.SH NAME\n{} \\- {}\n", escaped(title),
                       STEPLAB_VERSION, escaped(name), escaped(what));
}

/// Blocks of lines: those that are indented are examples, shown as they are.
std::string blocks(const std::string& text) {
    std::string page;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (line.empty()) {
            page += ".PP\n";
        } else if (line.starts_with(' ')) {
            page += fmt::format(".br\n.B {}\n", escaped(line.substr(line.find_first_not_of(' '))));
        } else {
            page += escaped(line) + '\n';
        }
    }
    return page;
}

std::string option_text(const DescribedOption& option) {
    std::string text = fmt::format(".TP\n\\fB{}\\fR", escaped(fmt::format("{}", fmt::join(option.names, ", "))));
    if (!option.placeholder.empty()) text += fmt::format(" \\fI{}\\fR", escaped(option.placeholder));
    return text + '\n' + escaped(option.what) + '\n';
}

std::string options_text(const DescribedCommand& command) {
    std::string text = ".SH OPTIONS\n", group;
    for (const DescribedOption& option : command.options) {
        if (option.group != group && option.group != "Options") text += fmt::format(".SS {}\n", escaped(option.group));
        group = option.group;
        text += option_text(option);
    }
    return text;
}

}  // namespace

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '\\') {
            result += "\\e";
        } else if (c == '-') {
            result += "\\-";
        } else if (c == '"') {
            result += "\\(dq";
        } else {
            result += c;
        }
    }
    const bool is_request = result.starts_with('.') || result.starts_with('\'');
    return is_request ? "\\&" + result : result;
}

std::string man_page(std::span<const DescribedCommand> commands) {
    std::string page = head("steplab", "a laboratory for numerical integrators of point masses");
    page += ".SH SYNOPSIS\n.B steplab\n[\\fICOMMAND\\fR] [\\fIOPTIONS\\fR]\n.SH DESCRIPTION\n";
    page +=
        "Scenes of point masses, moved by many integration methods: as numbers, pictures, films, and reports of speed "
        "against error.\nWithout a command the scene opens in a window.\n.SH COMMANDS\n";
    std::string others;
    for (const DescribedCommand& command : commands) {
        page += fmt::format(".TP\n.B {}\n{}. See\n.BR steplab\\-{} (1).\n", escaped(command.name),
                            escaped(command.what), escaped(command.name));
        others += fmt::format("{}.BR steplab\\-{} (1)", others.empty() ? "" : ",\n", escaped(command.name));
    }
    return page + exit_codes + ".SH SEE ALSO\n" + others + '\n';
}

std::string man_page(const DescribedCommand& command, const std::string& program) {
    std::string what = command.what;
    if (!what.empty()) what.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(what.front())));
    std::string page = head(program, what);
    page += fmt::format(".SH SYNOPSIS\n.B {}\n[\\fIOPTIONS\\fR]\n.SH DESCRIPTION\n{}.\n", escaped(program),
                        escaped(command.what));
    page += options_text(command);
    if (!command.examples.empty()) page += ".SH EXAMPLES AND MORE\n" + blocks(command.examples);
    return page + exit_codes + ".SH SEE ALSO\n.BR steplab (1)\n";
}

}  // namespace steplab::manual
