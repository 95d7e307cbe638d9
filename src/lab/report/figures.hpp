#pragma once

#include "lab/study/study.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace steplab {

/// The colours of methods on one page. Only those that are the fastest at some error anywhere have one, and rk4 to
/// compare with, the same in all diagrams: of twenty coloured lines nobody tells which is which.
using MethodColours = std::map<std::string, int>;
MethodColours method_colours(const std::vector<Study>& studies);

/// The methods of the study that have a colour in its diagrams: the fastest in its precision at some power of ten, and
/// rk4.
std::vector<std::string> coloured_methods(const Study& study);

/// Error against time and against evaluations for each precision of the plan, then the energy error over time. Those
/// against one kind of cost have the same axis of it. Throws Interrupted.
struct StudyFigures {
    std::vector<Figure> figures;
    std::vector<std::string> captions;
};
StudyFigures study_figures(const Study& study, const MethodColours& colours);

}  // namespace steplab
