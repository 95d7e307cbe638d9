#pragma once

#include "plot/layout.hpp"

#include <string>
#include <vector>

namespace steplab::plot {

/// The name of a curve within the frame.
struct CurveName {
    std::string text;
    std::size_t colour = 0;
    Box place;
};

/// A place for the name of each curve that is not quiet: next to one of its points, within the frame, where it covers
/// no other name and as few points of such curves as possible.
std::vector<CurveName> curve_names(const Plot& plot, const Layout& layout, const Lettering& lettering);

}  // namespace steplab::plot
