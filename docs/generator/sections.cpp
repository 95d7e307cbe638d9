#include "sections.hpp"

#include <regex>
#include <sstream>
#include <stdexcept>

namespace steplab::docs {
namespace {

constexpr const char* end_mark = "<!-- made end -->";

void skip_to_end_mark(std::istream& lines, const std::string& name) {
    for (std::string line; std::getline(lines, line);) {
        if (line == end_mark) return;
    }
    throw std::runtime_error("the section '" + name + "' has no line " + end_mark);
}

/// A line of a shell without the comment at its end.
std::string without_comment(const std::string& line) {
    const std::string command = line.substr(0, line.find(" #"));
    return command.substr(0, command.find_last_not_of(' ') + 1);
}

}  // namespace

std::string with_sections_made(const std::string& page, const SectionMaker& make) {
    static const std::regex begin_mark("<!-- made: (.*) -->");
    std::istringstream lines(page);
    std::string made;
    std::smatch match;
    for (std::string line; std::getline(lines, line);) {
        made += line + '\n';
        if (!std::regex_match(line, match, begin_mark)) continue;
        const std::string name = match[1];
        skip_to_end_mark(lines, name);
        made += make(name) + end_mark + '\n';
    }
    return made;
}

/// Of a block of code without a fence.
constexpr std::string_view indentation = "    ";

std::vector<std::string> examples(const std::string& page) {
    std::istringstream lines(page);
    std::vector<std::string> found;
    bool fenced = false, shell = false;
    std::string command;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("```")) {
            shell = line == "```sh";
            fenced = !fenced;
            continue;
        }
        if (fenced ? !shell : !line.starts_with(indentation)) continue;
        command += without_comment(fenced ? line : line.substr(indentation.size()));
        if (command.ends_with('\\')) {
            command.back() = ' ';
            continue;
        }
        if (command.starts_with("steplab")) found.push_back(command);
        command.clear();
    }
    return found;
}

std::vector<std::string> linked_files(const std::string& page) {
    static const std::regex link(R"(\]\(([^)#:\s]+)(?:#[^)]*)?\))");
    std::vector<std::string> files;
    for (auto match = std::sregex_iterator(page.begin(), page.end(), link); match != std::sregex_iterator(); ++match) {
        files.push_back((*match)[1]);
    }
    return files;
}

}  // namespace steplab::docs
