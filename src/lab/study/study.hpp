#pragma once

#include "lab/limits/limits.hpp"
#include "lab/report/figure.hpp"
#include "lab/study/speed_error.hpp"

#include <string>
#include <vector>

namespace steplab {

/// One scene of a report, measured.
struct Study {
    StudyPlan plan;
    std::string reference;       ///< in words: what the runs are judged by
    double reference_error = 0;  ///< how far that may be from the truth; no error is given below it
    std::vector<Measurement> runs;
    std::vector<CutSeries> cut;
    std::vector<Limit> limits;  ///< stability limits of the plan's methods, in the plan's first precision
};

/// The scenes a report takes if nobody names any: the models at their defaults over a time in which they show what they
/// do; morse with spacing 0.3, because at its default particles pass through each other, where no order holds; not
/// crystal, where none holds either, at the kinks of its cut-off.
std::vector<StudyPlan> default_plans(bool quick);

/// The part of a whole report's work that this model takes, about.
double share_of_work(const StudyPlan& plan);

/// Energy error over time of each method of fixed steps in double, at the run that comes nearest to this cost: the
/// largest within each of sixty spans of the time, so that a trend shows and not every swing. Throws Interrupted.
std::vector<Curve> energy_curves(const Study& study, double evaluations);

/// What the measurements were made on.
struct Circumstances {
    std::string version, commit, compiler, processor, date;
};
Circumstances circumstances();

}  // namespace steplab
