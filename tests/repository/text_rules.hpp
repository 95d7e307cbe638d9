#pragma once

#include "repository/files.hpp"

#include <string>
#include <vector>

namespace steplab::repository {

/// Lines that speak of one machine (absolute paths of a person's files) or put work off; "file:line: the words".
std::vector<std::string> unwanted_words(const std::vector<TextFile>& files);

/// Tests that are written but may not run.
std::vector<std::string> tests_that_may_not_run(const std::vector<TextFile>& files);

/// Sources longer than a person likes to read, "file: lines".
std::vector<std::string> long_sources(const std::vector<TextFile>& files);

/// Scripts without the run bit and files with it that are no scripts.
std::vector<std::string> wrong_run_bits(const std::vector<TextFile>& files);

/// Lines of the interface and the window that make a scene, or ask for what takes one: the run's thread does, and its
/// view has the answers.
std::vector<std::string> scenes_made_by_the_interface(const std::vector<TextFile>& files);

/// Lines of the programs that write to standard output or error past src/app/cli/standard_streams.cpp, which lets no
/// control character through.
std::vector<std::string> writing_past_the_streams(const std::vector<TextFile>& files);

/// Tabs, blanks at a line's end and missing line ends, against .editorconfig.
std::vector<std::string> untidy_lines(const std::vector<TextFile>& files);

}  // namespace steplab::repository
