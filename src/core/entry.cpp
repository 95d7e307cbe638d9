#include "core/entry.hpp"

#include "core/error.hpp"
#include "core/shown.hpp"
#include "core/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace steplab {

namespace {

/// Beyond this not every integer is a double.
constexpr double largest_integer = 9007199254740992.0;

[[noreturn]] void refuse(const ParameterInfo& info, std::string_view text) {
    throw UsageError(fmt::format("{} must be {} (got \"{}\")", info.name, range_text(info), shown(text)));
}

bool is_allowed(const ParameterInfo& info, double value) {
    using Kind = ParameterInfo::Kind;
    const bool low = info.minimum_included ? value < info.minimum : value <= info.minimum;
    const bool integer = info.kind == Kind::real || (value == std::floor(value) && value <= largest_integer);
    const double maximum = info.kind == Kind::choice ? static_cast<double>(info.choices.size()) - 1 : info.maximum;
    return std::isfinite(value) && !low && value <= maximum && integer;
}

}  // namespace

std::string range_text(const ParameterInfo& info) {
    using Kind = ParameterInfo::Kind;
    if (info.kind == Kind::choice) return joined(info.choices, " or ");
    const bool integer = info.kind == Kind::integer;
    const std::string_view what = integer ? "an integer" : "a number";
    const auto bound = [&](double value) { return integer ? fmt::format("{:.0f}", value) : exact_text(value); };
    const std::string_view least = info.minimum_included ? ">=" : ">";
    if (std::isfinite(info.maximum)) {
        if (integer && info.minimum == 0 && info.maximum == 1) return "0 or 1";
        if (info.minimum_included)
            return fmt::format("{} from {} to {}", what, bound(info.minimum), bound(info.maximum));
        return fmt::format("{} {} {} and <= {}", what, least, bound(info.minimum), bound(info.maximum));
    }
    if (info.minimum == -infinity) return integer ? "an integer" : "a finite number";
    return fmt::format("{} {} {}", what, least, bound(info.minimum));
}

void check_value(const ParameterInfo& info, double value) {
    if (!is_allowed(info, value)) refuse(info, exact_text(value));
}

double parse_value(const ParameterInfo& info, std::string_view text) {
    if (info.kind == ParameterInfo::Kind::choice) {
        const auto found = std::find(info.choices.begin(), info.choices.end(), text);
        if (found == info.choices.end()) refuse(info, text);
        return static_cast<double>(found - info.choices.begin());
    }
    const auto value = parse_number(text);
    if (!value || !is_allowed(info, *value)) refuse(info, text);
    return *value;
}

std::string format_value(const ParameterInfo& info, double value) {
    if (info.kind == ParameterInfo::Kind::choice) return std::string(info.choices[static_cast<std::size_t>(value)]);
    return exact_text(value);
}

ParameterValues::ParameterValues(std::span<const ParameterInfo> infos) : infos_(infos) {
    values_.reserve(infos.size());
    for (const auto& info : infos) values_.push_back(info.default_value);
}

std::size_t ParameterValues::index_of(std::string_view name) const {
    const auto found = std::find_if(infos_.begin(), infos_.end(), [&](const auto& info) { return info.name == name; });
    return static_cast<std::size_t>(found - infos_.begin());
}

bool ParameterValues::contains(std::string_view name) const { return index_of(name) < values_.size(); }

double ParameterValues::operator[](std::string_view name) const {
    assert(contains(name));
    return values_[index_of(name)];
}

std::size_t ParameterValues::count(std::string_view name) const { return static_cast<std::size_t>((*this)[name]); }

void ParameterValues::set(std::string_view name, double value) {
    assert(contains(name));
    const std::size_t index = index_of(name);
    check_value(infos_[index], value);
    values_[index] = value;
}

void ParameterValues::set_text(std::string_view name, std::string_view text) {
    assert(contains(name));
    const std::size_t index = index_of(name);
    values_[index] = parse_value(infos_[index], text);
}

namespace {

bool same_parameter(const ParameterInfo& a, const ParameterInfo& b) {
    return a.name == b.name && a.kind == b.kind &&
           std::equal(a.choices.begin(), a.choices.end(), b.choices.begin(), b.choices.end());
}

}  // namespace

bool operator==(const ParameterValues& a, const ParameterValues& b) {
    return a.values_ == b.values_ &&
           std::equal(a.infos_.begin(), a.infos_.end(), b.infos_.begin(), b.infos_.end(), same_parameter);
}

namespace {

double substeps(const ParameterValues& values) { return values.contains("substeps") ? values["substeps"] : 1; }

}  // namespace

double evaluations_per_step(const MethodInfo& info, const ParameterValues& values) {
    return info.evaluations * substeps(values);
}

double linear_limit(const MethodInfo& info, const ParameterValues& values) {
    return info.linear_limit * substeps(values);
}

}  // namespace steplab
