#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace steplab::repository {

/// A text file of the repository.
struct TextFile {
    std::filesystem::path path;  ///< relative to the root
    std::string text;
    bool executable = false;
};

/// All text files below `root` in the order of their paths: what is kept in the repository, without what is built.
std::vector<TextFile> text_files(const std::filesystem::path& root);

/// The pages among them: files of Markdown.
std::vector<TextFile> pages(const std::filesystem::path& root);

/// "docs/hard-cases.md", less the ending, as a part of a test's name: letters, digits and underscores.
std::string name_in_tests(const std::string& text);

/// The lines of a text, without their ends.
std::vector<std::string> lines_of(const std::string& text);

}  // namespace steplab::repository
