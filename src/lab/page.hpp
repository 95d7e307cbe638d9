#pragma once

#include "lab/study.hpp"

#include <string>

namespace steplab {

// What every page of the lab is made of: one file of HTML that needs nothing else.

/// From the doctype to the title and the line on what it was made with.
std::string page_head(const std::string& title, const Circumstances& made);
/// A diagram with its caption.
std::string captioned(const std::string& caption, const std::string& svg);
inline constexpr const char* page_end = "</body></html>\n";

}  // namespace steplab
