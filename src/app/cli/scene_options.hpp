#pragma once

#include "sim/run/run_description.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
}  // namespace CLI

namespace steplab {

/// One --set name=value.
struct Setting {
    std::string name, text;
};
/// Throws UsageError for texts of another form and for a parameter that is set twice.
std::vector<Setting> parse_settings(const std::vector<std::string>& texts);

/// "float" or "double". Throws UsageError.
Precision precision_of(std::string_view text);

/// The options SCENE, the same for every command and program: --model, --scene, --set, --method, --precision, --dt,
/// --from, --reverse.
/// All values are stored as text and read by our own parsers: in the C locale, with one form of message.
class SceneOptions {
public:
    /// Whether --method may be `all`; of LAMMPS there are one method and one precision.
    enum class Methods { one, one_or_all, lammps };
    /// The method and dt that are not given: fixed ones, or those that the model recommends (Opening).
    enum class Defaults { fixed, recommended };
    /// Whether dt may be negative.
    enum class Time { forward, both };
    explicit SceneOptions(Methods methods = Methods::one) : methods_(methods) {}
    explicit SceneOptions(Time time) : time_(time) {}
    explicit SceneOptions(Defaults defaults) : defaults_(defaults) {}

    /// Adds the options, and the table of models, methods and parameters at the end of the help.
    void declare(CLI::App& app);
    /// The run that the options describe, checked. Throws UsageError.
    RunDescription description() const;
    /// One run, checked, or with `all` one for each method. Each of these gets the settings that it has parameters for;
    /// whether its method accepts the scene is not checked. Throws UsageError, also for a setting that is a parameter
    /// of no model or method.
    std::vector<RunDescription> descriptions() const;
    /// True if any of the options was given.
    bool any_given() const;
    /// True if --method was given; a command may otherwise use all methods.
    bool names_method() const;
    /// True if --precision was given.
    bool names_precision() const;

private:
    RunDescription chosen_scene() const;
    StartChange start() const;
    double given_dt() const;
    void check_direction(const RunDescription& description) const;
    std::string default_text(std::string_view fixed) const;
    RunDescription with_given_method(RunDescription scene) const;

    Methods methods_ = Methods::one;
    Defaults defaults_ = Defaults::fixed;
    Time time_ = Time::forward;
    std::string model_, scene_;
    std::vector<std::string> settings_;
    std::string method_;
    std::string precision_;
    std::string dt_;
    std::string from_;
    bool reverse_ = false;
    const CLI::App* app_ = nullptr;
};

/// The options TIME: --steps or --until.
class TimeOptions {
public:
    /// What counts where neither is given: a number of steps, or before it the `until` of a scene file.
    enum class Default { steps, scene };
    explicit TimeOptions(std::uint64_t default_steps, Default given = Default::steps)
        : default_steps_(default_steps), default_(given) {}
    void declare(CLI::App& app);
    /// Whether an option sets the end.
    bool is_given() const { return !steps_.empty() || !until_.empty(); }
    /// Number of steps from the start. Throws UsageError.
    std::uint64_t steps(const RunDescription& description) const;
    /// Where the run ends: after --steps, or by run_end() at --until or the scene's end. Throws UsageError.
    RunEnd end(const RunDescription& description) const;
    /// The step or the time itself that is asked for, of frames that a file holds. Throws UsageError.
    RunEnd moment(const RunDescription& description) const;
    /// The end time: --until, the scene's end, or the steps times dt. Throws UsageError.
    double end_time(const RunDescription& description) const;
    /// The same. Throws UsageError unless it is > 0.
    double duration(const RunDescription& description) const;
    /// "4 steps of dt = 0.3 s end at t = 1.2 s, not at 1 s": where whole steps go beyond --until.
    std::optional<std::string> note(const RunDescription& description, const RunEnd& end) const;

private:
    /// The end time asked for, if one was.
    std::optional<double> until(const RunDescription& description) const;

    std::uint64_t default_steps_;
    Default default_;
    std::string steps_;
    std::string until_;
};

}  // namespace steplab
