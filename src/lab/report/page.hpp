#pragma once

#include "lab/study/study.hpp"

#include <string>

namespace steplab {

// What every page of the lab is made of: one file of HTML that needs nothing else, light or dark as its reader has it.

/// From the doctype to the title, what it is in a sentence, and what it was made with.
std::string page_head(const std::string& title, const std::string& what, const Circumstances& made);
/// A diagram with its caption.
std::string captioned(const std::string& caption, const std::string& svg);
/// A diagram as a file of its own, in the light colours on white.
std::string svg_file(std::string svg);
/// The name of a method; pointing at it brings its curves forward. `colour`: its number in the page's palette, for a
/// dot before it.
std::string method_name(const std::string& id, std::optional<int> colour = {});
extern const char* const page_end;

}  // namespace steplab
