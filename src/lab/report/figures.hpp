#pragma once

#include "lab/study/study.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace steplab {

/// The colours of methods on one page, the same in all diagrams. Only methods that are the fastest at some error have
/// one, and rk4 for comparison: twenty coloured lines could not be distinguished.
using MethodColours = std::map<std::string, std::size_t>;
MethodColours method_colours(const std::vector<Study>& studies);

/// The methods of the study that have a colour in its diagrams: the fastest in its precision at some power of ten, and
/// rk4.
std::vector<std::string> coloured_methods(const Study& study);

/// Error against time and against evaluations for each precision of the plan, then the energy error over time. Diagrams
/// against the same kind of cost have the same axis. Throws Interrupted.
struct StudyFigures {
    std::vector<plot::Plot> figures;
    std::vector<std::string> captions;
};
StudyFigures study_figures(const Study& study, const MethodColours& colours);

}  // namespace steplab
