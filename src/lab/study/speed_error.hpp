#pragma once

#include "lab/study/measurement.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace steplab {

/// A scene, a time, and the runs of it that are to be measured.
struct StudyPlan {
    RunDescription scene;  ///< its method, precision and dt are ignored
    double time = 0;
    std::vector<std::string> methods;
    std::map<std::string, double> method_settings;  ///< parameters for the methods that have them
    std::vector<Precision> precisions;
    double most_seconds_a_run = 0.02;  ///< on its share of the machine; a series ends before a run takes longer,
                                       ///< and a first one that takes 30 times as long is given up
    std::uint64_t most_steps_a_run = 1'000'000'000;  ///< a series also ends before a run takes more steps
    double ratio = 2;                                ///< of neighbouring dt in a series, > 1
    double reference_effort = 1;                     ///< part of the usual one
    double least_reference_gain = 0;                 ///< ReferenceEffort's
    bool brief = false;                              ///< what takes long and shows little is left out
    int rounds = 3;                                  ///< number of interleaved rounds in which each run is timed
};

/// Called between runs, and in them where that is said, with the fraction of the work that is done, 0 .. 1, by any
/// thread, but one at a time; may throw to end it.
using StudyProgress = std::function<void(double)>;

/// A series that ended because its next run would have taken too long, not because accuracy no longer improved.
struct CutSeries {
    std::string method;
    Precision precision = Precision::double_;
};

/// The measurements of one method in one precision.
struct MeasuredSeries {
    std::vector<Measurement> runs;
    bool cut = false;  ///< ended only by time
};

/// The progress of measuring a plan, sufficient to continue from there.
struct SeriesState {
    std::vector<Measurement> runs;
    std::vector<CutSeries> cut;
    std::size_t series = 0;  ///< number of series, in the plan's order, that are complete in `runs`
    std::map<std::size_t, MeasuredSeries>
        ahead;  ///< series that are complete, by position, but after an incomplete one
    bool timed = false;
};

/// Measures every method and precision of the plan over a series of decreasing dt, until rounding or the error of the
/// reference dominates; adaptive methods over a series of tolerances; in parallel on all processors. All runs that did
/// not diverge are then timed, one at a time and in interleaved rounds, so that other load of the machine affects all
/// of them equally, and the minimum of each is taken.
std::vector<Measurement> measure_series(const StudyPlan& plan, const Reference& reference,
                                        const StudyProgress& progress);

/// The same, continuing from `state`; `save` is called whenever there is more of it to save.
void continue_series(const StudyPlan& plan, const Reference& reference, SeriesState& state,
                     const std::function<void()>& save, const StudyProgress& progress);

/// The reference solution for the runs of a plan. If it is a run, its error need not be below `error` spacings of the
/// scene, which saves time; progress: ReferenceEffort's.
Reference reference_for(const StudyPlan& plan, double error = 0,
                        const std::function<void(int run, double part)>& progress = nullptr);

/// The run of this method with this many steps over the time: dt = time / steps.
RunDescription run_over(const StudyPlan& plan, const std::string& method, Precision precision, std::uint64_t steps);

/// Whether a method is measured over a series of dt, of tolerances, or (gauss-16) of both.
bool takes_dt(const std::string& method);
bool takes_tolerance(const std::string& method);

/// The scene's largest angular frequency, or one for which a tenth of the time is a quarter of its period. Expensive
/// for a scene of many particles. Throws UsageError (check_stiffness()).
double frequency(const StudyPlan& plan);

/// Number of steps at the method's largest reasonable dt: just below the stability limit if there is one.
std::uint64_t fewest_steps(const StudyPlan& plan, const std::string& method, double frequency);

/// The methods of the plan that can run its scene.
std::vector<std::string> possible_methods(const StudyPlan& plan);

/// The largest memory that a run of any of them takes, in bytes.
double most_bytes(const StudyPlan& plan);

/// Times these runs in interleaved rounds and stores the minimum of each.
void time_interleaved(std::vector<Measurement>& runs, int rounds, const StudyProgress& progress);

}  // namespace steplab
