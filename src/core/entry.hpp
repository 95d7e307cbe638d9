#pragma once

#include "core/coupling.hpp"

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace steplab {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// What a change of a parameter does to a run that is under way.
enum class OnChange { applies_live, restarts };

/// One parameter of a model or method: everything menus, sliders, help, docs and checks need to know.
struct ParameterInfo {
    enum class Kind { real, integer, choice };

    std::string_view name = {};
    Kind kind = Kind::real;
    std::string_view unit = {};  ///< "" if it is a pure number
    double minimum = 0;
    bool minimum_included = true;  ///< false: the value must be greater than `minimum`
    double maximum = infinity;
    double default_value = 0;  ///< for a choice: the index of the default
    OnChange on_change = OnChange::applies_live;
    std::string_view what = {};  ///< a phrase: "rest length of a spring"
    double slider_low = 0;       ///< the range a slider offers; exact entry goes beyond it
    double slider_high = 1;
    bool slider_logarithmic = false;
    std::span<const std::string_view> choices = {};
};

/// The number that `text` stands for. Throws UsageError naming the parameter, the text and the range.
double parse_value(const ParameterInfo& info, std::string_view text);
/// Shortest text that parse_value reads back as the same value.
std::string format_value(const ParameterInfo& info, double value);
/// "> 0", "0 .. 1", "a whole number from 2", "centre, corner".
std::string range_text(const ParameterInfo& info);
/// Throws UsageError if `value` is not allowed (range, whole number, finite).
void check_value(const ParameterInfo& info, double value);

/// The parameters of one model or method with their values: integers as whole doubles, choices as indices.
class ParameterValues {
public:
    ParameterValues() = default;
    /// Every parameter at its default. `infos` must outlive this object (entries are constants of the program).
    explicit ParameterValues(std::span<const ParameterInfo> infos);

    std::span<const ParameterInfo> infos() const { return infos_; }
    bool contains(std::string_view name) const;
    /// The value of a parameter this entry has (asserted).
    double operator[](std::string_view name) const;
    /// The value as a count; for integers.
    std::size_t count(std::string_view name) const;
    /// Checked: throws UsageError naming what is allowed.
    void set(std::string_view name, double value);
    void set_text(std::string_view name, std::string_view text);

    /// The same parameters in the same order with the same values, wherever their descriptions are stored.
    friend bool operator==(const ParameterValues& a, const ParameterValues& b);

private:
    std::size_t index_of(std::string_view name) const;

    std::span<const ParameterInfo> infos_;
    std::vector<double> values_;
};

/// A method as it describes itself. Menus, help, docs and the tests over all methods come from this.
struct MethodInfo {
    std::string_view id = {};
    std::string_view name = {};
    std::string_view what = {};  ///< one sentence for a person who chooses
    int order = 1;
    int order_with_drag = 1;
    int evaluations = 1;        ///< a step; a substep if it has the parameter `substeps`
    int start_evaluations = 0;  ///< once, at the start of each segment
    /// Largest stable omega dt on x'' = -omega^2 x (of one substep): 0 = unstable at any dt.
    double linear_limit = 0;
    bool symplectic = false;
    bool reversible = false;
    bool adaptive = false;
    bool implicit = false;            ///< solves equations: `evaluations` is what a step usually takes
    bool curiosity = false;           ///< kept to show a mistake; not for work, its velocities least of all
    std::string_view conserves = {};  ///< what it keeps, in words
    std::string_view source = {};
    std::span<const ParameterInfo> parameters = {};
    /// Why the method cannot run scenes of this coupling, none if it can; null for methods that run any.
    std::optional<std::string> (*refusal)(const Coupling&) = nullptr;
    /// Bytes it holds for a scene's interactions, given the number of pairs that interact; an upper bound. Null: none.
    double (*bytes_of_interactions)(const Coupling&, double pairs) = nullptr;
};

/// Evaluations a step of the method with these parameters, start-up not counted.
double evaluations_per_step(const MethodInfo& info, const ParameterValues& values);
/// Largest stable omega dt with these parameters, without drag: 0 = unstable at any dt.
double linear_limit(const MethodInfo& info, const ParameterValues& values);

/// A model as it describes itself.
struct ModelInfo {
    std::string_view id = {};
    std::string_view name = {};
    std::string_view what = {};  ///< one or two sentences
    std::span<const ParameterInfo> parameters = {};
};

}  // namespace steplab
