#pragma once

#include "session/run_view.hpp"
#include "sim/ensemble/live_ensemble_options.hpp"
#include "sim/run/act.hpp"
#include "sim/run/run_description.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>

namespace steplab {

/// From one step to a later one.
struct StepRange {
    std::uint64_t first = 0, last = 0;
    friend bool operator==(const StepRange&, const StepRange&) = default;
};

/// What a person can do in a session, as data.
namespace event {

struct Play {
    bool on = true;
    bool backwards = false;  ///< through the moments that the leading run was at
};
/// While the session plays, the leading run goes from the last of these steps to the first, or the other way round.
struct Loop {
    std::optional<StepRange> steps;  ///< none: no longer
};
/// Steps of the leading run on, or back where negative; the session then stands.
struct Step {
    std::int64_t steps = 1;
};
/// To a step of the leading run as fast as it can; playing goes on there.
struct Seek {
    std::uint64_t step = 0;
};
/// To a time in the same way: to the step at which the leading run is shown then.
struct SeekTime {
    double time = 0;
};
/// From the start again, with the present settings.
struct Restart {};
/// A run alone from its start, in place of all runs that there are.
struct Begin {
    RunDescription description;
};
/// The leading run goes on with another method, dt, precision or live parameter; or the session begins again where the
/// description restarts it, with the runs beside it.
struct Change {
    RunDescription description;
    bool held = false;  ///< of a slider that is held since the change before: both are taken back as one
};
struct SetRate {
    Rate rate;
};
/// The particle that views tell about.
struct Track {
    std::optional<std::size_t> particle;
};
/// Others that samples tell of besides it, of which there are up to Sample::most_particles in all.
struct AlsoTrack {
    std::vector<std::size_t> particles;
};
/// Something is done to particles of every run.
struct Do {
    Act act;
};
/// Takes back the last change, act or restart; and does it again.
struct Undo {};
struct Redo {};
/// Which runs of an ensemble go beside the leading run, from its start on.
struct ShowEnsemble {
    LiveEnsembleOptions ensemble;
};
/// Whether views hold the forces on the particles.
struct ShowForces {
    bool on = true;
};
/// The factor by which displacements from the rest positions are drawn, > 0.
struct Magnify {
    double factor = 1;
};
/// Whether views hold how far the runs are from the motion of their scene, also where one run is alone.
struct ShowErrors {
    bool on = true;
};
/// Whether views hold samples of the runs for plots; those of what was gone through meanwhile are missing.
struct ShowSamples {
    bool on = true;
};
/// Whether what accuracy costs on the scene is scanned.
struct ShowCosts {
    bool on = true;
};
/// Another run of the same scene beside the leading one, from its start on.
struct AddRun {
    RunDescription description;
    bool opening = false;  ///< of the runs that a session opens with, which is nothing to take back
};
/// Another description for a run beside the leading one (1 or more), which begins again with it.
struct ChangeRun {
    std::size_t run = 1;
    RunDescription description;
};
/// While on, each run beside the leading one has the dt or tolerance at which it costs as many force evaluations per
/// simulated second.
struct EqualCost {
    bool on = true;
};
/// Of the leading run (0), the next one takes the lead.
struct RemoveRun {
    std::size_t run = 1;
};
/// A run takes the lead.
struct Lead {
    std::size_t run = 1;
};
/// Marks the present moment; at a marked one, takes the mark away.
struct Bookmark {
    std::string text;
};
/// Goes over to a way that was left.
struct TakeBranch {
    std::size_t branch = 0;
};

}  // namespace event

using Event = std::variant<event::Play, event::Loop, event::Step, event::Seek, event::SeekTime, event::Restart,
                           event::Begin, event::Change, event::SetRate, event::Track, event::AlsoTrack, event::Do,
                           event::Undo, event::Redo, event::ShowEnsemble, event::ShowForces, event::Magnify,
                           event::ShowErrors, event::ShowSamples, event::ShowCosts, event::AddRun, event::ChangeRun,
                           event::EqualCost, event::RemoveRun, event::Lead, event::Bookmark, event::TakeBranch>;

/// True if it is one of these.
template <class... Kinds>
bool is_any(const Event& event) {
    return (std::holds_alternative<Kinds>(event) || ...);
}

/// Throws UsageError if a loop does not end at a later step than it begins.
void check(const event::Loop& loop);

/// True if an event changes what the runs of a session compute or where they stand; the others change what is shown.
inline bool changes_runs(const Event& event) {
    return !is_any<event::SetRate, event::Loop, event::Track, event::AlsoTrack, event::ShowEnsemble, event::ShowForces,
                   event::Magnify, event::ShowErrors, event::ShowSamples, event::ShowCosts>(event);
}

/// True if a recording has it: what changes the runs, and how fast they play.
inline bool is_recorded(const Event& event) { return changes_runs(event) || is_any<event::SetRate>(event); }

/// True if the second event leaves nothing of the first, which it follows: a slider or the time line is dragged.
bool overtakes(const Event& earlier, const Event& later);

}  // namespace steplab
