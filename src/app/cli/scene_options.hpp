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
/// Throws UsageError for what is not of that form or names a parameter twice.
std::vector<Setting> parse_settings(const std::vector<std::string>& texts);

/// "float" or "double". Throws UsageError.
Precision precision_of(std::string_view text);

/// The options SCENE, the same for every command and program: --model, --set, --method, --precision, --dt.
/// Everything is taken as text and read by our own parsers: in the C locale, whole, with one kind of message.
class SceneOptions {
public:
    /// Whether --method may be `all`.
    enum class Methods { one, one_or_all };
    explicit SceneOptions(Methods methods = Methods::one) : methods_(methods) {}

    /// Adds the options, and the table of models, methods and parameters at the foot of the help.
    void declare(CLI::App& app);
    /// The run they describe, checked. Throws UsageError.
    RunDescription description() const;
    /// The runs they describe, checked: one, or one for each method, which takes those of the settings that are its
    /// own; a method among all that refuses the scene is left to who runs it. Throws UsageError, also for a setting
    /// that is nobody's.
    std::vector<RunDescription> descriptions() const;
    /// Whether the command line names a method, a precision: where none is, a command may take all.
    bool names_method() const;
    bool names_precision() const;

private:
    Methods methods_;
    std::string model_;
    std::vector<std::string> settings_;
    std::string method_;
    std::string precision_;
    std::string dt_;
    const CLI::App* app_ = nullptr;
};

/// The options TIME: --steps or --until.
class TimeOptions {
public:
    explicit TimeOptions(std::uint64_t default_steps) : default_steps_(default_steps) {}
    void declare(CLI::App& app);
    /// Number of steps from the start. Throws UsageError.
    std::uint64_t steps(const RunDescription& description) const;
    /// The time they reach: --until, or the steps times dt. Throws UsageError unless it is > 0.
    double duration(const RunDescription& description) const;

private:
    std::uint64_t default_steps_;
    std::string steps_;
    std::string until_;
};

}  // namespace steplab
