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

/// What changing a parameter does to a running simulation.
enum class OnChange { applies_live, restarts };

/// A parameter of a model or method, with everything that menus, sliders, help texts, docs and checks need.
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
    double slider_low = 0;       ///< range of the slider; typed values may lie outside it
    double slider_high = 1;
    bool slider_logarithmic = false;
    std::span<const std::string_view> choices = {};
};

/// The value written as `text`. Throws UsageError naming the parameter, the text and the range.
double parse_value(const ParameterInfo& info, std::string_view text);
/// Shortest text that parse_value reads back as the same value.
std::string format_value(const ParameterInfo& info, double value);
/// "a number > 0", "an integer >= 2", "0 or 1", "centre or corner": what follows "must be".
std::string range_text(const ParameterInfo& info);
/// Throws UsageError if `value` is out of range, not finite, or not an integer where one is required.
void check_value(const ParameterInfo& info, double value);

/// The parameters of one model or method with their values: integers as doubles, choices as indices.
class ParameterValues {
public:
    ParameterValues() = default;
    /// Every parameter at its default. `infos` must outlive this object (entries are constants of the program).
    explicit ParameterValues(std::span<const ParameterInfo> infos);

    std::span<const ParameterInfo> infos() const { return infos_; }
    bool contains(std::string_view name) const;
    /// The value of a parameter that this entry has (asserted).
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

/// The description of a method, from which menus, help texts, docs and the tests over all methods are made.
struct MethodInfo {
    std::string_view id = {};
    std::string_view name = {};
    std::string_view what = {};  ///< one sentence that helps to choose a method
    int order = 1;
    int order_with_drag = 1;
    /// With dashpots, or drag that differs between particles; 0: the method cannot take them.
    int order_with_damping = 0;
    int evaluations = 1;        ///< of the force per step, or per substep if there is a parameter `substeps`
    int start_evaluations = 0;  ///< at the start of each segment
    /// Largest stable omega dt on x'' = -omega^2 x (of one substep): 0 = unstable at any dt.
    double linear_limit = 0;
    bool symplectic = false;
    bool reversible = false;
    bool adaptive = false;
    bool implicit = false;            ///< solves equations in each step: `evaluations` is typical
    bool curiosity = false;           ///< kept to demonstrate a mistake; not for production runs
    std::string_view conserves = {};  ///< conserved quantities, in words
    std::string_view source = {};
    std::span<const ParameterInfo> parameters = {};
    /// Why the method cannot run scenes with this coupling, nullopt if it can; null for methods that run every scene.
    std::optional<std::string> (*refusal)(const Coupling&) = nullptr;
    /// Upper bound of the bytes it stores for a scene's interactions, given those at the start. Null: none.
    double (*bytes_of_interactions)(const Coupling&, const Interactions&) = nullptr;
};

/// Force evaluations per step with these parameters, start-up excluded.
double evaluations_per_step(const MethodInfo& info, const ParameterValues& values);
/// Largest stable omega dt with these parameters, without drag: 0 = unstable at any dt.
double linear_limit(const MethodInfo& info, const ParameterValues& values);

/// The description of a model.
struct ModelInfo {
    std::string_view id = {};
    std::string_view name = {};
    std::string_view what = {};  ///< one or two sentences
    std::span<const ParameterInfo> parameters = {};
};

}  // namespace steplab
