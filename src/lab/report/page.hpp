#pragma once

#include "lab/study/study.hpp"

#include <string>

namespace steplab {

// The common parts of all pages: one self-contained HTML file, in the reader's light or dark mode.

/// From the doctype to the title, a sentence on the contents, and the circumstances of the measurement.
std::string page_head(const std::string& title, const std::string& what, const Circumstances& made);
/// A diagram with its caption.
std::string captioned(const std::string& caption, const std::string& svg);
/// A diagram as a separate file, in light colours on white.
std::string svg_file(std::string svg);
/// The name of a method; moving the mouse over it highlights its curves. `colour`: its number in the page's palette,
/// for a dot before it.
std::string method_name(const std::string& id, std::optional<int> colour = {});
extern const char* const page_end;

}  // namespace steplab
