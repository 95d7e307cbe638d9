#pragma once

#include "lab/limits/limits.hpp"
#include "lab/study/speed_error.hpp"
#include "plot/plot.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace steplab {

/// One scene of a report, measured.
struct Study {
    StudyPlan plan;
    std::string reference;       ///< the reference solution, in words
    double reference_error = 0;  ///< its estimated error; no smaller error is reported
    std::vector<Measurement> runs;
    std::vector<CutSeries> cut;
    std::vector<Limit> limits;  ///< stability limits of the plan's methods, in the plan's first precision
};

/// The scenes of a report by default: the models at their defaults over a characteristic time; morse with spacing 0.3,
/// because at its default particles pass through each other, where methods lose their order.
std::vector<StudyPlan> default_plans(bool quick);

/// The plan that a report has for a scene: all methods in both precisions.
StudyPlan plan_for(const RunDescription& scene, double time, bool quick);

/// The time, up to that of the plan, over which runs of this scene take as much work as a quick report has room for:
/// the same on every machine. Where methods solve equations of many pairs it takes minutes all the same. Throws
/// UsageError (check_stiffness()).
double quick_time(const StudyPlan& plan);

/// A model without a scene in reports, and why.
struct LeftOut {
    std::string_view model, reason;
};
std::span<const LeftOut> left_out_of_plans();
/// "crystal (why)".
std::string left_out_text();

/// Approximate share of this model in the work of a whole report.
double share_of_work(const StudyPlan& plan);

/// Energy error over time of each method with fixed steps in double, for the run closest to this cost: the maximum in
/// each of sixty intervals of the time, which shows the trend rather than every oscillation. Throws Interrupted.
std::vector<plot::Curve> energy_curves(const Study& study, double evaluations);

/// Program and machine of the measurements.
struct Circumstances {
    std::string version, commit, compiler, processor, date;
};
Circumstances circumstances();

}  // namespace steplab
