#pragma once

#include "lab/study/study.hpp"
#include "plot/svg.hpp"

#include <string>

namespace steplab {

// The common parts of all pages: one self-contained HTML file, in the reader's light or dark mode.

/// From the doctype to the title, a sentence on the contents, and the circumstances of the measurement.
std::string page_head(const std::string& title, const std::string& what, const Circumstances& made);
/// A diagram with its caption, in the colours of the page.
std::string captioned(const std::string& caption, const plot::Plot& figure);
/// The colours of diagrams in light mode, for files of their own.
plot::Inks light_inks();
/// The name of a method; moving the mouse over it highlights its curves. `colour`: its number in the page's palette,
/// for a dot before it.
std::string method_name(const std::string& id, std::optional<std::size_t> colour = {});
extern const char* const page_end;

}  // namespace steplab
