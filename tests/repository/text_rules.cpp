#include "repository/text_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <regex>

namespace steplab::repository {
namespace {

/// "file:line: text" of every line in which the pattern is found.
std::vector<std::string> lines_with(const std::vector<TextFile>& files, const std::regex& pattern) {
    std::vector<std::string> found;
    for (const TextFile& file : files) {
        std::size_t number = 0;
        for (const std::string& line : lines_of(file.text)) {
            ++number;
            if (std::regex_search(line, pattern))
                found.push_back(fmt::format("{}:{}: {}", file.path.string(), number, line));
        }
    }
    return found;
}

bool is_source(const TextFile& file) {
    const auto extension = file.path.extension();
    return extension == ".cpp" || extension == ".hpp";
}

}  // namespace

// The words are written in two pieces here, so that this file itself does not hold them.

std::vector<std::string> unwanted_words(const std::vector<TextFile>& files) {
    static const std::regex pattern(
        "\\b(TO"
        "DO|FIX"
        "ME|XX"
        "X|HA"
        "CK)\\b|/(wo"
        "rk|ho"
        "me|ro"
        "ot|Us"
        "ers)/\\w");
    return lines_with(files, pattern);
}

std::vector<std::string> tests_that_may_not_run(const std::vector<TextFile>& files) {
    static const std::regex pattern(
        "GTEST_SK"
        "IP|DISABL"
        "ED_");
    return lines_with(files, pattern);
}

std::vector<std::string> long_sources(const std::vector<TextFile>& files) {
    constexpr std::size_t longest = 350;  // above it there are two subjects in one file
    std::vector<std::string> found;
    for (const TextFile& file : files) {
        const std::size_t lines = lines_of(file.text).size();
        if (is_source(file) && lines > longest) found.push_back(fmt::format("{}: {}", file.path.string(), lines));
    }
    return found;
}

std::vector<std::string> wrong_run_bits(const std::vector<TextFile>& files) {
    std::vector<std::string> found;
    for (const TextFile& file : files) {
        if (file.text.starts_with("#!") != file.executable) found.push_back(file.path.string());
    }
    return found;
}

std::vector<std::string> scenes_made_by_the_interface(const std::vector<TextFile>& files) {
    static const std::regex pattern(
        R"((\.|->)(plan|scene|facts)\([^)]|\b(stability_limit|omega_max|fastest_frequency|start_frequency|opening_dt|facts_of|)"
        R"(has_drag|integrates_drag_work)\()"
        R"(|\b(remedy_candidates|resolution|linear_limit|check)\([^)])");
    std::vector<TextFile> interface = files;
    std::erase_if(interface, [](const TextFile& file) {
        const std::string path = file.path.string();
        return !path.starts_with("src/ui/") && !path.starts_with("src/app/window/");
    });
    return lines_with(interface, pattern);
}

std::vector<std::string> writing_past_the_streams(const std::vector<TextFile>& files) {
    static const std::regex pattern(R"(\b(stdout|stderr)\b|\bstd::(cout|cerr|clog|puts|printf)\b|\bfmt::print\()");
    // the one place; a bar of progress, of numbers and words of ours; data for tests of the window
    const std::vector<std::string> allowed{"src/app/cli/standard_streams.cpp", "src/app/cli/progress.cpp",
                                           "src/app/window/trace.cpp"};
    std::vector<TextFile> programs = files;
    std::erase_if(programs, [&](const TextFile& file) {
        const std::string path = file.path.string();
        return !path.starts_with("src/") || std::find(allowed.begin(), allowed.end(), path) != allowed.end();
    });
    return lines_with(programs, pattern);
}

std::vector<std::string> untidy_lines(const std::vector<TextFile>& files) {
    static const std::regex untidy("\t|\r|[ \t]$");
    std::vector<TextFile> checked = files;
    std::erase_if(checked, [](const TextFile& file) { return file.path.extension() == ".md"; });
    std::vector<std::string> found = lines_with(checked, untidy);
    for (const TextFile& file : files) {
        if (!file.text.empty() && !file.text.ends_with('\n')) found.push_back(file.path.string() + ": no end of line");
    }
    return found;
}

}  // namespace steplab::repository
