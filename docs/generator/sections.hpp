#pragma once

#include <functional>
#include <string>
#include <vector>

namespace steplab::docs {

using SectionMaker = std::function<std::string(const std::string& name)>;

/// A page of the documentation has sections that are made, not written. They stand between two marks of one line each:
///
///     <!-- made: methods -->
///     ...
///     <!-- made end -->
///
/// `make` gives the lines of the section of that name. The text comes back with every
/// section as it should be. Throws std::runtime_error if a section has no end.
std::string with_sections_made(const std::string& page, const SectionMaker& make);

/// The shell commands in a page's code blocks marked as `sh` that begin with "steplab", one for each line; a line that
/// ends in a backslash goes on in the next.
std::vector<std::string> examples(const std::string& page);

/// The files in the repository that a page links to or shows, as it names them: without #anchors and web addresses.
std::vector<std::string> linked_files(const std::string& page);

}  // namespace steplab::docs
