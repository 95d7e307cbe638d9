#pragma once

#include "lab/limits/replayed_run.hpp"
#include "session/moments.hpp"
#include "session/run_samples.hpp"
#include "sim/ensemble/live_ensemble.hpp"
#include "sim/run/act.hpp"
#include "sim/run/simulation.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace steplab {

/// A run with everything that was done to it, each change with the step at which it took effect. It can be taken to any
/// of its steps, bit for bit; what lies ahead is kept until something else is done. Changes are those of SegmentBegin:
/// the first is the start.
class TimeLine {
public:
    static constexpr std::size_t usual_bytes = std::size_t{256} << 20;

    /// `bytes`: memory for moments to come back to. Throws UsageError.
    explicit TimeLine(const RunDescription& description, std::size_t bytes = usual_bytes);

    /// The run where it stands.
    const Simulation& run() const { return run_; }
    std::uint64_t step() const { return run_.step(); }
    double time() const { return run_.time(); }
    /// All changes, and those of them that have taken effect: the start at least.
    std::span<const SegmentBegin> changes() const { return changes_; }
    std::span<const SegmentBegin> past() const { return std::span(changes_).first(taken_); }
    /// The momentum with which it began [kg m/s].
    Vec3 start_momentum() const { return start_momentum_; }
    /// The largest step that it was at, on this branch, and its time.
    std::uint64_t reached() const { return reached_; }
    double reached_time() const { return reached_time_; }
    /// The run stands at the last step that it can get to.
    bool is_over() const { return run_.divergence().has_value(); }

    /// Takes steps, and on the way what lies ahead. Throws Interrupted.
    void advance(std::uint64_t steps);
    /// So many steps back, to the start at most. Moments are kept on the way, so that going on back costs little.
    void step_back(std::uint64_t steps);
    /// Takes it to where it can go on to this step by advance(): the nearest moment before it that is kept, or stays
    /// where that is nearer.
    void turn_to(std::uint64_t step);
    /// The same, also where the run ended on the way to a later step: whether it has ended then depends on the step
    /// alone, not on where it was before.
    void turn_to_any(std::uint64_t step);
    /// True if the run ended, and may not have ended yet at this step.
    bool ended_beyond(std::uint64_t step) const { return is_over() && step < asked_; }
    /// Where it stands at the last good step of a run that is known to have ended there, it ends again: there is no
    /// telling by the moment alone. Throws Interrupted.
    void find_end();
    /// Forgets what lies ahead, as if it had not been there.
    void forget_ahead() { cut(run_.step(), taken_); }
    /// Memory for moments from now on.
    void allow(std::size_t bytes) { moments_.allow(bytes); }
    /// Gives its memory back; what is gone to afterwards is computed from the start.
    void forget_moments() { moments_.clear(); }
    /// Keeps the present moment, unless one is near.
    void keep_moment();

    /// The step at which it is to be shown at a time (step_at()), by the changes up to then.
    std::uint64_t step_at(double time) const;
    /// The time of a step, by the changes up to then.
    double time_of(std::uint64_t step) const;

    /// A way that the run went and left: all its changes from the start on, moments behind those that it shares with
    /// the present one, and how far it went.
    struct Branch {
        std::vector<SegmentBegin> changes;
        std::vector<Moments::Moment> moments;
        std::uint64_t fork = 0;  ///< the step where it left the way that followed
        std::uint64_t reached = 0;
        double reached_time = 0;
        std::vector<Sample> samples = {};  ///< behind the fork
        TrackedParticles followed = {};    ///< the particles that they tell of
        bool ended = false;                ///< it could get no farther than it went
    };

    /// From here on with another method, dt, precision or live parameter. What lay ahead is returned, if anything did.
    /// Throws UsageError, nothing changed, also where the description restarts the run (restarts()).
    /// One that follows another of the same settings at once takes its place, if it may. One of a slider that is `held`
    /// since the change before is taken back with that.
    std::optional<Branch> change(const RunDescription& description, bool may_replace = true, bool held = false);
    /// Does this to particles, which has to do something (steplab::acts()).
    std::optional<Branch> act(const Act& act);
    /// Takes back the last change that has taken effect, if it is not the start, or all tugs of a hold: the run then
    /// stands before them.
    std::optional<Branch> undo();
    /// Forgets all changes but the first so many, and what lies behind the first of them; the run then stands at a
    /// moment before that, if it was beyond.
    void keep_changes(std::size_t count);
    /// Goes over to that way: the run stands where the two part, behind the branch's change there. What is left is
    /// returned.
    std::optional<Branch> take(Branch branch);

    /// Whether samples are taken on its way from now on, and what particles they tell of: those that there are.
    void sample(bool on, TrackedParticles particles = {});
    /// The same as another one.
    void sample_as(const TimeLine& other);
    /// True if samples are taken, and one up to this step is not known.
    bool lacks_samples(std::uint64_t until) const { return samples_ && samples_->lack(until); }
    /// Takes over those of a line that goes the same way, up to the last step that this one was at: those that are not
    /// known here.
    void take_samples(const TimeLine& same);
    std::span<const Sample> samples() const { return samples_ ? samples_->all() : std::span<const Sample>(); }
    /// Forgets those behind this step.
    void forget_samples_behind(std::uint64_t step);
    /// One that stands at the start and goes the same way, taking the same samples.
    TimeLine again(std::size_t bytes) const;
    /// Of this branch, also of what lies ahead. Empty if none are taken.
    void put_samples_into(SampleSeries& series) const;

    std::size_t bytes() const { return moments_.bytes(); }
    /// The moments to come back to that are kept up to where it stands.
    std::vector<ReplayedRun::Moment> kept_moments() const;
    /// Seconds that its steps took lately, per simulated second; none before there were some.
    std::optional<double> cost() const;

private:
    void take_steps(std::uint64_t steps);
    void take_effect(SegmentBegin& change);
    void take_due_changes();
    void note_reached();
    void settle();
    void turn_to(std::uint64_t step, bool can_go_on);
    void go_back_to(const Moments::Moment* moment);
    void stand_at(std::uint64_t step, std::size_t changes);
    std::optional<Branch> cut(std::uint64_t step, std::size_t kept);
    std::optional<Branch> append(SegmentBegin change, bool may_replace = true);
    bool replaces_last(const SegmentBegin& change) const;

    Simulation run_;
    Moments moments_;
    std::vector<SegmentBegin> changes_;
    std::size_t taken_ = 1;    ///< how many have taken effect
    std::uint64_t asked_ = 0;  ///< the step that it was last taken to; where the run ended, it was found on the way
    std::uint64_t reached_ = 0;
    double reached_time_ = 0;
    bool ended_ = false;  ///< the step reached is the last good one
    Vec3 start_momentum_;
    std::optional<RunSamples> samples_;
    double spent_ = 0, simulated_ = 0;  ///< seconds; what is long past fades
};

}  // namespace steplab
