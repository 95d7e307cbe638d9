#pragma once

#include "core/frame.hpp"
#include "models/plan.hpp"
#include "sim/ensemble/ensemble_stepper.hpp"
#include "sim/ensemble/live_ensemble_options.hpp"
#include "sim/run/act.hpp"
#include "sim/run/execution.hpp"
#include "sim/run/run_description.hpp"
#include "sim/steppers/stepper.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace steplab {

/// Where a segment of a run began, and how. The segments of a run so far hold all that was done to it.
struct SegmentBegin {
    std::uint64_t step = 0;
    RunDescription description;
    std::optional<Act> act = {};  ///< just before
    double time = 0;              ///< of the step
    bool held = false;            ///< it goes on with the change before it, by a slider that is held
    friend bool operator==(const SegmentBegin&, const SegmentBegin&) = default;
};

/// Runs that go beside a run, step for step, and to which all that is done to it happens too. Each has the bits that it
/// has alone. Those that differ only in numbers are computed in SIMD lanes where their
/// method and scene allow it.
class LiveEnsemble {
public:
    /// What a member (counted from 0) computes while the run computes `description`.
    using Variation = std::function<RunDescription(const RunDescription& description, std::size_t member)>;

    /// No more particles than this in all of them.
    static constexpr std::size_t most_particles = std::size_t{1} << 20;

    LiveEnsemble(std::size_t runs, Variation variation, const Execution& execution = {});

    /// Goes to this step of the run that consists of these segments, the first of which begins at step 0; back as well,
    /// by stepping again; from the start, where segments have become others. Stops on the way if `enough` says so;
    /// false if it is not there yet. Throws UsageError if the runs cannot be computed.
    bool go_to(
        std::uint64_t step, std::span<const SegmentBegin> segments,
        const std::function<bool()>& enough = [] { return false; });
    /// True if they are there.
    bool are_at(std::uint64_t step, std::span<const SegmentBegin> segments) const;
    std::uint64_t step() const { return step_; }
    /// Number of members that are computed in SIMD lanes.
    std::size_t in_lanes() const;

    /// Puts the particles of all of them beside those of the run, which stands at the same step.
    EnsembleSpread observe(Frame& run);

private:
    struct Member {
        RunDescription held;
        Plan scene;         ///< its start is that of the segment
        bool lost = false;  ///< some of its numbers are not finite there
    };
    /// LiveEnsemble that are stepped together, in lanes; or one alone; or a lost one, by nothing.
    struct Batch {
        std::size_t first = 0, count = 1;
        std::unique_ptr<EnsembleStepper> lanes;
        std::unique_ptr<Stepper> alone;

        bool finite(std::size_t member) const;
        void synchronised(std::size_t member, State<double>& out) const;
    };

    bool begin(const RunDescription& description, const std::function<bool()>& enough);
    void begin_last_again(std::span<const SegmentBegin> segments);
    bool are_in(std::span<const SegmentBegin> segments) const;
    void check_memory(const RunDescription& description) const;
    void go_on(const SegmentBegin& segment);
    void make_batches();
    Batch make_batch(std::span<const StepperSetup> setups, std::size_t first) const;
    void continue_in(const SegmentBegin& segment, std::size_t member, const Batch& batch);
    void take(std::uint64_t steps);
    std::uint64_t steps_of_a_piece() const;

    std::size_t runs_;
    Variation variation_;
    Execution execution_;
    std::vector<Member> members_;
    std::vector<Batch> batches_;
    std::vector<SegmentBegin> segments_;  ///< up to the one they are in
    std::uint64_t step_ = 0;
    State<double> seen_;  ///< of one of them; kept for its memory
};

}  // namespace steplab
