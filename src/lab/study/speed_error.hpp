#pragma once

#include "lab/study/measurement.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace steplab {

/// A scene over a time, and which runs of it are to be measured.
struct StudyPlan {
    RunDescription scene;  ///< its method, precision and dt do not matter
    double time = 0;
    std::vector<std::string> methods;
    std::map<std::string, double> method_settings;  ///< parameters of methods; those that have them take them
    std::vector<Precision> precisions;
    double most_seconds_a_run = 0.02;  ///< by its share of the machine; a series ends before a run takes longer
    std::uint64_t most_steps_a_run = 1'000'000'000;  ///< nor of more steps
    double ratio = 2;                                ///< of neighbouring dt in a series, > 1
    int rounds = 3;                                  ///< each run is timed in so many interleaved rounds
};

/// Called between runs with the part of the work that is done, 0 .. 1, by any thread but one at a time; may throw to
/// end it.
using StudyProgress = std::function<void(double)>;

/// A series that ended because its next run would have taken too long, not because it gained no more.
struct CutSeries {
    std::string method;
    Precision precision = Precision::double_;
};

/// What was measured of one method in one precision.
struct MeasuredSeries {
    std::vector<Measurement> runs;
    bool cut = false;  ///< by time, and by that only
};

/// How far the measuring of a plan is: enough to go on from there.
struct SeriesState {
    std::vector<Measurement> runs;
    std::vector<CutSeries> cut;
    std::size_t series = 0;  ///< of a method in a precision, in the plan's order, that are complete in `runs`
    std::map<std::size_t, MeasuredSeries> ahead;  ///< complete too, by their place, but behind one that is not
    bool timed = false;
};

/// Measures every method and precision of the plan over a series of dt, largest first, down to where rounding or the
/// reference ends the gain; adaptive methods over a series of tolerances: side by side on all processors. All runs that
/// did not diverge are then timed, one at a time and in interleaved rounds, so that a disturbance of the machine hits
/// all alike, and the least of each is kept.
std::vector<Measurement> measure_series(const StudyPlan& plan, const Reference& reference,
                                        const StudyProgress& progress);

/// The same from where `state` is; `keep` is called when there is more of it to keep.
void go_on_with_series(const StudyPlan& plan, const Reference& reference, SeriesState& state,
                       const std::function<void()>& keep, const StudyProgress& progress);

/// What the runs of a plan are judged by: the scene at its time. Where that is a run, it need not be better than to
/// `error` spacings of the scene, and takes less time for it; progress: ReferenceEffort's.
Reference reference_for(const StudyPlan& plan, double error = 0,
                        const std::function<void(int run, double part)>& progress = nullptr);

/// The run of this method with this many steps over the time: dt = time / steps.
RunDescription run_over(const StudyPlan& plan, const std::string& method, Precision precision, std::uint64_t steps);

/// Whether a method is asked over a series of dt, of tolerances, or (gauss-16) over both.
bool takes_dt(const std::string& method);
bool takes_tolerance(const std::string& method);

/// The scene's largest angular frequency, or one that lets a tenth of the time be a quarter of its period. Dear for a
/// scene of many particles.
double frequency(const StudyPlan& plan);

/// Steps over the time at the method's largest sensible dt: just below the stability limit where there is one.
std::uint64_t fewest_steps(const StudyPlan& plan, const std::string& method, double frequency);

/// The methods of the plan that can run its scene: others refuse it by name.
std::vector<std::string> possible_methods(const StudyPlan& plan);

/// Memory that a run of any of them takes.
double dearest_bytes(const StudyPlan& plan);

/// Times these runs in interleaved rounds and stores the least of each.
void time_interleaved(std::vector<Measurement>& runs, int rounds, const StudyProgress& progress);

}  // namespace steplab
