#include "io/scene_parameters.hpp"

#include "core/number_text.hpp"
#include "core/precision.hpp"
#include "core/shown.hpp"
#include "core/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace steplab {

namespace {

constexpr std::size_t most_parameters = 1000;  // each of them has a slider

std::optional<double> number_of(const toml::node& node) {
    if (const auto* const integer = node.as_integer()) return static_cast<double>(integer->get());
    if (const auto* const real = node.as_floating_point()) return real->get();
    return std::nullopt;
}

double finite_number(const toml::node& node) {
    const auto number = number_of(node);
    if (!number) fail_at(node, "must be a number");
    if (!std::isfinite(*number)) fail_at(node, "must be a finite number");
    return *number;
}

}  // namespace

Expression expression_of(const toml::node& node) {
    const std::string text = text_of(node);
    try {
        return Expression(text);
    } catch (const ExpressionError& error) {
        fail_at(node, fmt::format("\"{}\", character {}: {}", shown(text), error.place() + 1, error.what()));
    }
}

SceneParameters::SceneParameters(const toml::table& root, SceneProblems& problems) {
    const toml::node* const all = root.get("parameters");
    if (!all) return;
    const toml::table& table = table_of(*all, "[parameters]");
    if (table.size() > most_parameters)
        fail_at(*all, fmt::format("a scene has at most {} parameters", most_parameters));
    std::vector<std::string> names;
    const auto parameter = [&](const std::string& name, const toml::node& node) {
        Entry& entry = entries_[name];
        try {
            read(entry, name, node);
        } catch (const SceneProblem& problem) {
            entry.problem = problem;
            throw;
        }
        names.push_back(name);
        if (!entry.expression) infos_.push_back(entry.info);
    };
    problems.attempt([&] { read_all_keys(table, "[parameters]", {}, parameter); });
    for (const std::string& name : names) problems.attempt([&] { set_range(entries_.at(name)); });
}

void SceneParameters::read(Entry& entry, const std::string& name, const toml::node& node) {
    entry.place = &node;
    if (!is_name(name) || name == "pi") fail_at(node, fmt::format("'{}' cannot be a name in expressions", shown(name)));
    entry.info.name = kept(name);
    if (const toml::table* const table = node.as_table()) {
        read_all_keys(*table, fmt::format("parameter '{}'", shown(name)),
                      {{"value", [&](const toml::node& given) { read_value(entry, given); }},
                       {"range",
                        [&](const toml::node& given) {
                            elements_of(given, "[lowest, highest]", 2, 2);
                            entry.range = &given;
                        }},
                       {"unit", [&](const toml::node& given) { entry.info.unit = kept(text_of(given)); }},
                       {"what", [&](const toml::node& given) { entry.info.what = kept(text_of(given)); }},
                       {"logarithmic", [&](const toml::node& given) {
                            entry.info.slider_logarithmic = flag_of(given);
                            entry.logarithmic = &given;
                        }}});
        if (!table->contains("value")) fail_at(node, fmt::format("parameter '{}' needs a value", shown(name)));
    } else {
        read_value(entry, node);
    }
    entry.info.minimum = -infinity;
    entry.info.default_value = entry.number;
}

/// Its ends may be expressions, in the values that the file gives.
void SceneParameters::set_range(Entry& entry) {
    double& low = entry.info.slider_low;
    double& high = entry.info.slider_high;
    const bool logarithmic = entry.info.slider_logarithmic && !entry.expression;
    if (entry.range) {
        const ParameterValues values(infos_);
        SceneNumbers numbers(*this, values);
        const auto ends = elements_of(*entry.range, "[lowest, highest]", 2, 2);
        low = numbers.quantity(*ends[0], SceneNumbers::Use::force).value;
        high = numbers.quantity(*ends[1], SceneNumbers::Use::force).value;
        if (!(low < high)) fail_at(*entry.range, "the range must grow");
        if (logarithmic && !(low > 0))
            fail_at(*entry.range,
                    fmt::format("a logarithmic range of '{}' must begin above 0", shown(entry.info.name)));
    } else if (logarithmic) {
        if (!(entry.number > 0))
            fail_at(*entry.logarithmic,
                    fmt::format("'{}' is not above 0: it needs a range that is", shown(entry.info.name)));
        low = entry.number / 100;
        high = entry.number * 100;
    } else {
        low = std::min(0.0, 2 * entry.number);
        high = entry.number == 0 ? 1 : std::max(0.0, 2 * entry.number);
    }
    for (ParameterInfo& info : infos_) {
        if (info.name == entry.info.name) info = entry.info;
    }
}

void SceneParameters::read_value(Entry& entry, const toml::node& node) {
    entry.place = &node;
    if (node.is_string()) {
        entry.expression = expression_of(node);
    } else {
        entry.number = finite_number(node);
    }
}

std::string_view SceneParameters::kept(std::string text) { return texts_.emplace_back(std::move(text)); }

void SceneParameters::on_change(std::string_view name, OnChange change) {
    for (ParameterInfo& info : infos_) {
        if (info.name == name) info.on_change = change;
    }
}

void SceneParameters::counts(std::string_view name, std::size_t least) {
    const auto entry = entries_.find(name);
    for (ParameterInfo& info : infos_) {
        if (info.name != name || entry == entries_.end()) continue;
        info.kind = ParameterInfo::Kind::integer;
        info.minimum = static_cast<double>(least);
        info.maximum = SceneNumbers::largest_count;
        if (!entry->second.range) info.slider_low = std::max(info.slider_low, info.minimum);
    }
}

SceneNumbers::SceneNumbers(const SceneParameters& parameters, const ParameterValues& values)
    : parameters_(parameters), values_(values) {}

std::vector<std::string_view> SceneNumbers::names() const {
    std::vector<std::string_view> names;
    for (const auto& [name, entry] : parameters_.entries()) names.push_back(name);
    return names;
}

std::map<std::string, std::string> SceneNumbers::followers() const {
    std::map<std::string, std::string> texts;
    for (const auto& [name, entry] : parameters_.entries()) {
        if (entry.expression) texts.emplace(name, text_of(*entry.place));
    }
    return texts;
}

std::optional<double> SceneNumbers::parameter(const std::string& name, const toml::node& place, Use use) {
    if (!parameters_.entries().contains(name)) return std::nullopt;
    uses(name, use);
    const double value = value_of(name, place);
    note_float(place, value, use);
    return value;
}

/// A change of what others follow is one of these.
void SceneNumbers::uses(std::string_view parameter, Use use) {
    const auto entry = parameters_.entries().find(parameter);
    if (entry == parameters_.entries().end()) return;
    const auto [known, added] = used_.try_emplace(entry->first, use);
    const bool more = use == Use::start && known->second != Use::start;
    if (!added && !more) return;
    known->second = use;
    if (!entry->second.expression) return;
    for (const std::string& name : entry->second.expression->names()) uses(name, use);
}

double SceneNumbers::value_of(const std::string& name, const toml::node& place) {
    if (const auto known = known_.find(name); known != known_.end()) return known->second;
    const auto entry = parameters_.entries().find(name);
    if (entry == parameters_.entries().end()) fail_at(place, unknown_word("parameter", name, names()));
    if (entry->second.problem) throw SceneProblem(*entry->second.problem);
    if (!entry->second.expression) return known_[name] = values_[name];
    if (!under_way_.insert(name).second)
        fail_at(*entry->second.place, fmt::format("'{}' depends on itself", shown(name)));
    constexpr std::size_t longest_chain = 200;  // of parameters that follow each other; it is as deep on the stack
    if (under_way_.size() > longest_chain)
        fail_at(*entry->second.place,
                fmt::format("'{}' follows a chain of more than {} others", shown(name), longest_chain));
    const struct Leaving {  // also by a problem: others are looked for
        ~Leaving() { names.erase(name); }
        std::set<std::string, std::less<>>& names;
        const std::string& name;
    } leaving{under_way_, name};
    return known_[name] = evaluated(*entry->second.expression, *entry->second.place);
}

double SceneNumbers::evaluated(const Expression& expression, const toml::node& place) {
    std::vector<double> values;
    for (const std::string& name : expression.names()) values.push_back(value_of(name, place));
    const double value = expression(values);
    if (!std::isfinite(value)) fail_at(place, "its value is not finite");
    return value;
}

WrittenNumber SceneNumbers::quantity(const toml::node& node, Use use) {
    if (!node.is_string()) {
        if (!number_of(node)) fail_at(node, "must be a number, or an expression in quotation marks");
        const double value = finite_number(node);
        note_float(node, value, use);
        return value;
    }
    const Expression expression = expression_of(node);
    const double value = evaluated(expression, node);
    note_float(node, value, use);
    for (const std::string& name : expression.names()) uses(name, use);
    return {value, text_of(node)};
}

/// What a force has in float must not be 0 there, or it would not act; a place or a velocity may.
void SceneNumbers::note_float(const toml::node& node, double value, Use use) {
    const double held = std::abs(rounded_to(Precision::float_, value));
    const bool vanishes = use == Use::force && value != 0 && held < std::numeric_limits<float>::min();
    if (std::isfinite(held) && !vanishes) return;
    lost_in_float_.attempt([&] {
        fail_at(node, fmt::format("{} is lost in float, which holds 1e-37 to 3e38: choose another value or double",
                                  exact_text(value)));
    });
}

WrittenNumber SceneNumbers::positive(const toml::node& node, Use use) {
    WrittenNumber quantity = this->quantity(node, use);
    if (!(quantity.value > 0)) fail_at(node, fmt::format("must be > 0 (is {})", exact_text(quantity.value)));
    if (quantity.value < std::numeric_limits<double>::min())  // runs take it for 0
        fail_at(node, fmt::format("must be at least 2.3e-308 (is {})", exact_text(quantity.value)));
    return quantity;
}

WrittenNumber SceneNumbers::not_negative(const toml::node& node, Use use) {
    WrittenNumber quantity = this->quantity(node, use);
    if (!(quantity.value >= 0)) fail_at(node, fmt::format("must be >= 0 (is {})", exact_text(quantity.value)));
    return quantity;
}

WrittenVector SceneNumbers::vector(const toml::node& node, Use use) {
    const auto elements = elements_of(node, "three numbers, [x, y, z]", 3, 3);
    return {quantity(*elements[0], use), quantity(*elements[1], use), quantity(*elements[2], use)};
}

/// True if the text is the name of a parameter, which then is the count.
bool SceneNumbers::is_count_alone(const toml::node& node, std::size_t least) {
    const toml::node* place = &node;
    while (place && place->is_string()) {
        const Expression expression = expression_of(*place);
        if (expression.nodes().back().operation != Expression::Operation::name) return false;
        const auto entry = parameters_.entries().find(expression.names().front());
        if (entry == parameters_.entries().end()) return false;
        place = entry->second.place;
        if (entry->second.expression) continue;
        std::size_t& known = counting_[entry->first];
        known = std::max(known, least);
        return true;
    }
    return false;
}

/// Rounding, of float too, makes no other number of particles of what is a whole one in decimals.
std::size_t SceneNumbers::count(const toml::node& node, std::size_t least) {
    const double value = quantity(node, Use::start).value, whole = std::nearbyint(value);
    const bool exact = !node.is_string() || is_count_alone(node, least);
    // a dozen roundings of float at most, and never half of a particle
    const double rounding = exact ? 0 : std::min(1e-6 * whole, 0.1);
    if (std::abs(value - whole) <= rounding && whole >= static_cast<double>(least) && whole <= largest_count)
        return static_cast<std::size_t>(whole);
    fail_at(node, fmt::format("must be an integer from {} to {} (is {})", least, exact_text(largest_count),
                              exact_text(value)));
}

std::uint64_t SceneNumbers::seed(const toml::node& node) {
    constexpr std::int64_t most = 16777215;
    const auto* const integer = node.as_integer();
    if (!integer || integer->get() < 1 || integer->get() > most)
        fail_at(node, fmt::format("a seed must be an integer from 1 to {}", most));
    return static_cast<std::uint64_t>(integer->get());
}

}  // namespace steplab
