#pragma once

#include "core/diagnostics.hpp"
#include "core/frame.hpp"
#include "session/run_samples.hpp"
#include "session/spread_samples.hpp"
#include "sim/ensemble/live_ensemble_options.hpp"
#include "sim/run/simulation.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace steplab {

/// How fast a playing run goes: simulated seconds a second, or as fast as the machine can.
struct Rate {
    bool as_fast_as_possible = false;
    double seconds_per_second = 1;
    friend bool operator==(const Rate&, const Rate&) = default;
};

/// One particle at one time against the exact solution, for plots and read-outs.
struct Tracked {
    std::size_t particle = 0;
    Vec3 displacement;  ///< from its rest position
    std::optional<Vec3> exact_displacement = {};
    std::optional<ExactMotion> exact = {};
};

/// An energy that is impossible, before the check that decides whether the run diverged.
struct Doubt {
    std::uint64_t step = 0;   ///< where it was found
    double time = 0;          ///< there
    std::uint64_t now = 0;    ///< the step that the run has got to
    std::uint64_t check = 0;  ///< the step that decides
    friend bool operator==(const Doubt&, const Doubt&) = default;
};

/// What the interface sees of a run: one consistent moment of it and how it is doing. Plain data, made by the worker
/// or, for a still picture, by view_of().
struct RunView {
    RunDescription description;  ///< as it is being computed
    /// Which colour, line and outline are its: of no other run of its session, and as long as it is one of them.
    std::size_t swatch = 0;
    Frame frame;
    Diagnostics diagnostics;
    std::optional<Tracked> tracked;
    std::vector<Tracked> also_tracked;  ///< others that samples tell of, in their order
    SampleSeries series;                ///< of the whole way of the run, if samples are wanted
    SpreadSeries spread;                ///< of the ensemble on that way
    /// E - E0, the work of drag counted in; none where drag takes energy and its work is not counted.
    std::optional<double> energy_error;
    std::uint64_t evaluations = 0;  ///< of the force since the start
    std::optional<Divergence> divergence;
    std::optional<StabilityLimit> limit;
    std::optional<Resolution> resolution;  ///< of the fastest oscillation
    SceneFacts facts;
    Conservation conservation;
    std::shared_ptr<const MethodRefusals> refusals;  ///< null: not known, as of a file
    std::vector<std::string> notes;                  ///< of rounding (notes.hpp)
    bool has_exact = false;
    std::string why_not_exact;  ///< why the position error is not known; empty if it is
    bool playing = false;
    std::optional<std::uint64_t> goal;  ///< the step that the run is on its way to
    bool can_step_back = false;
    Rate rate;
    double segment_start = 0;         ///< time the current method, dt and parameters began to hold
    double smooth_since = 0;          ///< time from which on particles were at no other place from one step to the next
    std::uint64_t baseline_step = 0;  ///< step from which the energy error counts
    std::uint64_t run = 0;            ///< grows with every restart or change of scene: plots start again
    double dt = 0.1;                  ///< as the precision holds it
    double opening_dt = 0.1;          ///< that the model recommends for this scene
    LiveEnsembleOptions ensemble;     ///< beside the run; it is in the frame unless it is still being computed
    EnsembleSpread ensemble_spread;
    /// Measured; none in still pictures.
    std::optional<double> steps_per_second;
    std::optional<double> evaluations_per_second;
    std::optional<double> cost;  ///< seconds of computing per simulated second
    std::string error;           ///< message of a command that was refused; empty if none
    std::uint64_t failures = 0;  ///< how many commands were refused so far
};

/// Fills in everything of `view` that the simulation knows, reusing its memory, and about tracked particles.
void observe(const Simulation& simulation, const TrackedParticles& tracked, RunView& view);

/// Puts what is known of tracked particles into the view of a run of so many; numbers beyond them are left out.
void tell_of(const TrackedParticles& tracked, std::size_t count,
             const std::function<Tracked(std::size_t particle)>& known, RunView& view);

/// What plots show of the moment of a view. Without velocities, that of the particle is 0.
Sample sample_of(const RunView& view);

/// The particle to track until another one is picked: the kicked one, else the bullet, else the last.
std::size_t first_followed(const Shape& shape);

/// The view of a run that stands still.
RunView view_of(const Simulation& simulation, std::optional<std::size_t> tracked = std::nullopt);
RunView view_of(const Simulation& simulation, const TrackedParticles& tracked);

}  // namespace steplab
