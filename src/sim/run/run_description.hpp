#pragma once

#include "core/entry.hpp"
#include "core/precision.hpp"
#include "models/model.hpp"
#include "models/scene/starting_values.hpp"
#include "models/scene_origin.hpp"
#include "sim/run/alterations.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace steplab {

/// The time step dt of a run: its range, default and description, the same for the command line, the window and ranges
/// of an ensemble.
inline constexpr ParameterInfo dt_parameter{
    .name = "dt",
    .unit = "s",
    .minimum_included = false,
    .default_value = 0.1,
    .what = "time step; for a method that chooses its own steps, the time between two frames",
    .slider_low = 1e-4,
    .slider_high = 10,
    .slider_logarithmic = true};

/// The mass of a particle that is altered.
inline constexpr ParameterInfo altered_mass{.name = "mass",
                                            .unit = "kg",
                                            .minimum_included = false,
                                            .default_value = 1,
                                            .what = "mass of the selected particles",
                                            .slider_low = 0.01,
                                            .slider_high = 100,
                                            .slider_logarithmic = true};

/// What is to be computed: scene, method, precision and dt. Two equal ones give the same bits, step for step.
struct RunDescription {
    std::string model;        ///< the id of a model of the catalogue, or the name of a scene file
    SceneOrigin origin = {};  ///< of a scene file
    ParameterValues scene;
    std::string method;
    ParameterValues method_parameters;
    Precision precision = Precision::double_;
    double dt = dt_parameter.default_value;
    StartChange start = {};        ///< of the scene
    Alterations alterations = {};  ///< of single particles of the scene

    friend bool operator==(const RunDescription&, const RunDescription&) = default;
};

/// The model of the catalogue, or that of the scene file, with its alterations. Throws UsageError if an id is unknown.
const Model& model_of(const RunDescription& description);
SceneFacts facts_of(const RunDescription& description);

/// Every parameter at its default. Throws UsageError, naming the known ids, if an id is unknown.
RunDescription describe(std::string_view model = "mesh", std::string_view method = "rk4");

/// A description of the scene of these files, as it opens without options: parameters, method, dt, precision.
RunDescription describe(SceneOrigin origin);

/// The same description with another model or method, whose parameters start at their defaults.
RunDescription with_model(RunDescription description, std::string_view model);
RunDescription with_method(RunDescription description, std::string_view method);

/// The same description without alterations of particles that its scene does not have, as its parameters were changed.
RunDescription without_missing_alterations(RunDescription description);
/// The same description with alterations of these particles besides those that it has.
RunDescription with_alterations(RunDescription description, std::span<const Alteration> alterations);

/// Sets a parameter of the model or of the method, whichever has it. Throws UsageError naming the known ones.
void set_parameter(RunDescription& description, std::string_view name, std::string_view text);

/// Throws UsageError unless dt is finite, > 0 and not lost in the precision (of a method that does not choose its steps
/// it may be < 0: time runs backward), every parameter fits into the precision,
/// the particles fit into this machine's memory (the message names the bytes needed) and the method can run the scene.
void check(const RunDescription& description);
/// The part of check() that makes no scene: all but what method and memory say of its interactions.
void check_values(const RunDescription& description);

/// The description with dt and the scene's parameters as its precision holds them. Throws UsageError (check()).
RunDescription as_held(RunDescription description);

/// "--model chain --set n=20 --method rk4 --precision double --dt 0.1": what differs from a default is named, so that
/// the command line gives the same description back, but for alterations: a scene file says them.
std::string command_line(const RunDescription& description);

/// The largest stable dt of the method on this scene as linear theory gives it, drag included: that of the fastest mode
/// and of motion without any spring. limit: infinity = stable at any dt; 0 = unstable at any dt. Nothing if the scene's
/// omega_max is not known, or beyond what the theory is asked for. With drag it takes some milliseconds.
struct StabilityLimit {
    double limit = 0;
    double omega_max = 0;
};
std::optional<StabilityLimit> stability_limit(const RunDescription& description);
/// In 1/s: up to here double holds a frequency's square, and what a step makes of it.
inline constexpr double largest_frequency = 1e150;

/// The largest angular frequency of the scene at its start; of pairs, for which that is not known, sqrt(2 k / m) of
/// one alone. 0 if nothing oscillates.
double fastest_frequency(const RunDescription& description);

/// True if the scene takes energy out of the motion: the energy then changes without any error.
bool has_drag(const RunDescription& description);
/// The order of a method on a scene, drag and damping considered.
int order_of(const MethodInfo& method, const SceneFacts& scene);
int order_of(const RunDescription& description);

/// True if it has drag, without dashpots, and its work is known: the method counts it beside its steps, or, where drag
/// is the same for all particles, its steps are of parts that are known (drag_work.hpp).
bool integrates_drag_work(const RunDescription& description);
/// The same of a run that counts it already, and goes on where there may be no drag for the time being.
bool keeps_drag_work(const RunDescription& description);

/// True if the method chooses its own steps within dt by its tolerance; false if every step is dt.
bool chooses_its_steps(const RunDescription& description);

/// ceil(duration / dt * (1 - 1e-12)): the steps that reach `duration`, which has the sign of dt.
std::uint64_t steps_until(double duration, double dt);

/// Where a run ends: after so many steps, the last of which ends at `time` where that is given.
struct RunEnd {
    std::uint64_t step = 0;
    std::optional<double> time = {};
};

/// The end of a run that is to reach `until`, which has the sign of dt: a method that chooses its own steps ends there,
/// any other at the end of the step of dt that reaches it.
RunEnd run_end(const RunDescription& description, double until);

}  // namespace steplab
