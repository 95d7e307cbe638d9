#pragma once

#include "core/error.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/simulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace steplab::test {

inline constexpr Precision precisions[] = {Precision::float_, Precision::double_};

using Settings = std::initializer_list<std::pair<std::string_view, double>>;

/// A description with these parameters of the model.
inline RunDescription run_of(std::string_view model, std::string_view method, Precision precision, double dt,
                             Settings settings = {}) {
    RunDescription description = describe(model, method);
    description.precision = precision;
    description.dt = dt;
    for (const auto& [name, value] : settings) description.scene.set(name, value);
    return description;
}

/// A description at the model's defaults; but a crystal of 125 particles, for which implicit methods solve in
/// milliseconds.
inline RunDescription small_run_of(std::string_view model, std::string_view method, Precision precision, double dt) {
    RunDescription description = run_of(model, method, precision, dt);
    if (model == "crystal") description.scene.set("edge", 5);
    return description;
}

/// A scene of the catalogue with these parameters, for tests that ask nothing of the method.
inline RunDescription scene_with(std::string_view model, Settings settings = {}) {
    return run_of(model, "rk4", Precision::double_, 0.1, settings);
}

/// A description with a tolerance for methods that choose their own steps.
inline RunDescription run_to_tolerance(std::string_view model, std::string_view method, double dt, double tolerance,
                                       Settings settings = {}, Precision precision = Precision::double_) {
    RunDescription description = run_of(model, method, precision, dt, settings);
    description.method_parameters.set("tolerance", tolerance);
    return description;
}

/// Of the models, as a test's parameters.
inline std::vector<std::string> model_ids() {
    std::vector<std::string> ids;
    for (const Model& model : models()) ids.emplace_back(model.info.id);
    return ids;
}

inline Frame frame_after(const RunDescription& description, std::uint64_t steps) {
    Simulation simulation(description);
    simulation.advance(steps);
    return simulation.frame();
}

/// Largest distance of a particle between two frames.
inline double distance(const Frame& a, const Frame& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.positions.size(); ++i)
        largest = std::max(largest, length(a.positions[i] - b.positions[i]));
    return largest;
}

/// One method in one precision; tests over the catalogue take it as their parameter.
struct MethodCase {
    const MethodInfo* info;
    Precision precision;

    std::string id() const { return std::string(info->id); }
    friend std::ostream& operator<<(std::ostream& out, const MethodCase& c) {
        return out << c.info->id << " in " << steplab::id(c.precision);
    }
};

/// Every method but the curiosities, in both precisions.
inline std::vector<MethodCase> working_methods() {
    std::vector<MethodCase> cases;
    for (const Method& method : methods()) {
        for (const Precision precision : precisions) {
            if (!method.info.curiosity) cases.push_back({&method.info, precision});
        }
    }
    return cases;
}

/// Every method in both precisions.
inline std::vector<MethodCase> all_methods() {
    std::vector<MethodCase> cases;
    for (const Method& method : methods()) {
        for (const Precision precision : precisions) cases.push_back({&method.info, precision});
    }
    return cases;
}

/// What is left of a list without that of which `holds` is not true. Throws std::logic_error if that is nothing: a test
/// of nothing would pass.
template <class T, class Holds>
std::vector<T> those_where(std::vector<T> all, const Holds& holds) {
    std::erase_if(all, [&](const T& one) { return !holds(one); });
    if (all.empty()) throw std::logic_error("a test is to be made of nothing");
    return all;
}

/// The methods of which `holds` is true, a function of a MethodCase.
template <class Holds>
std::vector<MethodCase> methods_where(const Holds& holds) {
    return those_where(all_methods(), holds);
}
template <class Holds>
std::vector<MethodCase> working_methods_where(const Holds& holds) {
    return those_where(working_methods(), holds);
}

/// Steps as long as dt, errors of their own.
inline bool has_fixed_steps(const MethodCase& c) { return !c.info->adaptive; }
/// Steps as long as dt that solve no equations: each costs the same.
inline bool has_equal_steps(const MethodCase& c) { return !c.info->adaptive && !c.info->implicit; }

/// The models of which `holds` is true, a function of a Model.
template <class Holds>
std::vector<const Model*> models_where(const Holds& holds) {
    std::vector<const Model*> all;
    for (const Model& model : models()) all.push_back(&model);
    return those_where(all, [&](const Model* model) { return holds(*model); });
}

/// The models that a method runs at their defaults: all, but those that it refuses by name
/// (RunDescription.default_of_every_model_can_be_run_by_all_but_taylor_of_crystal).
inline std::vector<const Model*> models_for(std::string_view method, Precision precision) {
    std::vector<const Model*> possible;
    for (const Model& model : models()) {
        try {
            check(run_of(model.info.id, method, precision, 0.1));
            possible.push_back(&model);
        } catch (const UsageError&) {
        }
    }
    return possible;
}

/// "rk4_double": how ctest names a case.
inline std::string case_name(const testing::TestParamInfo<MethodCase>& test) {
    std::string name = test.param.id() + "_" + std::string(id(test.param.precision));
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

}  // namespace steplab::test
