#include "sim/own_methods.hpp"

#include "core/error.hpp"
#include "core/shown.hpp"
#include "sim/run/linear_limit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <list>
#include <mutex>
#include <utility>

namespace steplab {

namespace {

/// Largest order and number of evaluations of a step: far above any method that is known.
constexpr int most = 1000;

struct OwnEntry {
    OwnMethodDescription description;
    std::shared_ptr<const OwnSteps> steps;
    ParameterInfo none = {};  ///< where its empty list of parameters begins: by that its setups are recognised
    Method method = {};
};

/// Entries are never removed: descriptions of runs point to them.
class OwnMethods {
public:
    const OwnEntry* find(std::string_view id) const {
        return find_if([&](const OwnEntry& entry) { return entry.description.id == id; });
    }
    const OwnEntry* find(std::span<const ParameterInfo> parameters) const {
        return find_if([&](const OwnEntry& entry) { return &entry.none == parameters.data(); });
    }
    std::vector<std::string_view> ids() const {
        const std::lock_guard lock(mutex_);
        std::vector<std::string_view> ids;
        for (const OwnEntry& entry : entries_) ids.push_back(entry.description.id);
        return ids;
    }
    OwnEntry& add(OwnMethodDescription description, std::shared_ptr<const OwnSteps> steps) {
        const std::lock_guard lock(mutex_);
        entries_.push_back({.description = std::move(description), .steps = std::move(steps)});
        return entries_.back();
    }

private:
    template <class Condition>
    const OwnEntry* find_if(const Condition& condition) const {
        const std::lock_guard lock(mutex_);
        const auto found = std::find_if(entries_.begin(), entries_.end(), condition);
        return found == entries_.end() ? nullptr : &*found;
    }

    mutable std::mutex mutex_;
    std::list<OwnEntry> entries_;
};

/// Part of the catalogue, of which there is one in a program.
OwnMethods& all_own_methods() {
    static OwnMethods all;
    return all;
}

std::unique_ptr<Stepper> make(const StepperSetup& setup) {
    const OwnEntry& entry = *all_own_methods().find(setup.parameters.infos());
    if (setup.precision != Precision::double_)
        throw UsageError(fmt::format("{} is a method of this program's own: it runs in double", entry.description.id));
    return own_stepper_maker(setup.instructions)(setup, entry.steps);
}

bool is_word(std::string_view id) {
    const auto allowed = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'; };
    return !id.empty() && id.front() >= 'a' && id.front() <= 'z' && std::all_of(id.begin(), id.end(), allowed);
}

void check(const OwnMethodDescription& description) {
    if (!is_word(description.id))
        throw UsageError(
            fmt::format("the id of a method is a word such as my-method (got '{}')", shown(description.id)));
    const auto same_id = [&](const Method& method) { return method.info.id == description.id; };
    if (own_method(description.id) || std::any_of(methods().begin(), methods().end(), same_id))
        throw UsageError(fmt::format("there is a method {} already", description.id));
    const auto in_range = [](int number) { return number >= 1 && number <= most; };
    if (!in_range(description.order) || !in_range(description.order_with_drag) || !in_range(description.evaluations))
        throw UsageError(
            fmt::format("{}: orders and evaluations of a method are integers from 1 to {}", description.id, most));
}

MethodInfo info_of(const OwnEntry& entry) {
    return {.id = entry.description.id,
            .name = entry.description.name,
            .what = entry.description.what,
            .order = entry.description.order,
            .order_with_drag = entry.description.order_with_drag,
            .evaluations = entry.description.evaluations,
            .symplectic = entry.description.symplectic,
            .reversible = entry.description.reversible,
            .parameters = {&entry.none, std::size_t{0}}};
}

}  // namespace

void add_own_method(const OwnMethodDescription& description, std::shared_ptr<const OwnSteps> steps) {
    check(description);
    OwnEntry& entry = all_own_methods().add(description, std::move(steps));
    entry.method.info = info_of(entry);
    for (const Instructions each : {Instructions::baseline, Instructions::avx2, Instructions::avx512})
        entry.method.makers[static_cast<std::size_t>(each)] = own_stepper_maker(each) ? make : nullptr;
    entry.method.info.linear_limit = measured_linear_limit(entry.method, ParameterValues(entry.method.info.parameters));
}

const Method* own_method(std::string_view id) {
    const OwnEntry* const entry = all_own_methods().find(id);
    return entry ? &entry->method : nullptr;
}

std::vector<std::string_view> own_method_ids() { return all_own_methods().ids(); }

}  // namespace steplab
