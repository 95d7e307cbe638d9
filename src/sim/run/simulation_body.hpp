#pragma once

#include "core/sum.hpp"
#include "sim/run/drag_work.hpp"
#include "sim/run/motion_from_start.hpp"
#include "sim/run/segment.hpp"
#include "sim/run/simulation.hpp"

#include <any>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>

namespace steplab {

/// Steps between two checks of the energy, which is as costly as some evaluations.
inline constexpr std::uint64_t steps_between_checks = 256;

/// Where a run is and what it is measured against; with the description and the internal state it is all of a run.
struct Course {
    std::uint64_t step = 0;
    std::uint64_t segment_number = 0;
    std::shared_ptr<const int> segment_identity = std::make_shared<const int>();  // also among other runs
    std::uint64_t segment_step = 0;                                               // step at which the segment began
    double segment_time = 0;
    std::uint64_t evaluations_before = 0;  // of the segments before
    Energy baseline;
    std::uint64_t baseline_step = 0;
    /// What the motion is to be: null once the scene was changed under way.
    std::shared_ptr<const MotionFromStart> motion;
    /// What drag has taken since the baseline, in this segment only as far as the stepper does not count it; none if it
    /// is not counted.
    std::optional<CompensatedSum> drag_work;
    std::optional<CompensatedSum> segment_drag_work;  // where the segment began
    bool shortened = false;                           // its one step ends at the time asked for, before dt
};

struct Simulation::Snapshot::Content {
    RunDescription description;
    Start start;  ///< of the segment
    double dt;    ///< of its steps, as its precision holds it
    Course course;
    std::any internal;
    std::size_t bytes;
};

/// A run in progress: its present segment, where it stands, and what was measured there.
struct Simulation::Body : Course {
    Segment segment;
    mutable std::shared_ptr<const Shape> shape;

    std::uint64_t newest_segment = 0;  // the largest number that one had, also of moments that the run has left
    std::any kept;                     // internal state at a step known to be good; none of large scenes
    std::uint64_t kept_step = 0;
    std::optional<CompensatedSum> kept_drag_work;  // there
    std::optional<Divergence> divergence;
    std::optional<RunEnd> end;     // of a run whose last step ends before dt
    std::optional<DragWork> drag;  // where the stepper does not count it

    Body(const RunDescription& description, const Execution& execution);

    double time_at(std::uint64_t at) const {
        if (end && at == end->step) return *end->time;
        return segment_time + static_cast<double>(at - segment_step) * segment.held.dt;
    }

    // What is read of the present step, computed when it is asked for.
    const State<double>& state();
    void emit(const PortionSink& sink);
    const Energy& energy();
    /// Measures the energy, and shows portions and pieces of particles on the way: those of several parts of the scene
    /// at the same time.
    void measure(const PortionSink& portions, const PieceSink& pieces);
    const ExactSolution* exact() const { return motion ? motion->solution().get() : nullptr; }

    bool energy_is_good();
    /// E - E0, the work of drag added where it is counted.
    double energy_error() { return energy().total() - baseline.total() + drag_taken().value_or(0); }
    std::optional<double> drag_taken();
    bool is_good() { return segment.stepper->finite() && energy_is_good(); }

    void keep();
    void go_back_to_kept();

    std::uint64_t steps_to_check() const { return steps_between_checks - (step - segment_step) % steps_between_checks; }
    std::uint64_t steps_to_shortened() const {
        const bool ahead = end && !shortened && step < end->step;
        return ahead ? end->step - 1 - step : std::numeric_limits<std::uint64_t>::max();
    }
    void shorten_last_step();
    void moved() {
        state_known = energy_known = settled = false;
        counted.reset();
    }

    void advance(std::uint64_t steps);
    void settle();
    void conclude();
    void take(std::uint64_t steps);
    void take_counting(std::uint64_t steps);
    bool count_drag_work();
    void segment_begun();
    void prepare_drag();
    void act(const Act& act);
    void go_back_to_last_good();
    void diverged();
    /// What a new segment changes besides the description.
    struct GoingOn {
        bool new_baseline = false;      // energy came from outside
        bool another_motion = false;    // than the one that it was to be
        std::optional<double> dt = {};  // of its steps, instead of the description's
    };
    void go_on(const RunDescription& description, const GoingOn& how);
    void leave_segment();
    void begin_segment(const GoingOn& how, std::shared_ptr<const MotionFromStart> other);

private:
    State<double> observed_state;
    Energy measured;
    bool state_known = false, energy_known = false;  // of the present step
    bool settled = false;                            // its numbers are finite
    std::optional<double> counted;                   // by the stepper
};

}  // namespace steplab
