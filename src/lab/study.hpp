#pragma once

#include "lab/figure.hpp"
#include "lab/speed_error.hpp"

#include <string>
#include <vector>

namespace steplab {

/// One scene of a report, measured.
struct Study {
    StudyPlan plan;
    Reference reference;
    std::vector<Measurement> runs;
};

/// The scenes a report takes if nobody names any: every model at its defaults over a time in which it shows what it
/// does; morse with spacing 0.3, because at its default particles pass through each other, where no order holds.
std::vector<StudyPlan> default_plans(bool quick);

/// Energy error over time of each method of fixed steps in double, at the run that comes nearest to this cost.
std::vector<Curve> energy_curves(const Study& study, double evaluations);

/// What the measurements were made on.
struct Circumstances {
    std::string version, commit, compiler, processor, date;
};
Circumstances circumstances();

}  // namespace steplab
